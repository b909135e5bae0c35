/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * An inspection, in the threads of the region. Its steps, in this order:
 *
 *     dry run    all iterations' addresses, in order       if the slice may read stale values
 *                by one thread                             (REDCC_DRY_RUN)
 *     sample     some iterations' addresses             -> partition: the arrays cut among owners
 *     sweep      all iterations' addresses              -> extents, overlap guard, and by the route
 *                                                          access summaries or an access log
 *     partition  owners cut from the access graph       -> divide: access summaries by these owners
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

/** State of a dry run, in the thread that makes it. */
struct dry_run {
    redcc_owner *window;  /* [array_count] contains the touched range; a touch in it overlaps no
                           * read, except possibly reads in clear ranges */
    redcc_owner *clear;   /* [source_count] a read in it overlaps no window */
    bool has_margins;     /* windows are larger than the touched ranges */
    bool ended_in_margin; /* by a read, which perhaps overlaps no touched range */
    redcc_int block;      /* iterations until the deadline is checked again */
    bool no_conflict;     /* no updated element was found to be read */
    bool leaves;          /* an iteration was found to leave the loop */
    double seconds;       /* its duration, at the end */
};

/** Time of the slice of some iterations, executed again and again, so that it is not the time of
 *  fetching their data. */
struct slice_timing {
    int passes;
    redcc_int iterations; /* of a pass */
    double began;
    double least; /* seconds of the shortest pass; 0: none is complete */
};

/** One thread's part. Only it writes this; the other threads read it after the barrier. */
struct inspector {
    int thread;
    int threads;
    bool failed;          /* no memory */
    bool recorded_all;    /* all requested iterations were recorded */
    bool late;            /* the deadline passed before that */
    redcc_int next;       /* iterations handed out so far, by the sweep */
    redcc_int handed;     /* in the current block */
    redcc_int block;      /* at most; with a deadline it grows */
    redcc_int largest;    /* up to this */
    redcc_int at;         /* iterations handed out so far, by the sample */
    redcc_entry *entries; /* [REDCC_ENTRIES] */
    struct range *seen;   /* [array_count] */
    redcc_int *executed;  /* [owners] iterations of this thread's share, by owner */
    struct dry_run dry_run;
    struct slice_timing timing;
    struct sample sample;
    struct sweep sweep;
    redcc_extent *sources; /* [source_count] recorded by redcc_read */
    redcc_owner *nowhere;  /* [array_count] an empty window: all touches are recorded */
};

/** What an inspection may take. */
struct pace {
    double usual;    /* seconds of an iteration of the sequential loop; 0: unknown */
    double began;    /* the stage with the deadline, on the clock of redcc_seconds */
    double deadline; /* on the same clock; 0: none */
};

/** Freed as one. */
struct inspection {
    const struct call *call;
    struct inspector *const *inspector; /* [threads] */
    struct barrier *barrier;
    struct range *touched; /* [array_count] by all threads; the loop's */
    struct range *sources; /* [source_count] their ranges; the loop's */
    uint32_t stealable;    /* blocks to be cut for each thread (partition.stealable) */
    enum route route;      /* as decided so far */
    struct pace pace;
    bool no_copies;         /* the ranges of all iterations rule them out; */
    bool no_graph;          /* nor can owners be cut from the access graph */
    bool is_exact;          /* unit numbers cover exactly the range touched by all iterations */
    struct touching each;   /* per iteration, according to the sample */
    struct overlap overlap; /* REASON_OVERLAP: the two that overlap */
    struct partition partition;
    struct partition whole;           /* the same in one piece: for extents only */
    const struct sample **samples;    /* [threads] */
    const struct summary **summaries; /* [threads] */
    const struct range **seen;        /* [threads] */
    struct divide divide;
    struct levels levels;
};

/** Begins; is_direct: threads will find their iterations during execution, by owners of an earlier
 *  one if these are kept. Otherwise auto may cut the arrays for stealable blocks. False: no memory
 *  (call redcc_inspection_end all the same). */
bool redcc_inspection_begin(struct inspection *inspection, bool is_direct);

/** Sets the number of owners for which the sample cuts the arrays. */
void redcc_inspection_set_owners(struct inspection *inspection);

/** Frees the inspection and its inspectors, except for owners that are kept. */
void redcc_inspection_end(struct inspection *inspection);

/** Has it taken longer than auto allows? */
bool redcc_inspection_is_late(const struct inspection *inspection);

/** Will it, at the pace of this fraction of the stage, 0 to 1? Says so after a 16th of the time. */
bool redcc_inspection_will_be_late(const struct inspection *inspection, double done);

/** With a deadline, the clock is read after so many iterations, then after twice as many each time,
 *  up to the second number (50 microseconds to a millisecond): iterations may be heavy. */
enum { REDCC_FIRST_BEFORE_DEADLINE = 16, REDCC_BLOCK_BEFORE_DEADLINE = 16384 };
static inline redcc_int redcc_next_before_deadline(redcc_int block) {
    return block < REDCC_BLOCK_BEFORE_DEADLINE ? 2 * block : block;
}

/** Has some thread run out of memory? */
bool redcc_inspection_failed(const struct inspection *inspection);

