/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Traverses expressions and statements in the order of evaluation and appends their accesses to an
 *  access_list. Calls are looked up in the effects. Only the implementation of access.h uses this
 *  header. */
#ifndef ANALYSIS_ACCESS_WALK_H
#define ANALYSIS_ACCESS_WALK_H

#include "analysis/memory/access.h"

typedef struct access_walk {
    arena *memory;
    effects *all;
    access_list *list;
    unsigned condition_depth; /* if > 0, the code that follows is not executed on all paths */
    bool in_callee;           /* the code belongs to a called function, so an `assert` is added to
                               * list->ends and not to the problems */
} access_walk;

void access_walk_node(access_walk *w, const ir_node *node);

/** Appends the accesses of the call: the function's summary, expressed by the caller's
 *  variables. */
void access_walk_call(access_walk *w, const ir_node *call);

/** If the node itself is an atomic operation, adds the update that it makes to list->listed.
 * Returns its name; NULL if the node is none. */
const char *access_walk_atomic(access_walk *w, const ir_node *node);

/** Is this the function that a C library's `assert` calls when it fails? Messages name it
 *  `assert`. */
bool access_is_assertion(const ir_function *function);

void access_add(access_walk *w, access item);
void access_problem_add(access_walk *w, reason_id why, const ir_node *node, const char *name);

#endif
