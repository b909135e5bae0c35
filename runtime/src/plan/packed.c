/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Packs and reads the runs of a schedule. */
#include "plan/schedule.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

/* A packed run is a word of 16 bits,
 *
 *     gap << 6 | count_and_check      gap < 2^10, 2 <= count_and_check < 2^6
 *
 * where gap is the number of iterations between the preceding run (or the chunk's origin) and this
 * one. A run that does not fit is stored as a word 0, followed by gap and count_and_check in two
 * words each, the lower word first. Gaps are modulo 2^32, because the next run of a chunk may begin
 * at an earlier iteration (dwa_lip.c). */
enum { GAP_SHIFT = 6, GAPS = 1 << 10, COUNTS = 1 << GAP_SHIFT, LONG_RUN = 5, PACK_LEAST = 256 };

static bool is_short(redcc_u32 gap, redcc_iterations run) {
    return gap < GAPS && run.count_and_check < COUNTS;
}

/* Packs the chunk's runs at `to`; if `to` is NULL, packs nothing. Returns the number of words that
 * the packed runs need. */
static size_t pack_chunk(const struct schedule *schedule, const struct chunk *chunk, uint16_t *to) {
    size_t words = 0;
    redcc_u32 at = 0;
    for (size_t r = chunk->run_begin; r < chunk->run_end; r++) {
        const redcc_iterations run = schedule->run[r];
        const redcc_u32 gap = run.begin - at;
        const bool brief = is_short(gap, run);
        at = run.begin + run.count_and_check / 2;
        if (to && brief) {
            to[words] = (uint16_t)(gap << GAP_SHIFT | run.count_and_check);
        } else if (to) {
            const uint16_t longer[LONG_RUN] = {0, (uint16_t)gap, (uint16_t)(gap >> 16),
                                               (uint16_t)run.count_and_check,
                                               (uint16_t)(run.count_and_check >> 16)};
            memcpy(to + words, longer, sizeof longer);
        }
        words += brief ? 1 : LONG_RUN;
    }
    return words;
}

void redcc_runs_pack(struct schedule *schedule) {
    assert(!schedule->packed);
    size_t words = 0, at = 0;
    if (schedule->run_count < PACK_LEAST)
        return;
    for (size_t c = 0; c < schedule->chunk_count; c++)
        words += pack_chunk(schedule, &schedule->chunk[c], NULL);
    if (words * sizeof *schedule->packed > schedule->run_count * sizeof *schedule->run / 2)
        return;
    uint16_t *packed = redcc_memory_alloc(words * sizeof *packed);
    if (!packed)
        return;
    for (size_t c = 0; c < schedule->chunk_count; c++) {
        struct chunk *chunk = &schedule->chunk[c];
        const size_t more = pack_chunk(schedule, chunk, packed + at);
        chunk->run_begin = at;
        chunk->run_end = at += more;
    }
    redcc_memory_free(schedule->run);
    schedule->run = NULL;
    schedule->run_capacity = 0;
    schedule->packed = packed;
}

struct run_reader redcc_runs_of(const struct schedule *schedule, const struct chunk *chunk) {
    assert(chunk->run_begin <= chunk->run_end);
    if (schedule->packed)
        return (struct run_reader){.word = schedule->packed + chunk->run_begin,
                                   .word_end = schedule->packed + chunk->run_end};
    return (struct run_reader){.run = schedule->run + chunk->run_begin,
                               .run_end = schedule->run + chunk->run_end};
}

static size_t copy_runs(struct run_reader *reader, redcc_iterations *to, size_t room) {
    const size_t left = (size_t)(reader->run_end - reader->run);
    const size_t count = left < room ? left : room;
    if (count == 0)
        return 0;
    memcpy(to, reader->run, count * sizeof *to);
    reader->run += count;
    return count;
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector) && __has_builtin(__builtin_convertvector)
#define BY_FOUR 1
#endif
#endif

#ifdef BY_FOUR
/* Are these four words four short runs? True if none of them is the 0 that begins a longer run. */
static bool all_are_short(const uint16_t *word) {
    const uint64_t each = 0x0001000100010001u;
    uint64_t counts;
    memcpy(&counts, word, sizeof counts);
    counts &= each * (COUNTS - 1);
    /* the highest bits are set only if some count is 0 */
    return ((counts - each) & each << 15) == 0;
}

typedef uint16_t four_words __attribute__((vector_size(8)));
typedef uint32_t four __attribute__((vector_size(16)));

