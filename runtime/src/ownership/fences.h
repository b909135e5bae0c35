/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Fences replace the inspection of an execution by owners that classifies iterations
 * (execute/select.h). The fence of an array is a range in which its updates are expected, that of a
 * source a range in which its reads are. No fence of an array overlaps that of another array, or of
 * a source that it may meet (overlap.h).
 *
 * Each thread evaluates the slices of all iterations in order and compares each touch and read with
 * the fences, before it executes the iteration. It stops at the first iteration that leaves one. Up
 * to there no iteration has updated anything that an iteration reads, whichever thread executed it:
 * so the overlap guard holds for these iterations, each slice has the values of the sequential
 * loop, and all threads stop at the same iteration. Its own slice stops at the first touch or read
 * outside, before it loads a value that the iteration itself may have updated, if such a value
 * could do harm (REDCC_DRY_RUN). When all threads have executed the iterations before it, one
 * thread executes the others in order. Only loops with REDCC_FENCED permit this.
 *
 * Fences are the ranges of the last complete inspection, with room on each side.
 */
#ifndef REDCC_FENCES_H
#define REDCC_FENCES_H

#include "base/range.h"

/** What an array or a source touched in the last inspection. */
struct fenced {
    const void *base; /* its base then */
    struct range seen;
};

struct fences {
    struct fenced *of;     /* [array_count + source_count] the arrays, then the sources */
    struct range *allowed; /* [array_count] the fences of this execution */
    redcc_owner *updates;  /* [array_count] the same for generated code */
    redcc_extent *reads;   /* [source_count] */
    bool are_known;        /* an inspection has set `of` */
    bool are_new;          /* it did so in this execution, and they were not known before */
    bool stand;            /* this execution has fences */
    int inspections;       /* since an iteration left a fence */
    int wanted;            /* the number after which there are fences again */
};

/** Allocates memory. False: there is none. Call redcc_fences_free in either case. */
bool redcc_fences_new(struct fences *fences, const redcc_loop *loop);
void redcc_fences_free(struct fences *fences);

/** An inspection has found that what was touched (touched [array_count]) and read (read
 * [source_count]) is disjoint. The other parameters are those of redcc_enter. */
void redcc_fences_learn(struct fences *fences, const redcc_loop *loop, void *const *bases,
                        const redcc_extent *known, const struct range *touched,
                        const struct range *read);

/** An iteration has left a fence: more inspections precede the next fences. */
void redcc_fences_fail(struct fences *fences);

/** Begins an execution without fences: no iteration leaves them. */
void redcc_fences_open(struct fences *fences, const redcc_loop *loop);

/** Sets the fences of the execution. False: there are none, and an inspection is needed. */
bool redcc_fences_set(struct fences *fences, const redcc_loop *loop, void *const *bases,
                      const redcc_extent *known);

#endif
