/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Between which numbers does an integer of a function lie, whatever it is computed from? Said by
 * what the function compares it with, and sets it to:
 *
 *     if (r < table->x0) r = table->x0;
 *     int i = (int)floor((r - table->x0) * table->inverse);
 *     if (i > table->n) i = table->n;
 *
 * Behind these i is between 0 and n, if the inverse is not negative: (r - x0) of an r not below x0
 * is not negative in any rounding, nor are products, quotients, roots and whole parts of such
 * values. A value that is no number, or too large for an integer, has no conversion (C17 6.3.1.4).
 *
 * The statements in front of the place are executed on intervals. Both branches of an `if` are, and
 * put together; what a loop, a switch or a call may change is not known behind it.
 */
#ifndef ANALYSIS_VALUE_BOUNDS_H
#define ANALYSIS_VALUE_BOUNDS_H

#include "analysis/base/facts.h"
#include "analysis/memory/variable_facts.h"

enum { BOUNDS_MOST_ENDS = 4 };

/** The least of `low` is not above the value, the greatest of `high` not below it. */
typedef struct value_bounds {
    unsigned low_count, high_count; /* 0: nothing is known */
    bound_term low[BOUNDS_MOST_ENDS], high[BOUNDS_MOST_ENDS];
} value_bounds;

/** What values that the bounds rest on must be: not negative, each of them. */
typedef struct bounds_conditions {
    unsigned count;
    const ir_node *value[BOUNDS_MOST_CONDITIONS];
} bounds_conditions;

/** Of the integer expression `value`, which the function evaluates at `site`, a node of it. Terms
 *  and conditions are nodes of the function's text: parameters that it never writes, and what it
 *  reads through them, which are to have one value from the function's begin on. False: there are
 *  none at one end. */
bool value_bounds_of(variable_facts *facts, const ir_function *function, const ir_node *value,
                     const ir_node *site, value_bounds *bounds, bounds_conditions *conditions);

/** Is this one of the terms already? */
bool element_bounds_has(const element_bounds *bounds, bound_term term);

#endif
