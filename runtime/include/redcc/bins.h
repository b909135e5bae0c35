/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * In-order binning, for generated code: a loop that is executed without an inspection. Its body
 * writes nothing of the reduction arrays; it appends a record of each update to the bin of its row
 * (redcc_push), and the runtime applies the records later, bin by bin, in the order of the loop.
 *
 *     redcc_enter, redcc_join, redcc_inspect       as in runtime.h
 *     redcc_bins_next  each thread  hands out iterations whose updates are to be pushed
 *       redcc_push                  in the place of an update; or, where they are made on private
 *                                   copies (REDCC_ARE_COPIED), redcc_update
 *       redcc_read                  of what is read and has no extent in `known`
 *     redcc_next, redcc_leave       as in runtime.h; redcc_next hands out, in its plain form, what
 *                                   could not be binned
 *
 * Iterations may be handed out to be pushed more than once: what was pushed before is thrown away.
 * So a loop has this form only if its body leaves the same whether it is executed once or twice,
 * and may be executed before its reads are compared with what is written: no address that it reads
 * or stores at, no divisor and no bound of a loop inside comes from memory that is not proved apart
 * from the reduction arrays. All that it reads beside is in the loop's sources.
 *
 * As runtime.h, this header includes no other of the system and compiles as C89 with GNU
 * extensions.
 */
#ifndef REDCC_BINS_H
#define REDCC_BINS_H

#include <redcc/runtime.h>

typedef unsigned short redcc_u16;

enum {
    /** Arrays that one record may update, at one subscript. */
    REDCC_STREAM_ARRAYS = 4,
    /** Bits of a place: the row within its bin, and above it the update's number. */
    REDCC_PLACE_BITS = 16,
    REDCC_MOST_TAG_BITS = 8,
    REDCC_BLOCK_RECORDS = 1024, /**< that lie together */
    REDCC_LINE_PLACES = 32,     /**< that fill a cache line */
    REDCC_CACHE_LINE = 64,      /**< bytes */
    REDCC_RECORDS_AHEAD = 16    /**< to be prefetched */
};

/** Records to apply, in this order. */
typedef struct redcc_applied {
    void *const *rows;      /**< of each array of the stream: its row at place 0 */
    const redcc_u16 *place; /**< [count + ahead] */
    const void *records;    /**< [count] */
    redcc_size count;
    redcc_size ahead;     /**< so many places behind the one at hand may be prefetched; or 0 */
    const void *operands; /**< what redcc_bins_next was given */
} redcc_applied;

/** Updates that must be applied in order: all those of an array, or of several at one subscript. */
typedef struct redcc_stream {
    /** Applies records: the text of the updates. May write nothing but the rows. */
    void (*apply)(const redcc_applied *applied);
    redcc_u32 array_count;                 /**< 1 to REDCC_STREAM_ARRAYS */
    redcc_u32 arrays[REDCC_STREAM_ARRAYS]; /**< numbers in the loop's arrays; no array is in two
                                                streams */
    redcc_u32 rows[REDCC_STREAM_ARRAYS];   /**< bytes of a row of each: that array's `unit` */
    redcc_u32 record; /**< bytes of a record, even; 0: the contribution is a constant */
    redcc_u32 tag_bits;
    int exact; /**< all updates of an array are by its operator, on integers: they may be made in
                    any order, and on private copies */
} redcc_stream;

/** A loop that can be binned; loop.flags has REDCC_BINNED. */
typedef struct redcc_binned {
    redcc_loop loop;
    redcc_u32 stream_count;
    const redcc_stream *streams;
} redcc_binned;

struct redcc_bin_buffer;

/** One thread's bins of one stream. Constant while a chunk of iterations is executed: generated
 *  code has a copy of it. */
typedef struct redcc_bins {
    redcc_int first;   /* row at place 0 of bin 0 */
    redcc_size span;   /* rows that the bins hold; 0: none, rows are only counted */
    redcc_u32 shift;   /* of a row to its bin */
    redcc_u32 *cursor; /* of each bin: the number of its next record */
    char *records;     /* by their numbers */
    redcc_u16 *places; /* by the records' numbers */
    char *lines;       /* write combining: of each bin the lines that are being filled; or 0 */
    char *copy[REDCC_STREAM_ARRAYS]; /* private copies: of each array, of row `first`; or 0 */
    const void *operands;
    struct redcc_bin_buffer *buffer;
} redcc_bins;

