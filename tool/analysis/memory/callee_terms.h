/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A function's accesses, in terms of its parameters and of the file's objects. */
#ifndef ANALYSIS_CALLEE_TERMS_H
#define ANALYSIS_CALLEE_TERMS_H

#include "analysis/memory/access.h"
#include "analysis/memory/hidden_names.h"

typedef struct callee_terms {
    arena *memory;
    variable_facts *facts;
    const hidden_names *names;
    bool strict_aliasing;
    const ir_function *function;
    const access_list *raw; /* all accesses of its text, including those of its local variables */
} callee_terms;

/** The access in these terms. Reads whose subscripts depend on counters of the function's loops get
 *  these loops (access.loops). If the accessed element is unknown, is_exact is not set. Then
 *  access.from is set for a search, else access.bounds if the function bounds the subscript. */
access callee_terms_of(const callee_terms *terms, const access *item);

#endif
