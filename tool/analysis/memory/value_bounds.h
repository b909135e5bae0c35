/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Computes bounds of an integer in a function that hold for any input, from the function's
 *  comparisons and assignments:
 *
 *      if (r < table->x0) r = table->x0;
 *      int i = (int)floor((r - table->x0) * table->inverse);
 *      if (i > table->n) i = table->n;
 *
 *  After these statements i is between 0 and n if table->inverse is not negative. In any rounding
 *  mode, the difference `r - x0` is not negative if `r` is not below `x0`. Sums, products, square
 *  roots and integer parts of values that are not negative are not negative either. The conversion
 *  of a NaN, or of a value that is too large for an integer, is undefined (C17 6.3.1.4).
 *
 *  The statements before the place are executed on intervals (abstract interpretation). For an
 *  `if`, the results of both branches are joined. A variable that a loop, a switch, a compound
 *  assignment or an increment changes is unknown afterwards. */
#ifndef ANALYSIS_VALUE_BOUNDS_H
#define ANALYSIS_VALUE_BOUNDS_H

#include "analysis/base/facts.h"
#include "analysis/memory/variable_facts.h"

enum { BOUNDS_MOST_ENDS = 4 };

/** The value is at least the minimum of the terms in `low`, and at most the maximum of the terms in
 *  `high`. */
typedef struct value_bounds {
    unsigned low_count, high_count; /* 0 if the bound is unknown */
    bound_term low[BOUNDS_MOST_ENDS], high[BOUNDS_MOST_ENDS];
} value_bounds;

/** Floating values. The bounds (value_bounds) hold if none of these values is negative. */
typedef struct bounds_conditions {
    unsigned count;
    const ir_node *value[BOUNDS_MOST_CONDITIONS];
} bounds_conditions;

/** Computes the bounds of the integer expression `value` at `site`, a node of the function. Terms
 *  and conditions are nodes of the function's text: constants, parameters that it never writes, and
 *  members reached through them. The caller must ensure that these do not change while the function
 *  runs. Returns false if one bound is unknown. */
bool value_bounds_of(variable_facts *facts, const ir_function *function, const ir_node *value,
                     const ir_node *site, value_bounds *bounds, bounds_conditions *conditions);

/** Is the term one of the bounds' terms already? */
bool element_bounds_has(const element_bounds *bounds, bound_term term);

#endif
