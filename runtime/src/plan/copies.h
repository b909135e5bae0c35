/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Private copies of reduction arrays: one of each group (arrays that overlap share one), of the
 * bytes that are touched, and their way back into the arrays.
 */
#ifndef REDCC_COPIES_H
#define REDCC_COPIES_H

#include "ownership/partition.h"

struct plan;

/** A copy of all groups. */
struct copy {
    char **memory;        /* [array_count] of group g; NULL: nothing of it is touched */
    struct offsets *held; /* [array_count] what of group g it is a copy of */
};

struct copies {
    int count;
    uint32_t array_count;
    struct copy *copy; /* [count] */
    const redcc_array *arrays;
};

/** As many copies as the plan's method needs, without memory for elements yet. False: no memory. */
bool redcc_copies_begin(struct plan *plan, const redcc_array *arrays);

/** Gives back their memory. */
void redcc_copies_end(struct copies *copies);

/** Can there be private copies of what the partition's groups are touched in (touched
 *  [array_count])? Not of types without a rule, nor where elements do not lie in step. */
bool redcc_copies_possible(const struct partition *partition, const struct range *touched);

/** Bytes that a copy of everything touched takes. */
size_t redcc_copy_bytes(const struct partition *partition, const struct range *touched);

/** Memory for the copy that `thread` is the first to use, if it is; `seen` [array_count] is what
 *  this thread's iterations touch, base [array_count] where the groups are. False: no memory. */
bool redcc_copies_take(struct plan *plan, int thread, const struct range *seen,
                       const uintptr_t *base);

/** The number of the copy that `thread` writes to; -1: it writes in place, or, by COPY_SHARE, to
 *  those that its chunks name. */
int redcc_copy_of(const struct plan *plan, int thread);

/** Sets this thread's share of its copy to the neutral element. */
void redcc_copies_fill(const struct plan *plan, int thread);

/** Brings this thread's share of the elements from all copies into the arrays at `bases`. */
void redcc_copies_merge(const struct plan *plan, int thread, void *const *bases);

#endif
