/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The linear system over all parts. The leader has all of b and the diagonal of A. It adds
 *  friction, which acts on single vertices, to both. All functions are collective; `whole` is the
 *  leader's simulation, or NULL on other ranks. */
#ifndef FABRIC_MPI_ASSEMBLY_H
#define FABRIC_MPI_ASSEMBLY_H

#include "part.h"
#include "step/forces.h"

/** Reduces the leader's matrix to one block per row; the parts have the other blocks. Ends the
 *  program if out of memory. */
void assembly_thin(simulation *whole);

/** Sends the hinges' angles, which count whole rotations, to parts that were just made. */
void assembly_start(part *p, const simulation *whole);

/** Like forces_assemble, but over all ranks; `at` is the leader's, or NULL on other ranks. */
void assembly_forces(part *p, simulation *whole, const expansion *at);

/** Like forces_add_missed, but over all ranks. Returns on all ranks whether elements were added. */
int assembly_missed(part *p, simulation *whole, const expansion *at, const double (*dv)[3]);

/** Sends the leader's diagonal and b to the parts. */
void assembly_receive(part *p, const linear_system *whole);

#endif
