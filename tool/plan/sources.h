/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects the loop's reads that the runtime must know. */
#ifndef PLAN_SOURCES_H
#define PLAN_SOURCES_H

#include "plan/plan.h"

/** Numbers the sources that the runtime must know: those that may overlap the arrays, and those
 *  that determine subscripts. Sources with the same base or range share one number
 *  (logged_source). */
void plan_sources(loop_plan *plan);

#endif
