/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Expresses a function's accesses by its parameters and the file's objects. */
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
    map *loops;             /* of callee_loops_around, for this function */
    const access_list *raw; /* all accesses in its text, including those of its local variables */
} callee_terms;

/** Expresses the access by the function's parameters and the file's objects. A read whose
 *  subscripts depend on counters of the function's loops gets these loops (access.loops). If the
 *  accessed element is unknown, is_exact is false. Then access.from is set for a linear search, and
 *  otherwise access.bounds if the function limits the subscript. */
access callee_terms_of(const callee_terms *terms, const access *item);

#endif
