/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A loop as redcc would write it for binning, with all that such loops may have: several arrays in
 * a record, several updates of an array, conditions, a loop inside, a source that may overlap.
 *
 *     for (t = 0; t < trip; t++)
 *         for (n = start[t]; n < start[t + 1]; n++) {
 *             if (value[n] > 0) { count[k[n]]++; sum[k[n]] += value[n]; }
 *             other[j[n]] -= value[n] * x[m[t]];
 *             other[j[n] + 1] = other[j[n] + 1] * half + 1;
 *         }
 *
 * Where value[n] or x[m[t]] is WRONG, a mathematical function fails.
 */
#ifndef BINNED_WORK_H
#define BINNED_WORK_H

#include "bins/window.h"
#include "loop.h"
#include "redcc/bins.h"

#include <stdbool.h>

struct work {
    redcc_int trip;
    int *start, *k, *j, *m;
    double *value;
    long *count;
    double *sum, *other;
    const double *x;
};

#define WRONG (-7777.0)

enum { ROWS = 3000, TRIP = 4000, MOST = 16 * TRIP, X = 50 };

/** The loop's data: one block, so that all parts may overlap. x is `other` from ROWS on. */
struct memory {
    long count[ROWS];
    double sum[ROWS];
    double other[ROWS + X];
};

/** The current data, and the initial data of each work_compare. */
extern struct memory now, before;

/** The loop's descriptor; its second stream has a tag. */
extern redcc_binned work_loop;

/** Number of threads that OpenMP is made to give; 0: the requested number. */
extern int fewer;

/** Random work of at most `most_inside` iterations of the loop inside; to be given to work_free. */
struct work work_new(unsigned long seed, int most_inside);

/** Gives it back, and all that the runtime has of the loop. */
void work_free(struct work *w);

/** The loop itself, from the memory as it is: the oracle. */
void work_oracle(const struct work *w);

/** Returns whether the loop was done, or else nothing of it. */
bool work_run(const struct work *w, int threads);

/** Runs it from `before` on, with the oracle's bits or the test fails. Returns whether all or the
 *  first rounds were binned. */
bool work_compare(const struct work *w, int threads);

/** The runtime's. */
const struct loop_state *work_state(void);

/** How often an execution was compared with the sequential loop (REDCC_VALIDATE=1). */
long work_validated(void);

/** How often the loop ran sequentially for the reason. */
long work_fallbacks(enum reason reason);

#endif
