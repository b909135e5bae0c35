/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* clang-format off */
/**
 * redcc/parallel.h: irregular reductions in parallel, with the bits of the sequential loop.
 *
 * A loop adds to elements or rows b[i] of arrays, where i is loaded from memory. You describe the
 * loop by a few small functions. From them the runtime learns which iterations update which rows.
 * It gives each row to one thread, and executes the loop. Each row gets its updates in the order of
 * the loop, so the result is that of the sequential loop, bit for bit, at every number of threads.
 * docs/by-hand.md has the first steps; examples/by-hand has four loops and a program to check them.
 *
 *     struct NAME {...};                 the context: the values and pointers that the loop uses
 *     REDCC_SLICE(NAME, int t) {...}     names the rows that iteration t updates and reads
 *     REDCC_BODY(NAME, int t) {...}      executes iteration t
 *     REDCC_DESCRIBE(NAME) {...}         describes an execution: iterations, addresses of arrays
 *     static const redcc_array NAME_arrays[] = {...};      the arrays that are updated
 *     static const redcc_source NAME_sources[] = {...};    the arrays that are read
 *     static const redcc_stream NAME_streams[] = {...};    optional: updates that may be deferred
 *
 *     #define REDCC_LOOP NAME
 *     #define REDCC_WHERE "file.c", 12, "function"         for reports
 *     #define REDCC_ARRAYS 1                               entries of NAME_arrays
 *     #define REDCC_SOURCES 2                              entries of NAME_sources; 0: none
 *     #include <redcc/define_loop.h>                       lists the options, and defines:
 *
 *     int NAME_run(const struct NAME *)        1: the loop is done. 0: nothing was written; execute
 *                                              the sequential loop, then call NAME_over()
 *     void NAME_over(void)                     ends the sequential loop, which the runtime times
 *     void NAME_execute(const struct NAME *)   executes the loop in any case: by NAME_run, or else
 *                                              by the body for each iteration in order
 *
 * In all functions `loop` points to the context, which is constant, and `it` is the first argument
 * of the calls below. If several threads call NAME_run at once, one of them runs the loop in
 * parallel, and for the others NAME_run returns 0.
 *
 * SLICE. It makes its calls in any order, and may repeat them. A superfluous row costs time; a
 * missing row gives wrong results (REDCC_VALIDATE=1 finds it). Which rows it names may depend only
 * on t, on sources marked as subscripts, and on values that are given to redcc_depends_on.
 *     redcc_updates(it, ARRAY, base, row)              the iteration may update base[row]
 *     redcc_reads(it, SOURCE, base, row)               it may read base[row]; for sources that the
 *                                                      description gives by redcc_reads_named
 *     redcc_updates_bytes(it, ARRAY, address, bytes)   the same if rows do not begin at
 *     redcc_reads_bytes(it, SOURCE, address, bytes)    a constant base
 *
 * BODY. It writes to the arrays only through these calls and reads none of them. It may be executed
 * several times for one iteration, so its updates must be its only effects. ARRAY is a constant.
 *     redcc_base(it, ARRAY, loop->b)      where to write in place of loop->b (perhaps a copy)
 *     redcc_add(it, ARRAY, &b[i], v)      b[i] += v. Also redcc_subtract, redcc_multiply,
 *                                         redcc_and, redcc_or, redcc_xor
 *     redcc_minimum(it, ARRAY, &b[i], v)  if (v < b[i]) b[i] = v. redcc_maximum: by >
 *     redcc_row(it, ARRAY, &b[i])         a pointer for updating the row: &b[i], or a scratch row
 *                                         if another thread makes the update. Valid until the
 *                                         iteration's end or redcc_rows_end(it). Each element is
 *                                         updated at most once, by the array's operator (or by
 *                                         - for +) with a value of the element's type. Rows are
 *                                         requested in the order of their updates.
 *     redcc_rows_end(it)                  ends the rows so far; at most 16 may be open at once
 *     redcc_may_update(it, ARRAY, &b[i])  precedes an update in plain C, which is made only if this
 *                                         returns 1. Not available with NAME_streams.
 *     redcc_concerns(it, ARRAY, &b[i])    0: this thread does not update that row now, so that an
 *                                         inner iteration may be skipped
 *
 * DESCRIBE. It describes each array, source and key once, and reads nothing through pointers.
 *     redcc_iterations(it, first, count)               t = first, first + 1, ... (or REDCC_STEP)
 *     redcc_updates_array(it, ARRAY, base)             base: the address of row 0
 *     redcc_reads_rows(it, SOURCE, base, row, count)   at most `count` rows from `row` on are read
 *     redcc_reads_named(it, SOURCE, base)              the slice names the rows by redcc_reads
 *     redcc_depends_on(it, KEY, value)                 another value that rows depend on; KEY
 *                                                      counts from 0
 *     redcc_give_up(it, condition)                     leaves this execution to the sequential loop
 *
 * ENTRIES. Names appear in reports. A row is the memory that one redcc_updates names.
 *     REDCC_ARRAY(name, operator, type, n)   rows of n numbers; operator: REDCC_SUM (also for -),
 *                                            REDCC_PRODUCT, REDCC_MINIMUM, REDCC_MAXIMUM,
 *                                            REDCC_AND, REDCC_OR, REDCC_XOR; type: one
 *                                            identifier
 *     REDCC_SUBSCRIPTS(name)                 decides which rows are updated. A plan is reused while
 *                                            all that was read of these is unchanged
 *     REDCC_READ(name)                       does not decide which rows are updated
 *     REDCC_KEPT(ARRAY, type, n)             updates may be stored and made later, in order (binning:
 *                                            for subscripts that change in each call). n: numbers
 *                                            in a row, or 1 with redcc_add and the like. Either all
 *                                            arrays have an entry, in the same order, or none has.
 *                                            The body then has no division, loop bound or address
 *                                            that depends on memory which an update may overlap.
 *
 * The object refers to one symbol of the runtime, redcc_run, weakly: if the runtime is not linked,
 * NAME_run returns 0. With -DREDCC_OFF it refers to none. Compile it with your own options; no OpenMP
 * option is needed, and none interferes. The language is C89 with GNU extensions to C23, or C++;
 * the compiler is gcc 9, clang 14, or later. Sizes are in bytes unless they are called rows or
 * counts. Detected misuse stops the program with a message. Including this file forbids the
 * contraction of a * b + c (to a fused multiply-add) in the rest of the file. Otherwise two copies
 * of one expression might be contracted differently.
 */
