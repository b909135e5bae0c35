/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses a strategy for executing a loop, as an online decision with a bound, which
 * docs/choosing.md derives. It is a multi-armed bandit: a problem of choosing repeatedly among arms
 * of unknown reward. The arms are the strategies of base/way.h.
 *
 *     redcc_decide     the action in this call: the sequential loop, an inspection, a strategy
 *     redcc_pick_way   within an inspection, with estimates: the strategy, if any
 *     redcc_observe    the result of the action, and its time
 *
 * The learner uses no clock, no threads and no memory of its own: times come with the observations.
 * Any action that may take longer than the sequential loop is paid from the credit. The credit is a
 * 32nd of the loop's time so far, plus past gains, plus at most one overdraft. An overdraft is
 * allowed for a plan that is expected to repay it soon. One thread at a time decides for a loop.
 */
#ifndef REDCC_LEARN_LEARNER_H
#define REDCC_LEARN_LEARNER_H

#include "base/way.h"
#include "learn/back_off.h"
#include "learn/paired_timing.h"
#include "learn/rule.h"

#include <stdbool.h>

/** The times of the last three executions, in seconds per iteration. */
struct timings {
    double recent[3];
    long count;
};

/** What is estimated and measured of a strategy. */
struct arm {
    bool possible;
    bool ruled_out; /**< a trial failed; the strategy is unavailable until the loop's back-off ends
                     */
    bool guessed;   /**< `execution` is only a lower bound, and a trial is needed to determine it */
    double set_up;  /**< estimated seconds of an inspection and a plan construction, including the
                       sample */
    double learned; /**< `set_up` as measured, or a lower bound of it; 0: not measured */
    double execution; /**< seconds per iteration, including the check of a kept plan; estimated */
    struct timings timed; /**< the times of measured executions */
};

/** Is there a kept plan of a strategy for this call? A strategy without plans counts as KEPT_FITS
 * if the loop has a form for it; it is usually tried only if a sample suggests that it may pay. */
enum kept_match {
    KEPT_NONE,
    KEPT_CHANGED, /**< there is one, but a sample shows that it is for other subscripts */
    KEPT_FITS /**< there is one that fits; the full contents of the subscripts were not compared yet
               */
};

/** What is known about a call when a decision is made. */
struct situation {
    long long trip; /**< number of iterations */
    int threads;    /**< number of threads that would execute them */
    double wake;    /**< measured seconds to wake these threads */
    double start;   /**< seconds to start the threads that do not exist yet, or a lower bound
                       (redcc_reach); 0: all exist */
    double spent;   /**< seconds of the current inspection so far */
    double dried;   /**< the part of `spent` that the dry run took */
    double awaited; /**< the part of `spent` that was spent waiting for threads that had to be
                       started */
    enum kept_match kept[WAY_COUNT];
    int steady; /**< number of consecutive calls whose sampled subscripts were those of one of the
                   last calls; -1: unknown */
    bool verified;  /**< all subscripts were found equal to those of the call before */
    bool dry_run;   /**< an inspection begins with a dry run, which may take as long as the loop */
    bool bins_only; /**< the loop cannot be inspected */
    bool whole;     /**< bins must push all iterations before they apply any (REDCC_WHOLE) */
    bool begun;     /**< the call is the rest of the first execution, whose first iterations were
                       executed in order and timed. A strategy that pays in this call alone is then not
                       delayed */
    bool tiled; /**< the inspection is short, because the loop is over pairs or has REDCC_BLOCKS */
    bool in_tiles; /**< the loop may be cut into tiles, so that WAY_DIRECT needs no estimate */
    bool measured; /**< this call's inspection has timed the slice */
};

enum action {
    ACTION_SEQUENTIAL, /**< execute the original loop */
    ACTION_INSPECT, /**< take a sample, then continue as redcc_pick_way decides; if `alone` is set,
                       only take the sample */
    ACTION_REUSE    /**< use a kept plan of strategy `way`, or a strategy without plans */
};

