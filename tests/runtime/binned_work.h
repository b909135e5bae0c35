/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A loop in the form that redcc generates for binning, with all that such loops may contain:
 * several arrays in a record, several updates of an array, conditions, an inner loop, and a
 * source that may overlap the arrays.
 *
 *     for (t = 0; t < trip; t++)
 *         for (n = start[t]; n < start[t + 1]; n++) {
 *             if (value[n] > 0) { count[k[n]]++; sum[k[n]] += value[n]; }
 *             other[j[n]] -= value[n] * x[m[t]];
 *             other[j[n] + 1] = other[j[n] + 1] * half + 1;
 *         }
 *
 * If value[n] or x[m[t]] is WRONG, a mathematical function fails.
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

/** The loop's data in one block, so that all parts may overlap. x is a pointer to `other` from
 * element ROWS on. */
struct memory {
    long count[ROWS];
    double sum[ROWS];
    double other[ROWS + X];
};

/** The current data, and the initial data of each work_compare. */
extern struct memory now, before;

/** The loop's descriptor; its second stream has a tag. */
extern redcc_binned work_loop;

/** The number of threads to which OpenMP is limited, or 0 if it is not. */
extern int fewer;

/** Returns random work with at most `most_inside` iterations of the inner loop. The caller frees it
 * by work_free. */
struct work work_new(unsigned long seed, int most_inside);

/** Frees the work, and everything that the runtime stores for the loop. */
void work_free(struct work *w);

/** Executes the loop sequentially on the current memory: the expected result. */
void work_oracle(const struct work *w);

/** Executes the loop by the runtime. Returns true if it was executed. If it returns false, nothing
 * has changed. */
bool work_run(const struct work *w, int threads);

/** Executes the loop on the data `before`. The test fails if the result differs from work_oracle's
 * in any bit. Returns true if binning executed all rounds, or at least the first ones. */
bool work_compare(const struct work *w, int threads);

/** Returns the runtime's state of the loop. */
const struct loop_state *work_state(void);

/** Returns the number of executions that were compared with the sequential loop
 * (REDCC_VALIDATE=1). */
long work_validated(void);

/** Returns the number of times that the loop ran sequentially for this reason. */
long work_fallbacks(enum reason reason);

#endif
