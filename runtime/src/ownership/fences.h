/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fences: ranges of memory that replace an inspection if threads classify iterations during the
 * execution (execute/select.h). An array's updates are expected inside the array's fence, and a
 * source's reads inside the source's fence. Two fences do not overlap if the overlap guard would
 * compare their arrays or sources (overlap.h); those of two arrays never overlap.
 *
 * Before a thread executes an iteration, it evaluates the iteration's slice and compares each touch
 * and read with the fences. Without a survey (execute/survey.h), each thread does so for all
 * iterations in order. All threads stop at the first iteration that leaves a fence. The iterations
 * before it update nothing that any of them reads. So the overlap guard holds for them, their
 * slices compute the values of the sequential loop, and all threads stop at the same iteration. In
 * a loop with REDCC_DRY_RUN, the slice of that iteration ends at its first touch or read outside of
 * the fences, before it loads a value that the iteration itself may have updated.
 *
 * When all threads have executed the earlier iterations, one thread executes the remaining ones in
 * order. Only loops with REDCC_FENCED or REDCC_FENCED_SERIES permit this. In a loop with series
 * (redcc/series.h), this thread first executes the earlier iterations again, in order and without
 * updates, to compute their sums. They yield the same operands as before, because none has updated
 * what another one reads. The thread then adds the operands of the remaining iterations directly.
 *
 * If redcc_enter was given a source's extent, this extent is the source's fence. Any other fence is
 * the range that the last complete inspection found, moved with the array or source and extended on
 * both sides.
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

/** Stores in fences->of the ranges touched[array_count] and read[source_count] of an inspection,
 * which found them disjoint. The other parameters are those of redcc_enter. */
void redcc_fences_learn(struct fences *fences, const redcc_loop *loop, void *const *bases,
                        const redcc_extent *known, const struct range *touched,
                        const struct range *read);

/** Called when an iteration has left a fence: about twice as many inspections as before must then
 * precede the next fences. */
void redcc_fences_fail(struct fences *fences);

/** Begins an execution without fences: all ranges are unbounded, so no iteration leaves them. */
void redcc_fences_open(struct fences *fences, const redcc_loop *loop);

/** Sets the fences of the execution. Returns false if ranges are unknown or overlap, or if more
 * inspections are wanted; then the execution needs an inspection. */
bool redcc_fences_set(struct fences *fences, const redcc_loop *loop, void *const *bases,
                      const redcc_extent *known);

#endif
