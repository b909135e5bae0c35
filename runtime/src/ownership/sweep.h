/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Turns the addresses that an inspector tells into an access summary. One for each thread.
 *
 * The usual case, a touch by the owner of the touch before, makes no entry (redcc_touch): `window`
 * is what the current owner owns of an array, within what this thread has seen touched of it so
 * far, so that what is inside widens nothing and brings no new owner.
 */
#ifndef REDCC_SWEEP_H
#define REDCC_SWEEP_H

#include "ownership/summary.h"

struct sweep {
    const struct partition *partition;
    struct range *seen;  /* [array_count] touched range of each group, by this thread */
    redcc_owner *window; /* [array_count] of each array */
    uint32_t current;    /* an owner that the iteration at hand touches, or the last one's */
    bool touched;        /* the iteration at hand touches something ... */
    bool mixed;          /* ... of several owners: those in `list` */
    uint32_t last_set;
    redcc_int in_last_set; /* iterations not yet added to the summary */
    uint64_t iteration;    /* stamp */
    uint64_t *stamp;       /* [owners] the iteration that touched it last */
    uint32_t *list;        /* [owners] */
    uint32_t listed;
    redcc_int done; /* iterations since the block was opened */
    struct summary summary;
    bool failed; /* no memory: what follows is ignored */
};

/** Begins; seen [array_count] is the caller's, holds what is already known to be touched and goes
 *  on being widened. False: no memory (end it all the same). */
bool redcc_sweep_begin(struct sweep *sweep, const struct partition *partition, struct range *seen);

/** Gives back its memory. */
void redcc_sweep_end(struct sweep *sweep);

/** What follows lies in iterations origin, origin + 1, ... */
void redcc_sweep_open_block(struct sweep *sweep, redcc_int origin);

/** Takes in `alike` whole iterations that touch nothing but the window, and then, where `inside`,
 * that the iteration at hand touches it. */
void redcc_sweep_take_window(struct sweep *sweep, redcc_int alike, bool inside);

/** Takes entries [first, end) in; an iteration's may come in several calls. */
void redcc_sweep_take(struct sweep *sweep, const redcc_entry *first, const redcc_entry *end);

/** The iteration at hand touches something of this owner's. */
void redcc_sweep_take_owner(struct sweep *sweep, uint32_t owner);

/** The iteration at hand is told. */
void redcc_sweep_end_iteration(struct sweep *sweep);

/** The block is at its end. Returns false where another number of iterations than `expected` was
 *  told, or where there was no memory. */
bool redcc_sweep_close_block(struct sweep *sweep, redcc_int expected);

/** How many iterations of the summary are executed, those of several owners more than once, when
 *  of every `each` owners in a row there is but one. */
redcc_int redcc_sweep_executed(const struct sweep *sweep, uint32_t each);

/** Adds up how many iterations of the summary each owner takes part in: executed [owners]. */
void redcc_sweep_count(const struct sweep *sweep, redcc_int *executed);

#endif
