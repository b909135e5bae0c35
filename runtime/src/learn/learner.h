/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The choice of a strategy for executing a loop, as an online decision with a bound (derived in
 * docs/choosing.md): a bandit whose arms are the strategies of base/way.h.
 *
 *     redcc_decide     the action in this call: the sequential loop, an inspection, a strategy
 *     redcc_pick_way   within an inspection, with estimates: the strategy, if any
 *     redcc_observe    the result of the action, and its time
 *
 * No clock, no threads, no allocation: times come with the observations. Any action that may take
 * longer than the sequential loop is paid from the credit. The credit is a 32nd of the loop's time
 * so far, past gains, and one overdraft at a time, for a plan that is expected to repay it soon.
 * Used by one thread at a time.
 */
#ifndef REDCC_LEARN_LEARNER_H
#define REDCC_LEARN_LEARNER_H

#include "base/way.h"
#include "learn/back_off.h"
#include "learn/paired_timing.h"
#include "learn/rule.h"

#include <stdbool.h>

/** The last three executions, seconds per iteration. */
struct timings {
    double recent[3];
    long count;
};

/** Estimates and measurements of a strategy. */
struct arm {
    bool possible;
    bool ruled_out;   /**< a trial failed: not available until the loop's back-off ends */
    bool guessed;     /**< `execution` is a lower bound: only a trial can determine it */
    double set_up;    /**< seconds of an inspection and a plan, including the sample; estimated */
    double learned;   /**< measured seconds of the same, or a lower bound; 0: none */
    double execution; /**< seconds per iteration, including the check of a kept plan; estimated */
    struct timings timed; /**< the measured executions */
};

/** Is there a kept plan for this call? A strategy without plans fits if the loop has a form for it,
 * and is usually tried only if a sample suggested that it may pay. */
enum kept_match {
    KEPT_NONE,
    KEPT_CHANGED, /**< one for other subscripts, according to a sample */
    KEPT_FITS     /**< according to everything but the full contents of the subscripts */
};

/** A call. */
struct situation {
    long long trip; /**< iterations */
    int threads;    /**< threads that would execute these */
    double wake;    /**< measured seconds to wake them */
    double start; /**< seconds to start the missing ones, or a lower bound (redcc_reach); 0: none is
                     missing */
    double spent; /**< seconds of the current inspection so far */
    double dried; /**< of `spent`: seconds of the dry run */
    double awaited; /**< of `spent`: seconds of waiting for threads that had to be started */
    enum kept_match kept[WAY_COUNT];
    int steady;     /**< consecutive calls whose sampled subscripts were those of one of the last
                     * calls; -1: unknown */
    bool verified;  /**< all subscripts were compared with those of the preceding call: they are
                     * equal */
    bool dry_run;   /**< an inspection begins with a dry run, perhaps as long as the loop */
    bool bins_only; /**< the loop cannot be inspected */
    bool whole;     /**< bins must push all iterations before they apply any (REDCC_WHOLE) */
    bool begun;     /**< the call is the rest of the first execution, whose first iterations were
                       timed in order: a strategy that pays in this call alone is not delayed */
    bool tiled;     /**< the inspection is short: a loop over pairs, or REDCC_BLOCKS */
    bool in_tiles;  /**< the loop may be cut into tiles, so that WAY_DIRECT needs no estimate */
};

enum action {
    ACTION_SEQUENTIAL, /**< the original loop */
    ACTION_INSPECT,    /**< a sample, then as redcc_pick_way decides; alone: the sample only */
    ACTION_REUSE       /**< a kept plan, of strategy `way`, or a strategy without one */
};

struct decision {
    enum action action;
    enum way way;
    bool alone;      /**< INSPECT: one thread takes the sample, for redcc_note_arms */
    bool timed;      /**< SEQUENTIAL: report its time to redcc_observe */
    double deadline; /**< INSPECT: time limit of a dry run, in seconds; of redcc_pick_way: of the
                      * plan construction */
    double may_lose; /**< REUSE, of a strategy that can stop when it is slower: the seconds it may
                      * lose; from -1 to below 0: a share of the sequential loop's time; 0:
                      * no limit */
    double earned;   /**< REUSE: seconds saved since the last plan construction, less its cost */
    enum rule rule;
};

/** The result of a call. An inspection or a reuse that fails is followed by a sequential execution,
 *  which is reported as a separate result. A trial and the sequential rest of its execution are one
 *  result. */
enum result {
    RESULT_SEQUENTIAL,
    RESULT_PARALLEL,     /**< after a plan construction, if set_up > 0 */
    RESULT_UNATTRACTIVE, /**< the inspection ended after its sample, by redcc_pick_way's decision */
    RESULT_STOPPED,      /**< the inspection ended at its deadline */
    RESULT_CHANGED,      /**< the kept plan's subscripts have changed */
    RESULT_LEFT,         /**< a trial was slower than allowed; the rest ran sequentially */
    RESULT_REFUSED       /**< a guard, or memory, forbade it; way SEQUENTIAL: all strategies */
};

struct outcome {
    enum result result;
    enum way way;
    long long trip;
    double seconds; /**< the execution's time; for UNATTRACTIVE, STOPPED, CHANGED and REFUSED the
                       lost time */
    double set_up;  /**< PARALLEL with a new plan: seconds that its construction took */
    double done;    /**< STOPPED: the completed fraction of the plan construction, 0 to 1 */
    double usual; /**< trial: seconds per iteration of the sequential loop, timed within the trial;
                     0: not timed */
    long untimed; /**< SEQUENTIAL: untimed executions before it, assumed to take the same time */
};

