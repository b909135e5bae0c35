/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for syscall */
#include "solver_domains_turns.h"

#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#else
#include <sched.h>
#endif

/* A thread spins before it sleeps: MOST_SPINS times, about 50 us, if its waits are short. A wait
 * that had to sleep halves the number, because the awaited thread may have no core. */
enum { MOST_SPINS = 2048 };
static _Thread_local int spins = MOST_SPINS;

static void relax(void) {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

static int has_made(const domain_turn *turn, unsigned pass) {
    return (int)(atomic_load_explicit(&turn->passes, memory_order_acquire) - pass) >= 0;
}

/* No wake-up is lost: either domain_turn_end finds this thread in `asleep`, or the kernel finds
 * that `passes` has changed and returns at once. */
static void sleep_until(domain_turn *turn, unsigned pass) {
    atomic_fetch_add(&turn->asleep, 1);
    for (;;) {
        const unsigned now = atomic_load(&turn->passes);
        if ((int)(now - pass) >= 0)
            break;
#ifdef __linux__
        syscall(SYS_futex, &turn->passes, FUTEX_WAIT_PRIVATE, now, NULL, NULL, 0);
#else
        sched_yield();
#endif
    }
    atomic_fetch_sub(&turn->asleep, 1);
}

static void await_one(domain_turn *turn, unsigned pass) {
    for (int spin = 0; spin < spins; spin++) {
        if (has_made(turn, pass)) {
            spins = spin > 0 && spins < MOST_SPINS ? 2 * spins : spins;
            return;
        }
        relax();
    }
    spins = spins > 1 ? spins / 2 : 1;
    sleep_until(turn, pass);
}

void domain_turn_add_neighbour(domain_turn *turn, int domain) {
    turn->first = !turn->has_any || domain < turn->first ? domain : turn->first;
    turn->last = !turn->has_any || domain > turn->last ? domain : turn->last;
    turn->has_any = 1;
}

void domain_turns_begin(domain_turn *turn, int count) {
    for (int n = 0; n < count; n++)
        atomic_store_explicit(&turn[n].passes, 0, memory_order_relaxed);
}

void domain_turn_await(domain_turn *turn, int domain, unsigned pass) {
    const domain_turn *of = &turn[domain];
    for (int n = of->first; of->has_any && n <= of->last; n += 2)
        if (!has_made(&turn[n], pass))
            await_one(&turn[n], pass);
}

void domain_turn_end(domain_turn *turn, unsigned pass) {
    atomic_store(&turn->passes, pass);
#ifdef __linux__
    if (atomic_load(&turn->asleep) > 0)
        syscall(SYS_futex, &turn->passes, FUTEX_WAKE_PRIVATE, 1 << 30, NULL, NULL, 0);
#endif
}
