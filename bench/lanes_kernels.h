/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#ifndef BENCH_LANES_KERNELS_H
#define BENCH_LANES_KERNELS_H

/** A triangle of a cloth: its corners, and the indices of its matrix blocks for the pairs of
 * corners ii ij ik jj jk kk. The derivatives of the position with respect to the material
 * coordinates u and v are sums of the corners' positions with weights u and v. */
struct element {
    int vertex[3];
    int block[6];
    double u[3], v[3];
    double area;
};

/** Like struct element, but for a matrix that stores all blocks: entry[p][q] is the block of
 *  corners p and q. */
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

/** Declares a kernel, NAME, as redcc has translated it, and serial_NAME, the original. */
#define BENCH_LANES_DECLARE(name, parameters)                                                      \
    void name parameters;                                                                          \
    void serial_##name parameters;
BENCH_LANES_KERNELS(BENCH_LANES_DECLARE)

#endif
