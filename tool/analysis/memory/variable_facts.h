/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Facts about each variable of a unit, independent of loops: its occurrences, the number of its
 *  assignments, whether its address is stored. */
#ifndef ANALYSIS_VARIABLE_FACTS_H
#define ANALYSIS_VARIABLE_FACTS_H

#include "analysis/memory/must_write/must_write.h"
#include "ir/ir.h"
#include "support/vector.h"

typedef struct variable_fact {
    VECTOR(const ir_node *) occurrences; /* IR_VARIABLE nodes, in text order */
    VECTOR(const ir_node *)
    writes;               /* nodes that assign it, take its address, or pass it, or an
                           * array in it, to a function; in text order */
    unsigned write_count; /* assignments, increments, initialisers; address-taking not counted */
    unsigned step_count;  /* of them, p++, p += e and the like */
    const ir_node *definition;       /* the value of the last assignment, if it is a plain `=` */
    const ir_node *definition_place; /* the node of the last assignment, of any form */
    const ir_node *start;            /* the value of the last assignment that is no step */
    const ir_node *declarator;
    enum { EXPOSURE_NOT_ASKED, EXPOSURE_YES, EXPOSURE_NO } exposure;
    enum { ESCAPE_NOT_ASKED, ESCAPE_IN_PROGRESS, ESCAPE_YES, ESCAPE_NO } escape;
    enum { RESTRICTED_NOT_ASKED, RESTRICTED_YES, RESTRICTED_NO } restricted;
} variable_fact;

typedef struct variable_facts variable_facts;

variable_facts *variable_facts_new(arena *a, const ir_unit *unit, must_write *prover);

const ir_unit *variable_facts_unit(const variable_facts *facts);

/** Facts about one variable; complete for locals and parameters, otherwise limited to this file. */
const variable_fact *variable_fact_of(variable_facts *facts, const ir_variable *variable);

/** May there be, or have been, a pointer to this local variable or parameter whose uses the
 *  analysis does not all see? True for all other variables. */
bool variable_escapes(variable_facts *facts, const ir_variable *variable);

/** Is there any pointer to it or into it: by &, or because it is an array used as a pointer (other
 *  than directly under a subscript or *), also as an argument? */
bool variable_is_exposed(variable_facts *facts, const ir_variable *variable);

/** Does anything below `node` assign the variable, take its address by &, or pass an array of it to
 *  a function? A variable whose address escapes may also change otherwise. */
bool variable_written_in(variable_facts *facts, const ir_node *node, const ir_variable *variable);
/** The same, but a call that gets &v and only reads through it, according to the callee's body,
 *  does not count. */
bool variable_may_change_in(variable_facts *facts, const ir_node *node,
                            const ir_variable *variable);

/** The highest node id below `node` (ids are in preorder: [node->id, last] is the subtree). */
unsigned expression_last_id(const ir_node *node);

/** The value of a local variable that is assigned only once, by an initialiser or a plain `=`, and
 *  whose address is not taken unless it is an array; NULL otherwise. */
const ir_node *variable_single_definition(variable_facts *facts, const ir_variable *variable);

/** The first value of a local pointer whose other assignments are all steps, if the first one and
 * the steps are inside `scope`; NULL: it is no such pointer. */
const ir_node *variable_walk_start(variable_facts *facts, const ir_variable *variable,
                                   const ir_node *scope);

/** The node of the only local array into which a local pointer points: the pointer's address is not
 *  taken, and it is only set to elements of the array or to null, and stepped. NULL: it is no such
 *  pointer. */
const ir_node *variable_walked_array(variable_facts *facts, const ir_variable *pointer);

/** Is it a restrict pointer whose value is used only for accesses through it and for calls of
 *  functions that do not store it? Then no other pointer reaches its target, if that is written. */
bool variable_is_restricted(variable_facts *facts, const ir_variable *variable);

#endif
