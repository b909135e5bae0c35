/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The order of the domains' passes (solver_domains.c), without barriers. A domain that is swept
 * waits until its neighbours have completed a pass, and then ends its own. Threads that wait only
 * for neighbours are busy although three domains of a kind do not divide between two threads.
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

/** Waits until all neighbours of the domain have completed this pass. turn: [domains] */
void domain_turn_await(domain_turn *turn, int domain, unsigned pass);

/** Ends a domain's pass. What the calling thread wrote before is seen by all that wait for it. */
void domain_turn_end(domain_turn *turn, unsigned pass);

#endif
