/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The memory that an lvalue denotes: a named object or a pointer's target, followed by fields and
 *  subscripts. A local pointer is replaced by its value if it is assigned once and otherwise only
 *  stepped, or if it only points into one local array. */
#ifndef ANALYSIS_LOCATION_H
#define ANALYSIS_LOCATION_H

#include "analysis/memory/variable_facts.h"

typedef struct location_step {
    const ir_field *field; /* NULL if the step is a subscript */
    const ir_record *record;
    const ir_node *subscript; /* NULL if it is unknown, or changed by pointer arithmetic */
} location_step;

typedef struct location {
    const ir_variable *object; /* the named object; NULL if the memory is reached through a
                                * pointer, or unknown */
    const ir_node *pointer;    /* if there is no object: the base pointer, replaced by its value as
                                * far as possible; NULL if unknown */
    const ir_node *base;       /* the lvalue in the source from which the address is computed
                                * without loading a further pointer: an object, or the last pointer
                                * that is loaded; NULL if unknown */
    const ir_type *type;       /* type of the accessed value */
    unsigned step_count;
    location_step steps[8];
    bool is_inexact;   /* the steps are incomplete: they end before an unknown part, such as
                        * further steps or casts */
    bool is_punned;    /* a cast to another pointer type occurs on the way */
    bool is_of_locale; /* a table of the C library that classifies characters; the program only
                        * reads it */
    bool is_string;    /* a string literal, which no written memory overlaps */
    bool has_union, has_bit_field;
} location;

/** Computes the location of an lvalue. A local pointer that is defined outside of the loop `scope`
 *  is replaced by its value to determine the memory, but `base` remains the pointer. If `scope` is
 *  NULL, no pointer counts as defined outside. */
location location_of(variable_facts *facts, const ir_node *lvalue, const ir_node *scope);

#endif
