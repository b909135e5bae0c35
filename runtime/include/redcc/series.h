/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sums of floating scalars in inner loops, `e += f(i, j)`. The number of operands of an iteration
 * is not known in advance, and the operands must be added in the order of the sequential loop. Each
 * thread appends the operands of the iterations that it executes to its own list. At the end the
 * first thread adds them in the order of the iterations. If the loop is executed by tiles
 * (tiles.h), the thread that has executed a band of rows adds the band's operands, after those of
 * the band above.
 *
 *     redcc_run               one thread    allocates a table of the iterations (redcc_attempt)
 *     redcc_series_begin      each thread   before anything is executed
 *     REDCC_SERIES_NEXT       each thread   begins an iteration
 *     redcc_series_put        each thread   stores an operand
 *     REDCC_SERIES_REPEATS    each thread   after the parallel part. If memory was short, or an
 *                                           iteration has left the memory in which its accesses
 *                                           were expected, the first thread repeats the iterations
 *                                           without their updates, adding the operands directly,
 *                                           and executes those that remain
 *     REDCC_SERIES_BANDS      each thread   after each tile
 *     series->is_over         each thread   1: it is the first thread, and the loop is done
 *     REDCC_SERIES_APPLY      that thread   adds the operands
 *     series->release         one thread    frees them after the loop
 *
 * runtime.h includes this file.
 */
#ifndef REDCC_SERIES_H
#define REDCC_SERIES_H

/** A part of the operands of one iteration. They lie consecutively in memory, in the order in which
 * they are added. */
struct redcc_series_part {
    struct redcc_series_part *more; /**< the operands that follow; NULL: none */
    redcc_size count;
    double value[1]; /**< `count` operands, once the part is complete; a float is stored as a
                        double */
};

/** A thread's state for one series. */
struct redcc_series_writer {
    redcc_series *series;
    const redcc_series_calls *calls;
    /** the last part of the current iteration; NULL: the iteration has none yet */
    redcc_series_part *part;
    double *begin;     /**< the first operand in `part`; NULL: the part is complete */
    double *at, *end;  /**< address for the next operand, and the end of the free memory there */
    double *block_end; /**< the end of the memory block that `at` points into */
    int adds;          /**< the thread adds operands directly and does not store them */
    int begins;        /**< `adds` is set, and the thread has not added an operand yet; 2: it reads
                          the scalar even if the loop does not update it */
    int follows;       /**< another thread stores the operands of the current iteration */
    int in_front; /**< the thread has executed all iterations before `next`, so it adds its operands
                     directly */
    int added;    /**< the thread has added an operand */
    redcc_int next;           /**< operands of iteration `next` and later iterations are stored */
    redcc_series_part **ends; /**< in tiles: the last part of each iteration of the band */
    /** the thread's memory blocks: the first one, and the one that `at` points into */
    struct operand_block *first, *block;
};

/** Initialises this thread's writer of series number `number` of the loop. */
static __inline__ __attribute__((__unused__)) void redcc_series_begin(redcc_worker *worker,
                                                                      const redcc_attempt *attempt,
                                                                      redcc_series_writer *writers,
                                                                      redcc_u32 number) {
    worker->call->calls->series->join(&writers[number], attempt->series[number]);
    writers[number].calls = worker->call->calls->series;
}

/** Completes the current part. */
#define REDCC_SERIES_COMPLETE(redcc_writer)                                                        \
    ((redcc_writer).begin ? (void)((redcc_writer).part->count =                                    \
                                       (redcc_size)((redcc_writer).at - (redcc_writer).begin),     \
                                   (redcc_writer).begin = 0)                                       \
                          : (void)0)

/** Begins an iteration. In an owner-checked iteration another thread may store the operands: the
 * iteration's leader (redcc_probe_first), which executes the whole iteration. */
#define REDCC_SERIES_NEXT(redcc_writer)                                                            \
    (REDCC_SERIES_COMPLETE(redcc_writer), (redcc_writer).part = 0,                                 \
     (redcc_writer).end = (redcc_writer).at,                                                       \
     (redcc_writer).follows =                                                                      \
         redcc__checked && redcc__worker->variant.operands == REDCC_OPERANDS_BY_LEADER,            \
     (redcc_writer).in_front ? (redcc__k == (redcc_writer).next && !(redcc_writer).follows         \
                                    ? (void)(redcc_writer).next++                                  \
                                    : (void)((redcc_writer).in_front = (redcc_writer).adds = 0))   \
                             : (void)0)
/** REDCC_SERIES_RESUME begins, and REDCC_SERIES_SUSPEND ends, the part of an iteration that lies in
 * the current tile. */
#define REDCC_SERIES_RESUME(redcc_writer)                                                          \
    ((redcc_writer).part =                                                                         \
         redcc__tile->is_first ? 0 : (redcc_writer).ends[redcc__k - redcc__tile->row],             \
     (redcc_writer).end = (redcc_writer).at,                                                       \
     (redcc_writer).follows = (redcc_writer).in_front = (redcc_writer).adds = 0)
