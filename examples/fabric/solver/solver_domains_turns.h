/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The order of the domains' passes (solver_domains.c), without barriers. A domain that is swept
 * waits until its neighbours have completed a pass, and then ends its own. So two threads stay busy
 * even if, for instance, there are three even domains, which cannot be divided between them
 * equally.
 *
 * No wait lasts forever if each thread makes its passes in the order of their numbers.
 */
#ifndef FABRIC_SOLVER_DOMAINS_TURNS_H
#define FABRIC_SOLVER_DOMAINS_TURNS_H

#include <stdatomic.h>

typedef struct domain_turn {
    int first, last;    /* the neighbours: every second domain from `first` to `last`, if has_any */
    int has_any;        /* is there a neighbour? */
    atomic_uint passes; /* number of the last pass that is complete */
    atomic_int asleep;  /* number of threads that sleep until a pass is complete */
    /* fills the cache line, so that threads that wait for different domains share none */
    char padding[64 - 3 * sizeof(int) - sizeof(atomic_uint) - sizeof(atomic_int)];
} domain_turn;

/** Extends the range of neighbours to this domain. */
void domain_turn_add_neighbour(domain_turn *turn, int domain);

/** Sets the number of each domain's last pass to 0. turn: [count]. Called outside of parallel
 *  regions. */
void domain_turns_begin(domain_turn *turn, int count);

/** A thread spins at most this number of times before it sleeps, about 50 us. */
enum { DOMAIN_TURN_MOST_SPINS = 2048 };

/** Returns the number of spins before the next sleep, after a sleep of `asleep` s. A long sleep
 *  halves the number `now`, because the awaited thread may have no core. A short one doubles it, so
 *  that one busy moment does not make a thread sleep for the rest of the run. */
int domain_turn_next_spins(int now, double asleep);

/** Waits until all neighbours of the domain have completed this pass. turn: [domains] */
void domain_turn_await(domain_turn *turn, int domain, unsigned pass);

/** Ends a domain's pass. What the calling thread wrote before is seen by all that wait for it. */
void domain_turn_end(domain_turn *turn, unsigned pass);

#endif
