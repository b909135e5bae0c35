/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * An inspection, in the threads of the region. Its steps, in this order:
 *
 *     dry run    all iterations' addresses, in order       where the slice may read stale values
 *                by one thread                             (REDCC_DRY_RUN)
 *     sample     some iterations' addresses             -> partition: the arrays cut among owners
 *     sweep      all iterations' addresses              -> extents, overlap guard, and by the route
 *                                                          access summaries or an access log
 *     partition  owners cut from the access graph       -> divide: access summaries by these owners
 *                or iterations in levels                -> levels
 *
 * Functions that take an inspector are called by each thread; the others by one thread, while the
 * others wait. Nothing here chooses: choose/advice.h does, and pipeline.c goes by it.
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

/** What the thread that makes it has of a dry run. */
struct dry_run {
    redcc_owner *window;  /* [array_count] holds what was touched; a touch in it is none of what
                             was read, or may be read in what is clear */
    redcc_owner *clear;   /* [source_count] a read in it is of nothing that a window holds */
    bool has_margins;     /* windows hold more than what was touched */
    bool ended_in_margin; /* by a read, perhaps of nothing that was touched */
    bool stands;          /* nothing updated was found to be read, */
    bool leaves;          /* or an iteration was found to leave the loop */
    double seconds;       /* what it took, in the end */
};

/** One thread's part. What only it writes; others look after the barrier. */
struct inspector {
    int thread;
    int threads;
    bool failed;          /* no memory */
    bool told_all;        /* the program told as many iterations as asked for */
    bool late;            /* the deadline came before all were */
    redcc_int next;       /* iterations handed out up to here, by the sweep */
    redcc_int handed;     /* in the block at hand */
    redcc_int block;      /* that many at most */
    redcc_int at;         /* iterations handed out up to here, by the sample */
    redcc_entry *entries; /* [REDCC_ENTRIES] */
    struct range *seen;   /* [array_count] */
    redcc_int *executed;  /* [owners] iterations of the own share, by owner */
    struct dry_run dry_run;
    struct sample sample;
    struct sweep sweep;
    redcc_extent *sources; /* [source_count] told by redcc_read */
    redcc_owner *nowhere;  /* [array_count] a window that holds nothing: all touches are entered */
};

/** Freed as one. */
struct inspection {
    const struct call *call;
    struct inspector *const *inspector; /* [threads] */
    struct barrier *barrier;
    struct range *touched;  /* [array_count] by all threads; the loop's */
    struct range *sources;  /* [source_count] where they lie; the loop's */
    uint32_t stealable;     /* blocks to be cut for each thread (partition.stealable) */
    enum route route;       /* as far as it is decided */
    double deadline;        /* on the clock of redcc_seconds; 0: none */
    bool no_copies;         /* by all iterations they cannot be had; */
    bool no_graph;          /* nor can owners be cut from the access graph */
    bool is_exact;          /* units are numbered by what all iterations touched */
    struct touching each;   /* iteration, by the sample */
    struct overlap overlap; /* REASON_OVERLAP: which */
    struct partition partition;
    struct partition whole;           /* the same in one piece: for extents alone */
    const struct sample **samples;    /* [threads] */
    const struct summary **summaries; /* [threads] */
    const struct range **seen;        /* [threads] */
    struct divide divide;
    struct levels levels;
};

/** Begins; steals: auto, which may have the arrays cut for stealable blocks. False: no memory (end
 *  it all the same). */
bool redcc_inspection_begin(struct inspection *inspection, bool steals);

/** As many owners as the sample is to cut the arrays for. */
void redcc_inspection_set_owners(struct inspection *inspection);

/** Frees what it and its inspectors hold. */
void redcc_inspection_end(struct inspection *inspection);

/** Has it taken longer than auto allows? */
bool redcc_inspection_is_late(const struct inspection *inspection);

/** Where there is a deadline, it is looked at after so many iterations: 50 microseconds to a
 *  millisecond. */
enum { REDCC_BLOCK_BEFORE_DEADLINE = 16384 };

/** Has some thread run out of memory? */
bool redcc_inspection_failed(const struct inspection *inspection);

/** The iterations that a thread inspects: a consecutive share, [begin, end). */
redcc_int redcc_own_begin(const struct inspection *inspection, const struct inspector *inspector);
redcc_int redcc_own_end(const struct inspection *inspection, const struct inspector *inspector);

/** Has the worker tell iterations first, first + stride, ... < last. A touch within `window`
 *  [array_count] makes no entry. */
void redcc_hand_out(struct inspector *inspector, redcc_worker *worker, redcc_int first,
                    redcc_int last, redcc_int stride, const redcc_owner *window);

/** Nothing was told as read. */
void redcc_forget_sources(const struct inspection *inspection, struct inspector *inspector);

