/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* sched_getaffinity */
#include "barrier.h"

#include <sched.h>
#include <time.h>
#include <unistd.h>

enum {
    SPINS = 4000, /* some 20 to 100 microseconds: longer than a balanced loop's threads differ */
    YIELDS = 200  /* then leave the core to whom we wait for, then sleep */
};

static int cores(void) {
    static atomic_int known;
    int count = atomic_load_explicit(&known, memory_order_relaxed);
    if (count == 0) {
        count = (int)sysconf(_SC_NPROCESSORS_ONLN);
        cpu_set_t allowed;
        if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
            count = CPU_COUNT(&allowed);
        count = count < 1 ? 1 : count;
        atomic_store_explicit(&known, count, memory_order_relaxed);
    }
    return count;
}

static inline void relax(void) {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ __volatile__("yield");
#endif
}

static void wait_for_phase_after(struct barrier *barrier, unsigned phase, int threads) {
    if (threads <= cores())
        for (int spin = 0; spin < SPINS; spin++) {
            if (atomic_load_explicit(&barrier->phase, memory_order_acquire) != phase)
                return;
            relax();
        }
    for (int yield = 0; yield < YIELDS; yield++) {
        if (atomic_load_explicit(&barrier->phase, memory_order_acquire) != phase)
            return;
        sched_yield();
    }
    const struct timespec nap = {0, 50 * 1000};
    while (atomic_load_explicit(&barrier->phase, memory_order_acquire) == phase)
        nanosleep(&nap, NULL);
}

bool redcc_barrier_arrive(struct barrier *barrier, int threads) {
    const unsigned phase = atomic_load_explicit(&barrier->phase, memory_order_relaxed);
    const unsigned before = atomic_fetch_add_explicit(&barrier->arrived, 1, memory_order_acq_rel);
    if (before + 1 == (unsigned)threads)
        return true;
    wait_for_phase_after(barrier, phase, threads);
    return false;
}

void redcc_barrier_release(struct barrier *barrier) {
    atomic_store_explicit(&barrier->arrived, 0, memory_order_relaxed);
    atomic_fetch_add_explicit(&barrier->phase, 1, memory_order_release);
}

void redcc_barrier_wait(struct barrier *barrier, int threads) {
    if (redcc_barrier_arrive(barrier, threads))
        redcc_barrier_release(barrier);
}
