/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Turns an inspector's recorded addresses into an access summary. One for each thread.
 *
 * The usual case, a touch by the same owner as before, makes no entry (redcc_touch): `window` is
 * the part of an array that the current owner owns, within the range this thread has seen touched
 * so far. So a touch inside it neither widens that range nor changes the owner.
 */
#ifndef REDCC_SWEEP_H
#define REDCC_SWEEP_H

#include "ownership/summary.h"

struct sweep {
    const struct partition *partition;
    struct range *seen;  /* [array_count] touched range of each group, by this thread */
    redcc_owner *window; /* [array_count] of each array */
    uint32_t current;    /* an owner that the current iteration touches, or the last one's */
    bool touched;        /* the current iteration touches something ... */
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

/** Begins; seen [array_count] belongs to the caller, holds the known touched ranges and is widened.
 *  False: no memory (call redcc_sweep_end all the same). */
bool redcc_sweep_begin(struct sweep *sweep, const struct partition *partition, struct range *seen);

/** Frees its memory. */
void redcc_sweep_end(struct sweep *sweep);

/** The next block covers iterations origin, origin + 1, ... */
void redcc_sweep_open_block(struct sweep *sweep, redcc_int origin);

/** Adds `alike` whole iterations that touch only the window, and then, if `inside`, a touch of it
 *  by the current iteration. */
void redcc_sweep_take_window(struct sweep *sweep, redcc_int alike, bool inside);

/** Adds entries [first, end); one iteration's may come in several calls. */
void redcc_sweep_take(struct sweep *sweep, const redcc_entry *first, const redcc_entry *end);

/** The current iteration touches an element of this owner. */
void redcc_sweep_take_owner(struct sweep *sweep, uint32_t owner);

/** The current iteration is complete. */
void redcc_sweep_end_iteration(struct sweep *sweep);

/** Ends the block. Returns false if the number of recorded iterations differs from `expected`, or
 *  without memory. */
bool redcc_sweep_close_block(struct sweep *sweep, redcc_int expected);

/** The number of executed iterations, counting each once per owner, if every `each` consecutive
 *  owners are merged. */
redcc_int redcc_sweep_executed(const struct sweep *sweep, uint32_t each);

/** Adds the number of iterations of each owner to executed [owners]. */
void redcc_sweep_count(const struct sweep *sweep, redcc_int *executed);

#endif
