/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Memory accesses of a piece of program: a list in the order of evaluation. Calls are replaced by
 * the accesses of their functions (summaries, computed once per function).
 */
#ifndef ANALYSIS_ACCESS_H
#define ANALYSIS_ACCESS_H

#include "analysis/base/update_form.h"
#include "analysis/memory/location.h"

typedef enum access_kind { ACCESS_READ, ACCESS_WRITE, ACCESS_UPDATE } access_kind;

typedef struct access {
    access_kind kind;
    const ir_node *lvalue; /* in the terms of the analysed function; NULL: any memory */
    bool is_exact; /* lvalue can be spelled before the statement, and its bytes are all that is
                    * accessed; else only its base is known */
    const ir_type *type; /* of the values accessed */
    bool is_presumed; /* the user, or another file's analysis, asserts that it is disjoint from the
                       * arrays that the loop accumulates into */
    bool is_conditional; /* not executed each time the piece is */
    bool is_behind;      /* a condition of the callee decides whether it is made or, with loops, in
                          * which of their iterations */
    unsigned loop_count; /* of the callee's loops: the lvalue denotes one element per iteration */
    const source_loop *loops;  /* outermost first. Bounds and lvalue can be computed in all
                                * iterations whenever the call is executed */
    const ir_node *node;       /* the expression: access, or call */
    const ir_function *callee; /* the function that makes the access; NULL: the text itself */
    update_form form;          /* ACCESS_UPDATE in the text itself */
    const ir_node *from; /* of a search (search.h): the first element that it reads; NULL: none */
    const ir_node *to;   /* of a search: the last one, whose subscript is the call's result */
    const element_bounds *bounds; /* not is_exact: the accessed elements are among these; or NULL */
} access;

/** A construct that prevents any assumption. */
typedef struct access_problem {
    reason_id why;
    const ir_node *node;
    const char *name;
} access_problem;

typedef struct access_list {
    VECTOR(access) items;
    VECTOR(access_problem) problems;
    bool has_floating_work;     /* floating-point arithmetic is done, here or in callees */
    bool has_unrepeatable_work; /* a call that a second call may not reproduce bit for bit: its
                                 * function has no body here, approximates, or has attributes */
    bool may_set_errno;         /* a mathematical function that sets errno is called */
    const char *errno_setter;
    VECTOR(const ir_node *)
    ends; /* assertions in a called function, or calls of functions that
           * may end the program by an assertion */
} access_list;

typedef struct effects effects; /* the summaries of all functions of a unit */

effects *effects_new(arena *a, const ir_unit *unit, const analysis_options *options,
                     variable_facts *facts);

/** Appends all accesses of executing `node` (statement or expression) once. */
void access_collect(effects *all, const ir_node *node, access_list *list);

/** The same for a call. If its function has problems, those of its accesses are added that are
 * single elements which the caller can name. */
void access_collect_known(effects *all, const ir_node *call, access_list *list);

/** A function's summary: accesses other than to local variables, in terms of its parameters and
 *  globals; with problems, not all of them. NULL: the function is recursive. */
const access_list *effects_of(effects *all, const ir_function *function);

/** The part of an lvalue whose address determines the range of all of it: trailing subscripts that
 *  are proved to stay inside their array types are dropped. */
const ir_node *access_row(const ir_node *lvalue);

/** The same for reads, possibly the whole array: it contains the bytes read, for any values of the
 *  dropped subscripts. */
const ir_node *access_extent(const ir_node *lvalue);

#endif
