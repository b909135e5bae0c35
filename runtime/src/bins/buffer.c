/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "bins/buffer.h"

#include "base/memory.h"
#include "base/safe_load.h"

#include <assert.h>
#include <string.h>

enum { LINE = REDCC_CACHE_LINE, BLOCK = REDCC_BLOCK_RECORDS };

static size_t whole_lines(size_t bytes) {
    return (bytes + LINE - 1) / LINE * LINE;
}

/* ---- layout of the memory -------------------------------------------------------------------- */

/* The offsets of the parts, and the total number of bytes. */
struct parts {
    size_t records;
    size_t places;
    size_t cursor;
    size_t next;
    size_t mark;
    size_t lines;
    size_t bytes;
};

static struct parts parts_of(const redcc_stream *stream, struct window window, uint32_t blocks) {
    const size_t records = (size_t)blocks * BLOCK;
    struct parts parts = {0};
    parts.places = parts.records + whole_lines(records * stream->record);
    parts.cursor = parts.places + whole_lines((records + REDCC_RECORDS_AHEAD) * sizeof(redcc_u16));
    parts.next = parts.cursor + whole_lines(window.bins * sizeof(redcc_u32));
    parts.mark = parts.next + whole_lines(blocks * sizeof(uint32_t));
    parts.lines = parts.mark + whole_lines((size_t)PIECE_MARKS * window.bins * sizeof(uint32_t));
    parts.bytes = parts.lines;
    if (window.combined)
        parts.bytes += (size_t)window.bins * REDCC_COMBINED_BYTES(stream->record);
    return parts;
}

size_t redcc_buffer_bytes(const redcc_stream *stream, struct window window, uint32_t blocks) {
    return parts_of(stream, window, blocks).bytes;
}

/* ---- lifetime -------------------------------------------------------------------------------- */

static void *part(const struct redcc_bin_buffer *buffer, size_t offset) {
    return buffer->memory + offset;
}

/* Ensures that the buffer has memory for `bytes` bytes. Keeps its present memory if that is large
 * enough. */
static bool provide(struct redcc_bin_buffer *buffer, size_t bytes) {
    if (buffer->memory && redcc_memory_size(buffer->memory) >= bytes + LINE)
        return true;
    redcc_buffer_end(buffer); /* frees it first, because the memory limit may not permit both */
    buffer->memory = redcc_memory_alloc(bytes);
    return buffer->memory != NULL;
}

static void place_rows(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                       struct window window) {
    buffer->stream = stream;
    buffer->bins = window.bins;
    buffer->push = (redcc_bins){.first = window.first,
                                .span = window.rows,
                                .shift = window.shift,
                                .buffer = buffer,
                                .readable_page = &buffer->readable_page};
}

bool redcc_buffer_shape(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                        struct window window, uint32_t blocks) {
    assert(blocks > window.bins);
    const struct parts parts = parts_of(stream, window, blocks);
    if (!provide(buffer, parts.bytes))
        return false;
    place_rows(buffer, stream, window);
    buffer->blocks = blocks;
    buffer->push.records = part(buffer, parts.records);
    buffer->push.places = part(buffer, parts.places);
    buffer->push.cursor = part(buffer, parts.cursor);
    buffer->next = part(buffer, parts.next);
    buffer->mark = part(buffer, parts.mark);
    buffer->push.lines = window.combined ? part(buffer, parts.lines) : NULL;
    return true;
}

bool redcc_buffer_shape_copies(struct redcc_bin_buffer *buffer, const redcc_stream *stream,
                               struct window window) {
    assert(window.rows > 0);
    size_t bytes = 0;
    for (uint32_t array = 0; array < stream->array_count; array++)
        bytes += whole_lines(window.rows * stream->rows[array]);
    if (!provide(buffer, bytes))
        return false;
    place_rows(buffer, stream, window);
    buffer->blocks = 0;
    bytes = 0;
    for (uint32_t array = 0; array < stream->array_count; array++) {
        buffer->push.copy[array] = part(buffer, bytes);
        bytes += whole_lines(window.rows * stream->rows[array]);
    }
    return true;
}

void redcc_buffer_end(struct redcc_bin_buffer *buffer) {
    redcc_memory_free(buffer->memory);
    buffer->memory = NULL;
    buffer->blocks = 0;
}

static void forget_outside(struct redcc_bin_buffer *buffer) {
    buffer->exhausted = false;
    buffer->outside = redcc_no_rows;
    buffer->outside_count = 0;
    buffer->reached = redcc_no_rows;
    /* the program may have unmapped it since the last round */
    buffer->readable_page = REDCC_NO_PAGE;
}

void redcc_buffer_clear(struct redcc_bin_buffer *buffer) {
    forget_outside(buffer);
    buffer->used = buffer->bins;
    for (uint32_t bin = 0; buffer->blocks > 0 && bin < buffer->bins; bin++)
        buffer->push.cursor[bin] = bin * BLOCK + redcc_bin_offset(bin);
}

void redcc_buffer_measure(struct redcc_bin_buffer *buffer, const redcc_stream *stream) {
    forget_outside(buffer);
    place_rows(buffer, stream, (struct window){0});
}

/* ---- pushing --------------------------------------------------------------------------------- */

void redcc_push_outside(struct redcc_bin_buffer *buffer, redcc_int row) {
    assert(buffer->outside_count >= 0);
    buffer->outside = redcc_rows_union(buffer->outside, (struct row_range){row, row});
    buffer->outside_count++;
}

