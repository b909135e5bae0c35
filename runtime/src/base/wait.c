/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/wait.h"

#include "base/affinity.h"
#include "base/clock.h"
#include "base/system.h"

#include <limits.h>

#ifdef __linux__
#include <linux/futex.h>
#endif

enum {
    SPINS = 4000, /* spins take some 20 to 100 microseconds, longer than the differences between the
                     threads of a balanced loop */
    IDLE = 1000,  /* number of spins of an idle thread (docs/decisions/0002) */
    YIELDS = 4,   /* how often the thread yields its core after the spins, before it sleeps */
    FULL = 1024
};

/* A thread spins for part / FULL of the full number of spins; `part` changes with exponential
 * back-off. If another program occupies the core of the awaited thread, spinning wastes a second
 * core. So a wait that ended after a long sleep halves `part`. A wait that ended during the spins,
 * or after a short sleep, doubles it. */
struct spinning {
    int part;
};

static _Thread_local struct spinning at_barriers
    __attribute__((__tls_model__("initial-exec"))) = {FULL};
static _Thread_local struct spinning in_between
    __attribute__((__tls_model__("initial-exec"))) = {FULL};
static const double soon = 0.1e-3; /* time in seconds, an upper limit of the time of SPINS spins */

static void note(struct spinning *it, bool was_worth_it) {
    const int next = was_worth_it ? 2 * it->part : it->part / 2;
    it->part = next > FULL ? FULL : next > 1 ? next : 1;
}

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

/* No wake-up is lost. Either this thread is counted in *asleep before another thread changes the
 * word, and is woken. Or the kernel finds that the word has changed, and returns at once. */
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

static bool changes_in(int most, struct spinning *spinning, atomic_uint *word, unsigned value) {
    const int spins = (int)((long)most * spinning->part / FULL);
    for (int spin = 0; spin < spins; spin++) {
        if (changed(word, value)) {
            note(spinning, true);
            return true;
        }
        relax();
    }
    return false;
}

static void sleep_and_learn(struct spinning *spinning, atomic_uint *word, unsigned value,
                            atomic_int *asleep) {
    const double began = redcc_seconds();
    sleep_while(word, value, asleep);
    note(spinning, redcc_seconds() - began < soon);
}

void redcc_wait_idle(atomic_uint *word, unsigned value, atomic_int *asleep) {
    if (!changes_in(IDLE, &in_between, word, value))
        sleep_and_learn(&in_between, word, value, asleep);
}

void redcc_wait_while(atomic_uint *word, unsigned value, atomic_int *asleep, int threads) {
    if (threads <= cores() && changes_in(SPINS, &at_barriers, word, value))
        return;
    for (int yield = 0; yield < YIELDS; yield++) {
        if (changed(word, value))
            return;
        redcc_system_yield();
    }
    sleep_and_learn(&at_barriers, word, value, asleep);
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
