/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The interface between the pipeline and the decisions of REDCC_METHOD=auto: every question that
 * auto answers, and every result that is reported to it, in the order of a call. No other file
 * calls the learner (learner.h), except that account.c traces the credit. If a method is named, the
 * learner is not used, and these functions answer by the method.
 *
 *     at entry              redcc_advise_rest, redcc_advise_saving, redcc_advise_entry
 *     after the sample      redcc_advise_sampled
 *     after the sweep       redcc_advise_swept; with an access log, redcc_advise_logged
 *     after the partition   redcc_advise_partitioned
 *     after the execution   redcc_tell, also after the sequential loop; redcc_advise_timed
 *
 * One thread at a time uses a chooser: the thread that holds the loop or, in the parallel region,
 * the thread that ends a stage.
 */
#ifndef REDCC_ADVICE_H
#define REDCC_ADVICE_H

#include "inspect/inspection.h"
#include "learn/learner.h"
#include "plan/method.h"
#include "reuse/kept.h"

/** Auto's state for a loop; initially zero. */
struct chooser {
    struct choice_state state;
    uint64_t sample;  /* a hash of some of this call's subscripts (redcc_reuse_sample); 0: none */
    enum reach reach; /* the actions that this call can afford */
    uint64_t sampled[REDCC_PLANS]; /* the samples of the last calls that differ from each other,
                                      most recent first */
    int steady;                    /* number of consecutive calls whose sample was in `sampled` */
    /* fingerprint of all subscripts after the last call, if it was computed */
    struct fingerprint all;
    bool remembered;
    bool verified;   /* all subscripts were once compared and unchanged, and their sample has not
                        changed since */
    int asked, came; /* number of threads requested and obtained in the last parallel region */
    bool begun;   /* the first iterations of this execution were executed in order (beginning.h) */
    long skipped; /* number of sequential calls since a plan was used */
    enum reason refused; /* the last reason why no plan was available */
};

/** What auto decides when a loop is entered. */
struct advice {
    enum action action;
    enum way way; /* with ACTION_REUSE: the strategy to use; with ACTION_INSPECT: the strategy for
                     which a plan is built, once it is decided */
    bool timed;   /* with ACTION_SEQUENTIAL: the execution is to be timed */
    bool alone;   /* with ACTION_INSPECT: one thread takes a sample, and no plan is constructed in
                     this call */
    double deadline; /* with ACTION_INSPECT: time limit of a dry run, in seconds */
    /* with ACTION_INSPECT: seconds spent waiting for threads that had to be started */
    double awaited;
    double may_lose; /* with ACTION_REUSE, in a trial: seconds that may be lost (struct decision);
                        0: no trial */
    double usual;    /* seconds per iteration of the sequential loop; 0: not known yet */
    long skipped_calls; /* with ACTION_REUSE: number of sequential calls since a plan was used */
    double earned; /* with ACTION_REUSE: seconds saved since the last plan construction, minus its
                      cost */
    enum reason reason; /* with ACTION_SEQUENTIAL: the reason */
    enum rule rule;
};

/** Do threads find their iterations during the execution, without a plan that depends on
 * subscripts? Then the only plan that can be reused is one for tiles. */
static inline bool redcc_goes_directly(const struct advice *advice) {
    return advice->action == ACTION_REUSE && advice->way == WAY_DIRECT;
}

/** Is the loop left sequential in this call, because it is short, or because no method helped
 * recently (back-off)? If so, sets *advice. This costs only a comparison and a counter. */
bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads, struct advice *advice);

/** Records that the first `done` iterations of the loop's first execution took `seconds`, executed
 * in order. The next decision is about the remaining `rest` iterations. */
void redcc_advise_begun(struct chooser *chooser, redcc_int rest, redcc_int done, double seconds);

/** May a loop with this trip count be tried in parallel in its first execution, although it was
 * never timed? */
bool redcc_advise_at_once(const redcc_loop *loop, redcc_int trip);

/** Called if redcc_advise_rest returned false: samples the call's subscripts. Sets *advice and
 * returns true if no parallel action would be affordable, even if threads cost nothing. It precedes
 * all work that only a parallel execution needs. */
bool redcc_advise_saving(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                         redcc_int trip, int threads, struct advice *advice);

/** Decides about a call for which redcc_advise_rest and redcc_advise_saving returned false. */
struct advice redcc_advise_entry(struct chooser *chooser, struct reuse *reuse, int threads);

/** Called after the original loop was timed and its time was passed to redcc_tell. Samples the
 * subscripts, unless that was done at entry. After the first timing, keeps the fingerprint of all
 * subscripts for the next call, if comparing them takes at most a 32nd of the loop's time. */
void redcc_advise_timed(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                        redcc_int trip, double seconds);

/** Does auto need statistics of the sample? */
bool redcc_wants_estimate(const struct inspection *inspection);

/** Decides how the inspection continues after the sample. ROUTE_SERIAL: it ends, because no
 * strategy is expected to pay. May join stealable blocks of the partition to their owners, or give
 * the partition a single owner. Sets entry->way and the deadline. */
enum route redcc_advise_sampled(struct chooser *chooser, struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate);

/** Is this a loop over pairs that can be cut into tiles? False if its arrays overlap, because two
 * pairs without a common row or column may then update the same element. */
bool redcc_may_be_tiled(const struct inspection *inspection);

/** In a trial of bins, sets the deadline of the sweep that finds the loop's address ranges. Every
 * execution in bins needs this sweep, so it is a part of the trial, and may take as much time as
 * the trial may lose. */
void redcc_advise_check(const struct advice *entry, struct inspection *inspection);

/** Selects the method, when the access summaries are complete. `reusable`: a later call can reuse
 * the plan. NULL: the original loop is expected to be faster. */
const struct method *redcc_advise_swept(const struct chooser *chooser,
                                        const struct inspection *inspection, bool reusable);

/** Do the memory limit and the touched ranges permit private copies? */
bool redcc_copies_allowed(const struct inspection *inspection);

/** Selects the method, when the access log is complete. May add stealable blocks to the partition.
 * `reusable` and NULL mean the same as for redcc_advise_swept. (Owners from the access graph do not
 * pay in a single execution.) */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection, bool reusable);

/** Informs auto that the access graph cannot be used to choose owners. */
void redcc_tell_no_graph(struct advice *entry);

/** Called after the access graph was partitioned. May change *method. PARTITIONED_JOIN: this
 * function has removed the stealable blocks from the partition, and their iterations must be joined
 * to their owners'. PARTITIONED_LEVELS: inspection->levels is ready and must be used. */
enum partitioned { PARTITIONED_KEEP, PARTITIONED_JOIN, PARTITIONED_LEVELS };
enum partitioned redcc_advise_partitioned(const struct chooser *chooser,
                                          struct inspection *inspection,
                                          const struct method **method);

/** Reports the result and the cost of a call. `reason` says why there was no plan, or is
 * REASON_NONE. */
void redcc_tell(struct chooser *chooser, const struct outcome *outcome, enum reason reason);

/** Reports that `came` of `asked` requested threads arrived, and that `started` of them were new.
 * `seconds` is the time that it took to start the new threads or, if none was new, to wake all
 * threads; 0: unknown. Several threads may call it at once, but for different choosers. */
void redcc_tell_team(struct chooser *chooser, int asked, int came, double seconds, int started);

/** The rule (row of auto's decision table) that decided last. */
enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip);

/** How many of `threads` threads are worth waking for a loop of `trip` iterations? For loops whose
 * sequential execution is never timed, because it would give other sums. `iterations` iterations of
 * earlier parallel executions took `seconds`. */
int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
