/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * One thread's records of one stream, in blocks of REDCC_BLOCK_RECORDS: block k holds records
 * [k * REDCC_BLOCK_RECORDS, (k + 1) * REDCC_BLOCK_RECORDS). Bin b begins in block b, at
 * redcc_bin_offset(b), and goes on in next[b], next[next[b]], ... Its cursor is inside of its last
 * block always. The memory is taken by the thread that entered the loop, first written by the one
 * that pushes, and kept for the executions that follow.
 */
#ifndef REDCC_BUFFER_H
#define REDCC_BUFFER_H

#include "bins/pieces.h"
#include "bins/window.h"

#include <stddef.h>

struct redcc_bin_buffer {
    redcc_bins push; /* what generated code has a copy of */
    const redcc_stream *stream;
    uint32_t bins;
    uint32_t blocks; /* there are */
    uint32_t used;   /* blocks, so far */
    uint32_t *next;  /* [blocks] the block of the same bin that follows */
    uint32_t *mark;  /* [PIECE_MARKS][bins] the cursors where the thread's pieces begin */
    redcc_int marked[PIECE_MARKS]; /* records, where they begin */
    bool exhausted;                /* there were no more blocks: records are missing */
    struct row_range outside; /* rows told that the bins do not hold: their records are missing */
    redcc_int told_outside;   /* how many */
    char *memory;
};

/** Records of one bin, in the order in which they were pushed: numbers of the first one and of the
 *  one behind the last. */
struct stretch {
    uint32_t begin;
    uint32_t end;
};

/** Some records of one bin, one after the other. */
struct records {
    const redcc_u16 *place;
    const void *record;
    size_t count;
};

/** Where bin `bin` begins in its first block: at other cache sets than its neighbours. */
static inline uint32_t redcc_bin_offset(size_t bin) {
    return (uint32_t)(bin * 5 & 15) * REDCC_LINE_PLACES;
}

/** Bytes of a buffer. */
size_t redcc_buffer_bytes(const redcc_stream *stream, struct window window, uint32_t blocks);

/** Makes it a buffer for the window's rows, with at least so many blocks. False: no memory; it has
 *  no blocks then. */
bool redcc_buffer_shape(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                        struct window window, uint32_t blocks);

/** The same for private copies of the window's rows. */
bool redcc_buffer_shape_copies(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                               struct window window);

/** Gives its memory back. */
void redcc_buffer_end(struct redcc_bin_buffer *buffer);

/** Empties it. By the thread that pushes, as what follows. */
void redcc_buffer_clear(struct redcc_bin_buffer *buffer);

/** Makes it hold no rows, so that all that are pushed are only counted. */
void redcc_buffer_measure(struct redcc_bin_buffer *buffer, const redcc_stream *stream);

/** Piece number `piece` of the thread begins here; and the one before ends. */
void redcc_buffer_mark(struct redcc_bin_buffer *buffer, int piece);

/** Is there room for so many records, wherever they go? By some more than is likely. */
bool redcc_buffer_has_room(const struct redcc_bin_buffer *buffer, double records);

/** All is pushed: writes what is still being combined. */
void redcc_buffer_finish(struct redcc_bin_buffer *buffer);

/** Are records missing? */
static inline bool redcc_buffer_failed(const struct redcc_bin_buffer *buffer) {
    return buffer->exhausted || !redcc_rows_empty(buffer->outside);
}

/** Records that were pushed. */
redcc_int redcc_buffer_count(const struct redcc_bin_buffer *buffer);

/** Has the bin records? */
bool redcc_bin_is_used(const struct redcc_bin_buffer *buffer, uint32_t bin);

/** All of the bin's records; and those of the thread's pieces [first, end). */
struct stretch redcc_bin_all(const struct redcc_bin_buffer *buffer, uint32_t bin);
struct stretch redcc_bin_pieces(const struct redcc_bin_buffer *buffer, uint32_t bin, int first,
                                int end);

/** Takes records that lie together from the front of the stretch. False: it is empty. */
bool redcc_bin_records(const struct redcc_bin_buffer *buffer, struct stretch *left,
                       struct records *records);

#endif
