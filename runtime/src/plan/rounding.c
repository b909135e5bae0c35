/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/rounding.h"

#include <assert.h>

#include "base/memory.h"
#include "plan/plan.h"

/* Can the array be compensated together with its group? It must be a sum of the same type as the
 * array whose number identifies the group, and its elements must be aligned to those of that
 * array. */
static bool fits(const struct plan *plan, const redcc_array *arrays, uint32_t group,
                 uint32_t array) {
    const redcc_array *it = &arrays[array], *lead = &arrays[group];
    const size_t size = redcc_rounding_element(lead->type);
    return it->operation == REDCC_SUM && it->type == lead->type && it->element == size &&
           it->unit % size == 0 && plan->shift[array] % (ptrdiff_t)size == 0;
}

static bool is_compensated(const struct plan *plan, const redcc_array *arrays, uint32_t group) {
    const struct offsets touched = plan->touched[group];
    const redcc_type type = arrays[group].type;
    if (plan->group_of[group] != group || touched.first >= touched.end ||
        (type != REDCC_FLOAT && type != REDCC_DOUBLE))
        return false;
    const ptrdiff_t size = (ptrdiff_t)redcc_rounding_element(type);
    bool all_fit = touched.first % size == 0 && touched.end % size == 0;
    for (uint32_t array = 0; array < plan->array_count; array++)
        if (plan->group_of[array] == group)
            all_fit = all_fit && fits(plan, arrays, group, array);
    return all_fit;
}

bool redcc_rounding_new(struct plan *plan, const redcc_array *arrays) {
    assert(!plan->rounding);
    plan->rounding = redcc_memory_alloc_zeroed(plan->array_count, sizeof *plan->rounding);
    if (!plan->rounding)
        return false;
    for (uint32_t group = 0; group < plan->array_count; group++) {
        if (!is_compensated(plan, arrays, group))
            continue;
        struct rounding *rounding = &plan->rounding[group];
        const struct offsets touched = plan->touched[group];
        *rounding = (struct rounding){.type = arrays[group].type, .offset = touched.first};
        rounding->count =
            (size_t)(touched.end - touched.first) / redcc_rounding_element(rounding->type);
        rounding->value = redcc_memory_alloc(rounding->count * sizeof *rounding->value);
        rounding->before = redcc_memory_alloc(rounding->count * sizeof *rounding->before);
        if (!rounding->value || !rounding->before)
            return false;
    }
    return true;
}

void redcc_rounding_free(struct plan *plan) {
    for (uint32_t group = 0; plan->rounding && group < plan->array_count; group++) {
        redcc_memory_free(plan->rounding[group].value);
        redcc_memory_free(plan->rounding[group].before);
    }
    redcc_memory_free(plan->rounding);
    plan->rounding = NULL;
}

size_t redcc_rounding_bytes(const struct plan *plan) {
    size_t bytes = 0;
    for (uint32_t group = 0; plan->rounding && group < plan->array_count; group++)
        bytes += redcc_memory_size(plan->rounding[group].value) +
                 redcc_memory_size(plan->rounding[group].before);
    return bytes;
}
