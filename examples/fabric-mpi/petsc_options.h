/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Options of PETSc (PETSC_OPTIONS) that nothing has asked for: misspelt, or without effect here.
 */
#ifndef FABRIC_MPI_PETSC_OPTIONS_H
#define FABRIC_MPI_PETSC_OPTIONS_H

#include "bits.h"

/** To be called when all that reads options has done so: after a solution. Where an option was not
 *  read, prints it and what may have been meant. Returns how many there are. */
int petsc_options_unread(bits_order bits);

/** Has an error of PETSc's, such as a preconditioner it does not know, be said in one line instead
 * of with PETSc's stack of calls and how it was built. */
void petsc_errors_short(void);

#endif
