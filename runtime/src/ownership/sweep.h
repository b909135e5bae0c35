/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Converts an inspector's recorded addresses to an access summary. One sweep per thread.
 *
 * The usual case, a touch of the same owner as before, makes no entry (redcc_touch). `window` is
 * the part of an array that the current owner owns, within the range that this thread has touched
 * so far. So a touch inside it neither widens that range nor changes the owner.
 */
#ifndef REDCC_SWEEP_H
#define REDCC_SWEEP_H

#include "ownership/summary.h"

struct sweep {
    const struct partition *partition;
    struct range *seen;  /* [array_count] range of each group that this thread has touched */
    redcc_owner *window; /* [array_count] for each array */
    uint32_t current;    /* an owner that the current or the last iteration touches */
    bool touched;        /* the current iteration touches an element */
    bool mixed; /* the current iteration touches several owners' elements; `list` has them */
    uint32_t last_set;
    redcc_int in_last_set; /* iterations not yet added to the summary */
    uint64_t iteration;    /* stamp of the latest iteration of several owners */
    uint64_t *stamp;       /* [owners] stamp of the last such iteration that touched the owner */
    uint32_t *list;        /* [owners] */
    uint32_t listed;
    redcc_int done; /* iterations since the block was opened */
    struct summary summary;
    bool failed; /* out of memory: further entries are ignored */
};

/** Begins a sweep; seen [array_count] belongs to the caller, contains the known touched ranges and
 * is widened. False: out of memory. Call redcc_sweep_end in either case. */
bool redcc_sweep_begin(struct sweep *sweep, const struct partition *partition, struct range *seen);

/** Frees its memory. */
void redcc_sweep_end(struct sweep *sweep);

/** Begins a block of iterations origin, origin + 1, ... */
void redcc_sweep_open_block(struct sweep *sweep, redcc_int origin);

/** Adds `alike` complete iterations that touch only the window, and then, if `inside`, a touch of
 * the window by the current iteration. */
void redcc_sweep_take_window(struct sweep *sweep, redcc_int alike, bool inside);

/** Adds entries [first, end); those of one iteration may be split over several calls. */
void redcc_sweep_take(struct sweep *sweep, const redcc_entry *first, const redcc_entry *end);

/** Records that the current iteration touches an element of this owner. */
void redcc_sweep_take_owner(struct sweep *sweep, uint32_t owner);

/** Completes the current iteration. */
void redcc_sweep_end_iteration(struct sweep *sweep);

/** Ends the block. False: the number of recorded iterations differs from `expected`, or out of
 * memory. */
bool redcc_sweep_close_block(struct sweep *sweep, redcc_int expected);

/** The number of executed iterations, counting each once per owner, if every `each` consecutive
 *  owners are merged. */
redcc_int redcc_sweep_executed(const struct sweep *sweep, uint32_t each);

/** Adds the number of iterations of each owner to executed [owners]. */
void redcc_sweep_count(const struct sweep *sweep, redcc_int *executed);

#endif
