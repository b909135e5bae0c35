/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether the iterations of an `omp for`, which the team of an enclosing region shares, may
 *  be distributed in another way. The team must share the variables that the loop reduces.
 *
 *  A schedule given as `static` is a promise: all such loops of the region with the same trip count
 *  give each iteration to the same thread (OpenMP 4.5, 2.7.1). Data in shared memory are safe
 *  behind barriers, which replace `nowait` (2.7: "an implementation may omit the barrier"). A
 *  thread's private data are not. */
#ifndef ANALYSIS_TEAM_LOOP_H
#define ANALYSIS_TEAM_LOOP_H

#include "analysis/base/openmp_loop.h"
#include "analysis/loop/loop_analysis.h"

/** The reason for which the loop's directive must stay as it is; NULL if there is none, and then
 *  *facts is set. */
const char *team_of_loop(const analyser *an, const ir_function *function, const ir_node *loop,
                         const openmp_directive *directive, const ir_variable *counter,
                         team_facts *facts);

#endif
