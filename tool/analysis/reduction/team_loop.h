/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Checks whether the iterations of an `omp for`, which the team of an enclosing region shares, may
 *  be distributed in another way. The variables that the loop reduces must be shared by the team.
 *
 *  A schedule given as `static` is a promise: all loops of the region that have this schedule and
 *  the same trip count give each iteration to the same thread (OpenMP 4.5, 2.7.1). Programs may
 *  therefore omit the barrier between two such loops. redcc distributes the iterations in another
 *  way. Data in shared memory stay correct, also where the source has `nowait`: no thread begins
 *  such a loop while others still execute an earlier one, or leaves it before it is complete. A
 *  thread's private data have no such protection. */
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
