/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the methods of solution share. */
#ifndef FABRIC_SOLVER_PARTS_H
#define FABRIC_SOLVER_PARTS_H

#include "constraint.h"

enum { UNCONSTRAINED, CONSTRAINED, DRIVEN /* and some z is not 0 */ };

/** dv = S dv + z; returns which of the above holds. */
int solver_apply(const constraints *c, double (*dv)[3]);

/** r = S r, every vertex. */
void solver_filter(const constraints *c, double (*r)[3]);

#endif
