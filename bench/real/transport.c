/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Transport of a substance in a network of channels, by implicit time steps and UMFPACK.
 *
 * transport NODES STEPS >concentrations
 *
 * NODES junctions are connected by channels, as in rivers and pipes; water flows from each junction
 * to a few others downstream. Concentrations follow dc/dt = (inflow - outflow + mixing) / volume,
 * by Euler's implicit method. The flow is steady, so the matrix is factorised once. Each step
 * solves the system for a new right-hand side, with UMFPACK's iterative refinement. The factors of
 * such matrices are sparse (little fill-in), so the products with the matrix in the refinement take
 * a good part of the time of a solution.
 *
 * T. A. Davis, Direct Methods for Sparse Linear Systems, SIAM 2006; the calls are those of
 * UMFPACK's umfpack_simple.c.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <umfpack.h>

enum { DEGREE = 8 /* most entries of a column besides the diagonal */ };

static int n, nz;
static int *Ap, *Ai;
static double *Ax;

static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fprintf(stderr, "transport: out of memory\n");
        exit(1);
    }
    return memory;
}

static double uniform(void) {
    static long seed = 90210;
    seed = seed * 16807 % 2147483647;
    return (double)seed / 2147483647.0;
}

static int by_row(const void *a, const void *b) {
    const int i = *(const int *)a, j = *(const int *)b;
    return (i > j) - (i < j);
}

/* Makes column j: the flow from junction j to up to DEGREE junctions downstream. */
static void make_column(int j, double dt) {
    int to[DEGREE], count = 0;
    for (int k = 0; k < DEGREE; k++) {
        const int i = j + 1 + (int)(uniform() * (k < 6 ? 60 : 2000));
        if (i < n)
            to[count++] = i;
    }
    qsort(to, count, sizeof *to, by_row);
    double outflow = 0;
    Ai[nz] = j;
    const int diagonal = nz++;
    for (int k = 0; k < count; k++) {
        if (k > 0 && to[k] == to[k - 1])
            continue;
        const double flow = 0.1 + uniform();
        Ai[nz] = to[k];
        Ax[nz++] = -dt * flow;
        outflow += flow;
    }
    Ax[diagonal] = 1.0 + dt * (outflow + 0.5);
}

static void check(int status, const char *what) {
    if (status != UMFPACK_OK) {
        fprintf(stderr, "transport: %s: status %d of UMFPACK\n", what, status);
        exit(1);
    }
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 100 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: transport NODES (100 or more) STEPS\n");
        return 2;
    }
    n = atoi(argv[1]);
    const int steps = atoi(argv[2]);
    const double dt = 0.5;
    Ap = allocate(n + 1, sizeof *Ap);
    Ai = allocate((size_t)n * (DEGREE + 1), sizeof *Ai);
    Ax = allocate((size_t)n * (DEGREE + 1), sizeof *Ax);
    double *c = allocate(n, sizeof *c), *b = allocate(n, sizeof *b);
    int *Wi = allocate(n, sizeof *Wi);
    double *W = allocate((size_t)n * 5, sizeof *W);
    for (int j = 0; j < n; j++) {
        make_column(j, dt);
        Ap[j + 1] = nz;
    }
    void *symbolic, *numeric;
    check(umfpack_di_symbolic(n, n, Ap, Ai, Ax, &symbolic, NULL, NULL), "symbolic analysis");
    check(umfpack_di_numeric(Ap, Ai, Ax, symbolic, &numeric, NULL, NULL), "factorisation");
    umfpack_di_free_symbolic(&symbolic);
    for (int step = 1; step <= steps; step++) {
        double total = 0;
        for (int i = 0; i < n; i++)
            b[i] = c[i] + (i % 97 == 0 ? dt * (1.0 + sin(0.1 * step)) : 0.0);
        check(umfpack_di_wsolve(UMFPACK_A, Ap, Ai, Ax, c, b, numeric, NULL, NULL, Wi, W), "solve");
        for (int i = 0; i < n; i++)
            total += c[i];
        printf("%4d %.17g\n", step, total);
    }
    umfpack_di_free_numeric(&numeric);
    for (int i = 0; i < n; i += 10)
        printf("%.17g\n", c[i]);
    return 0;
}