struct decision {
    enum action action;
    enum way way;
    bool alone;      /**< with ACTION_INSPECT: one thread takes the sample, for redcc_note_arms */
    bool timed;      /**< with ACTION_SEQUENTIAL: its time must be reported to redcc_observe */
    double deadline; /**< with ACTION_INSPECT: time limit of a dry run, in seconds; from
                        redcc_pick_way: time limit of the plan construction */
    double may_lose; /**< with ACTION_REUSE of a strategy that can stop when it is slower: the
                        seconds that it may lose. At least -1 and below 0: minus a share of the
                        sequential loop's time. 0: no limit */
    double earned; /**< with ACTION_REUSE: seconds saved since the last plan construction, minus its
                      cost */
    enum rule rule;
};

/** The result of a call. If an inspection or a reuse fails, the sequential execution that follows
 * is reported as a separate result. In a trial that stops in the middle, the trial and the
 * iterations that run sequentially are one result. */
enum result {
    RESULT_SEQUENTIAL,
    RESULT_PARALLEL,     /**< preceded by a plan construction if set_up > 0 */
    RESULT_UNATTRACTIVE, /**< the inspection ended after its sample, as redcc_pick_way decided */
    RESULT_STOPPED,      /**< the inspection ended, because it reached its deadline */
    RESULT_CHANGED,      /**< the subscripts of the kept plan have changed */
    RESULT_LEFT, /**< a trial was slower than allowed, and the rest of the loop ran sequentially */
    RESULT_REFUSED /**< a guard forbade the strategy, or there was no memory; WAY_SEQUENTIAL: this
                      concerns all strategies */
};

struct outcome {
    enum result result;
    enum way way;
    long long trip;
    double seconds; /**< the time of the execution; for RESULT_UNATTRACTIVE, _STOPPED, _CHANGED and
                       _REFUSED, the time that was lost */
    double set_up;  /**< with RESULT_PARALLEL: seconds that the construction of a new plan took; 0:
                       the plan was not new */
    /** with RESULT_STOPPED: the completed fraction of the plan construction, 0 to 1 */
    double done;
    double usual; /**< in a trial: seconds per iteration of the sequential loop, timed within the
                     trial; 0: not timed */
    long untimed; /**< with RESULT_SEQUENTIAL: number of untimed executions before this one; they
                     are assumed to have taken the same time */
};

/** The phase of a loop at trip counts of one size. */
enum phase {
    PHASE_SAVING,    /**< the loop is sequential until the credit permits a trial */
    PHASE_COMPARING, /**< two strategies are executed alternately */
    PHASE_PARALLEL,  /**< a strategy is faster than the sequential loop */
    PHASE_SHORT,     /**< the loop is too short for waking threads, and waits (exponential back-off)
                        without timing */
    PHASE_BACK_OFF   /**< the loop is sequential for a number of calls (exponential back-off) */
};

/** A comparison of two strategies, which are executed alternately, the contender first. */
struct comparison {
    enum way contender, incumbent;
    bool proven; /**< the contender is in use already. It is abandoned only after all pairs were
                    timed */
    struct paired_timing pairs;
};

/** The plan constructions at trip counts of one size. */
struct set_ups {
    double since;  /* seconds since the last construction that the sequential loop has taken, or
                      would have taken in parallel executions */
    double factor; /* multiple of a construction's estimated cost that `since` must reach before the
                      next construction; 0: the initial multiple */
    double invested; /* seconds that the last construction took */
    double earned;   /* seconds that executions have saved since the last construction */
    int misses;    /* number of consecutive constructions whose plans were abandoned before they had
                      saved as much as they cost */
    long begun;    /* number of the call that made the last construction */
    long uses;     /* number of parallel executions since the last construction */
    long met;      /* number of consecutive calls before the last construction that had the same
                      subscripts */
    long lifetime; /* number of calls for which the subscripts of the previous plan lasted; 0: no
                      plan was ended by a change of subscripts */
};

struct size_state {
    enum phase phase;
    enum rule rule;
    enum way way; /* in PHASE_PARALLEL: the strategy in use; in PHASE_BACK_OFF after a comparison:
                     the contender */
    int threads;
    int steady;       /* situation.steady of the last call, or 0 if it was negative */
    bool looked;      /* a sample was taken, so that estimates for all strategies are in `arm` */
    double look;      /* seconds that the last sample took; 0: none was taken */
    double looked_at; /* seconds per iteration of the sequential loop when that sample was taken */
    double gained; /* seconds that strategies gained in the last execution or, while the credit is
                      negative, since it became negative */
    double unchecked; /* in PHASE_PARALLEL: seconds since the sequential loop was timed */
    int checks;       /* number of consecutive checks in which a plan was faster */
    long calls;
    struct timings sequential;
    struct arm arm[WAY_COUNT];
    struct comparison comparison;
    struct set_ups set_ups;
    struct back_off back_off; /* counted in calls */
};

