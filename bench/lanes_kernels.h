/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef BENCH_LANES_KERNELS_H
#define BENCH_LANES_KERNELS_H

/** A triangle of a cloth: its corners, the blocks ii ij ik jj jk kk of the matrix, and how strains
 *  along u and v follow from the corners' places. */
struct element {
    int vertex[3];
    int block[6];
    double u[3], v[3];
    double area;
};

/** The same of a whole matrix: where the block of each pair of corners is. */
struct cloth_element {
    int vertex[3];
    int entry[3][3];
    double u[3], v[3];
    double area;
};

#define BENCH_LANES_KERNELS(X)                                                                     \
    X(cloth, (int count, const struct cloth_element *element, const double(*x)[3],                 \
              const double(*v)[3], double(*b)[3], double(*a)[3][3]))                               \
    X(membrane, (int count, const struct element *element, const double(*x)[3], double(*b)[3],     \
                 double(*a)[3][3]))                                                                \
    X(float_membrane,                                                                              \
      (int count, const struct element *element, const float(*x)[3], float(*b)[3]))                \
    X(contacts, (int count, const int(*pair)[2], const double(*x)[3], const double(*v)[3],         \
                 const double *radius, double(*force)[3]))                                         \
    X(touching, (int count, const int(*pair)[2], const double(*x)[3], const double *radius,        \
                 double(*force)[3]))                                                               \
    X(lennard_jones, (int count, const int(*pair)[2], const double(*x)[3], double(*force)[3]))     \
    X(springs, (int count, const int(*edge)[2], const double *rest, const double(*x)[3],           \
                double(*force)[3]))                                                                \
    X(tetrahedra, (int count, const int(*corner)[4], const double(*x)[3], const int *start,        \
                   const int *column, double(*k)[3][3]))                                           \
    X(half_product, (int rows, const int *start, const int *column, const double *value,           \
                     const double *x, double *y))

/** As redcc translated it, and, serial_NAME, untouched. */
#define BENCH_LANES_DECLARE(name, parameters)                                                      \
    void name parameters;                                                                          \
    void serial_##name parameters;
BENCH_LANES_KERNELS(BENCH_LANES_DECLARE)

#endif
