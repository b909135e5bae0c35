/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A thread's schedule: chunks in order, each consisting of runs of consecutive iterations. Before
 * the first chunk of a stage, all threads of the team have finished the stages before it.
 */
#ifndef REDCC_SCHEDULE_H
#define REDCC_SCHEDULE_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Runs run[run_begin] ... run[run_end - 1], relative to `origin`; once they are packed, those in
 *  packed[run_begin] ... packed[run_end - 1]. */
struct chunk {
    redcc_int origin;
    size_t run_begin;
    size_t run_end;
    uint32_t stage;
    uint32_t copy;       /* COPY_SHARE, COPY_LATER: the share, which determines the copy */
    uint32_t wait_begin; /* before it: wait for flags wait[wait_begin] ... wait[wait_end - 1] */
    uint32_t wait_end;
    uint32_t flag; /* after it: raise this flag, counted from 1; 0: none */
};

/** Zero: an empty schedule. */
struct schedule {
    struct chunk *chunk;
    size_t chunk_count;
    size_t chunk_capacity;
    redcc_iterations *run;
    size_t run_count;
    size_t run_capacity;
    uint16_t *packed; /* the packed runs; NULL: they are not packed */
    uint32_t *wait;   /* flags, counted from 0 */
    uint32_t wait_count;
    uint32_t wait_capacity;
    uint32_t waited;      /* number of entries of `wait` already assigned to chunks */
    uint32_t copy;        /* chunk.copy of later chunks */
    bool new_chunk;       /* the next iterations begin a new chunk */
    redcc_int iterations; /* executed, including owner-checked ones */
};

/** The largest count of a run, and the largest distance of its beginning from the chunk's origin.
 */
enum { REDCC_RUN_MOST = 1 << 30 };

/** Appends iterations [begin, begin + count), count >= 0, in `stage` (not below the last one),
 *  extending the last run if they continue it. False: out of memory. */
bool redcc_schedule_add(struct schedule *schedule, uint32_t stage, redcc_int begin, redcc_int count,
                        bool checked);

/** Appends all runs of `other`, in stage `stage`. False: out of memory. */
bool redcc_schedule_append(struct schedule *schedule, const struct schedule *other, uint32_t stage);

/** Begins a task: its first chunk waits until the flags wait [count] are raised. False: out of
 *  memory. */
bool redcc_schedule_begin_task(struct schedule *schedule, const uint32_t *wait, uint32_t count);

/** Ends the task, which has at least one iteration: raises `flag`. */
void redcc_schedule_end_task(struct schedule *schedule, uint32_t flag);

/** Makes later iterations write to the copy of share number `copy`. */
void redcc_schedule_into_copy(struct schedule *schedule, uint32_t copy);

/** Called when the schedule is complete: frees unused memory, and packs the runs
 * (redcc_runs_pack). */
void redcc_schedule_finish(struct schedule *schedule);

/** Packs the runs if there are at least 256, if memory is available, and if they shrink to half or
 * less. */
void redcc_runs_pack(struct schedule *schedule);

/** The position of a reader in a chunk's runs. Zero: at the end. */
struct run_reader {
    const redcc_iterations *run;
    const redcc_iterations *run_end;
    const uint16_t *word; /* packed */
    const uint16_t *word_end;
    redcc_u32 at;          /* the end of the preceding run */
    redcc_iterations rest; /* the rest of a run that was read in part */
};

/** Begins at the first run of a chunk of the schedule. */
struct run_reader redcc_runs_of(const struct schedule *schedule, const struct chunk *chunk);

/** Reads the next runs, at most `room` >= 1, into `to`; returns their number: 0 at the end. */
size_t redcc_runs_read(struct run_reader *reader, redcc_iterations *to, size_t room);

/** As redcc_runs_read, with at most *iterations > 0 iterations in total; subtracts those that were
 *  read. */
size_t redcc_runs_read_part(struct run_reader *reader, redcc_iterations *to, size_t room,
                            redcc_int *iterations);

/** Frees its memory. */
void redcc_schedule_end(struct schedule *schedule);

#endif
