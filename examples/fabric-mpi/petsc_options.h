/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds options of PETSc (PETSC_OPTIONS) that nothing has read, because they are misspelt or have
 *  no effect here. */
#ifndef FABRIC_MPI_PETSC_OPTIONS_H
#define FABRIC_MPI_PETSC_OPTIONS_H

#include "bits.h"

/** Prints each unread option with the nearest known one. To be called after a solution, when all
 *  options have been read. Returns the number of unread options. */
int petsc_options_unread(bits_order bits);

/** Makes PETSc print an error, such as an unknown preconditioner, in one line, without call stack
 * and build configuration. */
void petsc_errors_short(void);

#endif
