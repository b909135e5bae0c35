/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The memory of an lvalue: a named object or a pointer's target, followed by fields and subscripts.
 * Local pointers are looked through if they are assigned once and otherwise only stepped, or if
 * they only point into one local array.
 */
#ifndef ANALYSIS_LOCATION_H
#define ANALYSIS_LOCATION_H

#include "analysis/memory/variable_facts.h"

typedef struct location_step {
    const ir_field *field; /* NULL: a subscript */
    const ir_record *record;
    const ir_node *subscript; /* NULL: not known, or moved by pointer arithmetic */
} location_step;

typedef struct location {
    const ir_variable *object; /* the named object, or NULL */
    const ir_node *pointer; /* else its base pointer, looked through as far as possible; NULL too:
                             * unknown */
    const ir_node *base;    /* lvalue in the source: the array or pointer under the first subscript,
                             * field or dereference after the last pointer read; NULL: unknown */
    const ir_type *type;    /* type of the access */
    unsigned step_count;
    location_step steps[8];
    bool is_inexact;   /* steps end before the unknown part: more steps, casts */
    bool is_punned;    /* a cast to another pointer type lies between */
    bool is_of_locale; /* a table of the C library that classifies characters, which the program
                        * reads */
    bool is_string;    /* a string literal: no written memory can overlap it */
    bool has_union, has_bit_field;
} location;

/** `scope`: a local pointer defined outside of this loop (NULL: of no loop) is looked through to
 *  determine the memory, but `base` stays the pointer itself. */
location location_of(variable_facts *facts, const ir_node *lvalue, const ir_node *scope);

#endif
