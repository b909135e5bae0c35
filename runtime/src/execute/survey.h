/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A survey divides the classification of iterations (select.h) among the threads. Before anything
 * is executed, each thread classifies an equal share of the blocks of REDCC_SELECTED iterations,
 * keeps their classes, and marks those blocks in which another thread owns touched elements as
 * open. After a barrier it executes its iterations of its own share by the kept classes, and
 * classifies only the open blocks of the other shares. If each thread owns what its share touches,
 * the threads together classify each iteration once. At worst, each thread classifies each
 * iteration once, as without a survey.
 *
 * With fences (ownership/fences.h), each thread ends its part of the survey at the first iteration
 * of its share that leaves a fence. All threads end the parallel execution before the first of
 * these iterations. But some threads have then evaluated slices of later iterations, which may have
 * read values that earlier iterations would have changed. The classes of these later iterations are
 * never used. Loops in which reading such values could do harm (REDCC_DRY_RUN) have no survey with
 * fences. Without fences, a dry run has shown in the same call that no iteration changes what the
 * slices read.
 */
#ifndef REDCC_EXECUTE_SURVEY_H
#define REDCC_EXECUTE_SURVEY_H

#include "base/barrier.h"
#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The classes of 64 iterations, with one bit for each iteration. */
struct class_bits {
    uint64_t executed; /* this thread executes the iteration */
    uint64_t shared;   /* another thread also owns rows that the iteration touches */
    uint64_t follows;  /* in a loop with series (redcc/series.h): another thread stores the operands
                          of the iteration */
};

enum { REDCC_SELECTED_WORDS = REDCC_SELECTED / 64 };

struct surveyed_block {
    struct class_bits bits[REDCC_SELECTED_WORDS]; /* for the thread that classified the block */
};

/** A survey, which all threads share. Its memory is kept for the next execution. */
struct survey {
    struct surveyed_block *block; /* [blocks] */
    bool *is_open;                /* [blocks] */
    redcc_int *stop; /* [threads] the first iteration in the thread's share that leaves a fence, or
                        the share's end */
    redcc_int blocks;
    redcc_int room; /* number of blocks for which there is memory */
    int threads;
    int stops; /* number of threads for which there is memory */
    struct barrier *barrier;
    bool stands; /* the current execution uses this survey */
};

/** Begins a survey for several threads, which meet at `barrier`. Sets survey->stands to false if
 * there is only one thread, if not every thread gets a block, or if memory runs out. */
void redcc_survey_begin(struct survey *survey, redcc_int trip, int threads,
                        struct barrier *barrier);

void redcc_survey_free(struct survey *survey);

/** The first iteration of the thread's share; `trip` or more if thread == survey->threads. */
redcc_int redcc_survey_first(const struct survey *survey, int thread);

/** Called by each thread when it has classified its share up to `stop`: the first iteration that
 * leaves a fence, or the share's end. Waits for all threads. Returns the first iteration of the
 * loop that leaves a fence, or the trip count; all iterations before it are then classified. */
redcc_int redcc_survey_end(struct survey *survey, int thread, redcc_int stop);

#endif
