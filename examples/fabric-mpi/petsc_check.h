/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Handles errors that PETSc returns. */
#ifndef FABRIC_MPI_PETSC_CHECK_H
#define FABRIC_MPI_PETSC_CHECK_H

#include <petscsys.h>

/** Ends the program on all ranks if the call returns an error. */
#define CHECK(call) PetscCallAbort(PETSC_COMM_WORLD, call)

#endif
