/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The interface between the pipeline and auto's decisions: every question that REDCC_METHOD=auto
 * answers, and every result reported to it, in the order of a call. Nothing else calls the decision
 * core (learner.h), except that account.c traces the credit. If a method is named, the core is not
 * used, and these functions answer by the method.
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
    uint64_t sample;               /* of this call's subscripts (redcc_reuse_sample); 0: none */
    enum reach reach;              /* of this call */
    uint64_t sampled[REDCC_PLANS]; /* samples, most recent first */
    int steady;                    /* consecutive calls that had one of these */
    struct fingerprint all;        /* of all subscripts after the last call, if it was computed */
    bool remembered;
    bool verified;   /* all subscripts were compared once, and their sample has not changed since */
    int asked, came; /* threads requested and obtained in the last parallel region */
    bool begun;      /* this execution has begun in order (beginning.h) */
    long skipped;    /* sequential calls since a plan was used */
    enum reason refused; /* the last reason why no plan was available */
};

/** Auto's decision at entry. */
struct advice {
    enum action action;
    enum way way;       /* REUSE: the strategy; INSPECT: the same, once it is decided */
    bool timed;         /* SEQUENTIAL */
    bool alone;         /* INSPECT: only a sample, by one thread; a plan is constructed in another
                         * call */
    double deadline;    /* INSPECT: time limit of a dry run, in seconds */
    double awaited;     /* INSPECT: seconds spent waiting for threads that had to be started */
    double may_lose;    /* REUSE, in a trial: as in struct decision; 0: no trial */
    double usual;       /* seconds per iteration of the sequential loop; 0: not known yet */
    long skipped_calls; /* REUSE: sequential calls since a plan was used */
    double earned;      /* REUSE: seconds saved since the last plan construction, less its cost */
    enum reason reason; /* for SEQUENTIAL */
    enum rule rule;
};

/** Do threads find their iterations during the execution? Then only a plan for tiles can be
 * reused. */
static inline bool redcc_goes_directly(const struct advice *advice) {
    return advice->action == ACTION_REUSE && advice->way == WAY_DIRECT;
}

/** Is the loop left sequential in this call, because it is short or no method helped recently? Then
 *  sets *advice, at the cost of a compare and a counter. */
bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads, struct advice *advice);

/** `done` iterations of the execution that is decided next have taken so long in order; `rest` are
 *  left. */
void redcc_advise_begun(struct chooser *chooser, redcc_int rest, redcc_int done, double seconds);

/** Is a loop with this trip count tried in its first execution, before it was timed? */
bool redcc_advise_at_once(const redcc_loop *loop, redcc_int trip);

/** For a call that redcc_advise_rest did not decide: samples its subscripts. Returns true and sets
 * *advice if no parallel action would be affordable even if threads cost nothing. This precedes any
 * work that only a parallel execution needs. */
bool redcc_advise_saving(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                         redcc_int trip, int threads, struct advice *advice);

/** The decision for a call that neither redcc_advise_rest nor redcc_advise_saving decided. */
struct advice redcc_advise_entry(struct chooser *chooser, struct reuse *reuse, int threads);

/** The original loop was timed, and redcc_tell has the time. Samples the subscripts, unless that
 * was done at entry. After the first timing, if comparing all of them takes at most a 32nd of that
 * time, keeps their fingerprint for the next call. */
void redcc_advise_timed(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                        redcc_int trip, double seconds);

/** Does auto need estimates from the sample? */
bool redcc_wants_estimate(const struct inspection *inspection);

/** Decides how the inspection continues. SERIAL: it is not worth it. May join stealable blocks of
 *  the partition to their owners, or make it one piece. Sets entry->way, and the deadline. */
enum route redcc_advise_sampled(struct chooser *chooser, struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate);

/** Is it a loop over pairs that can be cut into tiles? Arrays that overlap cannot: two pairs
 * without a common row or column may then update one element. */
bool redcc_may_be_tiled(const struct inspection *inspection);

/** Sets the deadline of the sweep that finds the extents of a loop on trial in bins. Every
 * execution needs this sweep, so it is part of the trial and may take as long as the trial may
 * lose. */
void redcc_advise_check(const struct advice *entry, struct inspection *inspection);

/** Selects the method, given the access summaries. reusable: the plan can be kept. NULL: none, the
 *  original loop is expected to be faster. */
const struct method *redcc_advise_swept(const struct chooser *chooser,
                                        const struct inspection *inspection, bool reusable);

/** Do the memory limit and the touched ranges permit private copies? */
bool redcc_copies_allowed(const struct inspection *inspection);

/** Selects the method, given a complete access log. May add stealable blocks to the partition.
 *  reusable, and NULL: as above; owners cut from the graph do not pay off in one execution. */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection, bool reusable);

/** Informs auto that the owners cannot be cut from the access graph. */
void redcc_tell_no_graph(struct advice *entry);

/** Called after the owners are cut. *method is kept, or changes. JOIN: the stealable blocks, which
 *  the partition no longer contains, must be joined to their owners; LEVELS: inspection->levels is
 *  ready. */
enum partitioned { PARTITIONED_KEEP, PARTITIONED_JOIN, PARTITIONED_LEVELS };
enum partitioned redcc_advise_partitioned(const struct chooser *chooser,
                                          struct inspection *inspection,
                                          const struct method **method);

/** Reports the result and the cost of a call; reason: why there was no plan, or NONE. */
void redcc_tell(struct chooser *chooser, const struct outcome *outcome, enum reason reason);

/** Reports that `came` of `asked` requested threads arrived and that `started` of these were new.
 * `seconds`: the time to start them or, if none was new, to wake all; 0: unknown. Thread-safe
 * except for the chooser. */
void redcc_tell_team(struct chooser *chooser, int asked, int came, double seconds, int started);

/** The row of auto's table that decided last. */
enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip);

/** How many of `threads` threads are worth waking for a loop of `trip` iterations? The loop has no
 * timed sequential execution, because that would give other sums. seconds: the time of its first
 * `iterations`. */
int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
