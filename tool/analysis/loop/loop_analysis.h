/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Known facts about the unit as a whole, and about the analysed loop. */
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
    const openmp_loop *openmp; /* the analysed loop's directives; NULL: none */
    bool keeps_own;            /* variables may replace own elements (own.h) */
} analyser;

/** The classification of an access of the loop. */
typedef enum access_class {
    CLASS_OPEN,      /* not decided */
    CLASS_SCALAR,    /* of a private, stepped or unchanging variable; a store to an own element */
    CLASS_REDUCTION, /* an update of the array number `array` */
    CLASS_SELF,      /* a read, in an update's statement, of the updated element; all accesses to a
                      * scalar that the loop accumulates into */
    CLASS_FORWARDED, /* a read of a value that the iteration has stored, or of an own element */
    CLASS_SHARED     /* a read of memory that other iterations may read, too */
} access_class;

typedef struct loop_access {
    access access;
    location where;
    access_class class;
    unsigned array;        /* CLASS_REDUCTION */
    reduction_operator op; /* CLASS_REDUCTION */
    bool needs_guard;      /* CLASS_SHARED: may overlap an array, according to the analysis; or
                            * is_scalar */
    bool is_scalar;     /* CLASS_SELF: an update of a scalar whose is_guarded is set; or the first
                         * read of an own element whose is_guarded is set */
    bool meets_scalars; /* CLASS_SHARED: may overlap one of these */
    bool meets_arrays;  /* CLASS_SHARED: may overlap an array; else needs_guard for a scalar */
} loop_access;

typedef struct loop_array {
    reduction_array array;
    location where; /* of its first update */
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

/** Statements of the loop that are replaced while it is analysed. */
typedef struct left_out {
    const distribution *distribution; /* NULL: none */
    const loop_exits *exits;          /* as in loop_slice */
} left_out;

/** Facts about the analysed loop. A check gets it as const, with the results of earlier checks, and
 *  returns its own result. If the result's `why` is not REASON_NONE, the rest of it is invalid.
 *  verdict.c combines the results. A check that adds facts in several steps works on a copy. */
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

/** A copy whose accesses and lists may be changed and extended, while `known` is unchanged. */
loop_analysis analysis_copy(const loop_analysis *known);

/** A hash of the known facts, with all accesses and list items. 0 if NDEBUG is defined. */
uint64_t analysis_fingerprint(const loop_analysis *known);

/** Asserts that a check has not changed its input: `before` is the fingerprint before the check.
 *  Checks nothing if NDEBUG is defined. */
void analysis_assert_unchanged(const loop_analysis *known, uint64_t before);

/** The reason why the loop cannot be transformed, at this node; NULL: the loop itself. `name` is
 *  that of the cause. If the message names the loop (reasons.def), it is that of the counter; NULL:
 *  not known. */
reason analysis_reason(const loop_analysis *j, reason_id why, const ir_node *node,
                       const char *name);

/** Sets the reason in a check's own copy, if none is set yet. Returns false. */
bool analysis_refuse(loop_analysis *own, reason_id why, const ir_node *node, const char *name);

/** Does anything below `node` use an address in the array with this base as a value, as in `h == p`
 *  or `&h[i] - q`? Passing it to a function does not count: the function's accesses are analysed.
 */
bool has_address_as_value(const ir_node *node, const ir_node *base);

/** Does the loop's text declare the variable? */
bool analysis_declares(const loop_analysis *j, const ir_variable *variable);

/** The loop_start of a variable other than the counter; NULL: the loop's header does not set it. */
const loop_start *analysis_start_of(const loop_analysis *j, const ir_variable *variable);
/** Is it declared in the header, with a type with which a copy can be declared elsewhere? */
bool analysis_header_declares(const loop_analysis *j, const ir_variable *variable);

/** Is it a local variable that changes only by its name, and not in the loop? */
bool analysis_is_unchanged(const loop_analysis *j, const ir_node *node);
/** Is it a number, or such a variable? */
bool analysis_is_fixed(const loop_analysis *j, const ir_node *node);

/** Is this statement one of the updates found? */
bool analysis_is_update(const loop_analysis *j, const ir_node *statement);

/** A name for messages: the text of the lvalue's base, or its root variable. */
const char *analysis_name(const loop_analysis *j, const ir_node *lvalue);

#endif
