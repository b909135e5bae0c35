/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What a function accesses, said in terms of its parameters and of the file's objects. */
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
    const access_list *raw; /* all that its text accesses, its own variables included */
} callee_terms;

/** The access in these terms. Reads whose subscripts depend on counters of the function's loops get
 *  these loops (access.loops). Where it cannot be told which element is accessed, is_exact is not
 * set; of a search's then access.from is, and access.bounds where the function bounds the
 * subscript.
 */
access callee_terms_of(const callee_terms *terms, const access *item);

#endif
