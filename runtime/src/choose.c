/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose.h"

/* Measured or reckoned; docs/methods.md says how. */
enum { SMALL_TRIP = 4096 };
static const double least_seconds = 10e-6; /* a region and its barriers take 2 to 10 microseconds */
static const double most_share = 0.85;     /* of the iterations, executed by one thread */
static const double slack = 1.05;

static struct trial *trial_of(struct chooser *chooser, redcc_int trip) {
    return &chooser->trial[63 - __builtin_clzll((unsigned long long)trip | 1)];
}

static void rest(struct trial *trial, enum reason reason, long first, long factor, long most) {
    trial->rest = trial->rest ? trial->rest * factor : first;
    trial->rest = trial->rest > most ? most : trial->rest;
    trial->decided = COURSE_SERIAL;
    trial->reason = reason;
    trial->retry_at = trial->calls + trial->rest;
}

static void try_again(struct trial *trial) {
    trial->decided = COURSE_UNDECIDED;
    trial->serial_tries = trial->parallel_tries = trial->slow = 0;
}

/* The first parallel execution is not counted: threads start, a plan is made, pages are touched. */
enum { PARALLEL_TRIES = 3 };

static int serial_tries_needed(redcc_int trip) {
    return trip < SMALL_TRIP ? 2 : 1;
}

enum course redcc_choose_course(struct chooser *chooser, redcc_int trip, int threads,
                                enum reason *reason) {
    struct trial *trial = trial_of(chooser, trip);
    if (trial->threads != threads)
        *trial = (struct trial){.threads = threads};
    trial->calls++;
    if (trial->decided == COURSE_SERIAL) {
        *reason = trial->reason;
        if (trial->calls < trial->retry_at)
            return COURSE_SERIAL;
        try_again(trial);
    }
    if (trial->decided == COURSE_PARALLEL)
        return COURSE_PARALLEL;
    if (trip < SMALL_TRIP && trial->calls == 1) {
        *reason = REASON_LITTLE_WORK;
        return COURSE_SERIAL; /* once is no reason to wake threads */
    }
    if (trip < SMALL_TRIP && trial->serial_tries == 0)
        return COURSE_SOLO;
    if (trial->parallel_tries < PARALLEL_TRIES - 1)
        return COURSE_PARALLEL;
    return trial->serial_tries < serial_tries_needed(trip) ? COURSE_SOLO : COURSE_PARALLEL;
}

static void learn_serial(struct trial *trial, redcc_int trip, double seconds) {
    const double each = seconds / (double)trip;
    if (trial->serial_tries++ == 0 || each < trial->serial_best)
        trial->serial_best = each;
    if (trip < SMALL_TRIP && seconds < least_seconds)
        rest(trial, REASON_LITTLE_WORK, 256, 4, 1 << 20);
}

static void learn_parallel(struct trial *trial, redcc_int trip, double seconds) {
    const double each = seconds / (double)trip;
    if (trial->decided == COURSE_PARALLEL) {
        trial->slow = each > trial->serial_best * slack ? trial->slow + 1 : 0;
        if (trial->slow == 16)
            try_again(trial);
        return;
    }
    const int before = trial->parallel_tries++;
    if (before == 1 || (before > 1 && each < trial->parallel_best))
        trial->parallel_best = each;
    if (trial->parallel_tries < PARALLEL_TRIES || trial->serial_tries < serial_tries_needed(trip))
        return;
    if (trial->parallel_best < trial->serial_best)
        trial->decided = COURSE_PARALLEL;
    else
        rest(trial, REASON_SERIAL_FASTER, 256, 4, 1 << 20);
}

void redcc_choose_learn(struct chooser *chooser, redcc_int trip, enum course course,
                        double seconds) {
    struct trial *trial = trial_of(chooser, trip);
    if (course == COURSE_SOLO)
        learn_serial(trial, trip, seconds);
    else
        learn_parallel(trial, trip, seconds);
}

void redcc_choose_refused(struct chooser *chooser, redcc_int trip, enum reason reason) {
    struct trial *trial = trial_of(chooser, trip);
    if (reason == REASON_REPLICATION)
        rest(trial, reason, 16, 4, 1 << 20);
    else /* may be otherwise for the next call's arrays */
        rest(trial, reason, 2, 2, 64);
}

const struct method *redcc_choose_method(redcc_int trip, redcc_int executed, bool copies_possible) {
    if ((double)executed <= most_share * (double)trip)
        return &redcc_method_localwrite;
    return copies_possible ? &redcc_method_expansion : NULL;
}
