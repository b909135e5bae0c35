/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops that are executed many times: kernels.c compiled twice, once behind redcc-cc with PREFIX
 * `parallel_`, and once as it is with `sequential_`.
 */
#ifndef EXECUTIONS_KERNELS_H
#define EXECUTIONS_KERNELS_H

#define KERNELS_JOIN_(a, b) a##b
#define KERNELS_JOIN(a, b) KERNELS_JOIN_(a, b)

/** What a loop reads and updates. */
typedef struct problem {
    int n;            /* iterations */
    int rows;         /* of what is updated */
    const int *k, *m; /* subscripts below `rows`: 2 n of them, and `rows` of them */
    const int
        *first; /* n + 1, ascending by 0 to 3: where the columns of a matrix begin in k and v */
    const double *v;     /* 3 values for each row, and at least n */
    const float *f;      /* n values */
    const double *edges; /* EDGES of them, ascending */
    double cut;
    double *h, *g; /* 3 values for each row; updated, may overlap v */
    float *s;      /* one for each row; updated */
    int *count;    /* one for each row; updated */
    double sum;    /* beside the arrays */
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
