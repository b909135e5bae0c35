/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The bounds of an integer in a function, for any input, derived from the function's comparisons
 * and assignments:
 *
 *     if (r < table->x0) r = table->x0;
 *     int i = (int)floor((r - table->x0) * table->inverse);
 *     if (i > table->n) i = table->n;
 *
 * After these statements i is between 0 and n, if the inverse is not negative: (r - x0) of an r not
 * below x0 is not negative in any rounding, nor are sums, products, roots and whole parts of
 * such values. The conversion of a NaN, or of a value too large for an integer, is undefined (C17
 * 6.3.1.4).
 *
 * The statements before the place are executed on intervals. For an `if`, the results of both
 * branches are joined. Variables that a loop, a switch or a compound assignment changes are unknown
 * after it.
 */
#ifndef ANALYSIS_VALUE_BOUNDS_H
#define ANALYSIS_VALUE_BOUNDS_H

#include "analysis/base/facts.h"
#include "analysis/memory/variable_facts.h"

enum { BOUNDS_MOST_ENDS = 4 };

/** The value is at least the minimum of `low`, and at most the maximum of `high`. */
typedef struct value_bounds {
    unsigned low_count, high_count; /* 0: nothing is known */
    bound_term low[BOUNDS_MOST_ENDS], high[BOUNDS_MOST_ENDS];
} value_bounds;

/** The bounds hold if none of these values is negative. */
typedef struct bounds_conditions {
    unsigned count;
    const ir_node *value[BOUNDS_MOST_CONDITIONS];
} bounds_conditions;

/** The bounds of the integer expression `value` at `site`, a node of the function. Terms and
 *  conditions are nodes of the function's text: parameters that it never writes, and members read
 *  through them. The caller must ensure that these do not change during the call. Returns false if
 *  one end is unknown. */
bool value_bounds_of(variable_facts *facts, const ir_function *function, const ir_node *value,
                     const ir_node *site, value_bounds *bounds, bounds_conditions *conditions);

/** Is this one of the terms already? */
bool element_bounds_has(const element_bounds *bounds, bound_term term);

#endif
