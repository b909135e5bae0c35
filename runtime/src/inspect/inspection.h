/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * An inspection, by the threads of the region. Its steps, in this order:
 *
 *     dry run    all iterations' addresses, in order       if the slice may read stale values
 *                by one thread                             (REDCC_DRY_RUN)
 *     sample     some iterations' addresses             -> partition: the arrays cut among owners
 *     sweep      all iterations' addresses              -> extents, overlap guard, and by the route
 *                                                          access summaries or an access log
 *     partition  owners chosen by the access graph      -> divide: access summaries by these owners
 *                or iterations in levels                -> levels
 *
 * Functions that take an inspector are called by each thread; all others are called by one thread,
 * while the other threads wait. Decisions are made in choose/advice.h, and pipeline.c follows them.
 */
#ifndef REDCC_INSPECTION_H
#define REDCC_INSPECTION_H

#include "base/call.h"
#include "base/reason.h"
#include "base/route.h"
#include "ownership/estimate.h"
#include "ownership/graph/divide.h"
#include "ownership/graph/levels.h"
#include "ownership/overlap.h"
#include "ownership/sample.h"
#include "ownership/sweep.h"

enum { REDCC_ENTRIES = 1024 };

/** State of a dry run, in the thread that executes it. */
struct dry_run {
    redcc_owner *window;  /* [array_count] each window contains the touched range; a touch in it
                             overlaps no read range */
    redcc_owner *clear;   /* [source_count] a read in a clear range overlaps no window */
    bool has_margins;     /* windows are larger than the touched ranges */
    bool ended_in_margin; /* a read in a window ended the run, although the read may have been in a
                             margin */
    redcc_int block;      /* number of iterations until the deadline is checked again */
    bool no_conflict;     /* result: no updated element is read */
    bool leaves;          /* result: an iteration leaves the loop */
    redcc_int end;        /* result: the iteration that leaves the loop, if those before it may be
                             executed; 0: there is none */
    redcc_int usual;      /* with REDCC_CONTINUES: the number of iterations that the last complete
                             run found; 0: unknown. It is kept between executions */
    double seconds;       /* duration of the dry run, once it has ended */
};

/** Times the slice of some iterations. Several passes over the same iterations are timed, so that
 * cache misses do not count. */
struct slice_timing {
    int passes;
    redcc_int iterations; /* number of iterations per pass */
    double began;
    double least; /* seconds of the shortest pass; 0: no pass is complete */
};

/** One thread's part of the inspection. Only this thread writes to it; other threads may read it
 * after a barrier. */
struct inspector {
    int thread;
    int threads;
    bool failed;          /* out of memory */
    bool recorded_all;    /* all requested iterations were recorded */
    bool late;            /* the deadline passed before all iterations were recorded */
    redcc_int next;       /* next iteration of the sweep or of the dry run */
    redcc_int handed;     /* number of iterations handed out in the current sweep block */
    redcc_int block;      /* maximum number of iterations of a block; with a deadline it grows */
    redcc_int largest;    /* limit up to which `block` grows */
    redcc_int at;         /* number of the next iteration of the sample */
    redcc_entry *entries; /* [REDCC_ENTRIES] */
    struct range *seen;   /* [array_count] for each group, the range that this thread has touched */
    redcc_int *executed;  /* [owners] number of iterations, in the share that this thread inspects,
                             that each owner executes */
    struct dry_run dry_run;
    struct slice_timing timing;
    struct sample sample;
    struct sweep sweep;
    redcc_extent *sources; /* [source_count] ranges recorded by redcc_read */
    redcc_owner *nowhere;  /* [array_count] empty windows; with them all touches are recorded */
};

/** The limits on the duration of an inspection. */
struct pace {
    double usual;    /* seconds that an iteration of the sequential loop takes; 0: unknown */
    double began;    /* when the stage to which the deadline applies began, on the clock of
                        redcc_seconds */
    double deadline; /* when that stage must end; 0: no deadline */
};

