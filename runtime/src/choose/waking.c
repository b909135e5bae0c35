/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/waking.h"

#include "base/affinity.h"
#include "base/clock.h"
#include "base/system.h"
#include "base/team.h"
#include "learn/constants.h"

#include <assert.h>
#include <stdatomic.h>

/* `wake`: the measured seconds to wake a region's threads (smoothed). `start`: the measured seconds
 * to start one thread (the last measurement). Both are for all loops; 0: not measured yet.
 * time_slice: if other programs use the cores, a new thread waits about as long. first_region: if
 * the program's own regions have started the threads, a loop's first region takes about as long. */
static _Atomic double wake, start;
static const double first_wake = LEARN_SAMPLE / 40, time_slice = 10 * LEARN_SAMPLE,
                    first_region = LEARN_SAMPLE / 4;

double redcc_wake_seconds(void) {
    const double measured = atomic_load_explicit(&wake, memory_order_relaxed);
    return measured > 0 ? measured : first_wake;
}

/* In this time (in seconds), a thread queries the number of running threads at most once, unless it
 * asks about another number of threads for a region. A query takes 4 microseconds, but 15 to 400
 * microseconds after a loop whose data filled the caches. The result is not used for longer,
 * because another program may have run only for a moment. */
static const double least_between_looks = 1e-3;

double redcc_start_seconds(int missing, bool wanted) {
    assert(missing >= 0);
    const double measured = atomic_load_explicit(&start, memory_order_relaxed);
    if (missing == 0)
        return first_region;
    const double usual =
        measured > 0 ? missing * measured : LEARN_SAMPLE * (1 + (missing - 1) / 8.0);
    const double likely = usual < time_slice && wanted ? time_slice : usual;
    return likely > first_region ? likely : first_region;
}

static bool cores_are_wanted(int more) {
    const int online = redcc_system_online();
    return online == redcc_processors_here() && redcc_system_running() + more > online;
}

static double look_for_start(int threads) {
    const int missing = redcc_team_to_start(threads);
    return redcc_start_seconds(missing, missing > 0 && cores_are_wanted(missing));
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
    const double most = 5 * first_wake; /* if waking takes longer, the machine is busy, and longer
                                           times must not prevent that loops are tried */
    const double now = seconds < most ? seconds : most, before = redcc_wake_seconds();
    atomic_store_explicit(&wake, before + (now - before) / (2 * LEARN_STABLE),
                          memory_order_relaxed);
}
