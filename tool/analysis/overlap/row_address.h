/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the address of an lvalue as a sum: base + offset + bytes * subscript + ... */
#ifndef ANALYSIS_ROW_ADDRESS_H
#define ANALYSIS_ROW_ADDRESS_H

#include "ir/ir.h"

enum { ROW_MOST_TERMS = 8 };

typedef struct row_term {
    const ir_node *subscript; /* of an integer type */
    int64_t bytes;            /* number of bytes by which the address changes if the subscript
                               * increases by 1; negative for p - subscript */
} row_term;

typedef struct row_address {
    const ir_node *base; /* the first term: a pointer, or an object whose address is meant */
    bool base_is_object; /* the base is an object */
    int64_t offset;      /* in bytes, from members */
    unsigned term_count;
    row_term terms[ROW_MOST_TERMS];
} row_address;

/** Fills in *address. Returns false if the lvalue has another form, a size is not constant, or
 *  there are too many terms. */
bool row_address_of(const ir_node *row, row_address *address);

#endif