/* clang-format on */
#ifndef REDCC_PARALLEL_H
#define REDCC_PARALLEL_H

#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__FP_FAST_FMA) || defined(__FP_FAST_FMAF)
#pragma GCC optimize("fp-contract=off")
#endif
#pragma GCC system_header

#include <redcc/parallel_steps.h>

#define REDCC_SLICE(name, counter)                                                                 \
    REDCC_INLINE void name##_slice(const redcc_slice *it, counter, const struct name *loop)
#define REDCC_BODY(name, counter)                                                                  \
    REDCC_INLINE void name##_body(redcc_body *it, counter, const struct name *loop)
/** REDCC_HEAVY_BODY is for a body of several hundred operations: it is compiled once for all modes,
 * and not inlined. Requires REDCC_ONE_BODY. */
#define REDCC_HEAVY_BODY(name, counter)                                                            \
    REDCC_ONCE void name##_body(redcc_body *it, counter, const struct name *loop)
#define REDCC_DESCRIBE(name)                                                                       \
    REDCC_INLINE void name##_describe(redcc_description *it, const struct name *loop)

#define REDCC_ARRAY(name, operation, type, n)                                                      \
    { name, operation, REDCC_TYPE_OF(type), sizeof(type), (n) * sizeof(type), 0 }
#define REDCC_SUBSCRIPTS(name)                                                                     \
    { name, 1 }
#define REDCC_READ(name)                                                                           \
    { name, 0 }
