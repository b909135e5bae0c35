/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The address of an lvalue as a sum: base + offset + bytes * subscript + ... */
#ifndef ANALYSIS_ROW_ADDRESS_H
#define ANALYSIS_ROW_ADDRESS_H

#include "ir/ir.h"

enum { ROW_MOST_TERMS = 8 };

typedef struct row_term {
    const ir_node *subscript; /* an integer */
    int64_t bytes;            /* that one more of it adds; negative: p - subscript */
} row_term;

typedef struct row_address {
    const ir_node *base; /* a pointer whose value, or an object whose address, it begins with */
    bool base_is_object; /* the latter */
    int64_t offset;      /* bytes, of members */
    unsigned term_count;
    row_term terms[ROW_MOST_TERMS];
} row_address;

/** Fills in *address. False where a size on the way is not a constant, or the way is too long. */
bool row_address_of(const ir_node *row, row_address *address);

#endif
