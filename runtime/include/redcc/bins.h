/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning, for generated code: the loop is executed without an inspection. Its body does
 * not write the reduction arrays. It appends a record of each update to a bin (redcc_push). A bin
 * has the updates of neighbouring rows. The runtime applies the records later, bin by bin, in the
 * order of the loop.
 *
 *     redcc_enter, redcc_join, redcc_inspect     as in runtime.h
 *     redcc_bins_next   each thread   hands out iterations whose updates must be pushed
 *       redcc_push                    replaces an update; or redcc_update, if updates are made on
 *                                     private copies (REDCC_ARE_COPIED)
 *       redcc_read                    records reads whose address range is not in `known`
 *     redcc_next, redcc_leave         as in runtime.h; redcc_next hands out, in its plain form, the
 *                                     iterations that could not be binned
 *
 * An iteration may be pushed more than once; the records of its earlier attempts are then
 * discarded. So a loop has this form only if executing its body twice leaves the same state as
 * executing it once. The runtime also executes the body before it compares the addresses that the
 * loop reads with those that it updates. So the body's addresses, divisors and bounds of inner
 * loops must come from memory that is proved disjoint from the reduction arrays. All other memory
 * that the body reads must be in the loop's sources. A loop whose body is different is marked
 * REDCC_BINS_CHECKED.
 *
 * Like runtime.h, this header includes no system header and compiles as C89 with GNU extensions.
 */
#ifndef REDCC_BINS_H
#define REDCC_BINS_H

#include <redcc/runtime.h>

#if defined(__GNUC__)
#ifdef REDCC_HIDDEN /* static library: programs linked with it export none of these names */
#pragma GCC visibility push(hidden)
#else
#pragma GCC visibility push(default) /* the shared library hides all other names */
#endif
#endif

/**
 * Hands out the next iterations to push. Called after redcc_inspect by every thread of the region.
 * Returns
 * - REDCC_TO_PUSH: worker->first, worker->last and bins[stream_count] are set;
 * - REDCC_TO_EXECUTE: call redcc_next until it returns 0, then this function again;
 * - 0: no iterations are left to push; continue with redcc_next.
 * `operands` points to values that the apply functions need. It is the same for all threads, and
 * the values must not change until the function has returned 0 to all threads.
 */
int redcc_bins_next(redcc_worker *worker, redcc_bins *bins, const void *operands);

/** Called by redcc_push for a row that has no bin. */
void redcc_push_outside(struct redcc_bin_buffer *buffer, redcc_int row) __attribute__((__cold__));

/** Called by redcc_push when a block is full; returns the number of the next record of `bin`. */
redcc_u32 redcc_push_block(struct redcc_bin_buffer *buffer, redcc_size bin, redcc_u32 record)
    __attribute__((__cold__));

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

/* ---- used by generated text -------------------------------------------------------------------
 */

/** Values of redcc__checked besides 0 (plain) and 1 (owner-checked): updates are pushed to bins, or
 * made on private copies. */
enum { REDCC_IN_BINS = 2, REDCC_IN_COPIES = 3 };

/** An element's number, counted from the array's first one. */
#define REDCC_ELEMENT(redcc_base, redcc_at)                                                        \
    ((redcc_int)((redcc_at) - (__typeof__(redcc_at))(void *)(redcc_base)))

/** A thread's bins of one stream, and its private copy of one array of the stream. Rows that the
 * copy lacks are reported after the chunk: a call in the loop would occupy registers. */
typedef struct redcc_chunk_bins {
    redcc_bins bins;
    redcc_size copy, bytes;    /* the private copy */
    redcc_int lowest, highest; /* offsets from `copy` of what it lacks; lowest > highest: nothing */
} redcc_chunk_bins;

/** Is this address in the private copy? If not, returns 0 and records the address, so that the copy
 * made for the next attempt contains it. Addresses need no division, unlike row numbers. `bins` is
 * the member of a redcc_chunk_bins. */
