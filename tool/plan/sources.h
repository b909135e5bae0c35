/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which of the things that the loop reads the runtime must know. */
#ifndef PLAN_SOURCES_H
#define PLAN_SOURCES_H

#include "plan/plan.h"

/** Numbers the sources that the runtime must know: what may overlap the arrays, and what decides
 * subscripts. Sources that move together have one number. */
void plan_sources(loop_plan *plan);

#endif
