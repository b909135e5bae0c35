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
    int second_rows, second_width; /* 0: there is no second array */
    double *first;                 /* [rows][width] */
    double *second; /* [second_rows][second_width]; may lie in `first`, which is larger then */
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

/** Problem number 0 <= number < PROBLEMS; `exact`: all values are small integers. */
struct problem problem_new(int number, bool exact);

/** Frees its memory. */
void problem_free(struct problem *problem);

/** Sets the arrays to their initial contents. */
void problem_reset(struct problem *problem);

/** Makes auto believe that each iteration of the original loop took `seconds` in very many earlier
 * calls, and each plan construction ten times as long. Then auto constructs a plan in one of the
 * next calls, whatever the machine's load. The loop must have been executed once. */
void problem_tell_slow(redcc_loop *loop, long trip, double seconds);

/** Does problem_run call problem_tell_slow after a call that ran serially, if no method is named?
 * True initially. */
extern bool problem_run_tells;

/** The number of additions that an iteration's slice makes before it finds the touched rows. */
extern int problem_searches;

/** Executes the loop in the form that redcc generates. Returns 1 if it ran in parallel, 0 if
 * serially. *last becomes 3 t + 1, where t is the last iteration. */
int problem_run(struct problem *problem, struct described *described, int threads, long *last);

/** As problem_run, but OpenMP gives only `given` of the requested threads. */
int problem_run_fewer(struct problem *problem, struct described *described, int threads, int given,
                      long *last);

/** Describes the problem's loop. */
void problem_describe(const struct problem *problem, struct described *described);

/** The oracle: executes the loop sequentially on the current arrays. */
void problem_oracle(struct problem *problem);

/** The next number of a pseudo-random sequence that is the same on every machine. */
unsigned long next_random(unsigned long *state);

#endif