#define REDCC_SERIES_SUSPEND(redcc_writer)                                                         \
    (REDCC_SERIES_COMPLETE(redcc_writer),                                                          \
     (redcc_writer).ends[redcc__k - redcc__tile->row] = (redcc_writer).part)
/** While the first thread executes the loop's first iterations, it adds operands directly to
 * redcc_own, its copy of the scalar. */
#define REDCC_SERIES_IN_FRONT(redcc_writer, redcc_own, redcc_scalar)                               \
    if (redcc__worker->thread == 0) {                                                              \
        (redcc_writer).in_front = (redcc_writer).adds = 1;                                         \
        redcc_own = redcc_scalar;                                                                  \
    }
/** Must the thread execute the whole iteration, including parts that update no row that it owns? */
#define REDCC_LEADS(redcc_writer) (!(redcc_writer).follows)

/** Stores an operand of iteration number k and returns 1. If another thread stores the operand,
 * only returns 1. Returns 0 if the caller must add the operand itself (`adds`), or if there was no
 * memory. */
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
    return 1;
}

/** Follows each tile. After the last tile of a band, the band's thread waits until the operands of
 * the band above were added, and then adds the band's operands of all series. */
#define REDCC_SERIES_BANDS(redcc_count, redcc_sums)                                                \
    if (redcc__tile.is_last) {                                                                     \
        redcc__worker->call->calls->series->await_band(redcc__worker);                             \
        redcc_sums redcc__worker->call->calls->series->end_band(redcc__worker, redcc__writers,     \
                                                                redcc_count);                      \
    }
/** Adds a band's operands. The parameters are those of REDCC_SERIES_APPLY. */
#define REDCC_SERIES_BAND(redcc_writer, redcc_type, redcc_operand, redcc_operator, redcc_scalar,   \
                          redcc_sum, redcc_is_set)                                                 \
    {                                                                                              \
        redcc_type redcc__of_band = redcc_sum;                                                     \
        redcc_size redcc__j;                                                                       \
        const redcc_series_part *redcc__part;                                                      \
        for (redcc__k = redcc__tile.row; redcc__k < redcc__tile.row_end; redcc__k++)               \
            for (redcc__part = (redcc_writer).calls->part_of((redcc_writer).series, redcc__k);     \
                 redcc__part; redcc__part = redcc__part->more) {                                   \
                if (!redcc_is_set) {                                                               \
                    redcc__of_band = redcc_scalar;                                                 \
                    redcc_is_set = 1;                                                              \
                }                                                                                  \
                for (redcc__j = 0; redcc__j < redcc__part->count; redcc__j++)                      \
                    redcc__of_band = (redcc_type)(redcc__of_band redcc_operator(redcc_operand)     \
                                                      redcc__part->value[redcc__j]);               \
            }                                                                                      \
        redcc_sum = redcc__of_band;                                                                \
    }

/** Are iterations handed out a second time? */
#define REDCC_SERIES_REPEATS(redcc_count)                                                          \
    redcc__worker->call->calls->series->repeats(redcc__worker, redcc__writers, redcc_count)

/** If this thread adds the operands directly and has not begun, sets redcc_own to the scalar's
 * value. Unless `begins` is 2, the scalar is read only if the loop updates it at all. */
#define REDCC_SERIES_BEGIN(redcc_writer, redcc_own, redcc_scalar)                                  \
    ((redcc_writer).begins == 2 ||                                                                 \
             ((redcc_writer).begins && (redcc_writer).calls->has_any((redcc_writer).series))       \
         ? ((redcc_writer).begins = 0, (void)(redcc_own = redcc_scalar))                           \
         : (void)0)

/** Computes the scalar's value after the loop, redcc_sum, of type redcc_type. Each operand is first
 * converted by redcc_operand (the type in which it is added). */
#define REDCC_SERIES_APPLY(redcc_writer, redcc_type, redcc_operand, redcc_operator, redcc_scalar,  \
                           redcc_own, redcc_sum, redcc_is_set)                                     \
    if ((redcc_writer).added || (redcc_writer).calls->has_any((redcc_writer).series)) {            \
        redcc_int redcc__i = (redcc_writer).next;                                                  \
        redcc_size redcc__j;                                                                       \
        const redcc_series_part *redcc__part;                                                      \
        if (!(redcc_writer).adds || (redcc_writer).in_front) {                                     \
            if (!(redcc_writer).added)                                                             \
                redcc_own = (redcc_is_set) ? redcc_sum : redcc_scalar;                             \
            /* if redcc_is_set, the bands have added the operands */                               \
            while (!(redcc_is_set) &&                                                              \
                   (redcc__part = (redcc_writer).calls->find((redcc_writer).series, &redcc__i)) != \
                       0)                                                                          \
                for (redcc__i++; redcc__part; redcc__part = redcc__part->more)                     \
                    for (redcc__j = 0; redcc__j < redcc__part->count; redcc__j++)                  \
                        redcc_own = (redcc_type)(redcc_own redcc_operator(redcc_operand)           \
                                                     redcc__part->value[redcc__j]);                \
        }                                                                                          \
        redcc_sum = redcc_own;                                                                     \
        redcc_is_set = 1;                                                                          \
    }

#endif
