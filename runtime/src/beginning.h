/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The first execution of a loop with heavy iterations (REDCC_BEGINS): it may be long, and the only
 * one. The calling thread executes some iterations in order and times them. If the loop will take
 * long, the others are executed as a loop of their own, whose sequential time is then known.
 */
#ifndef REDCC_BEGINNING_H
#define REDCC_BEGINNING_H

#include "redcc/entry.h"

enum { BEGINNING_KEYS = 16 };

struct beginning {
    redcc_int done;     /**< iterations; 0: none */
    redcc_attempt rest; /**< the others, if there are both */
    redcc_word key[BEGINNING_KEYS];
};

/** Executes and times the first iterations if the loop was never executed before, perhaps all of
 *  them. `threads` would execute the others. */
void redcc_begin_in_order(struct beginning *beginning, redcc_site *site,
                          const redcc_attempt *attempt, redcc_member *member, const void *context,
                          int threads);

/** Executes iterations `from` and later ones of `attempt` in order. */
void redcc_end_in_order(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context, redcc_int from);

#endif