REDCC_INLINE int redcc_is_copied(const redcc_bins *bins, const void *at) {
    redcc_chunk_bins *const it = (redcc_chunk_bins *)(redcc_size)bins;
    const redcc_size offset = (redcc_size)at - it->copy;
    if (__builtin_expect(offset < it->bytes, 1))
        return 1;
    it->lowest = (redcc_int)offset < it->lowest ? (redcc_int)offset : it->lowest;
    it->highest = (redcc_int)offset > it->highest ? (redcc_int)offset : it->highest;
    return 0;
}
REDCC_INLINE redcc_chunk_bins redcc_chunk_bins_of(const redcc_bins *bins, redcc_u32 part,
                                                  redcc_u32 row_bytes) {
    redcc_chunk_bins it; /* C89 requires constant initialisers */
    it.bins = *bins;
    it.copy = (redcc_size)bins->copy[part];
    it.bytes = bins->span * row_bytes;
    it.lowest = (redcc_int)(~(redcc_word)0 >> 1);
    it.highest = -(redcc_int)(~(redcc_word)0 >> 1) - 1;
    return it;
}
REDCC_INLINE void redcc_report_lacking(const redcc_chunk_bins *it, redcc_int row_bytes) {
    const redcc_bins *const bins = &it->bins;
    if (it->lowest > it->highest)
        return;
    /* rounded down, also below 0 */
    bins->calls->push_outside(
        bins->buffer,
        bins->first + (it->lowest < 0 ? (it->lowest + 1) / row_bytes - 1 : it->lowest / row_bytes));
    bins->calls->push_outside(bins->buffer,
                              bins->first + (it->highest < 0 ? (it->highest + 1) / row_bytes - 1
                                                             : it->highest / row_bytes));
}

/** A row number that no bin contains. */
#define REDCC_NO_ROW ((redcc_int)((redcc_word)1 << 63))

/** Can a pointer be loaded from this address (is it aligned and readable)? */
REDCC_INLINE int redcc_can_load(const redcc_bins *bins, redcc_size address) {
    const redcc_size page = address / REDCC_PAGE;
    if (__builtin_expect(address % sizeof(void *) != 0, 0))
        return 0;
    return __builtin_expect(page == *bins->readable_page, 1) ||
           bins->calls->before->behind->is_readable(bins->readable_page, (const void *)address);
}

REDCC_INLINE redcc_int redcc_element_at(redcc_size address, redcc_size bytes) {
    return address % bytes == 0 ? (redcc_int)(address / bytes) : REDCC_NO_ROW;
}

/** Identifies an array as number `part` of the arrays of stream number `stream`. */
typedef struct redcc_part {
    redcc_u32 stream;
    redcc_u32 part;
} redcc_part;

/** Finds the array with number `array`, which must be in one of the streams. */
REDCC_INLINE redcc_part redcc_part_of(const redcc_stream *streams, redcc_u32 array) {
    redcc_part it = {0, 0};
    while (streams[it.stream].arrays[it.part] != array)
        if (++it.part == streams[it.stream].array_count) {
            it.part = 0;
            it.stream++;
        }
    return it;
}

/** Precedes an update of array `redcc_i`, as REDCC_UPDATE does. If updates are binned, it pushes a
 * record to stream `redcc_s` instead. The record has the operands of this update and of the
 * following updates that are written with REDCC_UPDATE_WITH. */
#define REDCC_UPDATE_BY(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at, redcc_record,           \
                        redcc_values)                                                              \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_record redcc__e = redcc_values;                                                \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ELEMENT(redcc_base, redcc_at), redcc_tag, &redcc__e);                     \
    } else if (REDCC_IS_MADE(redcc_i, REDCC_ELEMENT(redcc_base, redcc_at), redcc_at))
/** As REDCC_UPDATE_BY, for an update without operands: only its row is recorded. */
#define REDCC_UPDATE_ALIKE(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at)                      \
    if (redcc__checked == REDCC_IN_BINS)                                                           \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ELEMENT(redcc_base, redcc_at), redcc_tag, 0);                             \
    else if (REDCC_IS_MADE(redcc_i, REDCC_ELEMENT(redcc_base, redcc_at), redcc_at))
/** As REDCC_UPDATE_BY, for an update whose operands are in the record of an earlier
 * REDCC_UPDATE_BY: nothing is pushed. */
#define REDCC_UPDATE_WITH(redcc_i, redcc_base, redcc_at)                                           \
    if (redcc__checked != REDCC_IN_BINS &&                                                         \
        REDCC_IS_MADE(redcc_i, REDCC_ELEMENT(redcc_base, redcc_at), redcc_at))
/* `sizeof` uses redcc_number without evaluating it: redcc checks that each name in its output
 * reaches the compiler, also in the arguments of macros (tool/redcc/bindings.h). */
