/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Simulated loops that tests of the choice have in common, and the bound's constants. */
#ifndef CHOOSE_TRACES_H
#define CHOOSE_TRACES_H

#include "choose_simulator.h"

#include <stdint.h>

/** The bound's e, and how many times as fast as the sequential loop a plan of these loops is at
 *  most; apart from the code's own. */
static const double share = 1.0 / 32, fastest = 2;

/** The state of uniform: to be set by each test that draws. */
extern uint64_t random_state;

/** Uniformly distributed in [0, 1). */
double uniform(void);

/** A loop of a million iterations, 10 ms, half as long by owners, whose plan takes half an
 *  execution; owners by the graph are better and their plan is four times as expensive. The caller
 *  frees it. */
struct trace *ordinary(int count);

/** The sequential loop takes so many times as long in a call, and all others. */
void scale(struct simulated_call *call, double sequential, double parallel);

#endif
