/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Obstacles to writing a loop in any form. The result contains the body twice, and the first copy
 * runs in several threads. So nothing in the body may exist only once (a label, a static variable
 * other than constant numbers) or once per thread (a thread-local array or record). No macro call
 * may expand to the loop and more. The copy replaces names of arrays, so an update must name its
 * array, and the address of the array as a whole may not be taken.
 */
#ifndef PLAN_REWRITABLE_H
#define PLAN_REWRITABLE_H

#include "plan/plan.h"

/** Records an obstacle if the loop's place or text forbids duplicating it. */
void check_place(loop_plan *plan);
/** Records an obstacle if the loop's iterations cannot be counted in 64 bits, or if an update
 * cannot be redirected to a copy of the array. */
void check_iterations(loop_plan *plan);

#endif
