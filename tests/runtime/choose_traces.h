/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Simulated loops that several tests of the choice use, and the bound's constants. */
#ifndef CHOOSE_TRACES_H
#define CHOOSE_TRACES_H

#include "choose_simulator.h"

#include <stdint.h>

/** share: the bound's epsilon (docs/choosing.md). fastest: the largest speed-up of these loops by a
 * plan. Both are defined independently of the code under test. */
static const double share = 1.0 / 32, fastest = 2;

/** The state of `uniform`, which each test that draws numbers must set. */
extern uint64_t random_state;

/** Returns a number uniformly distributed in [0, 1). */
double uniform(void);

/** Returns a loop of a million iterations that takes 10 ms sequentially, and half of that by a plan
 * with owners. Constructing this plan takes half an execution. Owners cut from the access graph are
 * faster, but their plan is four times as expensive. The caller frees the trace. */
struct trace *ordinary(int count);

/** Multiplies the call's sequential time by `sequential`, and the times of all other strategies by
 * `parallel`. */
void scale(struct simulated_call *call, double sequential, double parallel);

#endif
