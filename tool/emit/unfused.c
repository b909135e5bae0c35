/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/unfused.h"

#include "plan/contraction.h"
#include "plan/place.h"

const char *contraction_directives(arena *a, const ir_unit *unit, bool has_targets) {
    return arena_format(a,
                        "#if defined(__clang__)\n"
                        "#pragma clang fp contract(off)\n"
                        "#elif defined(%s)\n"
                        "#pragma GCC optimize(\"fp-contract=off\")\n"
                        "#endif\n",
                        has_targets || may_name_targets(unit) ? "__GNUC__" : "__FP_FAST_FMA");
}

const char *unfused_function(arena *a, const ir_unit *unit, const ir_function *function,
                             uint32_t *place) {
    loop_text start = {.arena = a, .unit = unit};
    const bool is_in_line = place_in_front(unit, function, place);
    return arena_format(a, "%sREDCC_UNFUSED\n%s\n%s", is_in_line ? "\n" : "",
                        loop_line_directive(&start, function->range.begin),
                        is_in_line ? loop_column_blanks(&start, *place) : "");
}
