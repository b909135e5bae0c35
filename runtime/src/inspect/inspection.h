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
 * Functions that take an inspector are called by each thread; the others by one thread, while the
 * others wait. Decisions are made in choose/advice.h, and pipeline.c follows them.
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
    bool ended_in_margin; /* a read in a window ended the run, although perhaps it was only in a
                             margin */
    redcc_int block;      /* number of iterations until the deadline is checked again */
    bool no_conflict;     /* result: no updated element is read */
    bool leaves;          /* result: an iteration leaves the loop */
    double seconds;       /* duration of the dry run, once it has ended */
};

/** Times the slice of some iterations. They are repeated, so that cache misses are not included. */
struct slice_timing {
    int passes;
    redcc_int iterations; /* number of iterations per pass */
    double began;
    double least; /* seconds of the shortest pass; 0: no pass is complete */
};

/** One thread's part of the inspection. Only this thread writes to it; other threads read it after
 * a barrier. */
struct inspector {
    int thread;
    int threads;
    bool failed;          /* out of memory */
    bool recorded_all;    /* all requested iterations were recorded */
    bool late;            /* the deadline passed before all iterations were recorded */
    redcc_int next;       /* next iteration of the sweep or of the dry run */
    redcc_int handed;     /* number of iterations handed out in the current block */
    redcc_int block;      /* maximum number of iterations of a block; with a deadline it grows */
    redcc_int largest;    /* limit up to which `block` grows */
    redcc_int at;         /* next iteration of the sample */
    redcc_entry *entries; /* [REDCC_ENTRIES] */
    struct range *seen;   /* [array_count] the range of each group that this thread has touched */
    redcc_int *executed;  /* [owners] number of iterations of this thread's share that each owner
                             executes */
    struct dry_run dry_run;
    struct slice_timing timing;
    struct sample sample;
    struct sweep sweep;
    redcc_extent *sources; /* [source_count] ranges recorded by redcc_read */
    redcc_owner *nowhere;  /* [array_count] empty windows, with which all touches are recorded */
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
    uint32_t
        stealable; /* number of stealable blocks to be cut for each thread (partition.stealable) */
    enum route route; /* the route decided so far */
    struct pace pace;
    bool no_copies;       /* the ranges of all iterations rule out private copies */
    bool no_graph;        /* the access graph cannot be used to choose owners */
    bool is_exact;        /* the numbered units cover exactly the range that all iterations touch */
    struct touching each; /* averages per iteration, according to the sample */
    struct overlap overlap; /* with REASON_OVERLAP: the source and the array that overlap */
    struct partition partition;
    struct partition whole; /* a partition with one owner, used if only address ranges are needed */
    const struct sample **samples;    /* [threads] the threads' samples */
    const struct summary **summaries; /* [threads] the threads' access summaries */
    const struct range **seen;        /* [threads] the ranges that each thread has touched */
    struct divide divide;
    struct levels levels;
};

/** Begins an inspection. is_direct: threads will find their iterations during execution. Then
 * owners that an earlier execution kept are reused, if there are any. Otherwise auto may also cut
 * stealable blocks. False: out of memory. Call redcc_inspection_end in either case. */
bool redcc_inspection_begin(struct inspection *inspection, bool is_direct);

/** Sets the number of owners for which the sample cuts the arrays. */
void redcc_inspection_set_owners(struct inspection *inspection);

/** Frees the inspection and its inspectors, except for owners that are kept. */
void redcc_inspection_end(struct inspection *inspection);

/** Has the inspection taken longer than auto allows? */
bool redcc_inspection_is_late(const struct inspection *inspection);

/** Will the inspection miss its deadline if it continues at its present speed? `done` is the
 * completed fraction of the stage, 0 to 1. The answer is no during the first 16th of the time. */
bool redcc_inspection_will_be_late(const struct inspection *inspection, double done);

/** With a deadline, the clock is first read after 16 iterations, because they may be heavy. Then
 * the intervals double, up to 16384 iterations, which take 50 microseconds to a millisecond if they
 * are light. */
enum { REDCC_FIRST_BEFORE_DEADLINE = 16, REDCC_BLOCK_BEFORE_DEADLINE = 16384 };
static inline redcc_int redcc_next_before_deadline(redcc_int block) {
    return block < REDCC_BLOCK_BEFORE_DEADLINE ? 2 * block : block;
}

/** Has some thread run out of memory? */
bool redcc_inspection_failed(const struct inspection *inspection);

/** Each thread inspects a consecutive share of the iterations. It begins with number
 * redcc_own_begin and ends before redcc_own_end. */
redcc_int redcc_own_begin(const struct inspection *inspection, const struct inspector *inspector);
redcc_int redcc_own_end(const struct inspection *inspection, const struct inspector *inspector);

/** Makes the worker record iterations first, first + stride, ... < last. A touch within `window`
 *  [array_count] makes no entry. */
void redcc_hand_out(struct inspector *inspector, redcc_worker *worker, redcc_int first,
                    redcc_int last, redcc_int stride, const redcc_owner *window);

/** Clears the ranges recorded by redcc_read. */
void redcc_forget_sources(const struct inspection *inspection, struct inspector *inspector);

