/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sums of floating scalars in loops inside, `e += f(i, j)`: how many operands an iteration has is
 * not known before, and their order is the sequential loop's. Each thread writes those of the
 * iterations that it executes one behind the other; at the end the first thread applies them in the
 * order of the iterations.
 *
 *     redcc_series_take       one thread    before redcc_enter: room for a part an iteration
 *     redcc_series_join       each thread   after redcc_join
 *     REDCC_SERIES_NEXT       each thread   an iteration begins
 *     redcc_series_put        each thread   an operand
 *     redcc_series_again      each thread   once redcc_next has returned 0: where there was no
 *                                           memory for an operand, the first thread executes all
 *                                           iterations once more, without any update, and adds up
 *     redcc_series_is_over    each thread   1: it is the first, and the loop is done
 *     REDCC_SERIES_APPLY      that thread
 *     redcc_series_give       one thread    after redcc_leave
 *
 * runtime.h includes this file.
 */
#ifndef REDCC_SERIES_H
#define REDCC_SERIES_H

typedef struct redcc_series redcc_series;

/** Operands of one iteration, in order. */
typedef struct redcc_series_part {
    struct redcc_series_part *more; /**< those that come after; NULL: none */
    redcc_size count;
    double value[1]; /**< count of them; a float is a double's value as well */
} redcc_series_part;

/** A thread's. */
typedef struct redcc_series_writer {
    redcc_series *series;
    redcc_series_part *part; /**< of the iteration at hand; NULL: it has none yet */
    double *at, *end;        /**< where the next operand goes; equal: there is no room for it */
    double *block_end;       /**< behind the memory that `at` leads into */
    int adds;                /**< the thread adds up by itself: there is never room */
    int begins;              /**< and has not begun yet */
} redcc_series_writer;

#if defined(__GNUC__)
#pragma GCC visibility push(default)
#endif

/** Room for a loop of so many iterations. NULL: trip is not positive, or there is no memory (which
 *  is reported), and the original loop must run. */
redcc_series *redcc_series_take(redcc_loop *loop, redcc_int trip);

/** Gives it back; NULL does nothing. */
void redcc_series_give(redcc_series *series);

void redcc_series_join(redcc_series_writer *writer, redcc_series *series);

/** Called by redcc_series_put: makes room for an operand of iteration number k. 0: there is none,
 *  and what the thread adds up takes it. */
int redcc_series_room(redcc_series_writer *writer, redcc_int k) __attribute__((__cold__));

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

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

#define REDCC_SERIES_NEXT(redcc_writer)                                                            \
    ((redcc_writer).part = 0, (redcc_writer).end = (redcc_writer).at)

/** Keeps an operand of iteration number k; 0: there is no room. */
static __inline__ int redcc_series_put(redcc_series_writer *writer, redcc_int k, double operand) {
    if (writer->at == writer->end && !redcc_series_room(writer, k))
        return 0;
    *writer->at++ = operand;
    writer->part->count++;
    return 1;
}

/** The thread that adds up by itself begins with the scalar as it is, where it is ever updated. */
#define REDCC_SERIES_BEGIN(redcc_writer, redcc_own, redcc_scalar)                                  \
    ((redcc_writer).begins && redcc_series_has_any((redcc_writer).series)                          \
         ? ((redcc_writer).begins = 0, (void)(redcc_own = redcc_scalar))                           \
         : (void)0)

/** What the scalar, of type redcc_type, is after the loop: redcc_sum. Its operation is made in
 *  redcc_operand. */
#define REDCC_SERIES_APPLY(redcc_writer, redcc_type, redcc_operand, redcc_operator, redcc_scalar,  \
                           redcc_own, redcc_sum, redcc_is_set)                                     \
    if (redcc_series_has_any((redcc_writer).series)) {                                             \
        redcc_int redcc__i = 0;                                                                    \
        redcc_size redcc__j;                                                                       \
        const redcc_series_part *redcc__part;                                                      \
        if (!(redcc_writer).adds) {                                                                \
            redcc_own = redcc_scalar;                                                              \
            while ((redcc__part = redcc_series_find((redcc_writer).series, &redcc__i)) != 0)       \
                for (redcc__i++; redcc__part; redcc__part = redcc__part->more)                     \
                    for (redcc__j = 0; redcc__j < redcc__part->count; redcc__j++)                  \
                        redcc_own = (redcc_type)(redcc_own redcc_operator(redcc_operand)           \
                                                     redcc__part->value[redcc__j]);                \
        }                                                                                          \
        redcc_sum = redcc_own;                                                                     \
        redcc_is_set = 1;                                                                          \
    }

#endif
