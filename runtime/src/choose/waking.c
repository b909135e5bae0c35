/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/waking.h"

#include "base/clock.h"
#include "base/cores.h"
#include "base/team.h"

#include <stdatomic.h>

/* Seconds that waking the threads takes: a smoothed measurement of all loops'. Before the first, as
 * much as on a machine that is not busy; more than `most` is a busy one, whose loops are compared
 * with a plan all the same. */
static const double first_wake = 10e-6, most_wake = 50e-6;
static _Atomic double wake;

/* Seconds that starting a thread takes. Before it was measured, as on a machine that is not busy:
 * 0.1 to 0.4 ms, since who asks for a thread does not keep it waiting (base/cores.h), and as long
 * as making them for each further one, which come side by side. Where other programs want the cores
 * it is 2 to 6 ms: they wait for their turn. */
static const double first_start = 0.4e-3, next_start = 0.05e-3, turn = 4e-3;
static _Atomic double start;

/* ... that a loop's first region takes where the program's own have started the threads. */
static const double first_region = 0.1e-3;

double redcc_wake_seconds(void) {
    const double measured = atomic_load_explicit(&wake, memory_order_relaxed);
    return measured > 0 ? measured : first_wake;
}

/* A look takes 4 microseconds, but 15 to 400 after a loop whose data filled the caches: it holds
 * for a while. Not for long: it may have met another program that was there for a moment. */
static const double least_between_looks = 1e-3;

double redcc_start_seconds(int missing, bool wanted) {
    const double measured = atomic_load_explicit(&start, memory_order_relaxed);
    if (missing == 0)
        return first_region;
    const double usual =
        measured > 0 ? missing * measured : first_start + (missing - 1) * next_start;
    const double likely = usual < turn && wanted ? turn : usual;
    return likely > first_region ? likely : first_region;
}

static double look_for_start(int threads) {
    const int missing = redcc_team_to_start(threads);
    return redcc_start_seconds(missing, missing > 0 && redcc_cores_are_wanted(missing));
}

double redcc_likely_start(int threads) {
    static _Thread_local struct {
        double looked, found;
        int threads;
    } last __attribute__((__tls_model__("initial-exec")));
    if (redcc_team_missing(threads) == 0)
        return 0;
    const double now = redcc_seconds();
    if (last.threads != threads || now - last.looked > least_between_looks) {
        last.threads = threads;
        last.looked = now;
        last.found = look_for_start(threads);
    }
    return last.found;
}

double redcc_least_start(int threads) {
    return redcc_team_missing(threads) > 0 ? first_region : 0;
}

void redcc_note_waking(double seconds, int started) {
    if (seconds <= 0)
        return;
    if (started > 0) {
        atomic_store_explicit(&start, seconds / started, memory_order_relaxed);
        return;
    }
    const double now = seconds < most_wake ? seconds : most_wake, before = redcc_wake_seconds();
    atomic_store_explicit(&wake, before + (now - before) / 8, memory_order_relaxed);
}
