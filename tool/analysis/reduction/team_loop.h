/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * `omp for`, by the team of a region around it: may its iterations be distributed in another way?
 * The variables that it reduces must be the team's. Its schedule promises something if it is given
 * as `static`: other such loops of the region, with as many iterations, have the same thread for
 * each (OpenMP 4.5, 2.7.1). Data in memory that threads share is safe behind barriers, which
 * replace `nowait` (2.7: "an implementation may omit the barrier"); what a thread has for itself is
 * not.
 */
#ifndef ANALYSIS_TEAM_LOOP_H
#define ANALYSIS_TEAM_LOOP_H

#include "analysis/base/openmp_loop.h"
#include "analysis/loop/loop_analysis.h"

/** The reason why its directive stays as it is; NULL: there is none, and *facts is set. */
const char *team_of_loop(const analyser *an, const ir_function *function, const ir_node *loop,
                         const openmp_directive *directive, const ir_variable *counter,
                         team_facts *facts);

#endif
