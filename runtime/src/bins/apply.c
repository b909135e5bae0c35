/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Applies records to the arrays, or merges private copies into them. */
#include "bins/binning.h"

#include "base/share.h"
#include "plan/elements.h"
#include "plan/share_count.h"

#include <assert.h>
#include <string.h>

/* Applies records of doubles to rows of floats, for updates that were computed in double. */
static void apply_wide(const redcc_applied *applied, redcc_operator operation, size_t count) {
    float *const rows = applied->rows[0];
    const double *const records = applied->records;
    for (size_t k = 0; k < applied->count; k++)
        for (size_t i = 0; i < count; i++) {
            float *const to = &rows[applied->place[k] * count + i];
            const double x = records[k * count + i];
            *to = (float)(operation == REDCC_PRODUCT ? *to * x : *to + x);
        }
}

/* Can a function of the library apply the stream's records, so that the loop needs no apply
 * function? Sets *wide if the records are doubles and the rows are floats. */
static bool is_plain(const redcc_array *array, const redcc_stream *stream, bool *wide) {
    const struct element_rule *rule =
        redcc_element_rule((redcc_operator)array->operation, (redcc_type)array->type);
    if (!rule || !rule->apply || stream->array_count != 1 || stream->tag_bits != 0 ||
        stream->rows[0] % rule->size != 0)
        return false;
    *wide = array->type == REDCC_FLOAT && stream->record == 2 * stream->rows[0] &&
            (array->operation == REDCC_SUM || array->operation == REDCC_PRODUCT);
    return *wide || stream->record == stream->rows[0];
}

bool redcc_bins_can_apply(const redcc_binned *loop) {
    bool wide;
    for (uint32_t s = 0; s < loop->stream_count; s++)
        if (!loop->streams[s].apply &&
            !is_plain(&loop->loop.arrays[loop->streams[s].arrays[0]], &loop->streams[s], &wide))
            return false;
    return true;
}

static void apply_records(const redcc_binned *loop, const redcc_stream *stream,
                          const redcc_applied *applied) {
    const redcc_array *array = &loop->loop.arrays[stream->arrays[0]];
    bool wide = false;
    if (stream->apply) {
        stream->apply(applied);
        return;
    }
    const bool plain = is_plain(array, stream, &wide);
    assert(plain);
    (void)plain;
    if (wide)
        apply_wide(applied, (redcc_operator)array->operation, stream->rows[0] / sizeof(float));
    else
        redcc_element_rule((redcc_operator)array->operation, (redcc_type)array->type)
            ->apply(applied, stream->rows[0] / array->element);
}

/* Applies all records of one bin, in the order of the loop. */
static void apply_bin(const struct binning *binning, uint32_t s, uint32_t bin,
                      const void *operands) {
    const redcc_stream *stream = &binning->loop->streams[s];
    const struct window window = binning->stream[s].window;
    const redcc_int first = window.first + ((redcc_int)bin << window.shift);
    void *rows[REDCC_STREAM_ARRAYS];
    for (uint32_t array = 0; array < stream->array_count; array++)
        rows[array] = (void *)redcc_row_address(binning, stream, array, first);
    for (struct piece_run run = {0}; redcc_pieces_next_run(binning, &run);) {
        const struct redcc_bin_buffer *buffer = &binning->binner[run.thread]->buffer[s];
        struct records records;
        for (struct stretch left = redcc_bin_pieces(buffer, bin, run.first, run.end);
             redcc_bin_records(buffer, &left, &records);) {
            const redcc_applied applied = {.rows = rows,
                                           .place = records.place,
                                           .records = records.record,
                                           .count = records.count,
                                           .ahead = REDCC_RECORDS_AHEAD,
                                           .operands = operands,
                                           .row_count = (redcc_size)1 << window.shift};
            apply_records(binning->loop, stream, &applied);
        }
    }
}

/* Dynamic scheduling: a thread that has finished a bin takes the next bin, of any stream. */
void redcc_bins_apply(struct binning *binning, const struct binner *binner, const void *operands) {
    (void)binner;
    uint32_t s = 0, before = 0; /* number of bins of the streams before s */
    for (;;) {
        const uint32_t next =
            atomic_fetch_add_explicit(&binning->next_bin, 1, memory_order_relaxed);
        while (s < binning->loop->stream_count && next - before >= binning->stream[s].window.bins)
            before += binning->stream[s++].window.bins;
        if (s == binning->loop->stream_count)
            return;
        apply_bin(binning, s, next - before, operands);
    }
}

/* ---- private copies -------------------------------------------------------------------------- */

static const struct element_rule *rule_of(const struct binning *binning, uint32_t array) {
    const redcc_array *it = &binning->loop->loop.arrays[array];
    const redcc_u32 last = redcc_in_shares(binning->call) ? REDCC_DOUBLE : REDCC_UINT64;
    return it->type <= last
               ? redcc_element_rule((redcc_operator)it->operation, (redcc_type)it->type)
               : NULL;
}

