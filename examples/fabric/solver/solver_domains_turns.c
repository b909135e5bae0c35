/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solver_domains_turns.h"

#include <sched.h>

/* A thread that has waited for this number of spins, some 20 us, lets others use its core: the
 * thread that it waits for may have none. */
enum { SPINS = 1000 };

static void relax(void) {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
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

static void await_one(const domain_turn *turn, long pass) {
    for (int spins = 0; atomic_load_explicit(&turn->passes, memory_order_acquire) < pass; spins++)
        if (spins < SPINS)
            relax();
        else
            sched_yield();
}

void domain_turn_await(const domain_turn *turn, int domain, long pass) {
    const domain_turn *of = &turn[domain];
    for (int n = of->first; of->has_any && n <= of->last; n += 2)
        await_one(&turn[n], pass);
}

void domain_turn_end(domain_turn *turn, long pass) {
    atomic_store_explicit(&turn->passes, pass, memory_order_release);
}
