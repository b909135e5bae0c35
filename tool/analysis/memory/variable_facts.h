/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Facts about each variable of a unit that do not depend on a loop: its occurrences, how often it
 *  is assigned, and whether its address is stored. */
#ifndef ANALYSIS_VARIABLE_FACTS_H
#define ANALYSIS_VARIABLE_FACTS_H

#include "analysis/memory/must_write/must_write.h"
#include "ir/ir.h"
#include "support/vector.h"

typedef struct variable_fact {
    /* IR_VARIABLE nodes that name it, in the order of the text */
    VECTOR(const ir_node *) occurrences;
    VECTOR(const ir_node *)
    writes;               /* nodes that initialise the variable, assign it or a part of it, take its
                           * address, or pass an array in it to a function; in the order of the
                           * text */
    unsigned write_count; /* number of assignments and increments of the whole variable, and of
                           * initialisers; taking its address does not count */
    unsigned step_count;  /* how many of these are steps (p++, p += e and the like) */
    const ir_node *definition;       /* the value of the last assignment or initialiser; NULL if
                                      * that is not a plain `=` */
    const ir_node *definition_place; /* the node of the last assignment, whatever its form */
    const ir_node *start;            /* the value of the last assignment that is no step */
    const ir_node *declarator;
    enum { EXPOSURE_NOT_ASKED, EXPOSURE_YES, EXPOSURE_NO } exposure;
    enum { ESCAPE_NOT_ASKED, ESCAPE_IN_PROGRESS, ESCAPE_YES, ESCAPE_NO } escape;
    enum { RESTRICTED_NOT_ASKED, RESTRICTED_YES, RESTRICTED_NO } restricted;
} variable_fact;

typedef struct variable_facts variable_facts;

variable_facts *variable_facts_new(arena *a, const ir_unit *unit, must_write *prover);

const ir_unit *variable_facts_unit(const variable_facts *facts);

/** The facts about one variable. They are complete for locals and parameters; for other variables
 *  they cover only this file. */
const variable_fact *variable_fact_of(variable_facts *facts, const ir_variable *variable);

/** May a pointer to this local variable or parameter exist, or have existed, that the analysis
 *  cannot follow? True for all other variables. */
bool variable_escapes(variable_facts *facts, const ir_variable *variable);

/** Does the program create any pointer to the variable or into it, by & or by using an array in it
 *  as a pointer? An array directly under a subscript or * does not count; one passed as an argument
 *  does. */
bool variable_is_exposed(variable_facts *facts, const ir_variable *variable);

/** Does `node`, or a node below it, initialise the variable, assign it or a part of it, take its
 *  address by &, or pass an array in it to a function? If the variable's address escapes
 *  (variable_escapes), the variable may also change in other ways. */
bool variable_written_in(variable_facts *facts, const ir_node *node, const ir_variable *variable);
/** Same as variable_written_in, but a call that receives &v and only reads through it, according to
 *  the callee's body, does not count. */
bool variable_may_change_in(variable_facts *facts, const ir_node *node,
                            const ir_variable *variable);

/** Does the function hold a label, a goto or an opaque node, so that control may reach a node by
 *  other ways than its text shows? Asked often, and answered by one walk for each function. */
bool variable_facts_has_jump(variable_facts *facts, const ir_function *function);

/** The greatest node id in the tree below `node`. Ids are in preorder, so the subtree has exactly
 *  the ids from node->id to this one. */
unsigned expression_last_id(const ir_node *node);

/** The value of a local variable that is assigned only once, by an initialiser or a plain `=`, and
 *  whose address is not taken (unless it is an array). Otherwise NULL. */
const ir_node *variable_single_definition(variable_facts *facts, const ir_variable *variable);

/** The first value of a local pointer that is set once and otherwise only stepped, all inside
 *  `scope`. NULL if it is no such pointer. */
const ir_node *variable_walk_start(variable_facts *facts, const ir_variable *variable,
                                   const ir_node *scope);

/** The node that names the only local array into which a local pointer points. The pointer's
 *  address must not be taken; it may only be stepped, and set to elements of the array or to null.
 *  NULL if it is no such pointer. */
const ir_node *variable_walked_array(variable_facts *facts, const ir_variable *pointer);

/** Is the variable a restrict pointer whose value is used only for accesses through it, and for
 *  calls of functions that do not store it? If so, memory that is accessed through it and written
 *  is reached through no other pointer. */
bool variable_is_restricted(variable_facts *facts, const ir_variable *variable);

#endif