/** An inspection. Its memory is freed as a whole. */
struct inspection {
    const struct call *call;
    struct inspector *const *inspector; /* [threads] */
    struct barrier *barrier;
    struct range *touched; /* [array_count] ranges touched by all threads; owned by the loop */
    struct range *sources; /* [source_count] ranges read; owned by the loop */
    /* number of stealable blocks to be cut for each thread (partition.stealable) */
    uint32_t stealable;
    enum route route; /* the route decided so far */
    struct pace pace;
    bool no_copies; /* private copies are impossible, because the ranges that all iterations touch
                       are too large */
    bool no_graph;  /* the access graph cannot be used to choose owners */
    bool is_exact;  /* the numbered units cover exactly the range that all iterations touch */
    struct touching each;   /* averages per iteration, according to the sample */
    struct overlap overlap; /* with REASON_OVERLAP: the source and the array that overlap */
    struct partition partition;
    struct partition whole; /* a partition with one owner, used if only address ranges are needed */
    const struct sample **samples;    /* [threads] the threads' samples */
    const struct summary **summaries; /* [threads] the threads' access summaries */
    const struct range **seen; /* [threads] for each thread, the ranges that it has touched */
    struct divide divide;
    struct levels levels;
};

/** Begins an inspection. If `is_direct` is set, threads will find their iterations during
 * execution. Then owners kept from an earlier execution with as many threads are used, if there are
 * any, and auto cuts no stealable blocks. Returns false if out of memory. Call redcc_inspection_end
 * in either case. */
bool redcc_inspection_begin(struct inspection *inspection, bool is_direct);

/** Sets the number of owners for which the sample cuts the arrays. */
void redcc_inspection_set_owners(struct inspection *inspection);

/** Frees the inspection and its inspectors, except for owners that are kept for later
 * executions. */
void redcc_inspection_end(struct inspection *inspection);

/** Has the inspection taken longer than auto allows? */
bool redcc_inspection_is_late(const struct inspection *inspection);

/** Will the inspection miss its deadline if it continues at its present speed? `done` is the
 * completed fraction of the stage, 0 to 1. False during the first 16th of the time, when the speed
 * is uncertain. */
bool redcc_inspection_will_be_late(const struct inspection *inspection, double done);

/** If there is a deadline, the clock is first read after 16 iterations, because iterations may be
 * long. The intervals then double, up to 16384 iterations, which take 50 microseconds to a
 * millisecond if iterations are short. */
enum { REDCC_FIRST_BEFORE_DEADLINE = 16, REDCC_BLOCK_BEFORE_DEADLINE = 16384 };
static inline redcc_int redcc_next_before_deadline(redcc_int block) {
    return block < REDCC_BLOCK_BEFORE_DEADLINE ? 2 * block : block;
}

/** Has some thread run out of memory? */
bool redcc_inspection_failed(const struct inspection *inspection);

/** Each thread inspects a consecutive share of the iterations, from number redcc_own_begin to
 * before redcc_own_end. */
redcc_int redcc_own_begin(const struct inspection *inspection, const struct inspector *inspector);
redcc_int redcc_own_end(const struct inspection *inspection, const struct inspector *inspector);

/** Makes the worker record iterations first, first + stride, ... < last. A touch that lies in
 * `window`[array_count] makes no entry. */
void redcc_hand_out(struct inspector *inspector, redcc_worker *worker, redcc_int first,
                    redcc_int last, redcc_int stride, const redcc_owner *window);

/** Clears the ranges recorded by redcc_read. */
void redcc_forget_sources(const struct inspection *inspection, struct inspector *inspector);

/** Sets inspection->touched to the union of the ranges that the threads touched, for each group. */
void redcc_gather_touched(struct inspection *inspection);

/* ---- dry run (dry_run.c) --------------------------------------------------------------------- */

/** Begins the dry run, in the one thread that executes it. False: out of memory. */
bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the next iterations, in order. Returns false if none is left, the run has ended, or it
 * will miss the deadline. */
bool redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker);

/** Processes the recorded entries: one touch, and perhaps the end of an iteration. If the touch
 * overlaps a read range, ends the run: sets worker->last to 0, and ignores later records. */
void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker);

/** Does the recorded range of the source overlap an array's window? If so, ends the run. Also ends
 * it, and returns true, for REDCC_LEAVES and REDCC_ENDS. */
bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source);

/** The fraction of the iterations that the dry run has recorded; 0: unknown, because an iteration
 * may leave the loop. */
double redcc_dry_run_done(const struct inspection *inspection);

/** Ends the dry run. Returns REASON_OVERLAP (inspection->overlap says which ranges overlap),
 * REASON_LEAVES, REASON_DEADLINE, REASON_NO_MEMORY or REASON_NONE. *trip gets the number of
 * iterations to execute. */
enum reason redcc_dry_run_finish(struct inspection *inspection, redcc_int *trip);

/* ---- sample (sampling.c) --------------------------------------------------------------------- */