#define REDCC_IS_MADE(redcc_i, redcc_number, redcc_at)                                             \
    (redcc__checked == REDCC_IN_COPIES                                                             \
         ? redcc_is_copied(redcc__bins_##redcc_i, ((void)sizeof(redcc_number), redcc_at))          \
         : !redcc__checked || redcc_is_owned(redcc__worker, redcc__own_##redcc_i, redcc_at))

/** The number of an element that is reached through a pointer, counted from address 0.
 * `redcc_pointer` is the address from which that pointer is loaded, or 0. While updates are binned,
 * that address may be unverified. If it cannot be read, or the element is misaligned, the result is
 * REDCC_NO_ROW, and the round fails. (A round is a range of iterations whose records are collected
 * before any of them is applied.) */
#define REDCC_ELEMENT_BEHIND(redcc_i, redcc_pointer, redcc_at)                                     \
    ((redcc_size)(redcc_pointer) == 0 ||                                                           \
             redcc_can_load(redcc__bins_##redcc_i, (redcc_size)(redcc_pointer))                    \
         ? redcc_element_at((redcc_size)(redcc_at), sizeof *(redcc_at))                            \
         : REDCC_NO_ROW)
#define REDCC_UPDATE_BEHIND_BY(redcc_i, redcc_s, redcc_tag, redcc_pointer, redcc_at, redcc_record, \
                               redcc_values)                                                       \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_record redcc__e = redcc_values;                                                \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ELEMENT_BEHIND(redcc_i, redcc_pointer, redcc_at), redcc_tag, &redcc__e);  \
    } else if (REDCC_IS_MADE(redcc_i, 0, redcc_at))
#define REDCC_UPDATE_BEHIND_ALIKE(redcc_i, redcc_s, redcc_tag, redcc_pointer, redcc_at)            \
    if (redcc__checked == REDCC_IN_BINS)                                                           \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ELEMENT_BEHIND(redcc_i, redcc_pointer, redcc_at), redcc_tag, 0);          \
    else if (REDCC_IS_MADE(redcc_i, 0, redcc_at))
#define REDCC_UPDATE_BEHIND_WITH(redcc_i, redcc_pointer, redcc_at)                                 \
    if (redcc__checked != REDCC_IN_BINS && REDCC_IS_MADE(redcc_i, 0, redcc_at))

/* Pushes a record of consecutive elements. The record has the first element's address, the number
 * of elements, and the values that the expression `redcc_set` assigns. `redcc_first_row` is the
 * first element's row. */
#define REDCC_PUSH_SPAN_OF(redcc_i, redcc_s, redcc_at, redcc_first_row, redcc_record, redcc_set)   \
    {                                                                                              \
        redcc_record redcc__e;                                                                     \
        redcc__e.first = (redcc_size)(redcc_at);                                                   \
        redcc__e.count = redcc__number;                                                            \
        (void)redcc_set;                                                                           \
        redcc__bins_##redcc_i->calls->before->behind->push_span(                                   \
            redcc__bins_##redcc_i, &redcc__streams[redcc_s], redcc_first_row, redcc__number,       \
            &redcc__e);                                                                            \
    }

/** Replaces an inner loop that updates `redcc_number` consecutive elements of an array: pushes one
 * record for all of them. */
#define REDCC_PUSH_SPAN(redcc_i, redcc_s, redcc_base, redcc_at, redcc_number, redcc_record,        \
                        redcc_set)                                                                 \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_int redcc__number = redcc_number;                                              \
        if (redcc__number > 0)                                                                     \
            REDCC_PUSH_SPAN_OF(redcc_i, redcc_s, redcc_at,                                         \
                               REDCC_ROW(redcc_base, redcc_at, __typeof__(*(redcc_at)), 0),        \
                               redcc_record, redcc_set)                                            \
    }

/** As REDCC_PUSH_SPAN, for elements reached through a pointer; `redcc_pointer` as for
 * REDCC_ELEMENT_BEHIND. */
#define REDCC_PUSH_SPAN_BEHIND(redcc_i, redcc_s, redcc_pointer, redcc_at, redcc_number,            \
                               redcc_record, redcc_set)                                            \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_int redcc__number = redcc_number;                                              \
        if (redcc__number > 0 &&                                                                   \
            ((redcc_size)(redcc_pointer) == 0 ||                                                   \
             redcc_can_load(redcc__bins_##redcc_i, (redcc_size)(redcc_pointer))))                  \
            REDCC_PUSH_SPAN_OF(redcc_i, redcc_s, redcc_at,                                         \
                               redcc_element_at((redcc_size)(redcc_at), sizeof *(redcc_at)),       \
                               redcc_record, redcc_set)                                            \
        else if (redcc__number > 0)                                                                \
            redcc__bins_##redcc_i->calls->push_outside(redcc__bins_##redcc_i->buffer,              \
                                                       REDCC_NO_ROW);                              \
    }

/** The number of the row (of type `redcc_row`) in which the element at `redcc_at` is number
 * `redcc_part`. */
#define REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part)                                     \
    ((redcc_int)((redcc_row *)(void *)((redcc_size)(redcc_at) -                                    \
                                       (redcc_size)(redcc_part) * sizeof *(redcc_at)) -            \
                 (redcc_row *)(void *)(redcc_base)))

/** As REDCC_UPDATE_BY, _ALIKE and _WITH, for a stream whose array has rows of several elements. */
#define REDCC_UPDATE_ROW_BY(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at, redcc_row,          \
                            redcc_part, redcc_record, redcc_values)                                \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_record redcc__e = redcc_values;                                                \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part), redcc_tag, &redcc__e);  \
    } else if (REDCC_IS_MADE(redcc_i, REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part),      \
                             redcc_at))
