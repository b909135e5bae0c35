/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Sections of arrays in OpenMP's clause `reduction`: what the loop updates at most. With them it
 * is executed in a fixed order without an inspection (runtime/src/choose/sections.h). */
#ifndef PLAN_SECTIONS_H
#define PLAN_SECTIONS_H

#include "plan/plan.h"

/** Is every array of the loop in such a clause, with a section that can be written? Then that of
 *  each; else NULL, as if the sequential order is asked for. */
const array_section *plan_sections(const loop_plan *plan);

#endif
