/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The linear system over all parts. The leader's has b whole, and of A the diagonal: there it adds
 *  friction, which acts on single vertices. Collective; `whole` is the leader's, else NULL. */
#ifndef FABRIC_MPI_ASSEMBLY_H
#define FABRIC_MPI_ASSEMBLY_H

#include "part.h"
#include "step/forces.h"

/** The leader's system without what the parts have: one block a row. Ends the program where memory
 *  is out. */
void assembly_thin(simulation *whole);

/** What the hinges remember of their turns, for parts that were just made. */
void assembly_start(part *p, const simulation *whole);

/** As forces_assemble; at: the leader's, else NULL. */
void assembly_forces(part *p, simulation *whole, const expansion *at);

/** As forces_add_missed; all ranks return whether there were any. */
int assembly_missed(part *p, simulation *whole, const expansion *at, const double (*dv)[3]);

/** Parts get diagonal and b as the leader has them. */
void assembly_receive(part *p, const linear_system *whole);

#endif
