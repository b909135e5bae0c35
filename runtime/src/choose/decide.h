/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The choice of a method as an online decision with a bound (docs/choosing.md derives it).
 *
 *     redcc_decide     what to do in this call: the sequential loop, an inspection, a kept plan
 *     redcc_pick_way   within an inspection, when estimates are there: which way, if any
 *     redcc_observe    what came of it, and what it took
 *
 * No clock, no threads, no allocation: seconds come in with what is observed. Everything that may
 * take longer than the sequential loop is paid from the credit: a 32nd of the time that the
 * loop has taken, what was gained, and, for a plan that is expected to repay it soon, one loan.
 * Used by one thread at a time.
 */
#ifndef REDCC_CHOOSE_DECIDE_H
#define REDCC_CHOOSE_DECIDE_H

#include "base/trial.h"
#include "base/way.h"
#include "choose/rule.h"

#include <stdbool.h>

/** What a way would cost. */
struct prospect {
    bool possible;
    bool ruled_out;   /**< it was tried and failed: not possible until the loop has rested */
    bool measured;    /**< `execution`, rather than estimated */
    double set_up;    /**< seconds, of an inspection and a plan, its sample included; estimated */
    double learned;   /**< seconds that one has taken, or at least takes; 0: none was made */
    double execution; /**< seconds an iteration, the check of a kept plan included */
};

/** Is a plan kept for what this call executes? WAY_BINS needs none: it fits where the loop has a
 * form for it, and is only tried where a sample said that it may be worth it. */
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
    ACTION_REUSE       /**< a kept plan, of way `way` */
};

struct decision {
    enum action action;
    enum way way;
    bool alone;      /**< INSPECT: by one thread, for redcc_note_prospects; no thread is started */
    bool timed;      /**< SEQUENTIAL: tell redcc_observe what it took */
    double deadline; /**< INSPECT: seconds after which a dry run must be given up; of
                          redcc_pick_way: the set-up */
    struct trial trial; /**< REUSE of WAY_BINS, where it may turn out to be slower */
    double earned;      /**< REUSE: seconds saved since the last set-up, less what that took */
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
    long untimed;   /**< SEQUENTIAL: executions before it that nobody timed, taken to be alike */
};

/** Where a loop stands, at trip counts of one size. */
enum stand {
    STAND_UNTIMED,   /**< never executed */
    STAND_SHORT,     /**< too short for threads to be woken */
    STAND_SAVING,    /**< sequential, until the credit allows a trial */
    STAND_COMPARING, /**< two ways take turns */
    STAND_PARALLEL,  /**< a plan is the faster way */
    STAND_RESTING    /**< sequential for some calls: exponential back-off */
};

/** The last three sequential executions, seconds an iteration. */
struct timings {
    double recent[3];
    long count;
};

/** Two ways executed in turn, so that both meet the machine as it is now. */
struct comparison {
    enum way contender, incumbent;
    bool incumbents_turn;
    int contended, defended;             /* executions */
    double contender_sum, incumbent_sum; /* seconds an iteration */
};

/** Set-ups at one size. */
struct set_ups {
    double since;    /* sequential seconds since the last one */
    double factor;   /* of its estimated cost, which `since` must reach for another */
    double invested; /* seconds that the last one took */
    double earned;   /* and saved */
    int misses;      /* in a row that were abandoned before they had earned their cost */
    long begun;      /* the call that made the last one */
    long uses;       /* executions by it */
    long met;        /* calls before that one in a row that had its subscripts */
    long lifetime;   /* calls that had those of the plan before it, which others ended; 0: none */
};

/** Exponential back-off. */
struct back_off {
    long calls, until, length;
};

struct size_state {
    enum stand stand;
    enum rule rule;
    enum way way; /* PARALLEL: of the plan */
    int threads;
    int steady;       /* of the last call (situation.steady), not below 0 */
    bool looked;      /* the prospects are known */
    bool gained;      /* the last execution by a plan took less than the sequential loop */
    double look;      /* seconds that a sample took; 0: none was taken */
    double looked_at; /* seconds an iteration of the sequential loop, as they were then known */
    double unchecked; /* PARALLEL: seconds since the sequential loop was timed */
    int checks; /* how often it was in a row, a plan being the faster way; DOUBLINGS at most */
    struct timings sequential;
    struct prospect prospect[WAY_COUNT];
    struct comparison comparison;
    struct set_ups set_ups;
    struct back_off rest;
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
 *  least that it may be; kept is not looked at but for WAY_BINS. */
enum reach redcc_reach(const struct choice_state *state, const struct situation *now);

/** What to do in a call. */
struct decision redcc_decide(struct choice_state *state, const struct situation *now);

/** An inspection has sampled the loop (`spent` seconds so far): notes the prospects [WAY_COUNT] and
 *  says which way is worth its set-up and within the credit, until what deadline, from now on;
 *  ACTION_SEQUENTIAL: none, and the inspection ends here (RESULT_UNATTRACTIVE). */
struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct prospect *prospect, double spent);

/** An inspection by one thread has sampled the loop, and ends here (RESULT_UNATTRACTIVE): notes the
 *  prospects [WAY_COUNT]. */
void redcc_note_prospects(struct choice_state *state, long long trip,
                          const struct prospect *prospect, double spent);

/** Takes in an outcome; of each decision exactly one with what was decided, then, where that
 *  failed, one more of the sequential loop if it is timed. */
void redcc_observe(struct choice_state *state, const struct outcome *outcome);

/** Seconds that may be lost now without passing the bound, a loan included; may be negative. */
double redcc_credit(const struct choice_state *state);

/** Seconds of a sequential execution, as they were lately: the median of three. 0: not known. */
double redcc_usual_sequential(const struct choice_state *state, long long trip);

/** How many sequential executions of this size were timed. */
long redcc_timings_of(const struct choice_state *state, long long trip);

/** The row that decided last at this size. */
enum rule redcc_rule_of(const struct choice_state *state, long long trip);

#endif
