/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Converts an inspector's recorded addresses to an access summary. Each thread has one sweep.
 *
 * In the usual case a touch has the same owner as the touch before it, and makes no entry
 * (redcc_touch). `window` is the part of an array that the current owner owns, within the range
 * that this thread has touched so far. So a touch inside it neither widens that range nor changes
 * the owner.
 */
#ifndef REDCC_SWEEP_H
#define REDCC_SWEEP_H

#include "ownership/summary.h"

struct sweep {
    const struct partition *partition;
    struct range *seen;  /* [array_count] for each group, the range that this thread has touched */
    redcc_owner *window; /* [array_count] the window of each array */
    uint32_t current;    /* an owner of elements that the current or the last iteration touches */
    bool touched;        /* the current iteration touches an element */
    bool mixed; /* the current iteration touches elements of several owners, which are in `list` */
    uint32_t last_set;
    redcc_int in_last_set; /* number of the last iterations whose set of owners is last_set; they
                              are not yet added to the summary */
    uint64_t iteration;    /* number of iterations so far that touch several owners */
    uint64_t *stamp; /* [owners] for each owner, the value of `iteration` in the last iteration with
                        several owners that touched it */
    uint32_t *list;  /* [owners] the owners that the current iteration touches, if there are several
                        of them */
    uint32_t listed;
    redcc_int done; /* number of iterations since the block was opened */
    struct summary summary;
    bool failed; /* out of memory: further entries are ignored */
};

/** Begins a sweep. seen[array_count] has, for each group, the range that is known to be touched so
 * far; it belongs to the caller, and the sweep extends the ranges. Returns false if out of memory.
 * Call redcc_sweep_end in either case. */
bool redcc_sweep_begin(struct sweep *sweep, const struct partition *partition, struct range *seen);

/** Frees the sweep's memory. */
void redcc_sweep_end(struct sweep *sweep);

/** Begins a block whose first iteration is number `origin`. */
void redcc_sweep_open_block(struct sweep *sweep, redcc_int origin);

/** Adds `alike` complete iterations that touch only the window. Then, if `inside` is set, adds a
 * touch of the window by the current iteration. */
void redcc_sweep_take_window(struct sweep *sweep, redcc_int alike, bool inside);

/** Adds the entries from `first` to before `end`. The entries of one iteration may be split over
 * several calls. */
void redcc_sweep_take(struct sweep *sweep, const redcc_entry *first, const redcc_entry *end);

/** Records that the current iteration touches an element of this owner. */
void redcc_sweep_take_owner(struct sweep *sweep, uint32_t owner);

/** Completes the current iteration. */
void redcc_sweep_end_iteration(struct sweep *sweep);

/** Ends the block. Returns false if it did not get `expected` iterations, or if out of memory. */
bool redcc_sweep_close_block(struct sweep *sweep, redcc_int expected);

/** The number of executed iterations, if each `each` consecutive owners were merged into one; an
 * iteration counts once for each merged owner that it touches. */
redcc_int redcc_sweep_executed(const struct sweep *sweep, uint32_t each);

/** Adds to executed [owners] the number of iterations that each owner executes. */
void redcc_sweep_count(const struct sweep *sweep, redcc_int *executed);

#endif
