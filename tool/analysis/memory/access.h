/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Lists the memory accesses of a piece of a program in the order of evaluation. A call is replaced
 *  by the accesses of the called function (its summary, which is computed once per function). */
#ifndef ANALYSIS_ACCESS_H
#define ANALYSIS_ACCESS_H

#include "analysis/base/update_form.h"
#include "analysis/memory/location.h"

typedef enum access_kind { ACCESS_READ, ACCESS_WRITE, ACCESS_UPDATE } access_kind;

typedef struct access {
    access_kind kind;
    const ir_node *lvalue; /* the accessed lvalue, expressed by the variables of the analysed
                            * function; NULL if any memory may be accessed */
    bool is_exact; /* the lvalue can be spelled before the statement, and exactly its bytes are
                    * accessed. Otherwise only its base is known */
    const ir_type *type; /* type of the accessed values */
    bool is_presumed;    /* the user, or the analysis of another file, asserts that the access does
                          * not touch the arrays that the loop accumulates into */
    bool is_conditional; /* not made each time the piece of program is executed */
    bool is_behind;      /* a condition in the callee decides whether the access is made, or in
                          * which iterations of `loops` */
    unsigned loop_count; /* number of the callee's loops around it; the lvalue denotes one element
                          * per iteration */
    const source_loop *loops;  /* these loops, the outermost first. Their bounds and the lvalue
                                * can be computed for all iterations whenever the call is
                                * executed */
    const ir_node *node;       /* the expression that makes the access, or the call of a function
                                * that does */
    const ir_function *callee; /* the function that makes the access; NULL if the analysed text
                                * itself does */
    update_form form;          /* for an ACCESS_UPDATE in the analysed text itself */
    const ir_node *from;       /* for a linear search (search.h): the first element that it reads;
                                * otherwise NULL */
    const ir_node *to; /* for a linear search: the last element that it reads, whose subscript
                        * is the call's result */
    const element_bounds *bounds; /* if not is_exact: bounds between which the accessed elements
                                   * lie; NULL if unknown */
} access;

/** A construct that prevents any assumption about the piece of program. */
typedef struct access_problem {
    reason_id why;
    const ir_node *node;
    const char *name;
} access_problem;

typedef VECTOR(access) access_vector;

typedef struct access_list {
    access_vector items;
    VECTOR(access_problem) problems;
    access_vector listed; /* updates by atomic operations, and by called functions with problems.
                           * They serve to find loops to report; some may be missing */
    const char *atomic;   /* name of an atomic operation (atomic_call.h) in the piece or in a called
                           * function; NULL if there is none */
    bool has_floating_work;     /* the piece, or a function it calls, does floating-point
                                 * arithmetic */
    bool has_unrepeatable_work; /* it contains a call that may give other bits when repeated: the
                                 * function has no body here, is an approximation, or has
                                 * attributes */
    bool may_set_errno;         /* it calls a mathematical function that sets errno */
    const char *errno_setter;
    VECTOR(const ir_node *)
    ends; /* assertions in called functions, or calls of functions that may end the program by an
           * assertion */
} access_list;

typedef struct effects effects; /* the summaries of all functions of a unit */

effects *effects_new(arena *a, const ir_unit *unit, const analysis_options *options,
                     variable_facts *facts);

/** Appends all accesses that one execution of `node` (a statement or an expression) makes. */
void access_collect(effects *all, const ir_node *node, access_list *list);

/** Like access_collect, but for an expression of which only reports speak. Appends the updates in
 *  list->listed to list->items. If the node is the call of a function with problems, this also adds
 *  those of the function's other accesses that are single elements and that the caller can name. */
void access_collect_known(effects *all, const ir_node *node, access_list *list);

/** The function's summary: its accesses, other than those of its local variables, expressed by its
 *  parameters and globals. If it has problems, accesses may be missing. NULL if the function is
 *  recursive. */
const access_list *effects_of(effects *all, const ir_function *function);

/** The lvalue without trailing subscripts that are proved to stay inside their array types. The
 *  result is never a whole variable or a field of one, unless `lvalue` is. */
const ir_node *access_row(const ir_node *lvalue);

/** Same as access_row, but the result may also be a whole array variable. It contains the bytes
 *  that are read, whatever the dropped subscripts are. */
const ir_node *access_extent(const ir_node *lvalue);

#endif
