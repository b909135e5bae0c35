/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is known of a loop at trip counts of one size: what decisions (decide.c) and outcomes
 *  (observe.c) have in common. */
#ifndef REDCC_CHOOSE_SIZE_H
#define REDCC_CHOOSE_SIZE_H

#include "choose/decide.h"

/** A way that was measured is worth a trial below this, of the other's time: medians of executions
 * of one loop differ by 3 to 5 % without a cause. */
static const double redcc_better = 0.95;
/** Below this one execution shows it: twice the noise of a busy machine. */
static const double redcc_clear = 0.8;

enum {
    REDCC_REST_MOST = 1 << 20, /* calls */
    REDCC_STEADY = 2           /* calls in a row whose subscripts were met: they are not new */
};

struct size_state *redcc_size_of(struct choice_state *state, long long trip);
/** The same, to look at. */
const struct size_state *redcc_seen_size(const struct choice_state *state, long long trip);

/** Seconds an iteration: the median of the last three sequential executions, of two the lower. */
double redcc_usual(const struct timings *timings);

/** The shortest of them: what is gained is not to be overestimated. */
double redcc_least(const struct timings *timings);

void redcc_note_timing(struct timings *timings, double each);

/** Leaves the loop sequential for some calls: `first`, at each time in a row twice as many, `most`
 * at the most. */
void redcc_rest(struct size_state *size, enum stand stand, enum rule rule, long first, long most);

/** Did the last set-up pay? Then the next one may come sooner, else later: the factor of its cost
 *  that `since` must reach. */
double redcc_next_factor(const struct set_ups *set_ups);

/** set_ups->misses, the last one included. */
int redcc_next_misses(const struct set_ups *set_ups);

/** Seconds an iteration by a plan of that way. Estimates follow the sequential loop, whose first
 *  execution takes longer than others. */
double redcc_expected(const struct size_state *size, enum way way);

/** May that way be had, and is it worth a trial where an iteration takes `current` seconds? */
bool redcc_is_better(const struct size_state *size, enum way way, double current);

/** ... any way, instead of the sequential loop? */
bool redcc_some_way_is_better(const struct size_state *size);

/** Begins to compare two ways. */
void redcc_compare(struct size_state *size, enum way contender, enum way incumbent);

#endif
