/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The address of an lvalue as a sum: base + offset + bytes * subscript + ... */
#ifndef ANALYSIS_ROW_ADDRESS_H
#define ANALYSIS_ROW_ADDRESS_H

#include "ir/ir.h"

enum { ROW_MOST_TERMS = 8 };

typedef struct row_term {
    const ir_node *subscript; /* an integer */
    int64_t bytes;            /* bytes per unit of it; negative: p - subscript */
} row_term;

typedef struct row_address {
    const ir_node *base; /* its first term: a pointer's value, or an object's address */
    bool base_is_object; /* the latter */
    int64_t offset;      /* bytes, of members */
    unsigned term_count;
    row_term terms[ROW_MOST_TERMS];
} row_address;

/** Fills in *address. False if a size is not constant, or there are too many terms. */
bool row_address_of(const ir_node *row, row_address *address);

#endif
