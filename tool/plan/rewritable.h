/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What forbids writing a loop in any form. The body stands twice in the result, the first copy in a
 * thread of its own: nothing in it may be one thing for the whole program (a label, a static
 * variable, an object of each thread), and its text must be its own (no macro call may stand for it
 * and more). The names of arrays are replaced in the copy, so that an update must say its array's
 * name, and the address of the array as a whole may not be taken.
 */
#ifndef PLAN_REWRITABLE_H
#define PLAN_REWRITABLE_H

#include "plan/plan.h"

/** Records an obstacle where the loop's place or text forbids that it stands twice; */
void check_place(loop_plan *plan);
/** where its iterations cannot be counted in 64 bits, or an update cannot be redirected. */
void check_iterations(loop_plan *plan);

#endif
