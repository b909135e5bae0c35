/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The choice of a way to execute a loop, as an online decision with a bound (docs/choosing.md
 * derives it): a bandit whose arms are the ways of base/way.h.
 *
 *     redcc_decide     what to do in this call: the sequential loop, an inspection, a way
 *     redcc_pick_way   within an inspection, when estimates are there: which way, if any
 *     redcc_observe    what came of it, and what it took
 *
 * No clock, no threads, no allocation: seconds come in with what is observed. Everything that may
 * take longer than the sequential loop is paid from the credit: a 32nd of the time that the
 * loop has taken, what was gained, and, for a plan that is expected to repay it soon, one loan.
 * Used by one thread at a time.
 */
#ifndef REDCC_LEARN_LEARNER_H
#define REDCC_LEARN_LEARNER_H

#include "base/way.h"
#include "learn/back_off.h"
#include "learn/rule.h"
#include "learn/turns.h"

#include <stdbool.h>

/** What is known of a way. */
struct arm {
    bool possible;
    bool ruled_out;   /**< it was tried and failed: not possible until the loop has rested */
    bool measured;    /**< `execution`, rather than estimated */
    bool guessed;     /**< `execution` is the least that it may be: only a trial can tell */
    double set_up;    /**< seconds, of an inspection and a plan, its sample included; estimated */
    double learned;   /**< seconds that one has taken, or at least takes; 0: none was made */
    double execution; /**< seconds an iteration, the check of a kept plan included */
};

/** Is a plan kept for what this call executes? A way without plans fits where the loop has a form
 *  for it, and is only tried where a sample said that it may be worth it. */
enum kept_match {
    KEPT_NONE,
    KEPT_CHANGED, /**< one for other subscripts, as a sample of them shows */
    KEPT_FITS     /**< as far as is known without reading all subscripts */
};

/** A call. */
struct situation {
    long long trip; /**< iterations */
    int threads;    /**< that would execute them */
    double wake;    /**< seconds that waking those takes, as measured */
    double start;   /**< seconds that starting those that are not there takes; 0: all are, or none
                         is to be woken (redcc_reach) */
    double spent;   /**< seconds of the inspection that this is asked in, so far */
    double dried;   /**< seconds of `spent` that its dry run took, */
    double awaited; /**< and that passed until threads came which were not there */
    enum kept_match kept[WAY_COUNT];
    int steady;    /**< calls in a row whose sampled subscripts were those of one of the last calls;
                        -1: not known */
    bool verified; /**< all subscripts were compared with those of the call before: they are the
                        same */
    bool dry_run;  /**< an inspection begins with a dry run, perhaps as long as the loop */
};

enum action {
    ACTION_SEQUENTIAL, /**< the original loop */
    ACTION_INSPECT,    /**< a sample, then as redcc_pick_way says; alone: the sample only */
    ACTION_REUSE       /**< a kept plan, of way `way`, or a way without one */
};

struct decision {
    enum action action;
    enum way way;
    bool alone;      /**< INSPECT: by one thread, for redcc_note_arms; no thread is started */
    bool timed;      /**< SEQUENTIAL: tell redcc_observe what it took */
    double deadline; /**< INSPECT: seconds after which a dry run must be given up; of
                          redcc_pick_way: the set-up */
    double may_lose; /**< REUSE, of a way that can stop where it turns out to be slower: seconds
                          after which it does; 0: it goes on */
    double earned;   /**< REUSE: seconds saved since the last set-up, less what that took */
    enum rule rule;
};

/** What came of a call. An inspection or a reuse that fails is followed by a sequential execution,
 *  which is reported as a separate result. A trial and the sequential rest of its execution are
 *  reported as one result. */
enum result {
    RESULT_SEQUENTIAL,
    RESULT_PARALLEL,     /**< after a set-up, where set_up > 0 */
    RESULT_UNATTRACTIVE, /**< the inspection ended with its sample: redcc_pick_way said so */
    RESULT_STOPPED,      /**< ... or at its deadline */
    RESULT_CHANGED,      /**< the kept plan's subscripts were others */
    RESULT_LEFT,         /**< a trial was slower than allowed; it went on sequentially, and ended */
    RESULT_REFUSED       /**< a guard, or memory, forbade it; way SEQUENTIAL: any other, too */
};

struct outcome {
    enum result result;
    enum way way;
    long long trip;
    double seconds; /**< of the execution; of UNATTRACTIVE, STOPPED, CHANGED, REFUSED: lost */
    double set_up;  /**< seconds, of PARALLEL with a new plan */
    double done;    /**< STOPPED: the part of the set-up that was done, 0 to 1 */
    double usual; /**< of a trial: seconds an iteration of the sequential loop, timed within it; 0:
                       not timed */
    long untimed; /**< SEQUENTIAL: executions before it that nobody timed, taken to be alike */
};

