/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Advice on loops whose iterations update the same elements in a regular pattern (conflict.h). */
#ifndef ANALYSIS_REGULAR_H
#define ANALYSIS_REGULAR_H

#include "analysis/loop/loop_analysis.h"

/** Does an OpenMP directive of the program apply to a loop around `loop`, each of whose iterations
 *  updates elements of its own at `target`? Then the nest is parallel already. */
bool regular_is_parallel(const analyser *an, const ir_node *loop, const ir_node *target);

/** Which loop of the nest can be executed by `omp parallel for`, as far as the updated elements
 *  show it: one around `loop` or inside it, each of whose iterations updates elements of its own at
 *  `target`. NULL if there is none, or if interchanging two loops is better. */
const char *regular_advice(const analyser *an, const ir_node *loop, const ir_node *target);

#endif
