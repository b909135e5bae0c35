/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Whatever is executed before what the loop reads is known to be apart from what it writes may read
 * values that are not yet the sequential loop's: stale ones. That is so of the body in in-order
 * binning, which may be executed more than once, and of the slice in an inspection. The results are
 * thrown away where the two turn out to overlap, but until that is known stale values must do no
 * harm. They must not decide an address, an integer division, how often a loop inside iterates, or
 * whether something is evaluated that the sequential loop might not evaluate.
 *
 * What depends on stale values is found by going through the body until nothing new is: variables,
 * not values, are marked.
 */
#ifndef EMIT_STALE_H
#define EMIT_STALE_H

#include "emit/loop.h"

typedef struct staleness {
    const loop_text *loop;
    const bool *is_suspect;          /* by source: what is read there may be stale */
    bool *is_stale;                  /* by variable: it may hold a stale value */
    bool changed;                    /* in this pass */
    bool is_harmful;                 /* what was found */
    bool in_callee;                  /* then all memory is stale */
    bool in_slice;                   /* all that it reads is a source */
    bool may_have_left;              /* before what comes next: by a condition that is stale */
    unsigned depth;                  /* of calls */
    VECTOR(const ir_node *) certain; /* expressions that each iteration evaluates */
} staleness;

/** How control comes to a node. */
typedef struct control {
    bool is_stale;   /* it depends on stale values */
    bool is_certain; /* in each iteration */
} control;

/** By source: may it overlap what the loop writes, as far as the analysis knows? */
bool *guarded_sources(const loop_text *loop);

/** Is there any source of which that is said? */
bool stale_has_suspects(const loop_text *loop, const bool *is_suspect);

/** Marks the variables of the body, where what those sources read may be stale; in_slice: it is
 *  asked for the slice alone. */
staleness stale_begin(loop_text *loop, const bool *is_suspect, bool in_slice);

/** How control comes to the first statement of an iteration, */
control stale_in_iteration(const loop_text *loop);
/** and to the parts of a node: `first` is evaluated with it. */
control stale_below(const staleness *s, const ir_node *node, control how, bool first);

/** Does the node's value depend on stale ones? Of a statement: does what decides its parts? */
bool stale_value(const staleness *s, const ir_node *node);
bool stale_condition(const staleness *s, const ir_node *node);

/** Sets is_harmful where evaluating the node with stale values may do harm. */
void stale_check(staleness *s, const ir_node *node, control how);

/** stale.c: may the body be executed before what it reads is compared with what it writes? */
bool is_harmless_when_stale(loop_text *loop);

#endif
