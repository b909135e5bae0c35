/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/schedule.h"

#include "base/memory.h"

#include <assert.h>

static bool room_for_chunk(struct schedule *schedule) {
    if (schedule->chunk_count < schedule->chunk_capacity)
        return true;
    const size_t more = schedule->chunk_capacity ? schedule->chunk_capacity * 2 : 4;
    struct chunk *chunk = redcc_memory_resize(schedule->chunk, more * sizeof *chunk);
    if (!chunk)
        return false;
    schedule->chunk = chunk;
    schedule->chunk_capacity = more;
    return true;
}

static bool room_for_run(struct schedule *schedule) {
    if (schedule->run_count < schedule->run_capacity)
        return true;
    const size_t more = schedule->run_capacity ? schedule->run_capacity * 2 : 64;
    redcc_iterations *run = redcc_memory_resize(schedule->run, more * sizeof *run);
    if (!run)
        return false;
    schedule->run = run;
    schedule->run_capacity = more;
    return true;
}

/* Extends the last run by as many of the iterations from `begin` to before `begin` + `count` as it
 * can hold; by none if they do not continue it. Returns the number of these iterations. */
static redcc_int lengthen(struct schedule *schedule, const struct chunk *chunk, redcc_int begin,
                          redcc_int count, bool checked) {
    redcc_iterations *run = &schedule->run[schedule->run_count - 1];
    const redcc_int length = run->count_and_check / 2;
    if (chunk->run_begin == chunk->run_end || (run->count_and_check & 1) != checked ||
        chunk->origin + run->begin + length != begin)
        return 0;
    const redcc_int room = REDCC_RUN_MOST - length;
    const redcc_int more = count < room ? count : room;
    run->count_and_check += 2 * (redcc_u32)more;
    return more;
}

static bool add_piece(struct schedule *schedule, uint32_t stage, redcc_int begin, redcc_int count,
                      bool checked) {
    const struct chunk *last =
        schedule->chunk_count ? &schedule->chunk[schedule->chunk_count - 1] : NULL;
    if (!last || last->stage != stage || schedule->new_chunk || begin < last->origin ||
        begin - last->origin > REDCC_RUN_MOST) {
        if (!room_for_chunk(schedule))
            return false;
        schedule->chunk[schedule->chunk_count++] = (struct chunk){.origin = begin,
                                                                  .run_begin = schedule->run_count,
                                                                  .run_end = schedule->run_count,
                                                                  .stage = stage,
                                                                  .copy = schedule->copy,
                                                                  .wait_begin = schedule->waited,
                                                                  .wait_end = schedule->wait_count};
        schedule->waited = schedule->wait_count;
        schedule->new_chunk = false;
    }
    if (!room_for_run(schedule))
        return false;
    struct chunk *chunk = &schedule->chunk[schedule->chunk_count - 1];
    schedule->run[schedule->run_count++] =
        (redcc_iterations){(redcc_u32)(begin - chunk->origin), 2 * (redcc_u32)count + checked};
    chunk->run_end = schedule->run_count;
    return true;
}

bool redcc_schedule_add(struct schedule *schedule, uint32_t stage, redcc_int begin, redcc_int count,
                        bool checked) {
    assert(begin >= 0 && count >= 0);
    assert(!schedule->packed);
    assert(schedule->chunk_count == 0 || stage >= schedule->chunk[schedule->chunk_count - 1].stage);
    schedule->iterations += count;
    if (schedule->chunk_count) {
        const struct chunk *last = &schedule->chunk[schedule->chunk_count - 1];
        if (last->stage == stage && !schedule->new_chunk) {
            const redcc_int taken = lengthen(schedule, last, begin, count, checked);
            begin += taken;
            count -= taken;
        }
    }
    while (count > 0) {
        const redcc_int piece = count < REDCC_RUN_MOST ? count : REDCC_RUN_MOST;
        if (!add_piece(schedule, stage, begin, piece, checked))
            return false;
        begin += piece;
        count -= piece;
    }
    return true;
}

bool redcc_schedule_append(struct schedule *schedule, const struct schedule *other,
                           uint32_t stage) {
    assert(!other->packed);
    for (size_t c = 0; c < other->chunk_count; c++) {
        const struct chunk *chunk = &other->chunk[c];
        for (size_t r = chunk->run_begin; r < chunk->run_end; r++) {
            const redcc_iterations run = other->run[r];
            if (!redcc_schedule_add(schedule, stage, chunk->origin + run.begin,
                                    run.count_and_check / 2, run.count_and_check & 1))
                return false;
        }
    }
    return true;
}

bool redcc_schedule_begin_task(struct schedule *schedule, const uint32_t *wait, uint32_t count) {
    assert(wait || count == 0);
    if (schedule->wait_capacity - schedule->wait_count < count) {
        const uint32_t more = 2 * schedule->wait_capacity + count + 64;
        uint32_t *longer = redcc_memory_resize(schedule->wait, more * sizeof *longer);
        if (!longer)
            return false;
        schedule->wait = longer;
        schedule->wait_capacity = more;
    }
    for (uint32_t w = 0; w < count; w++)
        schedule->wait[schedule->wait_count++] = wait[w];
    schedule->new_chunk = true;
    return true;
}

void redcc_schedule_end_task(struct schedule *schedule, uint32_t flag) {
    assert(schedule->chunk_count > 0);
    assert(schedule->chunk[schedule->chunk_count - 1].flag == 0);
    schedule->chunk[schedule->chunk_count - 1].flag = flag + 1;
    schedule->new_chunk = true;
}

void redcc_schedule_into_copy(struct schedule *schedule, uint32_t copy) {
    schedule->copy = copy;
    schedule->new_chunk = true;
}

void redcc_schedule_finish(struct schedule *schedule) {
    assert(schedule->run_count <= schedule->run_capacity &&
           schedule->waited <= schedule->wait_count);
    redcc_runs_pack(schedule);
    if (schedule->run_capacity - schedule->run_count >= 64 && !schedule->packed) {
        const size_t count = schedule->run_count;
        redcc_iterations *run = redcc_memory_resize(schedule->run, count * sizeof *run);
        schedule->run = run ? run : schedule->run;
        schedule->run_capacity = run ? count : schedule->run_capacity;
    }
    if (schedule->chunk_capacity - schedule->chunk_count >= 64) {
        const size_t count = schedule->chunk_count;
        struct chunk *chunk = redcc_memory_resize(schedule->chunk, count * sizeof *chunk);
        schedule->chunk = chunk ? chunk : schedule->chunk;
        schedule->chunk_capacity = chunk ? count : schedule->chunk_capacity;
    }
}

void redcc_schedule_end(struct schedule *schedule) {
    redcc_memory_free(schedule->chunk);
    redcc_memory_free(schedule->run);
    redcc_memory_free(schedule->packed);
    redcc_memory_free(schedule->wait);
    *schedule = (struct schedule){0};
}
