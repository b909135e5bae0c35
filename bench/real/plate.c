/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Heat in a plate: finite elements and implicit time steps, on CSparse's matrices.
 *
 *    plate SIDE STEPS >temperatures
 *
 * A plate of SIDE x SIDE nodes is cut into linear triangles. Its conductivity varies; it is heated
 * in one corner and cooled along one edge. Crank and Nicolson's scheme gives a symmetric system for
 * each step, which conjugate gradients solve. All products of a matrix and a vector are CSparse's
 * cs_gaxpy, which works by columns: y[i] += A(i, j) x[j]. Matrices are built from triplets by
 * cs_entry, cs_compress and cs_dupl. Every step prints its iterations and the heat in the plate. At
 * the end the program prints temperatures.
 *
 * O. C. Zienkiewicz and R. L. Taylor, The Finite Element Method, 4th edition, McGraw-Hill 1989; M.
 * R. Hestenes and E. Stiefel, J. Res. NBS 49 (1952) 409. CSparse: T. A. Davis, Direct Methods for
 * Sparse Linear Systems, SIAM 2006.
 */
#include <cs.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DT 1e-4
#define TOLERANCE 1e-8
#define TRANSFER 5.0 /* heat transfer coefficient of the cooled edge */

static csi n, side;

static void fail(const char *what) {
    fprintf(stderr, "plate: %s\n", what);
    exit(1);
}

static void *allocate(size_t size) {
    void *memory = cs_calloc(n, size);
    if (!memory)
        fail("out of memory");
    return memory;
}

static void enter(cs *triplets, csi i, csi j, double value) {
    if (!cs_entry(triplets, i, j, value))
        fail("out of memory");
}

/* Adds the conductivity and capacity of a linear triangle with nodes v to the two matrices. */
static void add_triangle(const csi v[3], cs *stiffness, cs *mass) {
    double x[3], y[3], b[3], c[3];
    for (int a = 0; a < 3; a++) {
        x[a] = (double)(v[a] % side) / (double)(side - 1);
        y[a] = (double)(v[a] / side) / (double)(side - 1);
    }
    for (int a = 0; a < 3; a++) {
        b[a] = y[(a + 1) % 3] - y[(a + 2) % 3];
        c[a] = x[(a + 2) % 3] - x[(a + 1) % 3];
    }
    const double area = 0.5 * (b[0] * c[1] - b[1] * c[0]);
    const double k = 1.0 + 0.9 * sin(20 * x[0]) * cos(15 * y[0]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            enter(stiffness, v[i], v[j], k * (b[i] * b[j] + c[i] * c[j]) / (4 * area));
            enter(mass, v[i], v[j], area / (i == j ? 6 : 12));
        }
}

/* Returns the matrix of the triplets in compressed columns, with entries for the same place added
 * up. Frees the triplets. */
static cs *compressed(cs *triplets) {
    cs *transposed = cs_compress(triplets), *half = cs_transpose(transposed, 1);
    cs_spfree(triplets);
    cs_spfree(transposed);
    if (!half || !cs_dupl(half))
        fail("out of memory");
    return half; /* rows in order within each column */
}

/* Makes left = M + DT/2 K and right = M - DT/2 K, from the mass matrix M and the stiffness matrix
 * K. */
static void make_matrices(cs **left, cs **right) {
    cs *K = cs_spalloc(n, n, 18 * n, 1, 1), *M = cs_spalloc(n, n, 18 * n, 1, 1);
    if (!K || !M)
        fail("out of memory");
    for (csi j = 0; j < side - 1; j++)
        for (csi i = 0; i < side - 1; i++) {
            const csi p = j * side + i;
            const csi lower[3] = {p, p + 1, p + side + 1}, upper[3] = {p, p + side + 1, p + side};
            add_triangle(lower, K, M);
            add_triangle(upper, K, M);
        }
    for (csi i = 0; i < side; i++)
        enter(K, i, i, TRANSFER / (double)(side - 1));
    K = compressed(K);
    M = compressed(M);
    *left = cs_add(M, K, 1, 0.5 * DT);
    *right = cs_add(M, K, 1, -0.5 * DT);
    cs_spfree(K);
    cs_spfree(M);
    if (!*left || !*right)
        fail("out of memory");
}

static double dot(const double *a, const double *b) {
    double sum = 0;
    for (csi i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Solves A u = b by conjugate gradients, starting from the given u; r, p and w are work space.
 * Returns the number of iterations. */
static int conjugate_gradients(const cs *A, const double *b, double *u, double *r, double *p,
                               double *w) {
    memset(w, 0, sizeof *w * (size_t)n);
    cs_gaxpy(A, u, w);
    for (csi i = 0; i < n; i++)
        p[i] = r[i] = b[i] - w[i];
    double rr = dot(r, r);
    const double enough = TOLERANCE * TOLERANCE * dot(b, b);
    int iterations = 0;
    for (; rr > enough; iterations++) {
        memset(w, 0, sizeof *w * (size_t)n);
        cs_gaxpy(A, p, w);
        const double alpha = rr / dot(p, w);
        for (csi i = 0; i < n; i++) {
            u[i] += alpha * p[i];
            r[i] -= alpha * w[i];
        }
        const double before = rr;
        rr = dot(r, r);
        for (csi i = 0; i < n; i++)
            p[i] = r[i] + rr / before * p[i];
    }
    return iterations;
}

int main(int argc, char **argv) {
    if (argc != 3 || atoi(argv[1]) < 3 || atoi(argv[2]) < 1) {
        fprintf(stderr, "usage: plate SIDE (3 or more) STEPS\n");
        return 2;
    }
    side = atoi(argv[1]);
    n = side * side;
    const int steps = atoi(argv[2]);
    cs *left, *right;
    make_matrices(&left, &right);
    double *u = allocate(sizeof *u), *b = allocate(sizeof *b), *r = allocate(sizeof *r);
    double *p = allocate(sizeof *p), *w = allocate(sizeof *w);
    for (int step = 1; step <= steps; step++) {
        for (csi i = 0; i < n; i++)
            b[i] = i % side > side * 3 / 4 && i / side > side * 3 / 4 ? DT / (double)n : 0.0;
        cs_gaxpy(right, u, b);
        const int iterations = conjugate_gradients(left, b, u, r, p, w);
        double heat = 0;
        for (csi i = 0; i < n; i++)
            heat += u[i];
        printf("%4d %4d %.17g\n", step, iterations, heat / (double)n);
    }
    for (csi i = 0; i < n; i += 10)
        printf("%.17g\n", u[i]);
    for (int k = 0; k < 5; k++)
        cs_free((double *[]){u, b, r, p, w}[k]);
    cs_spfree(left);
    cs_spfree(right);
    return 0;
}
