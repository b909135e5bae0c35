/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Doubles and floats: their vectors, and C's conversions between them. A vector of floats has the
 * same number of lanes as one of doubles: an iteration's values stay in its lane.
 */
#include "emit/lanes/vectoriser.h"

#include <assert.h>

const lane_words *lane_words_of(const ir_type *type) {
    assert(lane_is_real(type));
    static const lane_words of_doubles = {.vector = "redcc_vector",
                                          .gather = "REDCC_GATHER",
                                          .same = "redcc_same",
                                          .select = "redcc_select",
                                          .mask = "(redcc_mask)",
                                          .of = "redcc_doubles_of",
                                          .scalar = "double"};
    static const lane_words of_floats = {.vector = "redcc_floats",
                                         .gather = "REDCC_GATHER_FLOATS",
                                         .same = "redcc_same_float",
                                         .select = "redcc_select_floats",
                                         .mask = "redcc_mask_of_floats",
                                         .of = "redcc_floats_of",
                                         .scalar = "float"};
    return type->size == 4 ? &of_floats : &of_doubles;
}

lane_value lane_convert(vectoriser *l, lane_value value, const ir_type *from, const ir_type *to) {
    arena *a = l->loop->arena;
    if (from->size == to->size)
        return value;
    if (value.is_vector)
        return (lane_value){arena_format(a, "%s(%s)", lane_words_of(to)->of, value.text), true};
    return (lane_value){arena_format(a, "((%s)%s)", lane_words_of(to)->scalar, value.text), false};
}

const char *lane_spread(vectoriser *l, lane_value value, const ir_type *type) {
    return value.is_vector
               ? value.text
               : arena_format(l->loop->arena, "%s(%s)", lane_words_of(type)->same, value.text);
}
