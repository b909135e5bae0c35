/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What `auto` may spend on trials: a fiftieth of the time that the program has run, and what its
 * loops have gained so far by running in parallel. So a program that is over too soon for a plan to
 * pay has lost a fiftieth of its time at most, whatever its loops are.
 */
#ifndef REDCC_BUDGET_H
#define REDCC_BUDGET_H

/** Seconds that may be spent now; may be negative. Thread-safe. */
double redcc_budget(void);

/** An execution took so many seconds less than the sequential loop would have taken (negative:
 *  more). Thread-safe. */
void redcc_budget_gain(double seconds);

#endif
