/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Operands of floating scalars in inner loops: the runtime's part of redcc/series.h. */
#ifndef REDCC_SERIES_SOURCE_H
#define REDCC_SERIES_SOURCE_H

#include <redcc/runtime.h>

/** Allocates a series for a loop of `trip` iterations. Returns NULL if the trip count is not
 * positive, or if memory runs out, which is reported. Then the original loop must run. */
redcc_series *redcc_series_alloc(redcc_loop *loop, redcc_int trip);

/** Frees a series; NULL does nothing. */
void redcc_series_free(redcc_series *series);

void redcc_series_join(redcc_series_writer *writer, redcc_series *series);

/** Called by redcc_series_put: provides memory for an operand of iteration number k and returns 1.
 * Returns 0 if the thread is to add its operands directly, or if no memory is left. */
int redcc_series_room(redcc_series_writer *writer, redcc_int k);

/** Called by each thread, with all series of the loop, until it returns 0. If operands were lost,
 * or an iteration has left a fence, hands out all iterations again to the first thread and returns
 * 1, as redcc_next does. */
int redcc_series_repeats(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);

/** Returns 1 to the first thread once the loop is done and all operands are stored; 0 to other
 * threads. */
int redcc_series_is_over(const redcc_worker *worker);

/** Does any iteration have an operand? */
int redcc_series_has_any(const redcc_series *series);

/** Finds the first iteration from number *k on that has operands. Returns the operands and sets *k
 * to the iteration's number. NULL: there is no such iteration. */
const redcc_series_part *redcc_series_find(const redcc_series *series, redcc_int *k);

/** Called when the thread has executed its band of rows: waits until the operands of all bands
 * above were added to the sums. */
void redcc_series_await_band(redcc_worker *worker);

/** The operands of iteration k, which belongs to the thread's band; NULL: it has none. */
const redcc_series_part *redcc_series_part_of(const redcc_series *series, redcc_int k);

/** Called when all operands of the thread's band were added to the sums. Reuses their memory for
 * the thread's next band, and lets the thread with the next band add its operands. */
void redcc_series_end_band(redcc_worker *worker, redcc_series_writer *writers, redcc_u32 count);

#endif