/** Where a loop stands, at trip counts of one size. */
enum stand {
    STAND_SAVING,    /**< sequential, until the credit allows a trial */
    STAND_COMPARING, /**< two ways take turns */
    STAND_PARALLEL,  /**< a way is faster than the sequential loop */
    STAND_SHORT,     /**< too short for threads to be woken: exponential back-off, not timed */
    STAND_RESTING    /**< sequential for some calls: exponential back-off */
};

/** The last three sequential executions, seconds an iteration. */
struct timings {
    double recent[3];
    long count;
};

/** Two ways take turns, the contender first. */
struct comparison {
    enum way contender, incumbent;
    struct turns turns;
};

/** Set-ups at one size. */
struct set_ups {
    double since;    /* sequential seconds since the last one */
    double factor;   /* of its estimated cost, which `since` must reach for another; 0: as at first
                      */
    double invested; /* seconds that the last one took */
    double earned;   /* and saved */
    int misses;      /* in a row that were abandoned before they had earned their cost */
    long begun;      /* the call that made the last one */
    long uses;       /* executions by it */
    long met;        /* calls before that one in a row that had its subscripts */
    long lifetime;   /* calls that had those of the plan before it, which others ended; 0: none */
};

struct size_state {
    enum stand stand;
    enum rule rule;
    enum way way; /* PARALLEL; RESTING after a comparison: the contender */
    int threads;
    int steady;       /* of the last call (situation.steady), not below 0 */
    bool looked;      /* the arms are known */
    bool gained;      /* the last execution by a way took less than the sequential loop */
    double look;      /* seconds that a sample took; 0: none was taken */
    double looked_at; /* seconds an iteration of the sequential loop, as they were then known */
    double unchecked; /* PARALLEL: seconds since the sequential loop was timed */
    int checks;       /* how often it was in a row, a plan being the faster way */
    long calls;
    struct timings sequential;
    struct arm arm[WAY_COUNT];
    struct comparison comparison;
    struct set_ups set_ups;
    struct back_off rest; /* until a call by its number */
};

/** Seconds of all sizes. */
struct ledger {
    double sequential; /* that the sequential loop has taken, or would have */
    double overhead;   /* taken beyond that; negative: gained */
    double loan; /* that may be lost beyond the credit, until it is repaid or its plan fails */
};

enum { REDCC_SIZES = 40 };

/** All that is known of a loop; zeroes at first. */
struct choice_state {
    struct ledger ledger;
    struct size_state size[REDCC_SIZES]; /* by the logarithm of the trip count */
};

/** Is this one of the calls in which a loop is left alone, but for the last of a rest? Then it is
 *  counted, and *decision tells: nothing has to be known of the call. */
bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads,
                         struct decision *decision);

/** What may be decided in a call. */
enum reach {
    REACH_NOTHING, /**< the sequential loop */
    REACH_LOOK,    /**< that, or a look by one thread */
    REACH_TEAM     /**< threads may be woken */
};

/** Of a loop that is saving and has no plan; of any other it is REACH_TEAM. start of *now is the
 *  least that it may be; kept is not looked at but for ways without plans. */
enum reach redcc_reach(const struct choice_state *state, const struct situation *now);

/** What to do in a call. */
struct decision redcc_decide(struct choice_state *state, const struct situation *now);

/** An inspection has sampled the loop (`spent` seconds so far): notes the arms [WAY_COUNT] and
 *  says which way is worth its set-up and within the credit, until what deadline, from now on;
 *  ACTION_SEQUENTIAL: none, and the inspection ends here (RESULT_UNATTRACTIVE). */
struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct arm *arm, double spent);

/** An inspection by one thread has sampled the loop, and ends here (RESULT_UNATTRACTIVE): notes the
 *  arms [WAY_COUNT]. */
void redcc_note_arms(struct choice_state *state, long long trip, const struct arm *arm,
                     double spent);

/** Takes in an outcome; of each decision exactly one with what was decided, then, where that
 *  failed, one more of the sequential loop if it is timed. */
void redcc_observe(struct choice_state *state, const struct outcome *outcome);

/** Seconds that may be lost now without passing the bound, a loan included; may be negative. */
double redcc_credit(const struct choice_state *state);

/** What is known at trip counts of that size. */
const struct size_state *redcc_size_of(const struct choice_state *state, long long trip);

/** Seconds an iteration of the sequential loop: the median of the last three executions, of two the
 *  lower. 0: not known. */
double redcc_usual(const struct size_state *size);

/** Seconds an iteration by that way. Estimates follow the sequential loop, whose first execution
 *  takes longer than others. */
double redcc_expected(const struct size_state *size, enum way way);

/** May that way be had, and is it worth a trial where an iteration takes `current` seconds? */
bool redcc_is_better(const struct size_state *size, enum way way, double current);

/** Did the last set-up not pay? How many in a row did not, that one included. */
int redcc_misses(const struct set_ups *set_ups);

/** How many times its cost `since` must reach for another set-up. */
double redcc_factor(const struct set_ups *set_ups);

/** Whose turn it is. */
enum way redcc_turn(const struct comparison *comparison);

/** Begins to compare two ways. */
void redcc_compare(struct size_state *size, enum way contender, enum way incumbent);

#endif