#if defined(__GNUC__)
#ifdef REDCC_HIDDEN /* the archive: what it is linked into exports nothing of it */
#pragma GCC visibility push(hidden)
#else
#pragma GCC visibility push(default) /* the library hides everything else */
#endif
#endif

/**
 * The next iterations to push: 1 with worker->first and worker->last, and bins [stream_count], or
 * 0: go on to redcc_next. Between redcc_inspect and redcc_next, by every thread of the region,
 * until it returns 0.
 *   operands  values that the apply functions need and that stay during the loop, the same for all
 *             threads; read until redcc_bins_next has returned 0 to all of them
 */
int redcc_bins_next(redcc_worker *worker, redcc_bins *bins, const void *operands);

/** Called by redcc_push for a row outside of the bins. */
void redcc_push_outside(struct redcc_bin_buffer *buffer, redcc_int row) __attribute__((__cold__));

/** Called by redcc_push: a block is full; the number of the next record of `bin`. */
redcc_u32 redcc_push_block(struct redcc_bin_buffer *buffer, redcc_size bin, redcc_u32 record)
    __attribute__((__cold__));

#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

/** Records of `bytes` bytes that fill whole cache lines together, at most 32. */
#define REDCC_LINE_RECORDS(bytes)                                                                  \
    ((bytes) == 0                                                                                  \
         ? 1u                                                                                      \
         : (redcc_u32)REDCC_CACHE_LINE / (((bytes) & (0u - (bytes))) > (redcc_u32)REDCC_CACHE_LINE \
                                              ? (redcc_u32)REDCC_CACHE_LINE                        \
                                              : ((bytes) & (0u - (bytes)))))

/** Bytes of these lines, and of the line of places behind them: what a bin is combined in. */
#define REDCC_LINES_BYTES(bytes) (REDCC_LINE_RECORDS(bytes) * (bytes))
#define REDCC_COMBINED_BYTES(bytes) (REDCC_LINES_BYTES(bytes) + (redcc_u32)REDCC_CACHE_LINE)

/** The row and the update's number in a place. */
#define REDCC_PLACE_ROW(place, tag_bits) ((place) & ((1u << (REDCC_PLACE_BITS - (tag_bits))) - 1u))
#define REDCC_PLACE_TAG(place, tag_bits) ((place) >> (REDCC_PLACE_BITS - (tag_bits)))

/** Apply functions: what is wanted soon. */
#define REDCC_APPLY_AHEAD(applied, k, row, tag_bits)                                               \
    do {                                                                                           \
        if ((applied)->ahead)                                                                      \
            __builtin_prefetch(                                                                    \
                &(row)[REDCC_PLACE_ROW((applied)->place[(k) + (applied)->ahead], tag_bits)]);      \
    } while (0)

/** Are the chunk's updates made on private copies? Then by redcc_update, else by redcc_push; of all
 *  streams, or of none. Only where each stream is `exact`. */
#define REDCC_ARE_COPIED(bins) ((bins)->copy[0] != 0)

/** Writes `bytes` bytes, whole lines, past the caches. */
REDCC_INLINE void redcc_write_lines(char *to, const char *from, redcc_size bytes) {
#if defined(__x86_64__) && defined(__SSE2__) && defined(__GNUC__)
    typedef double redcc_vector __attribute__((__vector_size__(16), __may_alias__));
    redcc_size done;
    for (done = 0; done < bytes; done += sizeof(redcc_vector))
        __asm__("movntdq %1, %0"
                : "=m"(*(redcc_vector *)(void *)(to + done))
                : "x"(*(const redcc_vector *)(const void *)(from + done)));
#else
    __builtin_memcpy(to, from, bytes);
#endif
}

/** The line that will be written soon. */
REDCC_INLINE void redcc_prefetch_to_write(const void *address) {
#if defined(__x86_64__) && defined(__GNUC__)
    __asm__ volatile("prefetchw %0" : : "m"(*(const char *)address));
#else
    __builtin_prefetch(address, 1);
#endif
}

