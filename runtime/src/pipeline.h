/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The pipeline: what becomes of a call of a translated loop.
 *
 *     redcc_enter    struct call      settings in force, arguments, threads       call.c
 *                    struct advice    auto: serial, timed, or parallel            choose/advice.h
 *                    struct kept_plan one that may serve again                    reuse/kept.h
 *     -- the parallel region: every thread walks through the stages ----------------------------
 *     redcc_inspect  verify     are the subscripts what they were?    yes: run    reuse/kept.h
 *                    dry run    all iterations, in order, where stale values
 *                               would do harm                                     inspect/
 *                    sample     some iterations   -> struct partition (the cuts)
 *                    sweep      all iterations    -> struct summary, one a thread
 *                                                    and the overlap guard
 *                    log        all touches, kept -> struct told, one a thread
 *                    partition  of the graph      -> struct divide or struct levels
 *                    join       without stealable blocks after all
 *                    plan       who executes what -> struct plan                  plan/
 *     redcc_bins_next  bins     instead of all that, or after a sweep for
 *                               extents (REDCC_BINS_CHECKED): records, by bins    bins/
 *     redcc_next     run        chunks, copies and their merge, hooks             execute/
 *     ------------------------------------------------------------------------------------------
 *     redcc_leave    counts for the report, tells auto, keeps the plan            account.c
 *
 * A stage is two functions in one table (pipeline.c): `each` is every thread's part, `then` is
 * done by one of them when all have done theirs, and returns the stage that follows. Whatever else
 * decides is in choose/. Rooms include one way: base, ownership, plan, {inspect, reuse, execute,
 * bins}, choose, and the files beside this one (script/rooms).
 */
#ifndef REDCC_PIPELINE_H
#define REDCC_PIPELINE_H

enum stage {
    STAGE_RECOUNT, /* fewer threads came than asked for */
    STAGE_VERIFY,
    STAGE_DRY_RUN,
    STAGE_SAMPLE,
    STAGE_SWEEP,
    STAGE_PARTITION,
    STAGE_JOIN,
    STAGE_PLAN,
    STAGE_RUN,
    STAGE_BINS, /* without inspection and plan */
    STAGE_OVER, /* nothing is to be done in parallel */
    STAGES
};

struct execution;

/** Looks for a kept plan that may serve the call, by the threads that it has now. */
void redcc_find_plan(struct execution *execution);

/** What a stage's share returns. */
enum progress {
    PROGRESS_TELL, /* the program has iterations to tell; then it comes again */
    PROGRESS_MEET, /* done: all threads meet, and one does `then` */
    PROGRESS_PASS  /* done, and all know that the stage that follows is `passed` */
};

#endif
