/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The data of the analysis: about the unit as a whole (analyser), and about the loop that is being
 *  analysed (loop_analysis). */
#ifndef ANALYSIS_LOOP_ANALYSIS_H
#define ANALYSIS_LOOP_ANALYSIS_H

#include "analysis/base/counted.h"
#include "analysis/base/facts.h"
#include "analysis/base/openmp_loop.h"
#include "analysis/base/unit_text.h"
#include "analysis/memory/access.h"
#include "analysis/memory/alias.h"

typedef struct analyser {
    arena *memory;
    const ir_unit *unit;
    const analysis_options *options;
    must_write *prover;
    variable_facts *facts;
    effects *effects;
    alias_rules rules;
    unit_text *text;
    const user_pragmas *pragmas;
    const openmp_loop *openmp; /* OpenMP directives of the analysed loop; NULL if it has none */
    bool keeps_own;            /* own elements may be replaced by variables (own.h) */
} analyser;

/** The classification of an access of the loop. */
typedef enum access_class {
    CLASS_OPEN,      /* not classified yet */
    CLASS_SCALAR,    /* an access to a private, stepped or unchanged variable; or a store to an
                      * own element */
    CLASS_REDUCTION, /* an update of an element of arrays[array] */
    CLASS_SELF,      /* a read of the updated element in the update's own statement; or any access
                      * to a scalar that the loop accumulates into */
    CLASS_FORWARDED, /* a read of a value that the same iteration has stored, or of an own
                      * element */
    CLASS_SHARED     /* a read of memory that other iterations may read too */
} access_class;

typedef struct loop_access {
    access access;
    location where;
    access_class class;
    unsigned array;        /* for CLASS_REDUCTION: index in loop_analysis.arrays */
    reduction_operator op; /* for CLASS_REDUCTION */
    bool needs_guard;      /* for CLASS_SHARED: it may overlap an array, as far as the analysis
                            * can tell, or an access for which is_scalar is set */
    bool is_scalar;        /* the access is an update of a scalar (CLASS_SELF) or the first read of
                            * an own element, and is_guarded is set for this scalar or element */
    bool meets_scalars;    /* for CLASS_SHARED: it may overlap an access for which is_scalar is
                            * set */
    bool meets_arrays; /* for CLASS_SHARED: it may overlap an array. If false, needs_guard is set
                        * only because of meets_scalars */
} loop_access;

typedef struct loop_array {
    reduction_array array;
    location where; /* location of its first update */
    const ir_node *first;
} loop_array;

typedef VECTOR(loop_array) array_list;
typedef VECTOR(reduction_update) update_list;
typedef VECTOR(scalar_update) scalar_list;
typedef VECTOR(forwarded_store) forward_list;
typedef VECTOR(private_variable) private_list;
typedef VECTOR(own_element) own_list;
typedef VECTOR(ir_variable *) variable_list;
typedef VECTOR(loop_source) source_list;
typedef VECTOR(const ir_node *) key_list;

/** Statements of the loop that are removed or replaced while the loop is analysed. */
typedef struct left_out {
    const distribution *distribution; /* NULL if there is none */
    const loop_exits *exits;          /* as in loop_slice */
} left_out;

/** The facts about the analysed loop. A check receives them as const, including the results of
 *  earlier checks, and returns a separate result. If the result's `why` is not REASON_NONE, the
 *  rest of the result is invalid. verdict.c combines the results. A check that adds facts in
 *  several steps works on a copy. */
typedef struct loop_analysis {
    const analyser *an;
    ir_function *function;
    ir_node *loop;
    counted_loop counted;
    access_list found;
    unsigned access_count;
    loop_access *accesses;
    array_list arrays;
    update_list updates;
    scalar_list scalars;
    forward_list forwards;
    left_out left_out;
    private_list privates;
    own_list own;
    variable_list captured;
    source_list sources;
    key_list key;
    loop_slice slice;
    bool counter_is_live_after;
    reason why;
} loop_analysis;

/** A copy whose accesses and lists can be changed and extended without changing `known`. */
loop_analysis analysis_copy(const loop_analysis *known);

/** A hash of the facts with all accesses and list items. Returns 0 if NDEBUG is defined. */
uint64_t analysis_fingerprint(const loop_analysis *known);

/** Asserts that a check has not changed its input, whose fingerprint was `before`. Does nothing if
 *  NDEBUG is defined. */
void analysis_assert_unchanged(const loop_analysis *known, uint64_t before);

/** Creates the reason for which the loop cannot be transformed. It is located at `node`; NULL means
 *  the loop. `name` names the cause. If the reason's message names the loop (reasons.def), `name`
 *  is the counter's name, or NULL if unknown. */
reason analysis_reason(const loop_analysis *j, reason_id why, const ir_node *node,
                       const char *name);

/** The loop's name in a message: by its counter, or by its line if the counter is unknown. */
const char *analysis_loop_text(const analyser *an, ir_node *loop);

/** Sets the reason in `own`, a check's own copy, unless one is set already. Returns false. */
bool analysis_refuse(loop_analysis *own, reason_id why, const ir_node *node, const char *name);

/** analysis_refuse for a read of an updated array (REASON_ARRAY_READ). The advice depends on
 * whether the iteration updates a record of its own, as a particle that is moved and then
 * deposited. */
bool analysis_refuse_read(loop_analysis *own, const loop_array *array, const ir_node *read);

/** Does `node`, or a node below it, use an address inside the array with this base as a value, as
 *  in `h == p` or `&h[i] - q`? Passing it to a function does not count, because the function's
 *  accesses are analysed. */
bool has_address_as_value(const ir_node *node, const ir_node *base);

/** Does the loop's text declare the variable? */
bool analysis_declares(const loop_analysis *j, const ir_variable *variable);

/** The loop_start of a variable other than the counter; NULL if the loop's header does not set the
 *  variable. */
const loop_start *analysis_start_of(const loop_analysis *j, const ir_variable *variable);
/** Does the loop's header declare the variable, with a type that C can spell, so that a copy can be
 *  declared elsewhere? */
bool analysis_header_declares(const loop_analysis *j, const ir_variable *variable);

/** Is `node` a local variable other than the counter that the loop does not write? Its address must
 *  not be taken. */
bool analysis_is_unchanged(const loop_analysis *j, const ir_node *node);
/** Is `node` a number, or a variable for which analysis_is_unchanged is true? */
bool analysis_is_fixed(const loop_analysis *j, const ir_node *node);

/** Is the statement one of the updates found? */
bool analysis_is_update(const loop_analysis *j, const ir_node *statement);

/** A name for messages: the text of the lvalue's base, the name of its root variable, or its own
 *  text. */
const char *analysis_name(const loop_analysis *j, const ir_node *lvalue);

#endif
