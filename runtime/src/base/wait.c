/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/wait.h"

#include "base/affinity.h"
#include "base/system.h"

#include <limits.h>

#ifdef __linux__
#include <linux/futex.h>
#endif

enum {
    SPINS = 4000, /* some 20 to 100 microseconds: longer than a balanced loop's threads differ */
    IDLE = 1000,  /* docs/decisions/0002 */
    YIELDS = 4    /* then leave the core to whom we wait for, then sleep */
};

static int cores(void) {
    static atomic_int known;
    int count = atomic_load_explicit(&known, memory_order_relaxed);
    if (count == 0) {
        count = redcc_processors_here();
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

/* Either we are counted as asleep before the word changes and are woken, or the kernel finds it
 * changed and does not let us sleep. */
static void sleep_while(atomic_uint *word, unsigned value, atomic_int *asleep) {
    atomic_fetch_add(asleep, 1);
    while (atomic_load(word) == value) {
#ifdef __linux__
        redcc_system(SYS_futex, word, FUTEX_WAIT_PRIVATE, value);
#else
        redcc_system_yield();
#endif
    }
    atomic_fetch_sub(asleep, 1);
}

static bool changed(atomic_uint *word, unsigned value) {
    return atomic_load_explicit(word, memory_order_acquire) != value;
}

static bool changes_in(int spins, atomic_uint *word, unsigned value) {
    for (int spin = 0; spin < spins; spin++) {
        if (changed(word, value))
            return true;
        relax();
    }
    return false;
}

void redcc_wait_idle(atomic_uint *word, unsigned value, atomic_int *asleep) {
    if (!changes_in(IDLE, word, value))
        sleep_while(word, value, asleep);
}

void redcc_wait_while(atomic_uint *word, unsigned value, atomic_int *asleep, int threads) {
    if (threads <= cores() && changes_in(SPINS, word, value))
        return;
    for (int yield = 0; yield < YIELDS; yield++) {
        if (changed(word, value))
            return;
        redcc_system_yield();
    }
    sleep_while(word, value, asleep);
}

void redcc_wake(atomic_uint *word, atomic_int *asleep) {
#ifdef __linux__
    if (atomic_load(asleep) > 0)
        redcc_system(SYS_futex, word, FUTEX_WAKE_PRIVATE, INT_MAX);
#else
    (void)word;
    (void)asleep;
#endif
}
