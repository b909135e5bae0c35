/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The loops of this folder in four versions: written by hand for redcc's runtime (no suffix),
 *  sequential (_plain), with OpenMP's clause `reduction` (_reduction), and with OpenMP's `atomic`
 *  (_atomic). */
#ifndef KERNELS_H
#define KERNELS_H

struct triangle {
    int corner[3];
    int place[3][3]; /* for each pair of corners, the index of its block in the matrix */
    double weight[3];
};

/** Lengths of the updated arrays, which only OpenMP's clause needs. */
struct lengths {
    int particles, rows, keys, blocks;
};
extern struct lengths lengths;

/* springs: adds to b the forces of n springs of stiffness k between particles at x.
 * product: y += A x with A stored by columns; column j has entries start[j] to start[j + 1] - 1.
 * histogram: counts n keys.
 * assemble: adds the forces of n triangles to the loads of their corners, and the derivatives to
 *     the blocks of a sparse matrix. */
#define DECLARE(suffix)                                                                            \
    void springs##suffix(int n, const int(*edge)[2], const double(*x)[3], double k,                \
                         double(*b)[3]);                                                           \
    void product##suffix(int n, const int *start, const int *row, const double *value,             \
                         const double *x, double *y);                                              \
    void histogram##suffix(int n, const int *key, unsigned *count);                                \
    void assemble##suffix(int n, const struct triangle *triangle, const double(*x)[3],             \
                          double(*load)[3], double(*block)[3][3]);
DECLARE(/* by hand */)
DECLARE(_plain)
DECLARE(_reduction)
DECLARE(_atomic)

#endif
