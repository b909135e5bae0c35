/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sums of floating scalars in loops inside, `e += f(i, j)`: how many operands an iteration has is
 * not known before, and their order is the sequential loop's. Each thread writes those of the
 * iterations that it executes one behind the other; at the end the first thread applies them in the
 * order of the iterations.
 *
 *     redcc_run               one thread    takes room for a part an iteration (redcc_attempt)
 *     redcc_series_begin      each thread   before anything is executed
 *     REDCC_SERIES_NEXT       each thread   an iteration begins
 *     redcc_series_put        each thread   an operand
 *     REDCC_SERIES_AGAIN      each thread   once there is nothing left to execute: where there was
 *                                           no memory for an operand, the first thread executes all
 *                                           iterations once more, without any update, and adds up
 *     series->is_over         each thread   1: it is the first, and the loop is done
 *     REDCC_SERIES_APPLY      that thread
 *     series->give            one thread    after the loop
 *
 * runtime.h includes this file.
 */
#ifndef REDCC_SERIES_H
#define REDCC_SERIES_H

/** Operands of one iteration, in order. */
struct redcc_series_part {
    struct redcc_series_part *more; /**< those that come after; NULL: none */
    redcc_size count;
    double value[1]; /**< count of them; a float is a double's value as well */
};

/** A thread's. */
struct redcc_series_writer {
    redcc_series *series;
    const redcc_series_calls *calls;
    redcc_series_part *part; /**< of the iteration at hand; NULL: it has none yet */
    double *at, *end;        /**< where the next operand goes; equal: there is no room for it */
    double *block_end;       /**< behind the memory that `at` leads into */
    int adds;                /**< the thread adds up by itself: there is never room */
    int begins;              /**< and has not begun yet */
    int follows;             /**< another thread keeps the operands of the iteration at hand */
    int in_front;            /**< adds: the thread has gone through all iterations before `next`, */
    int added;               /**< and met an operand */
    redcc_int next;          /**< what comes from here on is kept */
};

/** Number `number` of the loop's series is this thread's to write to. */
static __inline__ __attribute__((__unused__)) void redcc_series_begin(redcc_worker *worker,
                                                                      const redcc_attempt *attempt,
                                                                      redcc_series_writer *writers,
                                                                      redcc_u32 number) {
    worker->call->calls->series->join(&writers[number], attempt->series[number]);
    writers[number].calls = worker->call->calls->series;
}

/** An iteration begins: in the guarded form another thread may be to keep its operands, the one
 *  that owns the first byte which it touches, and which goes through all of it. */
#define REDCC_SERIES_NEXT(redcc_writer)                                                            \
    ((redcc_writer).part = 0, (redcc_writer).end = (redcc_writer).at,                              \
     (redcc_writer).follows = redcc__guarded && redcc__worker->manner.follows,                     \
     (redcc_writer).in_front ? (redcc__k == (redcc_writer).next && !(redcc_writer).follows         \
                                    ? (void)(redcc_writer).next++                                  \
                                    : (void)((redcc_writer).in_front = (redcc_writer).adds = 0))   \
                             : (void)0)
/** The first thread adds up by itself as long as its iterations are the loop's first: it begins
 *  with the scalar as it is. */
#define REDCC_SERIES_IN_FRONT(redcc_writer, redcc_own, redcc_scalar)                               \
    if (redcc__worker->thread == 0) {                                                              \
        (redcc_writer).in_front = (redcc_writer).adds = 1;                                         \
        redcc_own = redcc_scalar;                                                                  \
    }
/** Is the thread to go through all of the iteration, whatever it owns? */
#define REDCC_LEADS(redcc_writer) (!(redcc_writer).follows)

/** Keeps an operand of iteration number k; 0: there is no room. */
static __inline__ __attribute__((__unused__)) int redcc_series_put(redcc_series_writer *writer,
                                                                   redcc_int k, double operand) {
    if (writer->follows)
        return 1;
    if (writer->adds) {
        writer->added = 1;
        return 0;
    }
    if (writer->at == writer->end && !writer->calls->room(writer, k))
        return 0;
    *writer->at++ = operand;
    writer->part->count++;
    return 1;
}

/** Is a chunk handed out once more? */
#define REDCC_SERIES_AGAIN(redcc_count)                                                            \
    redcc__worker->call->calls->series->again(redcc__worker, redcc__writers, redcc_count)

/** The thread that adds up by itself begins with the scalar as it is, where it is ever updated. */
#define REDCC_SERIES_BEGIN(redcc_writer, redcc_own, redcc_scalar)                                  \
    ((redcc_writer).begins && (redcc_writer).calls->has_any((redcc_writer).series)                 \
         ? ((redcc_writer).begins = 0, (void)(redcc_own = redcc_scalar))                           \
         : (void)0)

/** What the scalar, of type redcc_type, is after the loop: redcc_sum. Its operation is made in
 *  redcc_operand. */
#define REDCC_SERIES_APPLY(redcc_writer, redcc_type, redcc_operand, redcc_operator, redcc_scalar,  \
                           redcc_own, redcc_sum, redcc_is_set)                                     \
    if ((redcc_writer).added || (redcc_writer).calls->has_any((redcc_writer).series)) {            \
        redcc_int redcc__i = (redcc_writer).next;                                                  \
        redcc_size redcc__j;                                                                       \
        const redcc_series_part *redcc__part;                                                      \
        if (!(redcc_writer).adds || (redcc_writer).in_front) {                                     \
            if (!(redcc_writer).added)                                                             \
                redcc_own = redcc_scalar;                                                          \
            while ((redcc__part = (redcc_writer).calls->find((redcc_writer).series, &redcc__i)) != \
                   0)                                                                              \
                for (redcc__i++; redcc__part; redcc__part = redcc__part->more)                     \
                    for (redcc__j = 0; redcc__j < redcc__part->count; redcc__j++)                  \
                        redcc_own = (redcc_type)(redcc_own redcc_operator(redcc_operand)           \
                                                     redcc__part->value[redcc__j]);                \
        }                                                                                          \
        redcc_sum = redcc_own;                                                                     \
        redcc_is_set = 1;                                                                          \
    }

#endif
