/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The processors that a thread may run on, and how it is moved to some of them: the system moves a
 * thread at once that may not stay where it is. All of it may be called by any thread, for itself
 * (thread 0) or another of the process (its number in the system).
 */
#ifndef REDCC_AFFINITY_H
#define REDCC_AFFINITY_H

#include <stdbool.h>
#include <stddef.h>

/** Words of a set of processors, by their numbers: no system has more. */
enum { REDCC_CORE_WORDS = 8192 / (8 * sizeof(unsigned long)) };

struct processors {
    unsigned long word[REDCC_CORE_WORDS]; /**< bit n % 64 of word n / 64: processor n */
    long bytes;                           /**< that the system knows of; 0: there are none */
};

/** Those that the thread may run on; none where that is not known here. */
struct processors redcc_processors_of(long thread);

/** These but for those in `taken` (`words` of them); none if all are. */
struct processors redcc_processors_without(struct processors these, const unsigned long *taken,
                                           size_t words);

/** That one of these; none if it is not among them. */
struct processors redcc_processors_only(struct processors these, int core);

/** Moves the thread to one of these; afterwards it may run on `allowed` again. False: there are
 *  none, or it cannot be done here. */
bool redcc_processors_move(long thread, const struct processors *these,
                           const struct processors *allowed);

/** Moves the calling thread to one that it may run on and that is not in `taken`; afterwards it may
 *  run where it might before. False: there is none, or it cannot be done here. */
bool redcc_processors_leave(const unsigned long *taken, size_t words);

/** How many the calling thread may run on; at least 1. */
int redcc_processors_here(void);

#endif
