/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Values that are read before the guard has compared the loop's reads with its writes. They may
 * differ from those of the sequential loop: they are unverified. The body reads such values in
 * in-order binning, where it may be executed more than once, and the slice in an inspection.
 *
 * Which code may compute with them: unverified_uses.h.
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
    const bool *is_suspect; /* per facts->sources[i]: its contents may be unverified */
    bool *is_unverified;    /* indexed by variable: it may hold an unverified value */
    bool changed;           /* this pass has marked a variable */
    bool is_harmful;        /* result of unverified_check (unverified_uses.h) */
    bool in_callee;         /* the body of a called function is being checked */
    bool is_typed;          /* if in_callee: only memory of the sources' types is unverified, not
                             * all memory */
    bool in_slice;          /* the slice is being checked: all its reads are sources */
    bool may_have_left;     /* under an unverified condition, a preceding jump may have left
                             * the iteration */
    unsigned depth;         /* nesting depth of calls */
    VECTOR(const ir_node *) certain; /* expressions that each iteration evaluates */
} unverified_reads;

/** For each source: may it overlap the loop's writes, according to the analysis? Indexed as
 * facts->sources. */
bool *guarded_sources(const loop_plan *plan);

/** Is any source marked? */
bool unverified_has_suspects(const loop_plan *plan, const bool *is_suspect);

/** Marks the variables of the body that may hold unverified values, given that reads of the suspect
 *  sources are unverified. `in_slice`: only the slice is evaluated. */
unverified_reads unverified_begin(const loop_plan *plan, const bool *is_suspect, bool in_slice);

/** Like unverified_begin, for the body of the function that the call names. Memory is unverified
 * there (is_typed), and so are parameters with unverified arguments, except for pointers. The call
 * has an argument for each parameter. */
unverified_reads unverified_begin_callee(const unverified_reads *s, const ir_node *call);

/** unverified_value: does the value of the expression depend on unverified values? unverified_part:
 * does the value of one of the expression's parts? unverified_condition: do unverified values
 * decide which parts of the statement are executed? */
bool unverified_value(const unverified_reads *s, const ir_node *node);
bool unverified_part(const unverified_reads *s, const ir_node *node);
bool unverified_condition(const unverified_reads *s, const ir_node *node);

/** May a value of the type be or contain an address? True for NULL. */
bool may_hold_address(const ir_type *type);

#endif
