/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/loop/loads_stay.h"

#include "analysis/base/loop_loads.h"

/* Is the variable through which the pointer is loaded unchanged in the loop? */
static bool starts_unchanged(const analyser *an, const ir_node *loop, const loop_loads *loads,
                             const loop_load *load) {
    return loop_loads_has(loads, load->through) ||
           (!variable_escapes(an->facts, load->through) &&
            !variable_written_in(an->facts, loop, load->through));
}

bool loads_stay(const analyser *an, const ir_node *loop, const loop_loads *loads) {
    access_list list = {0};
    access_collect(an->effects, loop, &list);
    for (unsigned i = 0; i < loads->count; i++) {
        const loop_load *load = &loads->items[i];
        if (!starts_unchanged(an, loop, loads, load))
            return false;
        const location from = location_of(an->facts, load->variable->stands_for, loop);
        for (unsigned k = 0; k < list.items.count; k++) {
            const access *a = &list.items.items[k];
            if (a->kind == ACCESS_READ)
                continue;
            if (!a->lvalue)
                return false;
            const location to = location_of(an->facts, a->lvalue, loop);
            if (locations_overlap(&an->rules, &from, &to) != OVERLAP_NO)
                return false;
        }
    }
    return true;
}
