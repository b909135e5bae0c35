/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Operands of floating scalars in loops inside (redcc/series.h). */
#ifndef REDCC_SERIES_SOURCE_H
#define REDCC_SERIES_SOURCE_H

#include <redcc/runtime.h>

/** Room for a loop of so many iterations. NULL: trip is not positive, or there is no memory (which
 *  is reported), and the original loop must run. */
redcc_series *redcc_series_take(redcc_loop *loop, redcc_int trip);

/** Gives it back; NULL does nothing. */
void redcc_series_give(redcc_series *series);

void redcc_series_join(redcc_series_writer *writer, redcc_series *series);

/** Called by redcc_series_put: makes room for an operand of iteration number k. 0: there is none,
 *  and what the thread adds up takes it. */
int redcc_series_room(redcc_series_writer *writer, redcc_int k);

/** Hands out all iterations once more, as redcc_next does, to the first of the threads, where
 *  operands were lost. To be called with all series of the loop by each thread until it returns
 *  0. */
int redcc_series_again(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);

/** 1 for the first thread, where the loop is done. All operands are there then. */
int redcc_series_is_over(const redcc_worker *worker);

/** Does any iteration have an operand? */
int redcc_series_has_any(const redcc_series *series);

/** The operands of the first iteration from *k on that has any, and its number; NULL: there are
 *  none left. */
const redcc_series_part *redcc_series_find(const redcc_series *series, redcc_int *k);

#endif
