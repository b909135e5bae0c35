/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * May code compute with unverified values (unverified.h)?
 *
 * Why that can be sound: if reads and writes turn out to overlap, all results are discarded and the
 * sequential loop runs. Until that is known, the computation must not fail. So no address, integer
 * division or trip count of an inner loop may depend on an unverified value; nor may an unverified
 * value decide whether an expression is evaluated that may fail.
 */
#ifndef PLAN_UNVERIFIED_USES_H
#define PLAN_UNVERIFIED_USES_H

#include "plan/unverified.h"

/** The control flow into a node. */
typedef struct control {
    bool is_unverified; /* it depends on unverified values */
    bool is_certain;    /* each iteration reaches the node */
} control;

/** The control flow into the first statement of an iteration. */
control unverified_in_iteration(const loop_plan *plan);
/** The control flow into a part of a node; `first`: the part is evaluated whenever the node is. */
control unverified_below(const unverified_reads *s, const ir_node *node, control how, bool first);

/** Sets is_harmful if evaluating the node with unverified values may be harmful. */
void unverified_check(unverified_reads *s, const ir_node *node, control how);

/** May the body be executed before its reads are compared with its writes? */
bool is_harmless_when_unverified(const loop_plan *plan);

#endif