bool redcc_private_possible(const struct binning *binning, const redcc_stream *stream) {
    assert(stream->array_count > 0);
    const bool is_span = stream->exact == REDCC_STREAM_SPANS;
    if (is_span || (!stream->exact && !redcc_in_shares(binning->call)))
        return false;
    for (uint32_t a = 0; a < stream->array_count; a++) {
        const struct element_rule *rule = rule_of(binning, stream->arrays[a]);
        if (!rule || stream->rows[a] % rule->size != 0 ||
            (uintptr_t)binning->call->request.bases[stream->arrays[a]] % rule->size != 0)
            return false;
    }
    return true;
}

void redcc_private_fill(const struct binning *binning, const struct binner *binner) {
    for (uint32_t s = 0; s < binning->loop->stream_count; s++) {
        const redcc_stream *stream = &binning->loop->streams[s];
        for (uint32_t a = 0; a < stream->array_count; a++) {
            const struct element_rule *rule = rule_of(binning, stream->arrays[a]);
            const size_t bytes = binning->stream[s].window.rows * stream->rows[a];
            assert(rule && bytes % rule->size == 0); /* redcc_private_possible ensures this */
            rule->fill(binner->buffer[s].push.copy[a], bytes / rule->size);
        }
    }
}

/* The range of rows, of an array of the stream, in which one copy is no longer neutral:
 * from the first to the last changed row. */
static struct row_range changed_rows(const struct binning *binning, uint32_t s, uint32_t a,
                                     const char *copy) {
    const redcc_stream *stream = &binning->loop->streams[s];
    const struct element_rule *rule = rule_of(binning, stream->arrays[a]);
    const struct window window = binning->stream[s].window;
    const uint64_t row = stream->rows[a], size = rule->size;
    uint64_t neutral = 0; /* large enough for the largest type that is copied */
    rule->fill(&neutral, 1);
    uint64_t first = 0, end = window.rows * row;
    while (first < end && memcmp(copy + first, &neutral, size) == 0)
        first += size;
    while (first < end && memcmp(copy + end - size, &neutral, size) == 0)
        end -= size;
    if (first == end)
        return redcc_no_rows;
    return (struct row_range){window.first + (redcc_int)(first / row),
                              window.first + (redcc_int)((end - 1) / row)};
}

struct row_range redcc_private_rows(const struct binning *binning, uint32_t s) {
    assert(s < binning->loop->stream_count);
    struct row_range rows = redcc_no_rows;
    for (uint32_t a = 0; a < binning->loop->streams[s].array_count; a++)
        for (int t = 0; t < binning->copies.count; t++)
            rows = redcc_rows_union(
                rows, changed_rows(binning, s, a, binning->binner[t]->buffer[s].push.copy[a]));
    return rows;
}

/* Merges `count` elements, from byte `first` of each copy on, into array number `a` of the stream.
 */
static void merge_elements(const struct binning *binning, uint32_t s, uint32_t a, void *to,
                           size_t first, size_t count) {
    const uint32_t array = binning->loop->streams[s].arrays[a];
    const struct element_rule *rule = rule_of(binning, array);
    const redcc_word limit = binning->loop->loop.arrays[array].limit;
    void *from[REDCC_MOST_SHARES];
    for (int c = 0; c < binning->copies.count; c++) {
        char *copy = binning->binner[c]->buffer[s].push.copy[a] + first;
        if (redcc_in_shares(binning->call))
            from[c] = copy;
        else
            rule->merge(to, copy, count, limit);
    }
    if (redcc_in_shares(binning->call))
        rule->drain(to, from, (size_t)binning->copies.count, count, limit);
}

/* Merges this thread's share of the changed rows of all copies, one copy after the other. Only
 * changed rows are merged, because other rows of the window may lie beyond the array's ends. */
static void merge_stream(const struct binning *binning, const struct binner *binner, uint32_t s) {
    const redcc_stream *stream = &binning->loop->streams[s];
    const struct row_range changed = binning->stream[s].changed;
    if (redcc_rows_empty(changed))
        return;
    const redcc_int base = binning->stream[s].window.first;
    const redcc_int from = changed.lowest - base, rows = changed.highest - changed.lowest + 1;
    const redcc_int first = from + redcc_share(rows, binner->threads, binner->thread);
    const redcc_int end = from + redcc_share(rows, binner->threads, binner->thread + 1);
    for (uint32_t a = 0; a < stream->array_count; a++) {
        const size_t row = stream->rows[a];
        merge_elements(binning, s, a, (void *)redcc_row_address(binning, stream, a, base + first),
                       (size_t)first * row,
                       (size_t)(end - first) * row / rule_of(binning, stream->arrays[a])->size);
    }
}

void redcc_private_merge(const struct binning *binning, const struct binner *binner) {
    for (uint32_t s = 0; s < binning->loop->stream_count; s++)
        merge_stream(binning, binner, s);
}