/** The times of a loop over all sizes, in seconds. */
struct ledger {
    double sequential; /* time that the sequential loop has taken, or would have taken */
    double overhead;   /* time taken in addition to that; negative: time gained */
    double overdraft; /* seconds that may be lost beyond the credit; 0 again once they are repaid or
                         the plan fails */
};

enum { REDCC_SIZES = 40 };

/** The complete state of a loop; initially zero. */
struct choice_state {
    struct ledger ledger;
    struct size_state size[REDCC_SIZES]; /* indexed by the base-2 logarithm of the trip count */
};

/** Is the loop left sequential in this call, because a back-off is not near its end? If so, counts
 * the call and sets *decision. Needs no further information about the call. */
bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads,
                         struct decision *decision);

/** The feasible actions in a call. */
enum reach {
    REACH_NOTHING, /**< only the sequential loop */
    REACH_LOOK,    /**< the sequential loop, or a sample taken by one thread */
    REACH_TEAM     /**< any action, also with threads that must be woken */
};

/** May the first execution be a trial of bins that times the sequential loop as well? */
bool redcc_goes_at_once(const struct situation *now);

/** The actions that a loop can afford, if it is in PHASE_SAVING and has no plan; otherwise
 * REACH_TEAM. In *now, `start` is a lower bound, and `kept` is ignored except for strategies
 * without plans. */
enum reach redcc_reach(const struct choice_state *state, const struct situation *now);

/** Decides the action in a call. */
struct decision redcc_decide(struct choice_state *state, const struct situation *now);

/** Called when an inspection has sampled the loop; this took `spent` seconds. Stores the estimates
 * arm[WAY_COUNT]. Returns a decision for the strategy whose plan construction pays and is within
 * the credit; its deadline begins now. ACTION_SEQUENTIAL: there is no such strategy, and the
 * inspection ends (RESULT_UNATTRACTIVE). */
struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct arm *arm, double spent);

/** Called when one thread has sampled the loop, in an inspection that ends after this
 * (RESULT_UNATTRACTIVE). Stores the estimates arm[WAY_COUNT]. */
void redcc_note_arms(struct choice_state *state, long long trip, const struct arm *arm,
                     double spent);

/** Records that the first `done` iterations of the loop's first execution were executed in order,
 * in `seconds`. The next decision is about the remaining `rest` iterations. */
void redcc_note_begin(struct choice_state *state, long long rest, long long done, double seconds);

/** Processes a result. Each decision must be followed by exactly one call with the result of its
 * action. If that action failed and the sequential loop is timed, a second call has the sequential
 * result. */
void redcc_observe(struct choice_state *state, const struct outcome *outcome);

/** The seconds that may be lost now within the bound, including an overdraft; negative if more was
 * lost. */
double redcc_credit(const struct choice_state *state);

/** The state at trip counts of the size of `trip`. */
const struct size_state *redcc_size_of(const struct choice_state *state, long long trip);

/** Seconds per iteration: the median of the last three executions, so that one interruption has no
 * effect. It is the lower of two times if there are only two, and 0 if there are none. */
double redcc_typical(const struct timings *timings);

/** redcc_typical for the sequential loop. */
double redcc_usual(const struct size_state *size);

/** The expected seconds per iteration with that strategy. Estimates are scaled by the sequential
 * loop's present time, because they are based on the first execution, which takes longer. */
double redcc_expected(const struct size_state *size, enum way way);

/** Is that strategy possible, and worth a trial if an iteration now takes `current` seconds? */
bool redcc_is_better(const struct size_state *size, enum way way, double current);

/** The number of consecutive plan constructions that did not pay, including the last one. */
int redcc_misses(const struct set_ups *set_ups);

/** The multiple of a construction's cost that `since` must reach before the next construction. */
double redcc_factor(const struct set_ups *set_ups);

/** The strategy to execute next in the comparison. */
enum way redcc_arm_to_run(const struct comparison *comparison);

/** Begins to compare two strategies. */
void redcc_compare(struct size_state *size, enum way contender, enum way incumbent);

#endif