/** What the threads touched, by group, into inspection->touched. */
void redcc_gather_touched(struct inspection *inspection);

/* ---- dry run (dry_run.c) --------------------------------------------------------------------- */

/** Begins it, in the one thread that makes it. False: no memory. */
bool redcc_dry_run_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out the next iterations, all in order by and by. False: none is left, or the run is over,
 * or it will not end before the deadline. */
bool redcc_dry_run_hand_out(const struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker);

/** Takes what was told since: one touch and perhaps an iteration's end. Where it overlaps something
 *  read, worker->last becomes 0, and what is told after that does not count. */
void redcc_dry_run_take(struct inspection *inspection, struct inspector *inspector,
                        redcc_worker *worker);

/** Does what was told of the source overlap what was touched? Then it ends as well. */
bool redcc_dry_run_is_stale(struct inspection *inspection, struct inspector *inspector,
                            redcc_worker *worker, uint32_t source);

/** The part of the iterations that were told. */
double redcc_dry_run_done(const struct inspection *inspection);

/** It is over, or ended: OVERLAP (and which), DEADLINE, NO_MEMORY or NONE. */
enum reason redcc_dry_run_finish(struct inspection *inspection);

/* ---- sample (sampling.c) --------------------------------------------------------------------- */

/** Begins the thread's part. */
void redcc_sample_start(const struct inspection *inspection, struct inspector *inspector);

/** Hands out its iterations of the sample. False: there are none left. */
bool redcc_sample_hand_out(const struct inspection *inspection, struct inspector *inspector,
                           redcc_worker *worker);

/** Takes what was told, up to `end`. */
void redcc_sample_take(const struct inspection *inspection, struct inspector *inspector,
                       const redcc_entry *end);

/** The sample is told: all threads' samples stand for as many touches each, and groups that overlap
 *  by it are one. */
enum reason redcc_sample_finish(struct inspection *inspection);

/** Cuts the groups among the owners, by the sample; estimate: what it says of that, or NULL. False:
 *  no memory. */
bool redcc_cut(struct inspection *inspection, struct estimate *estimate);

/* ---- sweep (sweeping.c) ---------------------------------------------------------------------- */

/** Begins what the route asks for; so many bytes of subscripts will be hashed meanwhile, block
 * after block. */
void redcc_sweep_start(const struct inspection *inspection, struct inspector *inspector,
                       size_t hashed);

/** Hands out the next block. False: there is none left. */
bool redcc_sweep_hand_out(const struct inspection *inspection, struct inspector *inspector,
                          redcc_worker *worker);

/** Takes in what was told. */
void redcc_sweep_flush(struct inspection *inspection, struct inspector *inspector,
                       redcc_worker *worker);

/** The block is told. Returns how much of the thread's iterations is, where more blocks than one
 *  are handed out; else 0. */
double redcc_sweep_close(const struct inspection *inspection, struct inspector *inspector);

/** How many of the iterations are told, 0 to 1. */
double redcc_sweep_done(const struct inspection *inspection);

/** All iterations are told: what is touched, where the sources lie, and the overlap guard. */
enum reason redcc_sweep_finish(struct inspection *inspection);

/* ---- log and partition (logging.c) ----------------------------------------------------------- */

/** Does the sweep keep all touches? */
bool redcc_is_logged(const struct inspection *inspection);

/** Before a sweep that does, by all threads: numbers the units of what was touched in the sweep
 *  before (is_exact), or of what the sample leads to expect. */
enum divide_result redcc_log_begin(struct inspection *inspection, bool is_exact);

/** Begins the thread's part. False: no memory. */
bool redcc_log_start(const struct inspection *inspection, struct inspector *inspector);

/** All is told: can it be used? BEYOND: it has to be told once more, exactly numbered. */
enum divide_result redcc_log_finish(const struct inspection *inspection);

/** Cuts owners from the access graph; joined: without stealable blocks after all. */
void redcc_partition_share(struct inspection *inspection, struct inspector *inspector, bool joined);

/** Puts the iterations in levels. False: no memory. */
bool redcc_partition_levels(struct inspection *inspection);

/* ---- statistics of all iterations (statistics.c) --------------------------------------------- */

/** How many iterations all owners execute, as the inspectors have counted them (executed). */
redcc_int redcc_executed_in_all(const struct inspection *inspection);

/** The same if the stealable blocks of the access graph's owners were joined to these. */
redcc_int redcc_executed_joined(const struct inspection *inspection);

/** What of the iterations the thread has that would execute most by LOCALWRITE. */
double redcc_largest_share(const struct inspection *inspection);

/** How often an iteration touches other owners than the one before it, in all threads' shares. */
double redcc_count_runs(const struct inspection *inspection);

#endif
