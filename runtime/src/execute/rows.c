/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/rows.h"

#include "plan/elements.h"
#include "redcc/entry.h"

#include <assert.h>
#include <string.h>

static const struct element_rule *rule_of(const redcc_array *array) {
    return redcc_element_rule((redcc_operator)array->operation, (redcc_type)array->type);
}

void redcc_rows_fill(const redcc_array *array, void *values, redcc_size bytes) {
    const struct element_rule *rule = rule_of(array);
    assert(!rule || bytes % rule->size == 0);
    if (rule)
        rule->fill(values, bytes / rule->size);
    else
        memset(values, 0, bytes);
}

void redcc_rows_settle(redcc_worker *worker, const struct redcc_kept_row *kept, int count) {
    const redcc_array *arrays = worker->call->loop->arrays;
    for (int n = 0; n < count; n++) {
        const struct redcc_kept_row *it = &kept[n];
        assert((redcc_u32)it->array < worker->call->loop->array_count);
        const struct element_rule *rule = rule_of(&arrays[it->array]);
        if (!rule)
            worker->call->calls->misuse(worker, "redcc_row is not for elements of this type");
        else if (worker->call->calls->hooked(worker->owner[it->array].hook, it->row))
            rule->merge(it->row, it->values, it->bytes / rule->size, arrays[it->array].limit);
    }
}
