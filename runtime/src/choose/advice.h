/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The seam between the pipeline and what chooses: every question that REDCC_METHOD=auto answers,
 * and everything that it is told, in the order in which a call comes to it. Nothing else calls the
 * decision core (learner.h); where a method is named it is not asked, and these functions answer by
 * the method.
 *
 *     at entry              redcc_advise_rest, redcc_advise_saving, redcc_advise_entry
 *     after the sample      redcc_advise_sampled
 *     after the sweep       redcc_advise_swept; where it was kept, redcc_advise_logged
 *     after the partition   redcc_advise_partitioned
 *     after the execution   redcc_tell, also of the sequential loop; redcc_advise_timed
 *
 * One thread at a time uses a chooser: the one that holds the loop, or that a stage's end runs in.
 */
#ifndef REDCC_ADVICE_H
#define REDCC_ADVICE_H

#include "inspect/inspection.h"
#include "learn/learner.h"
#include "plan/method.h"
#include "reuse/kept.h"

/** What auto knows of a loop; zeroes at first. */
struct chooser {
    struct choice_state state;
    uint64_t sample;               /* of this call's subscripts (redcc_reuse_sample); 0: none */
    enum reach reach;              /* of this call */
    uint64_t sampled[REDCC_PLANS]; /* samples, the last met first */
    int steady;                    /* calls in a row that had one of these */
    struct fingerprint all;        /* of all subscripts, after the last call; where remembered */
    bool remembered;
    bool verified;       /* all were compared once, and the samples have been the same since */
    int asked, came;     /* threads, in the last parallel region */
    long skipped;        /* sequential calls since a plan was used */
    enum reason refused; /* why no plan could be had, last */
};

/** What auto says at entry. */
struct advice {
    enum action action;
    enum way way;       /* REUSE; INSPECT: as soon as it is decided */
    bool timed;         /* SEQUENTIAL */
    bool alone;         /* INSPECT: a look, by one thread; a set-up is another call's */
    double deadline;    /* INSPECT: seconds that a dry run may take */
    double awaited;     /* INSPECT: seconds that passed until threads came which were not there */
    double may_lose;    /* REUSE, of a trial: seconds; 0: it is none */
    long skipped_calls; /* REUSE: that were sequential since a plan was used */
    double earned;      /* REUSE: seconds saved since the last set-up, less what that took */
    enum reason reason; /* for SEQUENTIAL */
    enum rule rule;
};

/** By owners without an inspection of who executes what? It has no plan that could be used again.
 */
static inline bool redcc_goes_directly(const struct advice *advice) {
    return advice->action == ACTION_REUSE && advice->way == WAY_DIRECT;
}

/** Is this a call in which the loop is left alone, since it is short or nothing served it lately?
 *  Then *advice says so, for a compare and a counter. */
bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads, struct advice *advice);

/** For a call that redcc_advise_rest had nothing to say of: samples its subscripts. Is there
 * nothing that may be begun, whatever threads cost? Then *advice says so, before anything is looked
 * for that only a parallel execution needs. */
bool redcc_advise_saving(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                         redcc_int trip, int threads, struct advice *advice);

/** For a call that neither had anything to say of. */
struct advice redcc_advise_entry(struct chooser *chooser, struct reuse *reuse, int threads);

/** The original loop was timed, and redcc_tell knows. Where it was the first time, samples the
 * subscripts, unless that was done at entry; and where comparing all of them costs next to nothing,
 * keeps their fingerprint for the next call. */
void redcc_advise_timed(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                        redcc_int trip, double seconds);

/** Of the sample: what of it auto goes by. */
bool redcc_wants_estimate(const struct inspection *inspection);

/** How shall the inspection go on? SERIAL: it is not worth it. May join stealable blocks of the
 *  partition to their owners, or make it one piece. Sets entry->way, and the deadline. */
enum route redcc_advise_sampled(struct chooser *chooser, struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate);

/** By what method, now that the access summaries are there? reusable: the plan can be kept. NULL:
 *  by none, it would be slower than the original loop. */
const struct method *redcc_advise_swept(const struct chooser *chooser,
                                        const struct inspection *inspection, bool reusable);

/** Do memory and what is touched allow private copies? */
bool redcc_copies_allowed(const struct inspection *inspection);

/** By what method, all touches being kept? May add stealable blocks to the partition. reusable, and
 *  NULL: as above; owners cut from the graph do not pay for themselves in one execution. */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection, bool reusable);

/** The owners cannot be cut from the access graph. */
void redcc_tell_no_graph(struct advice *entry);

/** The owners are cut. *method stays, or changes. JOIN: the stealable blocks, which the partition
 * has no longer, are to be joined to their owners; LEVELS: inspection->levels are there to be used.
 */
enum partitioned { PARTITIONED_KEEP, PARTITIONED_JOIN, PARTITIONED_LEVELS };
enum partitioned redcc_advise_partitioned(const struct chooser *chooser,
                                          struct inspection *inspection,
                                          const struct method **method);

/** What came of a call, and what it took; reason: why there was no plan, or NONE. */
void redcc_tell(struct chooser *chooser, const struct outcome *outcome, enum reason reason);

/** So many threads came where `asked` were asked for, of which so many were started, and that, or
 *  else waking them, took `seconds`; 0: not known. Thread-safe but for the chooser. */
void redcc_tell_team(struct chooser *chooser, int asked, int came, double seconds, int started);

/** The row of auto's table that decided last. */
enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip);

/** How many of `threads` are worth waking for a loop of `trip` iterations that no sequential loop
 *  can be timed against, since none gives its sums. seconds: what `iterations` of it have taken so
 *  far. */
int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations);

#endif
