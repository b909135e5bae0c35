/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Simulates the decision code of `auto` (runtime/src/learn/learner.h) with a virtual clock. A trace
 * gives the time of each call of a loop by each strategy. The decisions are executed as the runtime
 * would execute them, but without threads. Only the decision code belongs to the runtime.
 */
#ifndef CHOOSE_SIMULATOR_H
#define CHOOSE_SIMULATOR_H

#include "learn/learner.h"

enum { SIMULATED_CALLS = 2000 };

/** One call of the loop. */
struct simulated_call {
    long long trip;
    double sequential;           /**< seconds */
    double execution[WAY_COUNT]; /**< seconds of an execution by each strategy, including the check
                                    of a plan; element 0 is unused */
    int subscripts; /**< identifies the subscripts: a plan fits only calls with the same number */
};

struct trace {
    int count;
    struct simulated_call call[SIMULATED_CALLS];
    bool possible[WAY_COUNT];
    bool guessed;             /**< only a trial shows how long binning takes */
    double set_up[WAY_COUNT]; /**< true seconds per iteration of a plan construction */
    double set_up_error;      /**< ratio of the estimated to the true time of plan constructions */
    double execution_error;   /**< ratio of the estimated to the true time of executions */
    double look;              /**< seconds that a sample takes */
    double dry_run;     /**< seconds per iteration of a dry run before each sample, or 0 without dry
                           runs */
    double check;       /**< time to find that subscripts changed, as a fraction of a sequential
                           execution */
    double wake;        /**< seconds that waking the threads takes */
    double start;       /**< seconds that starting the threads takes, once */
    double late;        /**< additional seconds that starting takes unexpectedly */
    double overrun;     /**< seconds by which plan constructions take longer without checking the
                           clock */
    double block;       /**< seconds by which a deadline is passed */
    bool hidden;        /**< a sample of the subscripts does not show their changes */
    bool compared;      /**< all subscripts are compared with those of the preceding call */
    int refused_from;   /**< first call in which a guard forbids binning, or 0 if none does */
    double refusal;     /**< seconds until the guard forbids binning */
    bool no_inspection; /**< a guard forbids every plan, after the sample was taken */
};

struct simulated {
    double total;
    double sequential;   /**< seconds of the sequential program */
    double best;         /**< seconds of the best single strategy in hindsight, with its plan
                            constructions */
    double worst_prefix; /**< largest of (total - allowance) / sequential over all prefixes */
    double slowest;   /**< largest of total / sequential over all prefixes, without the allowance */
    double allowance; /**< the bound's additive constant: twice the largest excess of an execution
                         over the sequential one, a block or a sample, and the largest overdraft */
    double owed;      /**< the overdraft at the end, seconds */
    double overdraft; /**< the largest overdraft, divided by the longest sequential execution */
    int looks;        /**< samples taken by one thread */
    int set_ups;      /**< plan constructions begun */
    int stopped;      /**< samples that ended at their deadline */
    int parallel;     /**< executions by a plan */
    int left;         /**< trials of binning that stopped early */
    int refused;      /**< executions by binning that a guard forbade */
    int left_alone;   /**< calls in which, by redcc_reach, no parallel action was affordable
                       */
};

/** Simulates the trace, beginning with a zero state. Asserts that redcc_reach, which is called
 * without kept plans and with half of the starting time, permits each decision. */
struct simulated simulate(const struct trace *trace);

#endif
