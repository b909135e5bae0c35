/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Values that are read before the guard has compared the loop's reads with its writes. They may
 * differ from those of the sequential loop: they are unverified. The body reads such values in
 * in-order binning, where it may be executed more than once, and the slice in an inspection.
 *
 * Why it is sound to compute with them: if reads and writes turn out to overlap, all results are
 * discarded and the sequential loop runs. Until that is known, the computation must not fail. So no
 * address, integer division or trip count of an inner loop may depend on an unverified value; nor
 * may an unverified value decide whether an expression is evaluated that may fail.
 *
 * Variables are marked, not values: a pass over the body marks each variable that may hold an
 * unverified value, until a pass marks nothing new.
 */
#ifndef PLAN_UNVERIFIED_H
#define PLAN_UNVERIFIED_H

#include "plan/plan.h"
#include "support/vector.h"

typedef struct unverified_reads {
    const loop_plan *plan;
    const bool *is_suspect; /* by source: its contents may be unverified */
    bool *is_unverified;    /* by variable: it may hold an unverified value */
    bool changed;           /* this pass has marked a variable */
    bool is_harmful;        /* the result */
    bool in_callee;         /* the body of a called function is being checked */
    bool is_typed;          /* in_callee: only memory of the sources' types is unverified,
                             * not all memory */
    bool in_slice;          /* the slice is being checked: all its reads are sources */
    bool may_have_left;     /* under an unverified condition, a preceding jump may have left
                             * the iteration */
    unsigned depth;         /* of calls */
    VECTOR(const ir_node *) certain; /* expressions that each iteration evaluates */
} unverified_reads;

/** The control flow into a node. */
typedef struct control {
    bool is_unverified; /* it depends on unverified values */
    bool is_certain;    /* each iteration reaches the node */
} control;

/** By source: may it overlap the loop's writes, according to the analysis? */
bool *guarded_sources(const loop_plan *plan);

/** Is any source marked? */
bool unverified_has_suspects(const loop_plan *plan, const bool *is_suspect);

/** Marks the variables of the body that may hold unverified values, given that reads of the suspect
 *  sources are unverified. `in_slice`: only the slice is evaluated. */
unverified_reads unverified_begin(const loop_plan *plan, const bool *is_suspect, bool in_slice);

/** The control flow into the first statement of an iteration. */
control unverified_in_iteration(const loop_plan *plan);
/** The control flow into a part of a node; `first`: the part is evaluated whenever the node is. */
control unverified_below(const unverified_reads *s, const ir_node *node, control how, bool first);

/** Does the value of an expression depend on unverified values? Do they decide which parts of a
 *  statement are executed? */
bool unverified_value(const unverified_reads *s, const ir_node *node);
bool unverified_condition(const unverified_reads *s, const ir_node *node);

/** Sets is_harmful if evaluating the node with unverified values may be harmful. */
void unverified_check(unverified_reads *s, const ir_node *node, control how);

/** May the body be executed before its reads are compared with its writes? */
bool is_harmless_when_unverified(const loop_plan *plan);

#endif
