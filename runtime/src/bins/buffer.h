/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One thread's records of one stream, in blocks of REDCC_BLOCK_RECORDS: block k holds records [k *
 * REDCC_BLOCK_RECORDS, (k + 1) * REDCC_BLOCK_RECORDS). Bin b begins in block b, at
 * redcc_bin_offset(b), and continues in next[b], next[next[b]], ... Its cursor is always inside of
 * its last block. The thread that entered the loop allocates the memory, the pushing thread writes
 * it first, and it is kept for later executions.
 */
#ifndef REDCC_BUFFER_H
#define REDCC_BUFFER_H

#include "bins/pieces.h"
#include "bins/window.h"

#include <stddef.h>

struct redcc_bin_buffer {
    redcc_bins push; /* copied by generated code */
    const redcc_stream *stream;
    redcc_size readable_page; /* as in redcc_bins; of this round */
    uint32_t bins;
    uint32_t blocks; /* allocated */
    uint32_t used;   /* blocks, so far */
    uint32_t *next;  /* [blocks] the next block of the same bin */
    uint32_t *mark;  /* [PIECE_MARKS][bins] the cursors at the beginnings of the thread's pieces */
    redcc_int marked[PIECE_MARKS]; /* number of records at each beginning */
    bool exhausted;                /* no blocks were left: records are missing */
    struct row_range outside; /* recorded rows outside of the bins: their records are missing */
    redcc_int outside_count;  /* number of these records */
    struct row_range reached; /* rows that spans reach */
    char *memory;
};

/** Records of one bin, in the order they were pushed: numbers of the first one and of the one after
 *  the last. */
struct stretch {
    uint32_t begin;
    uint32_t end;
};

/** Consecutive records of one bin. */
struct records {
    const redcc_u16 *place;
    const void *record;
    size_t count;
};

/** The beginning of bin `bin` in its first block, which maps it to other cache sets than its
 *  neighbours. */
static inline uint32_t redcc_bin_offset(size_t bin) {
    return (uint32_t)(bin * 5 & 15) * REDCC_LINE_PLACES;
}

/** Bytes of a buffer. */
size_t redcc_buffer_bytes(const redcc_stream *stream, struct window window, uint32_t blocks);

/** Shapes the buffer for the window's rows, with `blocks` blocks. False: out of memory; it has
 * no blocks then. */
bool redcc_buffer_shape(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                        struct window window, uint32_t blocks);

/** The same for private copies of the window's rows. */
bool redcc_buffer_shape_copies(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                               struct window window);

/** Frees its memory. */
void redcc_buffer_end(struct redcc_bin_buffer *buffer);

/** Empties it. Called by the pushing thread, as are the next functions. */
void redcc_buffer_clear(struct redcc_bin_buffer *buffer);

/** Gives it a window without rows, so that pushed records are only counted. */
void redcc_buffer_measure(struct redcc_bin_buffer *buffer, const redcc_stream *stream);

/** Begins piece number `piece` of the thread, and ends the preceding one. */
void redcc_buffer_mark(struct redcc_bin_buffer *buffer, int piece);

/** Will this many more records probably fit? Requires twice the blocks that they would fill, and
 * two more. */
bool redcc_buffer_has_room(const struct redcc_bin_buffer *buffer, double records);

/** Called after the last push: writes the partially filled lines of write combining. */
void redcc_buffer_finish(struct redcc_bin_buffer *buffer);

/** Pushes a record of `count` rows, from row `low` on, to each of their bins. REDCC_NO_ROW: the
 *  round is lost. */
void redcc_push_span(const redcc_bins *bins, const redcc_stream *stream, redcc_int low,
                     redcc_int count, const void *record);

/** Is a pointer at this address readable? Then *page is the number of its page. */
int redcc_is_readable(redcc_size *page, const void *address);

/** Are records missing? */
static inline bool redcc_buffer_failed(const struct redcc_bin_buffer *buffer) {
    return buffer->exhausted || !redcc_rows_empty(buffer->outside);
}

/** Does the bin have records? */
bool redcc_bin_is_used(const struct redcc_bin_buffer *buffer, uint32_t bin);

/** All of the bin's records; and those of the thread's pieces [first, end). */
struct stretch redcc_bin_all(const struct redcc_bin_buffer *buffer, uint32_t bin);
struct stretch redcc_bin_pieces(const struct redcc_bin_buffer *buffer, uint32_t bin, int first,
                                int end);

/** Takes adjacent records from the front of the stretch. False: it is empty. */
bool redcc_bin_records(const struct redcc_bin_buffer *buffer, struct stretch *left,
                       struct records *records);

#endif
