/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The option --bits, which fabric-mpi has in addition to fabric's options. */
#ifndef FABRIC_MPI_BITS_H
#define FABRIC_MPI_BITS_H

/** The order of sums over ranks. It is the same on all ranks, since they have the same command
 * line. */
typedef enum bits_order {
    BITS_SERIAL, /* as in fabric-serial, whatever the number of ranks */
    BITS_ANY     /* as in PETSc's matrices, dot products and preconditioners */
} bits_order;

/**
 * Removes --bits ORDER or --bits=ORDER from the words of a command that simulates; argv[*argc]
 * stays NULL. Returns 0, or the exit status after an error. The message is printed only if `says`
 * is not 0.
 */
int bits_take(int *argc, char **argv, int says, bits_order *bits);

/** If --help was given, prints a line about --bits after fabric's own text. */
void bits_help(int argc, char **argv);

#endif
