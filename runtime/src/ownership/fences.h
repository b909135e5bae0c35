/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fences: ranges of memory that replace an inspection if threads classify iterations during the
 * execution (execute/select.h). An array's updates are expected inside the array's fence, and a
 * source's reads inside the source's fence. The fence of an array overlaps neither that of another
 * array nor that of a source with which the array may overlap (overlap.h).
 *
 * Before a thread executes an iteration, it evaluates the iteration's slice and compares each touch
 * and read with the fences. All threads do so for all iterations in order, and stop at the first
 * iteration that leaves a fence. No earlier iteration has updated memory that an iteration reads,
 * whichever thread executed it. So the overlap guard holds for the earlier iterations, each slice
 * computes the values of the sequential loop, and all threads stop at the same iteration. The slice
 * of that iteration ends at the first touch or read outside, before it loads a value that the
 * iteration itself may have updated, if such a load could do harm (REDCC_DRY_RUN). After all
 * threads have executed the earlier iterations, one thread executes the remaining ones in order.
 * Only loops with REDCC_FENCED or REDCC_FENCED_SERIES permit this. In a loop with series, the
 * thread that executes the remaining iterations adds their operands directly. Before, it computes
 * the sums of the earlier iterations by executing these again, in order and without updates. Their
 * operands are the same as before: none has updated what another one reads.
 *
 * A fence is the range that the last complete inspection found, extended on both sides.
 */
#ifndef REDCC_FENCES_H
#define REDCC_FENCES_H

#include "base/range.h"

#include <stdbool.h>

/** May the loop be executed with fences? */
static inline bool redcc_may_be_fenced(const redcc_loop *loop) {
    return loop->flags & (REDCC_FENCED | REDCC_FENCED_SERIES);
}

/** The range of an array or a source that the last inspection found. */
struct fenced {
    const void *base; /* base of the array or source in that inspection */
    struct range seen;
};

struct fences {
    struct fenced *of;     /* [array_count + source_count] the arrays, then the sources */
    struct range *allowed; /* [array_count] the fences of this execution */
    redcc_owner *updates;  /* [array_count] the same in the form that generated code reads */
    redcc_extent *reads;   /* [source_count] the sources' fences in this execution */
    bool are_known;        /* an inspection has set `of` */
    bool are_new;          /* this execution's inspection has set `of` for the first time, or again
                            * after an iteration left a fence */
    bool stand;            /* this execution has fences */
    int inspections;       /* number of inspections since an iteration last left a fence */
    int wanted;            /* number of inspections that must precede fences */
};

/** Allocates the memory of all fields. Returns false if memory runs out. Call redcc_fences_free in
 *  both cases. */
bool redcc_fences_new(struct fences *fences, const redcc_loop *loop);
void redcc_fences_free(struct fences *fences);

/** Notes the ranges touched[array_count] and read[source_count] of an inspection, which found them
 *  disjoint. The other parameters are those of redcc_enter. */
void redcc_fences_learn(struct fences *fences, const redcc_loop *loop, void *const *bases,
                        const redcc_extent *known, const struct range *touched,
                        const struct range *read);

/** Notes that an iteration has left a fence. More inspections must then precede the next fences. */
void redcc_fences_fail(struct fences *fences);

/** Begins an execution without fences: all ranges are unbounded, so no iteration leaves them. */
void redcc_fences_open(struct fences *fences, const redcc_loop *loop);

/** Sets the fences of the execution. Returns false if that is impossible, so that the execution
 *  needs an inspection. */
bool redcc_fences_set(struct fences *fences, const redcc_loop *loop, void *const *bases,
                      const redcc_extent *known);

#endif
