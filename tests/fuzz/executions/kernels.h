/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that are executed many times. kernels.c is compiled twice: by redcc-cc with PREFIX
 * `parallel_`, and unchanged with `sequential_`.
 */
#ifndef EXECUTIONS_KERNELS_H
#define EXECUTIONS_KERNELS_H

#define KERNELS_JOIN_(a, b) a##b
#define KERNELS_JOIN(a, b) KERNELS_JOIN_(a, b)

/** The data that a loop reads and updates. */
typedef struct problem {
    int n;            /* number of iterations */
    int rows;         /* number of updated rows */
    const int *k, *m; /* subscripts below `rows`: 2 n in k, and `rows` in m */
    const int *first; /* n + 1 numbers, ascending in steps of 0 to 3: where a matrix's columns begin
                         in k and v */
    const double *v;  /* 3 values for each row, and at least n */
    const float *f;   /* n values */
    const double *edges; /* EDGES ascending numbers */
    double cut;
    double *h, *g; /* updated arrays of 3 values for each row, which may overlap v */
    float *s;      /* updated array of one value for each row */
    int *count;    /* updated array of one value for each row */
    double sum;    /* a sum in addition to the arrays */
    int last;
} problem;

enum { EDGES = 100 };

typedef void kernel(problem *p);

typedef struct named_kernel {
    const char *name;
    kernel *parallel, *sequential;
} named_kernel;

#define KERNELS(X)                                                                                 \
    X(histogram)                                                                                   \
    X(counts)                                                                                      \
    X(springs)                                                                                     \
    X(heavy)                                                                                       \
    X(sums)                                                                                        \
    X(columns)                                                                                     \
    X(passed_over)                                                                                 \
    X(minimum)                                                                                     \
    X(bisection)                                                                                   \
    X(through_a_table)                                                                             \
    X(two_arrays)                                                                                  \
    X(last_value)

#define KERNELS_DECLARE(name) kernel parallel_##name, sequential_##name;
KERNELS(KERNELS_DECLARE)
#undef KERNELS_DECLARE

#endif