#define REDCC_UPDATE_ROW_ALIKE(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at, redcc_row,       \
                               redcc_part)                                                         \
    if (redcc__checked == REDCC_IN_BINS)                                                           \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part), redcc_tag, 0);          \
    else if (REDCC_IS_MADE(redcc_i, REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part),        \
                           redcc_at))
#define REDCC_UPDATE_ROW_WITH(redcc_i, redcc_base, redcc_at, redcc_row, redcc_part)                \
    if (redcc__checked != REDCC_IN_BINS &&                                                         \
        REDCC_IS_MADE(redcc_i, REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part), redcc_at))

/** Precedes an inner loop with a constant number of iterations that update parts of one row. Pushes
 * one record, with all values that these iterations add (_BY), or with the row alone (_ALIKE). The
 * updates inside the inner loop are REDCC_UPDATE_ROW_WITH. */
#define REDCC_APPEND_ROW_BY(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at, redcc_row,          \
                            redcc_part, redcc_record, redcc_values)                                \
    if (redcc__checked == REDCC_IN_BINS) {                                                         \
        const redcc_record redcc__e = redcc_values;                                                \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part), redcc_tag, &redcc__e);  \
    }
#define REDCC_APPEND_ROW_ALIKE(redcc_i, redcc_s, redcc_tag, redcc_base, redcc_at, redcc_row,       \
                               redcc_part)                                                         \
    if (redcc__checked == REDCC_IN_BINS)                                                           \
        redcc_push(redcc__bins_##redcc_i, &redcc__streams[redcc_s],                                \
                   REDCC_ROW(redcc_base, redcc_at, redcc_row, redcc_part), redcc_tag, 0);

/** Initialises a record of several values. */
#define REDCC_VALUES_2(redcc_v0, redcc_v1)                                                         \
    { redcc_v0, redcc_v1 }
#define REDCC_VALUES_3(redcc_v0, redcc_v1, redcc_v2)                                               \
    { redcc_v0, redcc_v1, redcc_v2 }
#define REDCC_VALUES_4(redcc_v0, redcc_v1, redcc_v2, redcc_v3)                                     \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3 }
#define REDCC_VALUES_5(redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4)                           \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4 }
#define REDCC_VALUES_6(redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5)                 \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5 }
#define REDCC_VALUES_7(redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6)       \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6 }
#define REDCC_VALUES_8(redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6,       \
                       redcc_v7)                                                                   \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6, redcc_v7 }
#define REDCC_VALUES_9(redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6,       \
                       redcc_v7, redcc_v8)                                                         \
    { redcc_v0, redcc_v1, redcc_v2, redcc_v3, redcc_v4, redcc_v5, redcc_v6, redcc_v7, redcc_v8 }

/** Records of values of one type: redcc_double_2 ... redcc_double_9, and the same for float. */
#define REDCC_RECORDS(redcc_type)                                                                  \
    typedef struct {                                                                               \
        redcc_type v0, v1;                                                                         \
    } redcc_##redcc_type##_2;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2;                                                                     \
    } redcc_##redcc_type##_3;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3;                                                                 \
    } redcc_##redcc_type##_4;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3, v4;                                                             \
    } redcc_##redcc_type##_5;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3, v4, v5;                                                         \
    } redcc_##redcc_type##_6;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3, v4, v5, v6;                                                     \
    } redcc_##redcc_type##_7;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3, v4, v5, v6, v7;                                                 \
    } redcc_##redcc_type##_8;                                                                      \
    typedef struct {                                                                               \
        redcc_type v0, v1, v2, v3, v4, v5, v6, v7, v8;                                             \
    } redcc_##redcc_type##_9
REDCC_RECORDS(double);
REDCC_RECORDS(float);

/** Precedes a REDCC_APPLY whose updates may combine several values of a record in floats. gcc 12
 * vectorises neighbouring updates (SLP) and then omits the roundings to float between them. An
 * example, with floats x and y and double operands: `x += d; x += e; y -= f; y += g;`. */
#if defined(__GNUC__) && !defined(__clang__)
#define REDCC_ROUNDED __attribute__((__optimize__("no-tree-slp-vectorize")))
#else
#define REDCC_ROUNDED
#endif

