/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Sections of arrays in OpenMP's clause `reduction`: the loop updates nothing outside of the
 * sections. With sections the loop is executed in a fixed order without an inspection
 * (runtime/src/choose/sections.h). */
#ifndef PLAN_SECTIONS_H
#define PLAN_SECTIONS_H

#include "plan/plan.h"

/** Returns the section of each array of the loop. Returns NULL if an array has no such clause or no
 * simple section, if the loop has locks or no inspector, or if the loop's updates or the user
 * require the sequential order. */
const array_section *plan_sections(const loop_plan *plan);

/** `atomic` or `critical` protect the loop's updates, so that their order is open. May all of them
 * be made on private copies while bins are filled (runtime/src/bins/shares.h)? Sets is_unordered,
 * or in_order if they are protected and may not. Requires the plan for bins. */
void plan_unordered(loop_plan *plan);

/** May the loop be executed in a fixed order that is not its own? */
bool is_reordered(const loop_plan *plan);

#endif