void redcc_push_span(const redcc_bins *bins, const redcc_stream *stream, redcc_int low,
                     redcc_int count, const void *record) {
    const redcc_int high = (redcc_int)((redcc_size)low + (redcc_size)count - 1);
    struct redcc_bin_buffer *buffer = bins->buffer;
    assert(count > 0);
    if (low == REDCC_NO_ROW || (redcc_size)low - (redcc_size)bins->first >= bins->span ||
        (redcc_size)high - (redcc_size)bins->first >= bins->span) {
        redcc_push_outside(buffer, low);
        redcc_push_outside(buffer, low == REDCC_NO_ROW ? low : high);
        return;
    }
    buffer->reached = redcc_rows_union(buffer->reached, (struct row_range){low, high});
    for (redcc_int row = low; row <= high;) {
        const redcc_int bin = (row - bins->first) >> bins->shift;
        redcc_push(bins, stream, row, 0, record);
        row = bins->first + ((bin + 1) << bins->shift);
    }
}

int redcc_is_readable(redcc_size *page, const void *address) {
    void *pointer;
    if (!redcc_load(&pointer, address, sizeof pointer))
        return 0;
    *page = (redcc_size)address / REDCC_PAGE;
    return 1;
}

/* If there is no free block, the bin's last block is overwritten, and the round fails. */
redcc_u32 redcc_push_block(struct redcc_bin_buffer *buffer, redcc_size bin, redcc_u32 record) {
    (void)bin;
    const uint32_t block = (record - 1) / BLOCK;
    assert(record > 0 && record % BLOCK == 0 && block < buffer->used);
    if (buffer->used == buffer->blocks) {
        buffer->exhausted = true;
        return block * BLOCK;
    }
    buffer->next[block] = buffer->used;
    return buffer->used++ * BLOCK;
}

static redcc_int count_records(const struct redcc_bin_buffer *buffer) {
    redcc_int count = (redcc_int)(buffer->used - buffer->bins) * BLOCK;
    for (uint32_t bin = 0; bin < buffer->bins; bin++)
        count += (redcc_int)(buffer->push.cursor[bin] % BLOCK) - (redcc_int)redcc_bin_offset(bin);
    return count;
}

void redcc_buffer_mark(struct redcc_bin_buffer *buffer, int piece) {
    if (buffer->blocks == 0)
        return;
    assert(piece >= 0 && buffer->used <= buffer->blocks);
    memcpy(buffer->mark + (size_t)piece * buffer->bins, buffer->push.cursor,
           buffer->bins * sizeof *buffer->mark);
    buffer->marked[piece] = count_records(buffer);
}

bool redcc_buffer_has_room(const struct redcc_bin_buffer *buffer, double records) {
    assert(records >= 0 && buffer->used <= buffer->blocks);
    const double block = BLOCK;
    return buffer->blocks - buffer->used >= 2 * records / block + 2;
}

/* Writes the records of a write-combining buffer `line` that is not full yet to memory. `end` is
 * the number after the bin's last record. */
static void write_rest(char *to, const char *line, uint32_t end, uint32_t per_line, size_t bytes) {
    const uint32_t begun = end % per_line;
    memcpy(to + (size_t)(end - begun) * bytes, line, begun * bytes);
}

void redcc_buffer_finish(struct redcc_bin_buffer *buffer) {
    if (!buffer->push.lines)
        return;
    const uint32_t record = buffer->stream->record;
    for (uint32_t bin = 0; bin < buffer->bins; bin++) {
        const char *line = buffer->push.lines + (size_t)bin * REDCC_COMBINED_BYTES(record);
        const uint32_t end = buffer->push.cursor[bin];
        if (record)
            write_rest(buffer->push.records, line, end, REDCC_LINE_RECORDS(record), record);
        write_rest((char *)buffer->push.places, line + REDCC_LINES_BYTES(record), end,
                   REDCC_LINE_PLACES, sizeof(redcc_u16));
    }
#if defined(__x86_64__) && defined(__SSE2__)
    __asm__ volatile("sfence"
                     :
                     :
                     : "memory"); /* the lines were written past the caches (non-temporal stores) */
#endif
}

/* ---- pushed records -------------------------------------------------------------------------- */

bool redcc_bin_is_used(const struct redcc_bin_buffer *buffer, uint32_t bin) {
    assert(bin < buffer->bins);
    return buffer->push.cursor[bin] != bin * BLOCK + redcc_bin_offset(bin);
}

struct stretch redcc_bin_all(const struct redcc_bin_buffer *buffer, uint32_t bin) {
    assert(bin < buffer->bins);
    return (struct stretch){bin * BLOCK + redcc_bin_offset(bin), buffer->push.cursor[bin]};
}

struct stretch redcc_bin_pieces(const struct redcc_bin_buffer *buffer, uint32_t bin, int first,
                                int end) {
    assert(bin < buffer->bins && 0 <= first && first <= end);
    return (struct stretch){buffer->mark[(size_t)first * buffer->bins + bin],
                            buffer->mark[(size_t)end * buffer->bins + bin]};
}

bool redcc_bin_records(const struct redcc_bin_buffer *buffer, struct stretch *left,
                       struct records *records) {
    const size_t first = left->begin;
    if (left->begin == left->end)
        return false;
    const uint32_t block = left->begin / BLOCK;
    const bool is_last = block == left->end / BLOCK;
    records->place = buffer->push.places + first;
    records->record = buffer->push.records + first * buffer->stream->record;
    records->count = (is_last ? left->end : (block + 1) * BLOCK) - left->begin;
    left->begin = is_last ? left->end : buffer->next[block] * BLOCK;
    return true;
}