/** Sets inspection->touched to the union of the ranges that the threads touched, for each group. */
void redcc_gather_touched(struct inspection *inspection);

/* ---- dry run (dry_run.c) --------------------------------------------------------------------- */

/** Begins the dry run, in the one thread that executes it. False: out of memory. */
bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the next iterations, in order. False: none is left, or the run has ended, or it will
 * miss the deadline. */
bool redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker);

/** Processes the recorded entries, which are one touch and perhaps an iteration's end. If the touch
 * overlaps a read range, sets worker->last to 0, and later records are ignored. */
void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker);

/** Does the recorded range of the source overlap an array's window? If so, or for REDCC_LEAVES,
 * ends the run. */
bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source);

/** The fraction of the iterations that the dry run has recorded. */
double redcc_dry_run_done(const struct inspection *inspection);

/** Ends the dry run. Returns REASON_OVERLAP (inspection->overlap says which ranges overlap),
 * REASON_LEAVES, REASON_DEADLINE, REASON_NO_MEMORY or REASON_NONE. */
enum reason redcc_dry_run_finish(struct inspection *inspection);

/* ---- sample (sampling.c) --------------------------------------------------------------------- */

/** Begins the thread's part of the sample. */
void redcc_sample_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the thread's iterations of the sample. False: none is left. */
bool redcc_sample_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** After the sample: hands out some iterations again, to time their slices. False: none is left, or
 * no estimate needs the time. */
bool redcc_timing_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** The seconds that the slice of an iteration takes if its data are in the caches; 0: not timed. */
double redcc_slice_seconds(const struct inspection *inspection);

/** Processes the entries up to `end`. Entries of timed iterations are ignored. */
void redcc_sample_take(const struct inspection *inspection, struct inspector *inspector,
                       const redcc_entry *end);

/** Completes the sample: scales all threads' samples to the same weight per touch, and merges
 * groups that overlap. */
enum reason redcc_sample_finish(struct inspection *inspection);

/** Cuts the groups into the ranges of the owners according to the sample, unless owners are kept
 * from an earlier execution. *estimate gets statistics of the cut, if `estimate` is not NULL.
 * False: out of memory. */
bool redcc_cut(struct inspection *inspection, struct estimate *estimate);

/* ---- sweep (sweeping.c) ---------------------------------------------------------------------- */

/** Begins the sweep for the current route. `hashed` is the number of bytes of subscripts that are
 * hashed at the same time, block by block. */
void redcc_sweep_start(const struct inspection *inspection, struct inspector *inspector,
                       size_t hashed);

/** Hands out the next block. False: no block is left, or the sweep has failed or is late. */
bool redcc_sweep_hand_out(const struct inspection *inspection, struct inspector *inspector,
                          redcc_worker *worker);

/** Processes the entries. */
void redcc_sweep_flush(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker);

/** Completes a block. Returns the completed fraction of the thread's iterations if the sweep has
 *  several blocks; otherwise 0. */
double redcc_sweep_close(const struct inspection *inspection, struct inspector *inspector);

/** The fraction of the iterations that are recorded, 0 to 1. */
double redcc_sweep_done(const struct inspection *inspection);

/** After all iterations are recorded: computes the touched ranges and the sources' ranges, and
 * checks the overlap guard. */
enum reason redcc_sweep_finish(struct inspection *inspection);

/* ---- log and partition (logging.c) ----------------------------------------------------------- */

/** Does the sweep log all touches? */
bool redcc_is_logged(const struct inspection *inspection);

/** Called before a sweep that logs touches: numbers the units. With is_exact, they cover the range
 * touched in the previous sweep; otherwise the range that the sample predicts. */
enum divide_result redcc_log_begin(struct inspection *inspection, bool is_exact);

/** Begins the thread's part of the log. False: out of memory. */
bool redcc_log_start(const struct inspection *inspection, struct inspector *inspector);

/** After the sweep: can the log be used? DIVIDE_BEYOND: the sweep must be repeated with is_exact.
 */
enum divide_result redcc_log_finish(const struct inspection *inspection);

/** Chooses owners by partitioning the access graph. joined: stealable blocks are joined to their
 * owners. */
void redcc_partition_share(struct inspection *inspection, struct inspector *inspector, bool joined);

/** Assigns the iterations to levels. False: out of memory. */
bool redcc_partition_levels(struct inspection *inspection);

/* ---- statistics of all iterations (statistics.c) --------------------------------------------- */

/** The sum, over all owners, of the numbers of iterations that they execute (inspector->executed).
 */
redcc_int redcc_executed_in_all(const struct inspection *inspection);

/** The value of redcc_executed_in_all if the stealable blocks of the access graph were joined to
 * their owners. */
redcc_int redcc_executed_joined(const struct inspection *inspection);

/** The fraction of the iterations that the most loaded thread executes by LOCALWRITE. With
 * stealable blocks it is at least an equal share. */
double redcc_largest_share(const struct inspection *inspection);

/** The number of iterations, in all threads' shares, that touch other owners than the iteration
 * before. */
double redcc_count_runs(const struct inspection *inspection);

#endif
