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

#endif
