/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The first execution of a loop with long iterations (REDCC_BEGINS). It may be the only execution,
 * and too long for executing it sequentially. So the calling thread executes some iterations in
 * order and times them. If the loop will take long, the remaining iterations are executed as a
 * separate loop, whose sequential time can now be estimated.
 */
#ifndef REDCC_BEGINNING_H
#define REDCC_BEGINNING_H

#include "redcc/entry.h"

enum { BEGINNING_KEYS = 16 };

struct beginning {
    redcc_int done;     /**< number of iterations executed; 0: none */
    redcc_attempt rest; /**< the other iterations, if 0 < done < trip */
    redcc_word key[BEGINNING_KEYS];
};

/** If the loop was never executed before, and `auto` may decide about it, executes and times its
 * first iterations, or all of them. `threads` is the number of threads for the remaining
 * iterations. */
void redcc_begin_in_order(struct beginning *beginning, redcc_site *site,
                          const redcc_attempt *attempt, redcc_member *member, const void *context,
                          int threads);

/** Executes the iterations of `attempt` from number `from` on, in order. */
void redcc_end_in_order(redcc_site *site, const redcc_attempt *attempt, redcc_member *member,
                        const void *context, redcc_int from);

#endif
