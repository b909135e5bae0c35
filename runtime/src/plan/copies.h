/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Private copies of the touched bytes of reduction arrays, and the merge of these copies into the
 * arrays. Arrays that overlap form a group, which is copied as a whole.
 */
#ifndef REDCC_COPIES_H
#define REDCC_COPIES_H

#include "ownership/partition.h"

struct plan;

/** A copy of all groups. */
struct copy {
    char **memory;        /* [array_count] the copy of each group; NULL: it is not copied */
    struct offsets *held; /* [array_count] for each group, the range that the copy contains */
};

struct copies {
    int count;
    uint32_t array_count;
    struct copy *copy; /* [count] */
    const redcc_array *arrays;
    bool is_neutral; /* with COPY_LATER: all elements of the copies are neutral, because they were
                        drained in the last merge */
};

/** Creates the copies that the plan's method needs, without memory for elements. False: out of
 * memory. */
bool redcc_copies_begin(struct plan *plan, const redcc_array *arrays);

/** Frees the copies' memory. */
void redcc_copies_end(struct copies *copies);

/** Are private copies possible for the touched ranges of the partition's groups,
 * touched[array_count]? Requirements: there is an element_rule for each array's operator and type;
 * arrays that overlap have the same type and operator; rows and ranges consist of whole
 * elements. */
bool redcc_copies_possible(const struct partition *partition, const struct range *touched);

/** The size of a copy of all touched ranges, in bytes. */
size_t redcc_copy_bytes(const struct partition *partition, const struct range *touched);

/** Allocates memory for the copies of which `thread` is the first user, if any. seen[array_count]
 * has the ranges that this thread's iterations touch; base[array_count] has the addresses of the
 * groups. Returns false if out of memory. */
bool redcc_copies_take(struct plan *plan, int thread, const struct range *seen,
                       const uintptr_t *base);

/** The number of the copy to which `thread` writes. -1: the thread writes to the arrays or, with
 * COPY_SHARE and COPY_LATER, to the copies of the shares that its chunks name. */
int redcc_copy_of(const struct plan *plan, int thread);

/** The number of the copy of a share; -1: the share writes to the arrays. */
int redcc_copy_of_share(const struct plan *plan, uint32_t share);

/** Sets the copies of which this thread is the first user to the neutral element, unless they are
 * neutral already. If a team shares a copy, each of its threads sets a part of it. */
void redcc_copies_fill(const struct plan *plan, int thread);

/** Merges this thread's share of the elements of all copies into the arrays at `bases`. With
 * COPY_LATER, makes the copies neutral again. */
void redcc_copies_merge(const struct plan *plan, int thread, void *const *bases);

#endif
