/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The option --bits of fabric-mpi's command line, which fabric does not have. */
#ifndef FABRIC_MPI_BITS_H
#define FABRIC_MPI_BITS_H

/** In which order sums over ranks are added. All ranks have the same command line, so the same. */
typedef enum bits_order {
    BITS_SERIAL, /* fabric-serial's, whatever the number of ranks */
    BITS_ANY     /* as PETSc's matrices, dot products and preconditioners do */
} bits_order;

/**
 * Takes --bits ORDER or --bits=ORDER out of the words of a command that simulates; argv[*argc]
 * stays NULL. 0, or the exit status: of the ranks the one that `says` so has printed what is wrong.
 */
int bits_take(int *argc, char **argv, int says, bits_order *bits);

/** After fabric's own text: where --help was asked for, a line on --bits. */
void bits_help(int argc, char **argv);

#endif
