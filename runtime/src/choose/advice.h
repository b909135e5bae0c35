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
 * One thread at a time uses a chooser: the one that holds the loop, or that ends a stage.
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
    uint64_t sampled[REDCC_PLANS]; /* the samples of the last calls, most recent first */
    int steady;                    /* number of consecutive calls whose sample was one of these */
    struct fingerprint
        all; /* fingerprint of all subscripts after the last call, if it was computed */
    bool remembered;
    bool verified;   /* all subscripts were compared once, and their sample has not changed since */
    int asked, came; /* number of threads requested and obtained in the last parallel region */
    bool begun;   /* the first iterations of this execution were executed in order (beginning.h) */
    long skipped; /* number of sequential calls since a plan was used */
    enum reason refused; /* the last reason why no plan was available */
};

/** What auto decides when a loop is entered. */
struct advice {
    enum action action;
    enum way way; /* with ACTION_REUSE: the strategy; with ACTION_INSPECT: the strategy, once it is
                     decided */
    bool timed;   /* with ACTION_SEQUENTIAL: the execution is to be timed */
    bool alone; /* with ACTION_INSPECT: one thread takes a sample, and a plan is constructed only in
                   another call */
    double deadline; /* with ACTION_INSPECT: time limit of a dry run, in seconds */
    double
        awaited; /* with ACTION_INSPECT: seconds spent waiting for threads that had to be started */
    double may_lose;    /* with ACTION_REUSE, in a trial: as in struct decision; 0: no trial */
    double usual;       /* seconds per iteration of the sequential loop; 0: not known yet */
    long skipped_calls; /* with ACTION_REUSE: number of sequential calls since a plan was used */
    double earned; /* with ACTION_REUSE: seconds saved since the last plan construction, minus its
                      cost */
    enum reason reason; /* with ACTION_SEQUENTIAL: the reason */
    enum rule rule;
};

/** Do threads find their iterations during the execution? If so, only a plan for tiles can be
 * reused. */
static inline bool redcc_goes_directly(const struct advice *advice) {
    return advice->action == ACTION_REUSE && advice->way == WAY_DIRECT;
}

/** Is the loop left sequential in this call, because it is short or no method helped recently? If
 * so, sets *advice. This costs only a comparison and a counter. */
bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads, struct advice *advice);

/** Records that the first `done` iterations of an execution took `seconds` in order. The other
 * `rest` iterations are decided about next. */
void redcc_advise_begun(struct chooser *chooser, redcc_int rest, redcc_int done, double seconds);

/** Is a loop with this trip count tried in its first execution, before it was timed? */
bool redcc_advise_at_once(const redcc_loop *loop, redcc_int trip);

/** Called if redcc_advise_rest did not decide: samples the call's subscripts. Returns true and sets
 * *advice if no parallel action would be affordable even if threads cost nothing. This precedes any
 * work that only a parallel execution needs. */
bool redcc_advise_saving(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                         redcc_int trip, int threads, struct advice *advice);

/** Decides about a call that neither redcc_advise_rest nor redcc_advise_saving decided. */
struct advice redcc_advise_entry(struct chooser *chooser, struct reuse *reuse, int threads);

/** Called after the original loop was timed and redcc_tell was given the time. Samples the
 * subscripts, unless that was done at entry. After the first timing, keeps the fingerprint of all
 * subscripts for the next call, if comparing them takes at most a 32nd of that time. */
void redcc_advise_timed(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                        redcc_int trip, double seconds);

/** Does auto need statistics of the sample? */
bool redcc_wants_estimate(const struct inspection *inspection);

/** Decides how the inspection continues. ROUTE_SERIAL: it is not worth continuing. May join
 * stealable blocks of the partition to their owners, or give the partition a single owner. Sets
 * entry->way and the deadline. */
enum route redcc_advise_sampled(struct chooser *chooser, struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate);

/** Is this a loop over pairs that can be cut into tiles? It cannot if its arrays overlap, because
 * two pairs without a common row or column may then update the same element. */
bool redcc_may_be_tiled(const struct inspection *inspection);

/** Sets the deadline of the sweep that finds the address ranges of a loop in a trial of bins. Every
 * execution in bins needs this sweep, so that it is part of the trial. It may take as much time as
 * the trial may lose. */
void redcc_advise_check(const struct advice *entry, struct inspection *inspection);

/** Selects the method, given the access summaries. `reusable`: the plan can be kept. NULL: the
 * original loop is expected to be faster. */
const struct method *redcc_advise_swept(const struct chooser *chooser,
                                        const struct inspection *inspection, bool reusable);

/** Do the memory limit and the touched ranges permit private copies? */
bool redcc_copies_allowed(const struct inspection *inspection);

/** Selects the method, given a complete access log. May add stealable blocks to the partition.
 * `reusable` and NULL have the meaning of redcc_advise_swept. Owners from the access graph do not
 * pay in a single execution. */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection, bool reusable);

/** Informs auto that the access graph cannot be used to choose owners. */
void redcc_tell_no_graph(struct advice *entry);

/** Called after the access graph was partitioned. May change *method. PARTITIONED_JOIN: the
 * stealable blocks, which the partition no longer has, must be joined to their owners.
 * PARTITIONED_LEVELS: inspection->levels is ready and must be used. */
enum partitioned { PARTITIONED_KEEP, PARTITIONED_JOIN, PARTITIONED_LEVELS };
enum partitioned redcc_advise_partitioned(const struct chooser *chooser,
                                          struct inspection *inspection,
                                          const struct method **method);

/** Reports the result and the cost of a call. `reason` says why there was no plan, or is
 * REASON_NONE. */
void redcc_tell(struct chooser *chooser, const struct outcome *outcome, enum reason reason);

/** Reports that `came` of `asked` requested threads arrived, and that `started` of them were new.
 * `seconds` is the time to start the new threads or, if none was new, to wake all; 0: unknown.
 * Thread-safe except for the chooser. */
void redcc_tell_team(struct chooser *chooser, int asked, int came, double seconds, int started);

/** The rule (row of auto's decision table) that decided last. */
enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip);

/** How many of `threads` threads are worth waking for a loop of `trip` iterations? The sequential
 * execution of this loop is never timed, because that would give other sums. `seconds` is the time
 * of its first `iterations` iterations. */
int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
