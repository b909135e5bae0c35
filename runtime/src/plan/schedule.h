/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What one thread executes: chunks in order, each of runs of consecutive iterations. Before the
 * first chunk of a stage, all threads of the team have finished the stages before it.
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
    uint32_t copy;       /* COPY_SHARE: the copy that it writes to */
    uint32_t wait_begin; /* before it: until flags wait[wait_begin] ... wait[wait_end - 1] are up */
    uint32_t wait_end;
    uint32_t flag; /* after it: this flag goes up, counted from 1; 0: none */
};

/** All zero is an empty one. */
struct schedule {
    struct chunk *chunk;
    size_t chunk_count;
    size_t chunk_capacity;
    redcc_iterations *run;
    size_t run_count;
    size_t run_capacity;
    uint16_t *packed; /* the runs instead; NULL: they are not packed */
    uint32_t *wait;   /* flags, counted from 0 */
    uint32_t wait_count;
    uint32_t wait_capacity;
    uint32_t waited;      /* those of `wait` that chunks have already */
    uint32_t copy;        /* of the chunks that follow */
    bool apart;           /* what follows begins a new chunk */
    redcc_int iterations; /* executed, guarded ones included */
};

/** The largest count of a run, and how far its begin may lie from the chunk's origin. */
enum { REDCC_RUN_MOST = 1 << 30 };

/** Appends iterations [begin, begin + count), count >= 0, in `stage` (not below the last one's);
 *  what continues the last run lengthens it. False: no memory. */
bool redcc_schedule_add(struct schedule *schedule, uint32_t stage, redcc_int begin, redcc_int count,
                        bool guarded);

/** Appends all that `other` has, in stage `stage`. False: no memory. */
bool redcc_schedule_append(struct schedule *schedule, const struct schedule *other, uint32_t stage);

/** What follows is a task: its first chunk begins when the flags wait [count] are up. False: no
 *  memory. */
bool redcc_schedule_begin_task(struct schedule *schedule, const uint32_t *wait, uint32_t count);

/** The task, which has at least one iteration, is at its end: `flag` goes up. */
void redcc_schedule_end_task(struct schedule *schedule, uint32_t flag);

/** What follows is written to copy number `copy`. */
void redcc_schedule_into_copy(struct schedule *schedule, uint32_t copy);

/** Nothing more will be added: gives back what is not used, and packs the runs where that takes
 * less and there is memory to do it. */
void redcc_schedule_finish(struct schedule *schedule);

/** Packs the runs where that takes less, there are many, and there is memory to do it. */
void redcc_runs_pack(struct schedule *schedule);

/** Where a reader of a chunk's runs stands. All zero: at the end. */
struct run_reader {
    const redcc_iterations *run;
    const redcc_iterations *run_end;
    const uint16_t *word; /* packed */
    const uint16_t *word_end;
    redcc_u32 at;          /* where the run before ends */
    redcc_iterations rest; /* of a run that was read in part */
};

/** To the first run of a chunk of the schedule. */
struct run_reader redcc_runs_of(const struct schedule *schedule, const struct chunk *chunk);

/** The next runs, `room` >= 1 at most, into `to`; returns how many: 0 at the end. */
size_t redcc_runs_read(struct run_reader *reader, redcc_iterations *to, size_t room);

/** As redcc_runs_read, runs of *iterations > 0 in all at most; takes from it what they have. */
size_t redcc_runs_read_part(struct run_reader *reader, redcc_iterations *to, size_t room,
                            redcc_int *iterations);

/** Gives back its memory. */
void redcc_schedule_end(struct schedule *schedule);

#endif