/* Reads four runs of one word each. All four elements of `at` are the iteration to which the first
 * gap is relative. Returns the iteration to which the next gap is relative, in the same form. */
static four read_four(const uint16_t *word, redcc_iterations *to, four at) {
    const four none = {0, 0, 0, 0};
    four_words words;
    memcpy(&words, word, sizeof words);
    const four both = __builtin_convertvector(words, four) & (COUNTS - 1);
    const four gap = __builtin_convertvector(words, four) >> GAP_SHIFT;
    const four step = gap + (both >> 1);
    four sum = step + __builtin_shufflevector(none, step, 0, 4, 5, 6);
    sum += __builtin_shufflevector(none, sum, 0, 1, 4, 5);
    const four begin = at + sum - step + gap;
    const four low = __builtin_shufflevector(begin, both, 0, 4, 1, 5);
    const four high = __builtin_shufflevector(begin, both, 2, 6, 3, 7);
    memcpy(to, &low, sizeof low);
    memcpy(to + 2, &high, sizeof high);
    return at + __builtin_shufflevector(sum, sum, 3, 3, 3, 3);
}

/* Reads as many groups of four one-word runs as possible, at most `room` runs in total. Returns the
 * number of runs. */
static size_t read_short(struct run_reader *reader, redcc_iterations *to, size_t room) {
    const uint16_t *word = reader->word;
    four at = {reader->at, reader->at, reader->at, reader->at};
    size_t count = 0;
    for (; room - count >= 4 && reader->word_end - word >= 4 && all_are_short(word); word += 4) {
        at = read_four(word, to + count, at);
        count += 4;
    }
    reader->word = word;
    reader->at = at[0];
    return count;
}
#else
static size_t read_short(const struct run_reader *reader, const redcc_iterations *to, size_t room) {
    (void)reader;
    (void)to;
    (void)room;
    return 0;
}
#endif

/* Reads a run of one word or of five. */
static redcc_iterations read_run(struct run_reader *reader) {
    const uint16_t *word = reader->word;
    const bool brief = *word & (COUNTS - 1);
    const redcc_u32 gap =
        brief ? (redcc_u32)*word >> GAP_SHIFT : word[1] | (redcc_u32)word[2] << 16;
    const redcc_u32 both = brief ? *word & (COUNTS - 1) : word[3] | (redcc_u32)word[4] << 16;
    const redcc_iterations run = {reader->at + gap, both};
    reader->at = run.begin + both / 2;
    reader->word += brief ? 1 : LONG_RUN;
    return run;
}

size_t redcc_runs_read(struct run_reader *reader, redcc_iterations *to, size_t room) {
    assert(room >= 1);
    size_t count = 0;
    if (!reader->word)
        return copy_runs(reader, to, room);
    while (count < room && reader->word != reader->word_end) {
        count += read_short(reader, to + count, room - count);
        if (count < room && reader->word != reader->word_end)
            to[count++] = read_run(reader);
    }
    return count;
}

static redcc_u32 length_of(redcc_iterations run) {
    return run.count_and_check / 2;
}

/* Reads the next run, or returns the rest of a run that was split. False: there is no run left. */
static bool read_next(struct run_reader *reader, redcc_iterations *to) {
    *to = reader->rest;
    reader->rest = (redcc_iterations){0, 0};
    if (length_of(*to) > 0)
        return true;
    if (reader->word == reader->word_end && reader->run == reader->run_end)
        return false;
    *to = reader->word ? read_run(reader) : *reader->run++;
    return true;
}

/* Returns the run's first `count` iterations; the reader keeps the rest. */
static redcc_iterations split(struct run_reader *reader, redcc_iterations run, redcc_u32 count) {
    const redcc_u32 checked = run.count_and_check & 1;
    reader->rest = (redcc_iterations){run.begin + count, run.count_and_check - 2 * count};
    return (redcc_iterations){run.begin, 2 * count + checked};
}

size_t redcc_runs_read_part(struct run_reader *reader, redcc_iterations *to, size_t room,
                            redcc_int *iterations) {
    assert(room >= 1 && *iterations > 0);
    size_t count = 0;
    redcc_iterations run;
    while (count<room && * iterations> 0 && read_next(reader, &run)) {
        if ((redcc_int)length_of(run) > *iterations)
            run = split(reader, run, (redcc_u32)*iterations);
        *iterations -= (redcc_int)length_of(run);
        to[count++] = run;
    }
    return count;
}