/** Defines a function that applies records. `redcc_updates` is the text for one record: it updates
 * the element *redcc__to with the values in redcc__e. redcc__tag is the number, in the loop's body,
 * of the update that pushed the record. If the stream has several arrays, the text begins with a
 * REDCC_APPLY_ALSO for each array except the first. */
#define REDCC_APPLY(redcc_name, redcc_element, redcc_record, redcc_bits, redcc_updates)            \
    REDCC_APPLY_HEAD(redcc_name, redcc_element, redcc_bits)                                        \
    const redcc_record redcc__e = ((const redcc_record *)redcc__applied->records)[redcc__n];       \
    redcc_updates                                                                                  \
    }                                                                                              \
    }
#define REDCC_APPLY_ALIKE(redcc_name, redcc_element, redcc_bits, redcc_updates)                    \
    REDCC_APPLY_HEAD(redcc_name, redcc_element, redcc_bits)                                        \
    redcc_updates                                                                                  \
    }                                                                                              \
    }
#define REDCC_APPLY_HEAD(redcc_name, redcc_element, redcc_bits)                                    \
    REDCC_UNFUSED static void redcc_name(const redcc_applied *redcc__applied) {                    \
        REDCC_UNFUSED_BLOCK                                                                        \
        redcc_element *const redcc__rows = (redcc_element *)redcc__applied->rows[0];               \
        redcc_size redcc__n;                                                                       \
        for (redcc__n = 0; redcc__n < redcc__applied->count; redcc__n++) {                         \
            const redcc_u32 redcc__place = redcc__applied->place[redcc__n];                        \
            const redcc_u32 redcc__tag __attribute__((__unused__)) =                               \
                REDCC_PLACE_TAG(redcc__place, redcc_bits);                                         \
            redcc_element *const redcc__to =                                                       \
                &redcc__rows[REDCC_PLACE_ROW(redcc__place, redcc_bits)];                           \
            const int redcc__ahead __attribute__((__unused__)) =                                   \
                redcc__applied->ahead                                                              \
                    ? (__builtin_prefetch(&redcc__rows[REDCC_PLACE_ROW(                            \
                           redcc__applied->place[redcc__n + redcc__applied->ahead], redcc_bits)]), \
                       1)                                                                          \
                    : 0;

/** Declares redcc__to_N, a pointer to the element in the stream's array number N. */
#define REDCC_APPLY_ALSO(redcc_n, redcc_element, redcc_bits)                                       \
    redcc_element *const redcc__to_##redcc_n =                                                     \
        &((redcc_element *)                                                                        \
              redcc__applied->rows[redcc_n])[REDCC_PLACE_ROW(redcc__place, redcc_bits)];           \
    const int redcc__ahead_##redcc_n __attribute__((__unused__)) =                                 \
        redcc__applied->ahead                                                                      \
            ? (__builtin_prefetch(                                                                 \
                   &((redcc_element *)redcc__applied->rows[redcc_n])[REDCC_PLACE_ROW(              \
                       redcc__applied->place[redcc__n + redcc__applied->ahead], redcc_bits)]),     \
               1)                                                                                  \
            : 0;

/** Begins a function that applies records of spans. Each record is applied to those elements of its
 * span that are in the bin. The function's body has, in this order:
 * - declarations of the names that the text uses; REDCC_EACH_SPAN;
 * - declarations of the record's values; a loop by the program's counter over [redcc__from,
 *   redcc__end), which updates *redcc__to and reads no other element that the round updates;
 * - REDCC_SPANS_END. */
#define REDCC_APPLY_SPANS(redcc_name, redcc_context)                                               \
    REDCC_UNFUSED static void redcc_name(const redcc_applied *redcc__applied) {                    \
        REDCC_UNFUSED_BLOCK                                                                        \
        const struct redcc_context *const redcc__context __attribute__((__unused__)) =             \
            (const struct redcc_context *)redcc__applied->operands;                                \
        const redcc_size redcc__low = (redcc_size)redcc__applied->rows[0];                         \
        redcc_size redcc__n;
#define REDCC_EACH_SPAN(redcc_element, redcc_record)                                               \
    const redcc_size redcc__high = redcc__low + redcc__applied->row_count * sizeof(redcc_element); \
    for (redcc__n = 0; redcc__n < redcc__applied->count; redcc__n++) {                             \
        const redcc_record redcc__e = ((const redcc_record *)redcc__applied->records)[redcc__n];   \
        const redcc_int redcc__from =                                                              \
            redcc__e.first < redcc__low                                                            \
                ? (redcc_int)((redcc__low - redcc__e.first) / sizeof(redcc_element))               \
                : 0;                                                                               \
        const redcc_int redcc__to_high =                                                           \
            (redcc_int)((redcc__high - redcc__e.first) / sizeof(redcc_element));                   \
        const redcc_int redcc__end =                                                               \
            redcc__e.count < redcc__to_high ? redcc__e.count : redcc__to_high;                     \
        redcc_element *__restrict__ redcc__to = (redcc_element *)redcc__e.first + redcc__from;
#define REDCC_SPANS_END                                                                            \
    }                                                                                              \
    }

/** A stream of one array whose records describe spans of its elements. */
#define REDCC_STREAM_OF_SPANS(redcc_apply, redcc_array, redcc_element, redcc_bytes)                \
    { redcc_apply, 1, {redcc_array}, {sizeof(redcc_element)}, redcc_bytes, 0, REDCC_STREAM_SPANS }

/** A stream of one array, whose rows are its elements. */
#define REDCC_STREAM(redcc_apply, redcc_array, redcc_element, redcc_bytes, redcc_bits,             \
                     redcc_exact)                                                                  \
    { redcc_apply, 1, {redcc_array}, {sizeof(redcc_element)}, redcc_bytes, redcc_bits, redcc_exact }

/* Parameters of the body when updates are binned: all streams, and for each array the bins of its
 * stream. */
#define REDCC_BINS_PARAMETERS_1                                                                    \
    const redcc_stream *const redcc__streams, const redcc_bins *const redcc__bins_0
#define REDCC_BINS_PARAMETERS_2 REDCC_BINS_PARAMETERS_1, const redcc_bins *const redcc__bins_1
#define REDCC_BINS_PARAMETERS_3 REDCC_BINS_PARAMETERS_2, const redcc_bins *const redcc__bins_2
#define REDCC_BINS_PARAMETERS_4 REDCC_BINS_PARAMETERS_3, const redcc_bins *const redcc__bins_3
#define REDCC_BINS_PARAMETERS_5 REDCC_BINS_PARAMETERS_4, const redcc_bins *const redcc__bins_4
#define REDCC_BINS_PARAMETERS_6 REDCC_BINS_PARAMETERS_5, const redcc_bins *const redcc__bins_5
#define REDCC_BINNED_PARAMETERS_1 REDCC_BODY_PARAMETERS_1, REDCC_BINS_PARAMETERS_1
#define REDCC_BINNED_PARAMETERS_2 REDCC_BODY_PARAMETERS_2, REDCC_BINS_PARAMETERS_2
#define REDCC_BINNED_PARAMETERS_3 REDCC_BODY_PARAMETERS_3, REDCC_BINS_PARAMETERS_3
#define REDCC_BINNED_PARAMETERS_4 REDCC_BODY_PARAMETERS_4, REDCC_BINS_PARAMETERS_4
#define REDCC_BINNED_PARAMETERS_5 REDCC_BODY_PARAMETERS_5, REDCC_BINS_PARAMETERS_5
#define REDCC_BINNED_PARAMETERS_6 REDCC_BODY_PARAMETERS_6, REDCC_BINS_PARAMETERS_6
#define REDCC_BINS_ARGUMENTS_1 redcc__streams, redcc__bins_0
#define REDCC_BINS_ARGUMENTS_2 REDCC_BINS_ARGUMENTS_1, redcc__bins_1
#define REDCC_BINS_ARGUMENTS_3 REDCC_BINS_ARGUMENTS_2, redcc__bins_2
#define REDCC_BINS_ARGUMENTS_4 REDCC_BINS_ARGUMENTS_3, redcc__bins_3
#define REDCC_BINS_ARGUMENTS_5 REDCC_BINS_ARGUMENTS_4, redcc__bins_4
#define REDCC_BINS_ARGUMENTS_6 REDCC_BINS_ARGUMENTS_5, redcc__bins_5
#define REDCC_BINNED_ARGUMENTS_1 REDCC_BODY_ARGUMENTS_1, REDCC_BINS_ARGUMENTS_1
#define REDCC_BINNED_ARGUMENTS_2 REDCC_BODY_ARGUMENTS_2, REDCC_BINS_ARGUMENTS_2
#define REDCC_BINNED_ARGUMENTS_3 REDCC_BODY_ARGUMENTS_3, REDCC_BINS_ARGUMENTS_3
#define REDCC_BINNED_ARGUMENTS_4 REDCC_BODY_ARGUMENTS_4, REDCC_BINS_ARGUMENTS_4
#define REDCC_BINNED_ARGUMENTS_5 REDCC_BODY_ARGUMENTS_5, REDCC_BINS_ARGUMENTS_5
#define REDCC_BINNED_ARGUMENTS_6 REDCC_BODY_ARGUMENTS_6, REDCC_BINS_ARGUMENTS_6

/* For each array of a chunk whose updates are pushed or made on copies: declares a copy of the bins
 * of its stream, and the array's base. Other chunks use REDCC_NO_BINS_OF. */
#define REDCC_BINS_OF(redcc_i)                                                                     \
    const redcc_part redcc__part_##redcc_i = redcc_part_of(redcc__streams, redcc_i);               \
    const redcc_u32 redcc__row_bytes_##redcc_i =                                                   \
        redcc__streams[redcc__part_##redcc_i.stream].rows[redcc__part_##redcc_i.part];             \
    redcc_chunk_bins redcc__bin_##redcc_i =                                                        \
        redcc_chunk_bins_of(&redcc__all[redcc__part_##redcc_i.stream], redcc__part_##redcc_i.part, \
                            redcc__row_bytes_##redcc_i);                                           \
    const redcc_bins *const redcc__bins_##redcc_i = &redcc__bin_##redcc_i.bins;                    \
    const redcc_owner redcc__owner_##redcc_i = {0, 0, 0, 0, 0, 0};                                 \
    void *const redcc__base_##redcc_i __attribute__((__unused__)) =                                \
        redcc__checked == REDCC_IN_COPIES                                                          \
            ? redcc_copy_base(redcc__bins_##redcc_i,                                               \
                              &redcc__streams[redcc__part_##redcc_i.stream],                       \
                              redcc__part_##redcc_i.part)                                          \
            : redcc__attempt->bases[redcc_i];
#define REDCC_BINS_1_OF(redcc_of) redcc_of(0)
#define REDCC_BINS_2_OF(redcc_of) REDCC_BINS_1_OF(redcc_of) redcc_of(1)
#define REDCC_BINS_3_OF(redcc_of) REDCC_BINS_2_OF(redcc_of) redcc_of(2)
#define REDCC_BINS_4_OF(redcc_of) REDCC_BINS_3_OF(redcc_of) redcc_of(3)
#define REDCC_BINS_5_OF(redcc_of) REDCC_BINS_4_OF(redcc_of) redcc_of(4)
#define REDCC_BINS_6_OF(redcc_of) REDCC_BINS_5_OF(redcc_of) redcc_of(5)
#define REDCC_LACKING_OF(redcc_i)                                                                  \
    redcc_report_lacking(&redcc__bin_##redcc_i, redcc__row_bytes_##redcc_i);
#define REDCC_NO_BINS_OF(redcc_i) const redcc_bins *const redcc__bins_##redcc_i = 0;

/** Executes iterations whose updates are pushed, or made on copies. The bits of redcc_first_mask
 * select the sources whose reads the first iteration records; those of redcc_later_mask, the
 * sources whose reads the later iterations record. */
#define REDCC_PUSH_CHUNK(redcc_bins_n, redcc_mode, redcc_first_mask, redcc_later_mask,             \
                         redcc_call_of_slice, redcc_call_of_body)                                  \
    {                                                                                              \
        const int redcc__checked = redcc_mode;                                                     \
        redcc_probe *const redcc__probe __attribute__((__unused__)) = 0;                           \
        redcc_u32 redcc__source_mask = redcc_first_mask;                                           \
        redcc_bins_n##_OF(REDCC_BINS_OF) for (redcc__k = redcc__worker->first;                     \
                                              redcc__k < redcc__worker->last; redcc__k++) {        \
            if (redcc__source_mask)                                                                \
                redcc_call_of_slice;                                                               \
            redcc_call_of_body;                                                                    \
            redcc__source_mask = redcc_later_mask;                                                 \
        }                                                                                          \
        redcc_bins_n##_OF(REDCC_LACKING_OF)                                                        \
    }

/** A function that executes a chunk whose updates are made on private copies. In the function of
 * each thread, with its many forms of the body, compilers keep values that this loop needs in
 * memory. */
#define REDCC_COPIER static __attribute__((__noinline__, __unused__)) void
#define REDCC_COPIER_PARAMETERS                                                                    \
    REDCC_MEMBER_PARAMETERS, const redcc_stream *redcc__streams, const redcc_bins *redcc__all
#define REDCC_COPIED_BY(redcc_copier)                                                              \
    (redcc_copier(redcc__worker, redcc__attempt, redcc__given, redcc__streams, redcc__all), 2)
#define REDCC_COPY_CHUNK(redcc_bins_n, redcc_first_mask, redcc_later_mask, redcc_call_of_slice,    \
                         redcc_call_of_body)                                                       \
    {                                                                                              \
        redcc_worker *const redcc__recorder __attribute__((__unused__)) = redcc__worker;           \
        redcc_int redcc__k;                                                                        \
        REDCC_PUSH_CHUNK(redcc_bins_n, REDCC_IN_COPIES, redcc_first_mask, redcc_later_mask,        \
                         redcc_call_of_slice, redcc_call_of_body)                                  \
    }

/** As REDCC_PARALLEL, for a loop that can be binned.
 *    redcc_bins_n       REDCC_BINS_n, for n arrays
 *    redcc_first_mask    sources whose reads are recorded while iterations are pushed
 *    redcc_copies        are updates on private copies possible? 0: no. 1: yes, by a part of this
 *                        function. Or REDCC_COPIED_BY */
#define REDCC_PARALLEL_BINNED(redcc_streams, redcc_chunk, redcc_bins_n, redcc_first_mask,          \
                              redcc_copies, redcc_call_of_slice, redcc_call_of_body)               \
    REDCC_BINNED_AND(0, 0, 1, redcc_streams, redcc_chunk, redcc_bins_n, redcc_first_mask,          \
                     redcc_first_mask, redcc_copies, redcc_call_of_slice, redcc_call_of_slice,     \
                     redcc_call_of_body)
/** As REDCC_PARALLEL_BINNED, but a separate slice (redcc_call_of_reads) records the reads of
 * iterations that are pushed. redcc_later_mask selects only the sources whose rows differ from
 * iteration to iteration: a chunk's first iteration has recorded the others. */
#define REDCC_PARALLEL_BINNED_READS(redcc_streams, redcc_chunk, redcc_bins_n, redcc_first_mask,    \
                                    redcc_later_mask, redcc_copies, redcc_call_of_reads,           \
                                    redcc_call_of_slice, redcc_call_of_body)                       \
    REDCC_BINNED_AND(redcc__context, 0, 1, redcc_streams, redcc_chunk, redcc_bins_n,               \
                     redcc_first_mask, redcc_later_mask, redcc_copies, redcc_call_of_reads,        \
                     redcc_call_of_slice, redcc_call_of_body)
/** As REDCC_PARALLEL_BINNED, for a loop with series. If redcc_again is true at the end, all
 * iterations are executed a second time (redcc/series.h). */
#define REDCC_PARALLEL_BINNED_SERIES(redcc_streams, redcc_chunk, redcc_bins_n, redcc_first_mask,   \
                                     redcc_copies, redcc_again, redcc_call_of_slice,               \
                                     redcc_call_of_body)                                           \
    REDCC_BINNED_AND(0, redcc_again, 2, redcc_streams, redcc_chunk, redcc_bins_n,                  \
                     redcc_first_mask, redcc_first_mask, redcc_copies, redcc_call_of_slice,        \
                     redcc_call_of_slice, redcc_call_of_body)
#define REDCC_BINNED_AND(redcc_operands, redcc_again, redcc_selects, redcc_streams, redcc_chunk,   \
                         redcc_bins_n, redcc_first_mask, redcc_later_mask, redcc_copies,           \
                         redcc_call_of_reads, redcc_call_of_slice, redcc_call_of_body)             \
    {                                                                                              \
        const redcc_stream *const redcc__streams = redcc_streams;                                  \
        redcc_bins redcc__all[sizeof(redcc_streams) / sizeof(redcc_stream)];                       \
        int redcc__bins_kind;                                                                      \
        REDCC_JOIN(redcc_call_of_slice)                                                            \
        do {                                                                                       \
            while (__builtin_expect((redcc__bins_kind = redcc__worker->call->calls->bins_next(     \
                                         redcc__worker, redcc__all, redcc_operands)) ==            \
                                        REDCC_TO_PUSH,                                             \
                                    0)) {                                                          \
                const int redcc__copies = REDCC_ARE_COPIED(&redcc__all[0]) ? (redcc_copies) : 0;   \
                if (redcc__copies == 1)                                                            \
                    REDCC_PUSH_CHUNK(redcc_bins_n, REDCC_IN_COPIES, redcc_first_mask,              \
                                     redcc_later_mask, redcc_call_of_reads, redcc_call_of_body)    \
                else if (!redcc__copies)                                                           \
                    REDCC_PUSH_CHUNK(redcc_bins_n, REDCC_IN_BINS, redcc_first_mask,                \
                                     redcc_later_mask, redcc_call_of_reads, redcc_call_of_body)    \
            }                                                                                      \
            {                                                                                      \
                redcc_bins_n##_OF(REDCC_NO_BINS_OF) REDCC_EXECUTE_AND(                             \
                    redcc__bins_kind != REDCC_TO_EXECUTE && (redcc_again), redcc_selects,          \
                    redcc_chunk, redcc_call_of_slice, redcc_call_of_body)                          \
            }                                                                                      \
        } while (redcc__bins_kind == REDCC_TO_EXECUTE);                                            \
    }

#endif
