/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The decision code of `auto` (runtime/src/learn/learner.h) against a virtual clock: what each call
 * of a loop would take by each way is given, and the decisions are carried out as the runtime
 * would, without threads. Apart from the decision code this knows nothing of it.
 */
#ifndef CHOOSE_SIMULATOR_H
#define CHOOSE_SIMULATOR_H

#include "learn/learner.h"

enum { SIMULATED_CALLS = 2000 };

/** One call of the loop. */
struct simulated_call {
    long long trip;
    double sequential;           /**< seconds */
    double execution[WAY_COUNT]; /**< seconds by a plan, its check included; [0] unused */
    int subscripts;              /**< a plan serves only calls with the same number */
};

struct trace {
    int count;
    struct simulated_call call[SIMULATED_CALLS];
    bool possible[WAY_COUNT];
    bool guessed;             /**< of bins nothing is known before they are tried */
    double set_up[WAY_COUNT]; /**< seconds an iteration, in truth */
    double set_up_error;      /**< estimated over true */
    double execution_error;   /**< the same, of executions */
    double look;              /**< seconds of a sample */
    double dry_run;           /**< seconds an iteration, before each sample; 0: there is none */
    double check;             /**< of a sequential execution: to find that subscripts changed */
    double wake;              /**< seconds */
    double start;             /**< seconds that starting the threads takes, once, */
    double late;              /**< and by which it takes longer than that */
    double overrun;           /**< by which a set-up takes longer, with no look at the clock */
    double block;             /**< seconds by which a deadline is passed */
    bool hidden;              /**< a sample of the subscripts does not show that they changed */
    bool compared;            /**< all of them are compared with those of the call before */
    int refused_from;         /**< call from which on a guard forbids bins; 0: none, */
    double refusal;           /**< after so many seconds */
    bool no_inspection;       /**< a guard forbids all that is inspected, after the sample */
};

struct simulated {
    double total;
    double sequential;   /**< seconds of the sequential program */
    double best;         /**< of the best single way in hindsight, its set-ups included */
    double worst_prefix; /**< largest of (total - allowance) / sequential over all prefixes */
    double slowest;      /**< largest of total / sequential, nothing allowed for */
    double allowance; /**< the bound's additive constant: twice the largest excess of an execution
                           over the sequential one, a block or a sample, and the largest loan */
    double owed;      /**< what is lent at the end, seconds */
    double loan;      /**< the largest, over the longest sequential execution */
    int looks;        /**< by one thread */
    int set_ups;      /**< begun; */
    int stopped;      /**< of them, at their deadline */
    int parallel;     /**< executions by a plan */
    int left;         /**< trials in bins that were left in the middle */
    int refused;      /**< executions in bins that a guard forbade */
    int left_alone;   /**< calls of which redcc_reach said that nothing can be begun */
};

/** Carries out the trace, from a state of zeroes. Asserts that no decision is beyond what
 *  redcc_reach, which is told of no plan and of half the start, has said of it. */
struct simulated simulate(const struct trace *trace);

#endif