#define REDCC_KEPT(array, type, n) REDCC_KEPT_BY(0, array, type, n, (n) * sizeof(type))
/** As REDCC_KEPT, with an apply function of the user (0: the library's) and records of `bytes`
 * bytes. Records may have a wider type than the array: for doubles that are added to floats, a
 * record has 8 bytes per number. */
#define REDCC_KEPT_BY(apply, array, type, n, bytes)                                                \
    { apply, 1, {array, 0, 0, 0}, {(n) * sizeof(type), 0, 0, 0}, bytes, 0, REDCC_IS_INTEGER(type) }

/* ---- slices ---- */

#define redcc_updates(it, array, base, row)                                                        \
    redcc_slice_update_row(it, array, &(base)[row], base, (redcc_int)(row), sizeof((base)[row]))
#define redcc_reads(it, source, base, row)                                                         \
    redcc_slice_read_row(it, source, &(base)[row], base, (redcc_int)(row), sizeof((base)[row]))
#define redcc_updates_bytes(it, array, address, bytes) redcc_slice_update(it, array, address, bytes)
#define redcc_reads_bytes(it, source, address, bytes) redcc_slice_read(it, source, address, bytes)
/** For loops that may update their own subscripts (REDCC_DRY_RUN). If one of these returns 1, the
 * slice must return at once. redcc_is_finished follows an update; redcc_is_outdated follows a read
 * that may overlap an update. */
#define redcc_is_finished(it) redcc_slice_finished(it)
#define redcc_is_outdated(it, source) redcc_slice_outdated(it, source)

/* ---- bodies ---- */

#define redcc_base(it, array, pointer) ((__typeof__(pointer))(it)->base[array])
#define redcc_row(it, array, row)                                                                  \
    ((__typeof__(row))redcc_row_of(                                                                \
        it, array, (void *)(row),                                                                  \
        sizeof *(row) + 0 * sizeof(char[sizeof *(row) <= REDCC_ROW_BYTES ? 1 : -1])))
#define redcc_rows_end(it) redcc_end_rows(it)
#define redcc_may_update(it, array, at) redcc_is_mine(it, array, at, sizeof *(at))
#define redcc_concerns(it, array, at) redcc_is_concerned(it, array, at, sizeof *(at))

#define redcc_add(it, array, at, value) REDCC_UPDATE_BY(it, array, at, +=, value, value)
#define redcc_subtract(it, array, at, value)                                                       \
    REDCC_UPDATE_BY(it, array, at, -=, value, REDCC_NEGATED(*(at) + (value), value))
#define redcc_multiply(it, array, at, value) REDCC_UPDATE_BY(it, array, at, *=, value, value)
#define redcc_and(it, array, at, value) REDCC_UPDATE_BY(it, array, at, &=, value, value)
#define redcc_or(it, array, at, value) REDCC_UPDATE_BY(it, array, at, |=, value, value)
#define redcc_xor(it, array, at, value) REDCC_UPDATE_BY(it, array, at, ^=, value, value)
#define redcc_minimum(it, array, at, value) REDCC_REPLACE_IF(it, array, at, <, value)
#define redcc_maximum(it, array, at, value) REDCC_REPLACE_IF(it, array, at, >, value)

/* ---- descriptions ---- */

#define redcc_iterations(it, from, count)                                                          \
    ((it)->first = (redcc_int)(from), (it)->trip = (redcc_int)(count))
#define redcc_updates_array(it, array, start)                                                      \
    ((it)->counts_only ? (void)0 : (void)((it)->bases[array] = (void *)(start)))
#define redcc_reads_rows(it, source, start, row, count)                                            \
    redcc_describe_rows(it, source, (const void *)(start), (redcc_int)(row), (redcc_int)(count),   \
                        sizeof *(start))
#define redcc_reads_named(it, source, start) redcc_describe_named(it, source, (const void *)(start))
#define redcc_depends_on(it, number, value)                                                        \
    ((it)->counts_only ? (void)0 : (void)((it)->extra[number] = (redcc_word)(value)))
#define redcc_give_up(it, condition) ((it)->gives_up |= (condition) ? 1 : 0)

#endif
