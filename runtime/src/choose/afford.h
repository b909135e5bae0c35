/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What a loop can afford at trip counts of one size: executions, looks and set-ups, by its credit
 * or a loan (docs/choosing.md). Nothing here changes what is known; decide.c does.
 */
#ifndef REDCC_CHOOSE_AFFORD_H
#define REDCC_CHOOSE_AFFORD_H

#include "choose/size.h"

/** Bins need no set-up: until they are the faster way, an execution by them is a trial. */
bool redcc_is_trial(const struct size_state *size, enum way way);

/** Seconds; it ends after the first round that has lost as much. */
double redcc_trial_may_lose(const struct size_state *size, long long trip);

/** May a plan be executed? One that was measured and is clearly the faster way repays what is owed,
 *  as long as it does. */
bool redcc_may_execute(const struct choice_state *state, const struct size_state *size,
                       long long trip, enum way way);

/** A sample said that bins may be worth a trial, and it would not be the first thing that is lost.
 */
bool redcc_may_bin(const struct choice_state *state, const struct size_state *size,
                   const struct situation *now);

/** Is an execution too short for threads to be woken? */
bool redcc_is_short(const struct size_state *size, const struct situation *now);

/** The way that is the cheapest, set-up included, over the executions to come; of those that the
 *  credit allows and that are better than `current` seconds an iteration. SEQUENTIAL: none. */
enum way redcc_affordable_way(const struct choice_state *state, const struct size_state *size,
                              const struct situation *now, double current);

/** The best way that is worth a loan; SEQUENTIAL: none, or nothing may be lent now. */
enum way redcc_way_to_borrow_for(const struct choice_state *state, const struct size_state *size,
                                 const struct situation *now);

/** Seconds to be lent for a set-up of that way. */
double redcc_loan_for(const struct size_state *size, const struct situation *now, enum way way);

/** Seconds from now on that a set-up of that way may take; is_lent: it has a loan. */
double redcc_deadline(const struct choice_state *state, const struct size_state *size,
                      const struct situation *now, enum way way, bool is_lent);

/** Does the credit cover a look, of a loop that has none? */
bool redcc_may_look(const struct choice_state *state, const struct size_state *size,
                    const struct situation *now);

/** Would one thread look, since a set-up is not likely to follow or threads would cost too much? */
bool redcc_looks_alone(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now);

/** May starting threads for a look be lent? It is little beside an execution. */
bool redcc_may_lend_start(const struct choice_state *state, const struct size_state *size,
                          const struct situation *now);

#endif
