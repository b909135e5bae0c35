/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/barrier.h"

#include <assert.h>

#include "base/wait.h"

bool redcc_barrier_arrive(struct barrier *barrier, int threads) {
    const unsigned phase = atomic_load_explicit(&barrier->phase, memory_order_relaxed);
    const unsigned before = atomic_fetch_add_explicit(&barrier->arrived, 1, memory_order_acq_rel);
    assert(before < (unsigned)threads);
    if (before + 1 == (unsigned)threads)
        return true;
    redcc_wait_while(&barrier->phase, phase, &barrier->asleep, threads);
    return false;
}

void redcc_barrier_release(struct barrier *barrier) {
    assert(atomic_load(&barrier->arrived) > 0); /* the last thread to arrive calls this function */
    atomic_store_explicit(&barrier->arrived, 0, memory_order_relaxed);
    atomic_fetch_add(&barrier->phase, 1);
    redcc_wake(&barrier->phase, &barrier->asleep);
}

void redcc_barrier_wait(struct barrier *barrier, int threads) {
    if (redcc_barrier_arrive(barrier, threads))
        redcc_barrier_release(barrier);
}
