/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One thread's records of one stream, in blocks of REDCC_BLOCK_RECORDS: block k holds records [k *
 * REDCC_BLOCK_RECORDS, (k + 1) * REDCC_BLOCK_RECORDS). Bin b begins in block b, at
 * redcc_bin_offset(b), and continues in next[b], next[next[b]], ... A bin's cursor, the number of
 * its next record, is always inside of the bin's last block. The thread that entered the loop
 * allocates the memory, and the pushing thread is the first to write to it. The memory is kept for
 * later executions.
 */
#ifndef REDCC_BUFFER_H
#define REDCC_BUFFER_H

#include "bins/pieces.h"
#include "bins/window.h"

#include <stddef.h>

struct redcc_bin_buffer {
    redcc_bins push; /* the part that generated code copies */
    const redcc_stream *stream;
    redcc_size readable_page; /* redcc_bins.readable_page points to this; valid for one round */
    uint32_t bins;
    uint32_t blocks; /* number of allocated blocks */
    uint32_t used;   /* number of blocks used so far */
    uint32_t *next;  /* [blocks] the next block of the same bin */
    /* [PIECE_MARKS][bins] the cursors at the beginning of each of the thread's pieces */
    uint32_t *mark;
    redcc_int marked[PIECE_MARKS]; /* the number of records at the beginning of each piece */
    bool exhausted;                /* a record was not stored, because no blocks were left */
    struct row_range outside; /* range of the rows outside of the bins, whose records are missing */
    redcc_int outside_count;  /* number of these records */
    struct row_range reached; /* range of the rows that spans reach */
    char *memory;
};

/** A stretch of one bin: consecutive records, in the order in which they were pushed. `begin` is
 * the number of the first record, `end` the number after the last record. */
struct stretch {
    uint32_t begin;
    uint32_t end;
};

/** Records of one bin that are adjacent in memory. */
struct records {
    const redcc_u16 *place;
    const void *record;
    size_t count;
};

/** The position in its first block at which bin `bin` begins. Neighbouring bins have different
 * positions, so that they use different cache sets. */
static inline uint32_t redcc_bin_offset(size_t bin) {
    return (uint32_t)(bin * 5 & 15) * REDCC_LINE_PLACES;
}

/** The size of a buffer in bytes. */
size_t redcc_buffer_bytes(const redcc_stream *stream, struct window window, uint32_t blocks);

/** Lays out the buffer for the window's rows, with `blocks` blocks. False: out of memory; then the
 * buffer has no blocks. */
bool redcc_buffer_shape(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                        struct window window, uint32_t blocks);

/** As redcc_buffer_shape, for private copies of the window's rows. */
bool redcc_buffer_shape_copies(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                               struct window window);

/** Frees the buffer's memory. */
void redcc_buffer_end(struct redcc_bin_buffer *buffer);

/** Empties the buffer. The pushing thread calls this and the following functions. */
void redcc_buffer_clear(struct redcc_bin_buffer *buffer);

/** Gives the buffer a window without rows, so that pushed records are only counted. */
void redcc_buffer_measure(struct redcc_bin_buffer *buffer, const redcc_stream *stream);

/** Begins piece number `piece` of the thread, and ends the piece before it. */
void redcc_buffer_mark(struct redcc_bin_buffer *buffer, int piece);

/** Will `records` more records probably fit? True only if there are twice as many free blocks as
 * they would fill, and two more. */
bool redcc_buffer_has_room(const struct redcc_bin_buffer *buffer, double records);

/** Called after the last push of a round: writes the partially filled write-combining buffers to
 * memory. */
void redcc_buffer_finish(struct redcc_bin_buffer *buffer);

/** Pushes a record that covers `count` rows from row `low` on: to each bin that has some of these
 * rows. If `low` is REDCC_NO_ROW, the round fails. */
void redcc_push_span(const redcc_bins *bins, const redcc_stream *stream, redcc_int low,
                     redcc_int count, const void *record);

/** Is a pointer at this address readable? If so, sets *page to the number of its page. */
int redcc_is_readable(redcc_size *page, const void *address);

/** Are records of the buffer missing? */
static inline bool redcc_buffer_failed(const struct redcc_bin_buffer *buffer) {
    return buffer->exhausted || !redcc_rows_empty(buffer->outside);
}

/** Does the bin have records? */
bool redcc_bin_is_used(const struct redcc_bin_buffer *buffer, uint32_t bin);

/** redcc_bin_all: all records of the bin. redcc_bin_pieces: its records from pieces [first, end) of
 * the thread. */
struct stretch redcc_bin_all(const struct redcc_bin_buffer *buffer, uint32_t bin);
struct stretch redcc_bin_pieces(const struct redcc_bin_buffer *buffer, uint32_t bin, int first,
                                int end);

/** Removes adjacent records from the front of the stretch *left and returns them in *records.
 * False: the stretch is empty. */
bool redcc_bin_records(const struct redcc_bin_buffer *buffer, struct stretch *left,
                       struct records *records);

#endif
