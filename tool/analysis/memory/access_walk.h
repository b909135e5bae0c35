/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The traversal of expressions and statements in the order of evaluation; results go to an
 *  access_list, calls are looked up in the effects. Internal to access.h. */
#ifndef ANALYSIS_ACCESS_WALK_H
#define ANALYSIS_ACCESS_WALK_H

#include "analysis/memory/access.h"

typedef struct access_walk {
    arena *memory;
    effects *all;
    access_list *list;
    unsigned condition_depth; /* > 0: the following code is not executed on all paths */
    bool in_callee;           /* the code is a called function's: an `assert` is added to
                               * list->ends, not to the problems */
} access_walk;

void access_walk_node(access_walk *w, const ir_node *node);

/** Appends the accesses of the call: its function's summary in the caller's terms. */
void access_walk_call(access_walk *w, const ir_node *call);

/** Is it the function that a C library's `assert` calls on failure? Messages say `assert`. */
bool access_is_assertion(const ir_function *function);

void access_add(access_walk *w, access item);
void access_problem_add(access_walk *w, reason_id why, const ir_node *node, const char *name);

#endif
