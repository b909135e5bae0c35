/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * REDCC_METHOD=auto: serial or parallel, and which method. docs/methods.md has the table.
 *
 * Executions are timed, and for each size of a loop (trip counts between two powers of two) the
 * faster course is kept. Who waits in a serial course tries again, at growing distances.
 * Used by one thread at a time: the one that holds the loop.
 */
#ifndef REDCC_CHOOSE_H
#define REDCC_CHOOSE_H

#include "method.h"
#include "reason.h"

enum course {
    COURSE_UNDECIDED,
    COURSE_SERIAL,  /* the original loop */
    COURSE_SOLO,    /* one thread of the region executes all, in order, timed */
    COURSE_PARALLEL /* a method */
};

/** What is known of a loop at trip counts of one size. */
struct trial {
    enum course decided; /* UNDECIDED, SERIAL or PARALLEL */
    enum reason reason;  /* for SERIAL */
    int threads;
    int serial_tries;
    int parallel_tries;
    int slow; /* executions in turn in which PARALLEL took longer than serial_best */
    long calls;
    long retry_at;      /* SERIAL: this call tries again */
    long rest;          /* how many calls the last decision for SERIAL rested */
    double serial_best; /* seconds an iteration */
    double parallel_best;
};

struct chooser {
    struct trial trial[64]; /* by the logarithm of the trip count */
};

/** What to do in this call; for COURSE_SERIAL also why. */
enum course redcc_choose_course(struct chooser *chooser, redcc_int trip, int threads,
                                enum reason *reason);

/** How long a SOLO or PARALLEL course took. */
void redcc_choose_learn(struct chooser *chooser, redcc_int trip, enum course course,
                        double seconds);

/** The course could not be taken (a guard, too much replication, memory). */
void redcc_choose_refused(struct chooser *chooser, redcc_int trip, enum reason reason);

/** The method for a loop: `executed` is the most iterations that one of the threads would execute
 *  by LOCALWRITE, `copies_possible` whether private copies may and can be had. NULL: serial. */
const struct method *redcc_choose_method(redcc_int trip, redcc_int executed, bool copies_possible);

#endif
