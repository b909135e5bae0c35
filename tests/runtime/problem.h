/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Irregular loops for tests of the runtime:
 *
 *     for (t = 0; t < trip; t++)
 *         for (k = start[t]; k < start[t + 1]; k++) {
 *             for (c = 0; c < width; c++)
 *                 first[row[k]][c] += value[k] * (c + 1);
 *             if (second) for (c = 0; c < second_width; c++)
 *                 second[other[k]][c] -= value[k] * (c + 2);
 *         }
 */
#ifndef PROBLEM_H
#define PROBLEM_H

#include "redcc/runtime.h"

#include <stdbool.h>

struct problem {
    const char *name;
    long trip;
    long touches; /* start[trip] */
    int *start;
    int *row;
    int *other;
    double *value;
    int rows, width;
    int second_rows, second_width; /* 0 if there is no second array */
    double *first;                 /* [rows][width] */
    double *second; /* [second_rows][second_width]; with second_in_first a part of `first`, which is
                       larger then */
    bool second_in_first;
    long doubles; /* number of doubles in `first` */
};

/** A loop's description, separate for each problem. */
struct described {
    redcc_array arrays[2];
    redcc_source sources[4];
    redcc_loop loop;
};

enum { PROBLEMS = 14 };

/** Returns problem number `number`, at least 0 and less than PROBLEMS. If `exact`, all values are
 * small integers. */
struct problem problem_new(int number, bool exact);

/** Frees the problem's memory. */
void problem_free(struct problem *problem);

/** Sets the arrays to their initial contents. */
void problem_reset(struct problem *problem);

/** Makes auto believe that each iteration of the original loop took `seconds` in a great many
 * earlier calls, and each plan construction ten times as long. Then auto constructs a plan in one
 * of the next calls, whatever the machine's load is. The loop must have been executed once. */
void problem_tell_slow(redcc_loop *loop, long trip, double seconds);

/** If true (initially), problem_run calls problem_tell_slow after a call that ran serially, if no
 * method is named. */
extern bool problem_run_tells;

/** The number of additions that an iteration's slice makes before it finds the touched rows. */
extern int problem_searches;

/** Executes the loop in the form that redcc generates. Returns 1 if it ran in parallel, or 0 if
 * serially. Sets *last to 3 t + 1, where t is the last iteration. */
int problem_run(struct problem *problem, struct described *described, int threads, long *last);

/** Like problem_run, but OpenMP gives only `given` of the requested threads. */
int problem_run_fewer(struct problem *problem, struct described *described, int threads, int given,
                      long *last);

/** Describes the problem's loop. */
void problem_describe(const struct problem *problem, struct described *described);

/** Executes the loop sequentially on the current arrays: the expected result. */
void problem_oracle(struct problem *problem);

/** Returns the next number of a pseudo-random sequence that is the same on every machine. */
unsigned long next_random(unsigned long *state);

#endif