/** Begins the thread's part of the sample. */
void redcc_sample_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the thread's iterations of the sample, and then those of redcc_timing_hand_out.
 * Returns false if none is left. */
bool redcc_sample_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** Called after the sample: hands out some iterations, in several passes, to time their slices.
 * Returns false if none is left, or if no estimate needs the time. */
bool redcc_timing_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** The seconds that an iteration's slice takes if its data are in the caches; 0: it was not
 * timed. */
double redcc_slice_seconds(const struct inspection *inspection);

/** Processes the entries up to `end`. Entries of timed iterations are ignored. */
void redcc_sample_take(const struct inspection *inspection, struct inspector *inspector,
                       const redcc_entry *end);

/** Completes the sample: makes each item of all threads' samples represent the same number of
 * touches, and merges groups that overlap. Returns REASON_NONE or the reason why the inspection
 * must end. */
enum reason redcc_sample_finish(struct inspection *inspection);

/** Cuts the groups into the ranges of the owners, as the sample suggests. If `estimate` is not
 * NULL, *estimate gets statistics of the cut, and a map of owners by votes may be added. If owners
 * are kept from an earlier execution, only sets the known ranges of sources. Returns false if out
 * of memory. */
bool redcc_cut(struct inspection *inspection, struct estimate *estimate);

/* ---- sweep (sweeping.c) ---------------------------------------------------------------------- */

/** Begins the sweep for the current route. `hashed` is the number of bytes of subscripts that this
 * thread hashes during the sweep, block by block. */
void redcc_sweep_start(const struct inspection *inspection, struct inspector *inspector,
                       size_t hashed);

/** Hands out the next iterations. Returns false if none is left, or if the sweep has failed or is
 * late. */
bool redcc_sweep_hand_out(const struct inspection *inspection, struct inspector *inspector,
                          redcc_worker *worker);

/** Processes the entries. */
void redcc_sweep_flush(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker);

/** Completes a block. Returns the fraction of the thread's iterations that is completed, if the
 * sweep has several blocks; otherwise 0. */
double redcc_sweep_close(const struct inspection *inspection, struct inspector *inspector);

/** The fraction of the iterations that are recorded, 0 to 1. */
double redcc_sweep_done(const struct inspection *inspection);

/** Called when all iterations are recorded: computes the ranges that are touched and read, and
 * checks the overlap guard. Returns REASON_NONE, or the reason why the loop must run
 * sequentially. */
enum reason redcc_sweep_finish(struct inspection *inspection);

/* ---- log and partition (logging.c) ----------------------------------------------------------- */

/** Does the sweep log all touches? */
bool redcc_is_logged(const struct inspection *inspection);

/** Called before a sweep that logs touches: numbers the units. If is_exact, the numbered units
 * cover the range that the previous sweep found to be touched; otherwise, the range that the sample
 * predicts. */
enum divide_result redcc_log_begin(struct inspection *inspection, bool is_exact);

/** Begins the thread's part of the log. False: out of memory. */
bool redcc_log_start(const struct inspection *inspection, struct inspector *inspector);

/** Called after the sweep: can the log be used? DIVIDE_BEYOND: a touch was outside of the numbered
 * units, and the sweep must be repeated with is_exact. */
enum divide_result redcc_log_finish(const struct inspection *inspection);

/** Executes a thread's part in choosing owners by partitioning the access graph. If `joined` is
 * set, only joins stealable blocks to their owners. */
void redcc_partition_share(struct inspection *inspection, struct inspector *inspector, bool joined);

/** Assigns the iterations to levels. False: out of memory. */
bool redcc_partition_levels(struct inspection *inspection);

/* ---- statistics of all iterations (statistics.c) --------------------------------------------- */

/** The sum of all owners' numbers of executed iterations (inspector->executed); an iteration counts
 * once for each owner that executes it. */
redcc_int redcc_executed_in_all(const struct inspection *inspection);

/** The value of redcc_executed_in_all if the stealable blocks of the access graph were joined to
 * their owners. */
redcc_int redcc_executed_joined(const struct inspection *inspection);

/** The fraction of the iterations that the most loaded thread executes by LOCALWRITE. With
 * stealable blocks it is at least the fraction of an equal share. */
double redcc_largest_share(const struct inspection *inspection);

/** The number of spans in the threads' access summaries: about the number of iterations that touch
 * other owners than the iteration before. */
double redcc_count_runs(const struct inspection *inspection);

#endif
