/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses between executing a loop with prefetches and without. Both give the same bits. In a
 * trial, timing slices alternate between the two (learn/paired_timing.h). The faster variant is
 * then used until the next trial. If an execution is long enough, it is divided into as many slices
 * as the trial needs.
 */
#ifndef REDCC_EXECUTE_VARIANT_H
#define REDCC_EXECUTE_VARIANT_H

#include "learn/back_off.h"
#include "learn/paired_timing.h"
#include "redcc/runtime.h"

#include <stdbool.h>

/** A round of a trial has one timing slice of each variant. A long execution has several rounds. */
enum {
    VARIANTS = PAIRED_ARMS,
    VARIANT_ROUNDS = 2 * LEARN_PAIRS,
    VARIANT_PARTS = VARIANT_ROUNDS * VARIANTS
};

/** The results of a loop's executions. Initially zero. */
struct variants {
    struct paired_timing pairs; /* timings of the current trial */
    bool best;                  /* did the variant with prefetches win the last trial? */
    long executions;            /* number of executions in which the choice was open */
    /* back-off of trials, counted in executions in which the choice was open */
    struct back_off back_off;
};

/** The number of timing slices of an execution in which each thread executes `iterations`
 * iterations on average: as many as the trial still needs, but at most one per 512 iterations, and
 * at least one. 0: there is no trial. `open`: trials are allowed. */
unsigned redcc_variant_parts(const struct variants *it, bool open, redcc_int iterations);

/** Does timing slice number `part` of the execution use prefetches? If trials are allowed (`open`),
 * slice 0 of the loop's first execution does. */
bool redcc_variant_of(const struct variants *it, bool open, unsigned part);

/** If trials are allowed (`open`), records an execution that has ended, with the seconds per
 * iteration of each slice; this may end the trial. Called by one thread at a time. */
void redcc_variant_note(struct variants *it, bool open, unsigned parts, const double *seconds);

#endif
