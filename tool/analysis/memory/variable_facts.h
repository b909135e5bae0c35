/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a unit does with each variable, whatever the loop: where it occurs, how often it is
 *  assigned, whether its address is kept. */
#ifndef ANALYSIS_VARIABLE_FACTS_H
#define ANALYSIS_VARIABLE_FACTS_H

#include "analysis/memory/must_write/must_write.h"
#include "ir/ir.h"
#include "support/vector.h"

typedef struct variable_fact {
    VECTOR(const ir_node *) occurrences; /* IR_VARIABLE nodes, in text order */
    VECTOR(const ir_node *) writes; /* whatever assigns it or takes its address, in text order */
    unsigned write_count; /* assignments, increments, initialisers; address-taking not counted */
    const ir_node *definition;       /* the value of the last one found, where it is a plain `=` */
    const ir_node *definition_place; /* the declarator or IR_ASSIGN of it */
    const ir_node *declarator;
    enum { EXPOSURE_NOT_ASKED, EXPOSURE_YES, EXPOSURE_NO } exposure;
    enum { ESCAPE_NOT_ASKED, ESCAPE_IN_PROGRESS, ESCAPE_YES, ESCAPE_NO } escape;
    enum { RESTRICTED_NOT_ASKED, RESTRICTED_YES, RESTRICTED_NO } restricted;
} variable_fact;

typedef struct variable_facts variable_facts;

variable_facts *variable_facts_new(arena *a, const ir_unit *unit, must_write *prover);

const ir_unit *variable_facts_unit(const variable_facts *facts);

/** Facts of one variable; of locals and parameters complete, of others as far as this file goes. */
const variable_fact *variable_fact_of(variable_facts *facts, const ir_variable *variable);

/** May there be, or once have been, a pointer to this local variable or parameter that the analysis
 *  does not see at each of its uses? True for everything that is not local. */
bool variable_escapes(variable_facts *facts, const ir_variable *variable);

/** Is there any pointer to it or into it at all: by &, or because it is an array used as a pointer
 *  (under a subscript or * right there it is none), also as an argument? */
bool variable_is_exposed(variable_facts *facts, const ir_variable *variable);

/** Does anything below `node` assign the variable or take its address by &? Of variables whose
 *  addresses escape it may be changed without that. */
bool variable_written_in(variable_facts *facts, const ir_node *node, const ir_variable *variable);
/** The same, but that a call which gets &v and only reads there, by the callee's body, is no
 * change. */
bool variable_may_change_in(variable_facts *facts, const ir_node *node,
                            const ir_variable *variable);

/** The highest node id below `node` (ids are in preorder: [node->id, last] is the subtree). */
unsigned expression_last_id(const ir_node *node);

/** The value of a local pointer or scalar that is assigned once only, by a plain initialiser or
 *  assignment; NULL otherwise. */
const ir_node *variable_single_definition(variable_facts *facts, const ir_variable *variable);

/** Is it a restrict pointer whose value flows nowhere but into accesses through it and into calls
 *  of functions that do not keep it? Then nothing else reaches what it points to, where that is
 *  written. */
bool variable_is_restricted(variable_facts *facts, const ir_variable *variable);

#endif
