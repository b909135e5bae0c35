/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The number of shares into which the iterations of a loop are divided if its order is fixed, but
 * need not be that of the loop. Each share but the first needs a private copy of the arrays. The
 * number never depends on threads, time or free memory, so that all executions give the same bits.
 */
#ifndef REDCC_SHARE_COUNT_H
#define REDCC_SHARE_COUNT_H

#include "redcc/runtime.h"

enum { REDCC_MOST_SHARES = 16 };

/** An estimate of the number of updates, by the loop's flags. */
double redcc_updates(const redcc_loop *loop, redcc_int trip);

/** The number of shares, if the loop makes `updates` updates and a private copy has `bytes` bytes.
 * Below 2: the loop is executed in its own order. `memory_limit` is that of the settings; 0: none.
 */
int redcc_share_count(const redcc_loop *loop, redcc_int trip, double updates, redcc_size bytes,
                      redcc_size memory_limit);

/** The first iteration of share number `share` of `shares`: a multiple of REDCC_SUM_BLOCK, but for
 * the end of the last share. */
redcc_int redcc_share_begin(redcc_int trip, int shares, int share);

#endif
