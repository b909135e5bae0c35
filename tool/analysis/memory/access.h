/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a piece of program touches: a list of accesses in the order of evaluation, calls replaced by
 * what their functions access (summaries, one a function, made once).
 */
#ifndef ANALYSIS_ACCESS_H
#define ANALYSIS_ACCESS_H

#include "analysis/base/update_form.h"
#include "analysis/memory/location.h"

typedef enum access_kind { ACCESS_READ, ACCESS_WRITE, ACCESS_UPDATE } access_kind;

typedef struct access {
    access_kind kind;
    const ir_node *lvalue; /* in the terms of the function looked at; NULL: any memory at all */
    bool is_exact; /* lvalue can be spelled before the statement, and its bytes are all that is
                      accessed; else only what it hangs on is known */
    const ir_type *type; /* of the values accessed */
    bool is_presumed;    /* by the user's word it is apart from what the loop accumulates */
    bool is_conditional; /* not executed each time the piece is */
    bool is_behind;      /* a condition of the callee's decides whether it is made; with
                            loops, for some of their turns */
    unsigned loop_count; /* of the callee's loops: the lvalue stands for an element for each turn */
    const source_loop *loops;  /* outermost first. Bounds and lvalue can be computed in all turns
                                  whenever the call is executed */
    const ir_node *node;       /* the expression: access, or call */
    const ir_function *callee; /* the access is the callee's; NULL: in the text itself */
    update_form form;          /* ACCESS_UPDATE in the text itself */
    const ir_node *from; /* a search through a[from], a[from + 1], ... up to the element whose */
    const ir_node *to;   /* subscript is the call's result: the first and the last one read */
    const element_bounds *bounds; /* not is_exact: what is accessed is among these; or NULL */
} access;

/** Something met on the way of which nothing may be assumed. */
typedef struct access_problem {
    reason_id why;
    const ir_node *node;
    const char *name;
} access_problem;

typedef struct access_list {
    VECTOR(access) items;
    VECTOR(access_problem) problems;
    bool has_floating_work;     /* floating-point arithmetic is done, here or in callees */
    bool has_unrepeatable_work; /* a call whose value another call may not give, bit for bit: of a
                                   function without a body, or that approximates */
    bool may_set_errno;         /* a mathematical function is called that sets it */
    const char *errno_setter;
    VECTOR(const ir_node *) ends; /* calls of functions that may end the program by an assertion */
} access_list;

typedef struct effects effects; /* all summaries of one unit */

effects *effects_new(arena *a, const ir_unit *unit, const analysis_options *options,
                     variable_facts *facts);

/** Appends all that executing `node` (statement or expression) once touches. */
void access_collect(effects *all, const ir_node *node, access_list *list);

/** A function's summary: accesses to what is not its own, over its parameters and globals. */
const access_list *effects_of(effects *all, const ir_function *function);

/** The part of an lvalue whose address tells where all of it lies: trailing subscripts that are
 *  proved to stay inside their array types are left off. */
const ir_node *access_row(const ir_node *lvalue);

/** The same for what is only read, where it may be all of an array: the bytes that are read lie in
 *  it, whatever the values of the subscripts left off. */
const ir_node *access_extent(const ir_node *lvalue);

#endif