/** In the place of an update where REDCC_ARE_COPIED: it is made at once, on the thread's own copy;
 *  otherwise as redcc_push. */
REDCC_INLINE void redcc_update(const redcc_bins *bins, const redcc_stream *stream, redcc_int row,
                               redcc_u32 tag, const void *record) {
    const redcc_size into = (redcc_size)row - (redcc_size)bins->first;
    const redcc_u16 place = (redcc_u16)(tag << (REDCC_PLACE_BITS - stream->tag_bits));
    void *rows[REDCC_STREAM_ARRAYS];
    redcc_applied one;
    redcc_u32 array;
    if (__builtin_expect(into >= bins->span, 0)) {
        redcc_push_outside(bins->buffer, row);
        return;
    }
    for (array = 0; array < stream->array_count; array++)
        rows[array] = bins->copy[array] + into * stream->rows[array];
    one.rows = rows;
    one.place = &place;
    one.records = record;
    one.count = 1;
    one.ahead = 0;
    one.operands = bins->operands;
    stream->apply(&one);
}

/* Appends to the lines of the bin, which are written once they are full. */
REDCC_INLINE redcc_u32 redcc_push_combined(const redcc_bins *bins, redcc_size bin, redcc_u32 number,
                                           redcc_u16 place, const void *record, redcc_u32 bytes) {
    const redcc_u32 records = REDCC_LINE_RECORDS(bytes);
    char *const line = bins->lines + bin * REDCC_COMBINED_BYTES(bytes);
    redcc_u16 *const places = (redcc_u16 *)(void *)(line + REDCC_LINES_BYTES(bytes));
    if (bytes)
        __builtin_memcpy(line + (redcc_size)(number % records) * bytes, record, bytes);
    places[number % REDCC_LINE_PLACES] = place;
    number++;
    if (bytes && number % records == 0)
        redcc_write_lines(bins->records + (redcc_size)(number - records) * bytes, line,
                          REDCC_LINES_BYTES(bytes));
    if (number % REDCC_LINE_PLACES == 0)
        redcc_write_lines((char *)(bins->places + (number - REDCC_LINE_PLACES)),
                          (const char *)places, REDCC_CACHE_LINE);
    return number;
}

REDCC_INLINE redcc_u32 redcc_push_direct(const redcc_bins *bins, redcc_u32 number, redcc_u16 place,
                                         const void *record, redcc_u32 bytes) {
    char *const to = bins->records + (redcc_size)number * bytes;
    bins->places[number] = place;
    if (bytes) {
        __builtin_memcpy(to, record, bytes);
        redcc_prefetch_to_write(to + (redcc_size)REDCC_RECORDS_AHEAD * bytes);
    }
    return number + 1;
}

/**
 * In the place of an update: the row, counted in rows of the stream's arrays from their bases, is
 * to be updated by update number `tag` with what *record (stream->record bytes) holds. `stream` is
 * the descriptor's own entry, so that the compiler sees its fields.
 */
REDCC_INLINE void redcc_push(const redcc_bins *bins, const redcc_stream *stream, redcc_int row,
                             redcc_u32 tag, const void *record) {
    const redcc_size into = (redcc_size)row - (redcc_size)bins->first;
    redcc_size bin;
    redcc_u32 number;
    redcc_u16 place;
    if (__builtin_expect(into >= bins->span, 0)) {
        redcc_push_outside(bins->buffer, row);
        return;
    }
    bin = into >> bins->shift;
    place = (redcc_u16)(tag << (REDCC_PLACE_BITS - stream->tag_bits) |
                        (redcc_u32)(into - (bin << bins->shift)));
    number = bins->cursor[bin];
    number = bins->lines ? redcc_push_combined(bins, bin, number, place, record, stream->record)
                         : redcc_push_direct(bins, number, place, record, stream->record);
    if (__builtin_expect(number % REDCC_BLOCK_RECORDS == 0, 0))
        number = redcc_push_block(bins->buffer, bin, number);
    bins->cursor[bin] = number;
}

#endif
