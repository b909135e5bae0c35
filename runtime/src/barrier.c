/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* sched_getaffinity */
#include "barrier.h"

#include <limits.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#endif

enum {
    SPINS = 4000, /* some 20 to 100 microseconds: longer than a balanced loop's threads differ */
    YIELDS = 4    /* then leave the core to whom we wait for, then sleep */
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

static bool passed(struct barrier *barrier, unsigned phase) {
    return atomic_load_explicit(&barrier->phase, memory_order_acquire) != phase;
}

/* Sleeps until the phase is another. Either we are counted as asleep before the phase changes and
 * are woken, or the kernel finds the phase changed and does not let us sleep. */
static void sleep_in_phase(struct barrier *barrier, unsigned phase) {
    atomic_fetch_add(&barrier->asleep, 1);
    while (atomic_load(&barrier->phase) == phase) {
#ifdef __linux__
        syscall(SYS_futex, &barrier->phase, FUTEX_WAIT_PRIVATE, phase, NULL, NULL, 0);
#else
        const struct timespec nap = {0, 50 * 1000};
        nanosleep(&nap, NULL);
#endif
    }
    atomic_fetch_sub(&barrier->asleep, 1);
}

static void wait_for_phase_after(struct barrier *barrier, unsigned phase, int threads) {
    if (threads <= cores())
        for (int spin = 0; spin < SPINS; spin++) {
            if (passed(barrier, phase))
                return;
            relax();
        }
    for (int yield = 0; yield < YIELDS; yield++) {
        if (passed(barrier, phase))
            return;
        sched_yield();
    }
    sleep_in_phase(barrier, phase);
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
    atomic_fetch_add(&barrier->phase, 1);
#ifdef __linux__
    if (atomic_load(&barrier->asleep) > 0)
        syscall(SYS_futex, &barrier->phase, FUTEX_WAKE_PRIVATE, INT_MAX, NULL, NULL, 0);
#endif
}

void redcc_barrier_wait(struct barrier *barrier, int threads) {
    if (redcc_barrier_arrive(barrier, threads))
        redcc_barrier_release(barrier);
}
