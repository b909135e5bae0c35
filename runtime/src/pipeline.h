/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The pipeline of a call of a translated loop.
 *
 *     redcc_enter    struct call      settings in force (call_settings.h),
 *                                     arguments, threads                          call.c
 *                    struct advice    auto: serial, timed, or parallel            choose/advice.h
 *                    struct kept_plan a plan that may be reused                   reuse/kept.h
 *     -- the parallel region: every thread passes through the stages ---------------------------
 *     redcc_inspect  verify     are the subscripts unchanged?         yes: run    reuse/kept.h
 *                    dry run    all iterations, in order, if stale values
 *                               would be harmful                                  inspect/
 *                    sample     some iterations   -> struct partition (the cuts)
 *                    sweep      all iterations    -> struct summary, one per thread
 *                                                    and the overlap guard
 *                    log        all touches, stored -> struct access_log, one per thread
 *                    partition  of the graph      -> struct divide or struct levels
 *                    join       stealable blocks with their owners, if not needed
 *                    plan       schedules         -> struct plan                  plan/
 *     redcc_bins_next  bins     instead of these, or after a sweep for
 *                               extents (REDCC_BINS_CHECKED): in-order binning    bins/
 *     redcc_next     run        chunks, copies and their merge, hooks             execute/
 *     ------------------------------------------------------------------------------------------
 *     redcc_leave    updates the report, informs auto, keeps the plan             call.c
 *
 * A stage is two functions in one table (pipeline.c): every thread calls `each`; when all have
 * finished, one thread calls `then`, which returns the next stage. All other decisions are in
 * choose/. The folders include each other in one direction: base, ownership, plan, {inspect, reuse,
 * execute, bins}, choose, and the files of this folder (script/rooms).
 */
#ifndef REDCC_PIPELINE_H
#define REDCC_PIPELINE_H

enum stage {
    STAGE_RECOUNT, /* fewer threads arrived than were requested, so a plan for this number is
                      searched for */
    STAGE_VERIFY,
    STAGE_DRY_RUN,
    STAGE_SAMPLE,
    STAGE_SWEEP,
    STAGE_PARTITION,
    STAGE_JOIN,
    STAGE_PLAN,
    STAGE_RUN,
    STAGE_BINS, /* binning, without a plan; an inspection comes before only with REDCC_BINS_CHECKED
                 */
    STAGE_OVER, /* nothing runs in parallel */
    STAGES
};

struct execution;

/** Searches for a kept plan for the call and its present number of threads; sets reuse.found or,
 * with sections, run.plan. */
void redcc_find_plan(struct execution *execution);

/** What a stage's function `each` returns. */
enum progress {
    PROGRESS_TELL, /* the program must now record the addresses of some iterations; then `each` is
                      called again */
    PROGRESS_MEET, /* the stage is done: a barrier follows, and one thread calls `then` */
    PROGRESS_PASS  /* the stage is done without a barrier: the next stage is `passed` */
};

#endif
