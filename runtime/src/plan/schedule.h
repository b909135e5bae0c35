/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A thread's schedule: a list of chunks, each of which consists of runs of consecutive iterations.
 * Before a thread begins a chunk of a later stage, all threads of its team have finished all
 * earlier stages.
 */
#ifndef REDCC_SCHEDULE_H
#define REDCC_SCHEDULE_H

#include "redcc/runtime.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** A chunk. Its runs are run[run_begin] to run[run_end - 1], relative to `origin`. Once runs are
 * packed, they are the words packed[run_begin] to packed[run_end - 1] instead. */
struct chunk {
    redcc_int origin;
    size_t run_begin;
    size_t run_end;
    uint32_t stage;
    uint32_t copy; /* with COPY_SHARE and COPY_LATER: the number of the share, which determines the
                      copy */
    uint32_t wait_begin; /* before it begins the chunk, the thread waits for the flags
                            wait[wait_begin] to wait[wait_end - 1] */
    uint32_t wait_end;
    uint32_t flag; /* after the chunk, the thread raises this flag, counted from 1; 0: none */
};

/** A schedule. If all fields are zero, it is empty. */
struct schedule {
    struct chunk *chunk;
    size_t chunk_count;
    size_t chunk_capacity;
    redcc_iterations *run;
    size_t run_count;
    size_t run_capacity;
    uint16_t *packed; /* the packed runs; NULL: they are not packed */
    uint32_t *wait;   /* the numbers of the flags that chunks wait for, counted from 0 */
    uint32_t wait_count;
    uint32_t wait_capacity;
    uint32_t waited;      /* number of entries of `wait` that are already assigned to chunks */
    uint32_t copy;        /* the value of `copy` for later chunks */
    bool new_chunk;       /* the next iterations begin a new chunk */
    redcc_int iterations; /* number of executed iterations, including owner-checked ones */
};

/** The largest number of iterations of a run, and the largest distance of a run's beginning from
 * the chunk's origin. */
enum { REDCC_RUN_MOST = 1 << 30 };

/** Appends the iterations from `begin` to before `begin` + `count` (count >= 0) to stage `stage`,
 * which must not be below that of the last chunk. Extends the last run if they continue it. Returns
 * false if out of memory. */
bool redcc_schedule_add(struct schedule *schedule, uint32_t stage, redcc_int begin, redcc_int count,
                        bool checked);

/** Appends all runs of `other`, in stage `stage`. False: out of memory. */
bool redcc_schedule_append(struct schedule *schedule, const struct schedule *other, uint32_t stage);

/** Begins a task. Its first chunk waits until the flags wait[count] are raised. Returns false if
 * out of memory. */
bool redcc_schedule_begin_task(struct schedule *schedule, const uint32_t *wait, uint32_t count);

/** Ends the task, which has at least one iteration: raises `flag`. */
void redcc_schedule_end_task(struct schedule *schedule, uint32_t flag);

/** Makes the iterations that are appended from now on write to the copy of share number `copy`. */
void redcc_schedule_into_copy(struct schedule *schedule, uint32_t copy);

/** Called when the schedule is complete. Frees unused memory, and packs the runs (redcc_runs_pack).
 */
void redcc_schedule_finish(struct schedule *schedule);

/** Packs the runs, if there are at least 256 of them, if memory is available, and if packing at
 * least halves their size. */
void redcc_runs_pack(struct schedule *schedule);

/** The position of a reader in a chunk's runs. If all fields are zero, it is at the end. */
struct run_reader {
    const redcc_iterations *run;
    const redcc_iterations *run_end;
    const uint16_t *word; /* the next word, if runs are packed */
    const uint16_t *word_end;
    redcc_u32 at;          /* the end of the preceding run */
    redcc_iterations rest; /* the rest of a run that was read in part */
};

/** Begins at the first run of a chunk of the schedule. */
struct run_reader redcc_runs_of(const struct schedule *schedule, const struct chunk *chunk);

/** Reads the next runs into `to`, at most `room` >= 1 of them. Returns the number of runs read; 0
 * if none is left. */
size_t redcc_runs_read(struct run_reader *reader, redcc_iterations *to, size_t room);

/** As redcc_runs_read, but reads runs with at most *iterations > 0 iterations in total. Subtracts
 * the number of iterations that it has read from *iterations. */
size_t redcc_runs_read_part(struct run_reader *reader, redcc_iterations *to, size_t room,
                            redcc_int *iterations);

/** Frees the schedule's memory. */
void redcc_schedule_end(struct schedule *schedule);

#endif
