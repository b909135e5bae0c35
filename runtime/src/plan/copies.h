/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Private copies of the touched bytes of reduction arrays, one for each group (arrays that overlap
 * share one), and their merge into the arrays.
 */
#ifndef REDCC_COPIES_H
#define REDCC_COPIES_H

#include "ownership/partition.h"

struct plan;

/** A copy of all groups. */
struct copy {
    char **memory;        /* [array_count] for each group; NULL: nothing is copied */
    struct offsets *held; /* [array_count] the copied range of each group */
};

struct copies {
    int count;
    uint32_t array_count;
    struct copy *copy; /* [count] */
    const redcc_array *arrays;
    bool is_neutral; /* COPY_LATER: all elements are neutral since the last merge */
};

/** Makes the copies that the plan's method needs, without memory for elements yet. False: out of
 *  memory. */
bool redcc_copies_begin(struct plan *plan, const redcc_array *arrays);

/** Frees their memory. */
void redcc_copies_end(struct copies *copies);

/** Are private copies possible for the touched ranges of the partition's groups (touched
 * [array_count])? Not for types without an element_rule, nor if overlapping arrays differ in type
 * or operator, or if rows or ranges are not whole elements. */
bool redcc_copies_possible(const struct partition *partition, const struct range *touched);

/** Bytes of a copy of all touched ranges. */
size_t redcc_copy_bytes(const struct partition *partition, const struct range *touched);

/** Allocates the copies that `thread` uses first, if any; `seen` [array_count] is the range touched
 * by this thread's iterations, base [array_count] the groups' addresses. False: out of memory. */
bool redcc_copies_take(struct plan *plan, int thread, const struct range *seen,
                       const uintptr_t *base);

/** The number of the copy that `thread` writes to; -1: it writes in place or, with COPY_SHARE and
 *  COPY_LATER, to the copies of the shares that its chunks name. */
int redcc_copy_of(const struct plan *plan, int thread);

/** The number of the copy of a share; -1: it is in place. */
int redcc_copy_of_share(const struct plan *plan, uint32_t share);

/** Sets the copies that this thread uses first to the neutral element, unless they are neutral; of
 * a team's copy only the thread's share. */
void redcc_copies_fill(const struct plan *plan, int thread);

/** Merges this thread's share of the elements from all copies into the arrays at `bases`. With
 * COPY_LATER it makes the copies neutral again. */
void redcc_copies_merge(const struct plan *plan, int thread, void *const *bases);

#endif
