/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which memory an lvalue is: a named object or what a pointer points to, and the fields and
 * subscripts from there. Local pointers that are assigned once are looked through.
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
    const ir_node *pointer; /* else the pointer it hangs on, looked through as far as possible; NULL
                               too: unknown */
    const ir_node *base;    /* lvalue in the source: the array or pointer under the first subscript,
                               field or dereference after the last pointer read; NULL: unknown */
    const ir_type *type;    /* what is accessed */
    unsigned step_count;
    location_step steps[8];
    bool is_inexact;   /* steps end where the rest is not known: more steps, casts */
    bool is_punned;    /* a cast to another pointer type lies between */
    bool is_of_locale; /* a table of the C library that classifies characters: the program reads it
                        */
    bool is_string;    /* a string literal: nothing can overlap it that is written */
    bool has_union, has_bit_field;
} location;

/** `scope`: a local pointer defined outside this loop (NULL: nothing is outside) is looked through
 *  to know the memory, but `base` stays the pointer itself. */
location location_of(variable_facts *facts, const ir_node *lvalue, const ir_node *scope);

/** Where a pointer's value points to. */
location location_pointed(variable_facts *facts, const ir_node *pointer, const ir_node *scope);

#endif