/** The iterations that a thread inspects: a consecutive share, [begin, end). */
redcc_int redcc_own_begin(const struct inspection *inspection, const struct inspector *inspector);
redcc_int redcc_own_end(const struct inspection *inspection, const struct inspector *inspector);

/** Has the worker record iterations first, first + stride, ... < last. A touch within `window`
 *  [array_count] makes no entry. */
void redcc_hand_out(struct inspector *inspector, redcc_worker *worker, redcc_int first,
                    redcc_int last, redcc_int stride, const redcc_owner *window);

/** Clears the recorded reads. */
void redcc_forget_sources(const struct inspection *inspection, struct inspector *inspector);

/** Merges the ranges touched by the threads, by group, into inspection->touched. */
void redcc_gather_touched(struct inspection *inspection);

/* ---- dry run (dry_run.c) --------------------------------------------------------------------- */

/** Begins it, in the one thread that makes it. False: no memory. */
bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the next iterations, all in order over several calls. False: none is left, or the run
 *  is over, or it will miss the deadline. */
bool redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker);

/** Processes the addresses recorded since: one touch and perhaps an iteration's end. If it overlaps
 *  a read, sets worker->last to 0, and later records are ignored. */
void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker);

/** Does the read range recorded for the source overlap a touched range? Then the run ends as
 *  well. */
bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source);

/** The fraction of the iterations that were recorded. */
double redcc_dry_run_done(const struct inspection *inspection);

/** Ends the run; returns OVERLAP (and which), DEADLINE, NO_MEMORY or NONE. */
enum reason redcc_dry_run_finish(struct inspection *inspection);

/* ---- sample (sampling.c) --------------------------------------------------------------------- */

/** Begins the thread's part. */
void redcc_sample_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out its iterations of the sample. False: none is left. */
bool redcc_sample_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** After the sample: hands out some iterations once more, to time their slices. False: none is
 *  left, or no estimate needs it. */
bool redcc_timing_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** Seconds of the slice of an iteration whose data are in the caches; 0: not timed. */
double redcc_slice_seconds(const struct inspection *inspection);

/** Processes the entries up to `end`; those of timed iterations are ignored. */
void redcc_sample_take(const struct inspection *inspection, struct inspector *inspector,
                       const redcc_entry *end);

/** The sample is complete: scales all threads' samples to one weight per touch, and merges groups
 *  that overlap in it. */
enum reason redcc_sample_finish(struct inspection *inspection);

/** Cuts the groups among the owners according to the sample, unless they are kept; estimate:
 *  statistics of the cut, or NULL. False: no memory. */
bool redcc_cut(struct inspection *inspection, struct estimate *estimate);

/* ---- sweep (sweeping.c) ---------------------------------------------------------------------- */

/** Begins the sweep of the route; this number of bytes of subscripts will be hashed meanwhile,
 *  block by block. */
void redcc_sweep_start(const struct inspection *inspection, struct inspector *inspector,
                       size_t hashed);

/** Hands out the next block. False: none is left. */
bool redcc_sweep_hand_out(const struct inspection *inspection, struct inspector *inspector,
                          redcc_worker *worker);

/** Processes the entries. */
void redcc_sweep_flush(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker);

/** The block is complete. Returns the completed fraction of the thread's iterations if more than
 *  one block is handed out; else 0. */
double redcc_sweep_close(const struct inspection *inspection, struct inspector *inspector);

/** The fraction of the iterations that are recorded, 0 to 1. */
double redcc_sweep_done(const struct inspection *inspection);

/** All iterations are recorded: computes the touched ranges and the sources' ranges, and checks the
 *  overlap guard. */
enum reason redcc_sweep_finish(struct inspection *inspection);

/* ---- log and partition (logging.c) ----------------------------------------------------------- */

/** Does the sweep log all touches? */
bool redcc_is_logged(const struct inspection *inspection);

/** Before such a sweep, by all threads: numbers the units touched in the previous sweep (is_exact),
 *  or of the range that the sample predicts. */
enum divide_result redcc_log_begin(struct inspection *inspection, bool is_exact);

/** Begins the thread's part. False: no memory. */
bool redcc_log_start(const struct inspection *inspection, struct inspector *inspector);

/** All is recorded: can the log be used? BEYOND: the sweep must be repeated with exact numbers. */
enum divide_result redcc_log_finish(const struct inspection *inspection);

/** Cuts owners from the access graph; joined: without stealable blocks after all. */
void redcc_partition_share(struct inspection *inspection, struct inspector *inspector, bool joined);

/** Assigns the iterations to levels. False: no memory. */
bool redcc_partition_levels(struct inspection *inspection);

/* ---- statistics of all iterations (statistics.c) --------------------------------------------- */

/** The number of iterations that all owners execute, as the inspectors counted them (executed). */
redcc_int redcc_executed_in_all(const struct inspection *inspection);

/** The same if the stealable blocks of the access graph's owners were joined to these. */
redcc_int redcc_executed_joined(const struct inspection *inspection);

/** The share of the iterations of the most loaded thread by LOCALWRITE. */
double redcc_largest_share(const struct inspection *inspection);

/** How often an iteration touches other owners than the preceding one, in all threads' shares. */
double redcc_count_runs(const struct inspection *inspection);

#endif