/** The phase of a loop at trip counts of one size. */
enum phase {
    PHASE_SAVING,    /**< sequential, until the credit permits a trial */
    PHASE_COMPARING, /**< two strategies alternate */
    PHASE_PARALLEL,  /**< a strategy is faster than the sequential loop */
    PHASE_SHORT,     /**< too short to wake threads: exponential back-off, not timed */
    PHASE_BACK_OFF   /**< sequential for some calls: exponential back-off */
};

/** Two strategies alternate, the contender first. */
struct comparison {
    enum way contender, incumbent;
    bool proven; /**< the contender is in use, and loses only after all pairs */
    struct paired_timing pairs;
};

/** Plan constructions at one size. */
struct set_ups {
    double since;  /* seconds that the sequential loop took, or would have taken, since the last */
    double factor; /* multiple of its estimated cost that `since` must reach for another; 0: the
                      initial multiple */
    double invested; /* seconds that the last one took */
    double earned;   /* seconds that executions have saved since */
    int misses;    /* consecutive constructions whose plans were abandoned before they had saved as
                      much as they cost */
    long begun;    /* the call that made the last one */
    long uses;     /* parallel executions since */
    long met;      /* consecutive calls before that one that had the same subscripts */
    long lifetime; /* calls that the subscripts of the preceding plan lasted; 0: no plan ended by a
                      change */
};

struct size_state {
    enum phase phase;
    enum rule rule;
    enum way way; /* PARALLEL: the strategy in use; BACK_OFF after a comparison: the contender */
    int threads;
    int steady;       /* situation.steady of the last call, at least 0 */
    bool looked;      /* a sample was taken, so that the arms are known */
    double look;      /* seconds that a sample took; 0: none was taken */
    double looked_at; /* seconds per iteration of the sequential loop at the time of that sample */
    double gained; /* seconds gained by strategies: in the last execution or, while there is a debt,
                      since it began */
    double unchecked; /* PARALLEL: seconds since the sequential loop was timed */
    int checks;       /* consecutive checks in which a plan was faster */
    long calls;
    struct timings sequential;
    struct arm arm[WAY_COUNT];
    struct comparison comparison;
    struct set_ups set_ups;
    struct back_off back_off; /* counts calls */
};

/** Seconds of all sizes. */
struct ledger {
    double sequential; /* that the sequential loop has taken, or would have */
    double overhead;   /* seconds taken in addition; negative: gained */
    double overdraft;  /* seconds that may be lost beyond the credit, until they are repaid or the
                          plan fails */
};

enum { REDCC_SIZES = 40 };

/** The complete state of a loop; initially zero. */
struct choice_state {
    struct ledger ledger;
    struct size_state size[REDCC_SIZES]; /* by the logarithm of the trip count */
};

/** Is the loop left sequential in this call, within a back-off but not at its end? Then counts the
 *  call and sets *decision, without further information about the call. */
bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads,
                         struct decision *decision);

/** The feasible actions in a call. */
enum reach {
    REACH_NOTHING, /**< the sequential loop */
    REACH_LOOK,    /**< the sequential loop, or a sample by one thread */
    REACH_TEAM     /**< threads may be woken */
};

/** May the first execution be a trial of bins, which times the sequential loop as well? */
bool redcc_goes_at_once(const struct situation *now);

/** The actions that a loop in PHASE_SAVING without a plan can afford; for other loops REACH_TEAM.
 * In *now, `start` is a lower bound, and `kept` is ignored except for strategies without plans. */
enum reach redcc_reach(const struct choice_state *state, const struct situation *now);

/** The action in a call. */
struct decision redcc_decide(struct choice_state *state, const struct situation *now);

/** An inspection has sampled the loop (`spent` seconds so far): stores the arms [WAY_COUNT].
 * Returns the strategy whose plan construction pays and is within the credit, with its deadline
 * from now on. ACTION_SEQUENTIAL: none, and the inspection ends here (RESULT_UNATTRACTIVE). */
struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct arm *arm, double spent);

/** An inspection by one thread has sampled the loop, and ends here (RESULT_UNATTRACTIVE): stores
 *  the arms [WAY_COUNT]. */
void redcc_note_arms(struct choice_state *state, long long trip, const struct arm *arm,
                     double spent);

/** The first `done` iterations of the loop's first execution were executed in order, in `seconds`;
 *  `rest` are left, to be decided next. */
void redcc_note_begin(struct choice_state *state, long long rest, long long done, double seconds);

/** Processes a result: for each decision exactly one with the chosen action, then, if that failed,
 *  another one of the sequential loop if it is timed. */
void redcc_observe(struct choice_state *state, const struct outcome *outcome);

/** Seconds that may be lost now within the bound, including an overdraft; may be negative. */
double redcc_credit(const struct choice_state *state);

/** The state at trip counts of that size. */
const struct size_state *redcc_size_of(const struct choice_state *state, long long trip);

/** Seconds per iteration: the median of the last three executions, so that one interruption has no
 * effect; the lower of two; 0: unknown. */
double redcc_typical(const struct timings *timings);

/** The same for the sequential loop. */
double redcc_usual(const struct size_state *size);

/** Seconds per iteration by that strategy. Estimates are scaled by the sequential loop's time,
 * since its first execution takes longer. */
double redcc_expected(const struct size_state *size, enum way way);

/** Is that strategy feasible, and worth a trial when an iteration takes `current` seconds? */
bool redcc_is_better(const struct size_state *size, enum way way, double current);

/** The number of consecutive plan constructions that did not pay, including the last one. */
int redcc_misses(const struct set_ups *set_ups);

/** The multiple of its cost that `since` must reach for another plan construction. */
double redcc_factor(const struct set_ups *set_ups);

/** The strategy to execute next. */
enum way redcc_arm_to_run(const struct comparison *comparison);

/** Begins to compare two strategies. */
void redcc_compare(struct size_state *size, enum way contender, enum way incumbent);

#endif
