/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Forces of springs between particles: each spring updates two rows of b. */
#include "kernels.h"

#include <redcc/parallel.h>

struct springs {
    int n;
    const int (*edge)[2];
    const double (*x)[3];
    double k;
    double (*b)[3];
};
enum { B };       /* arrays updated */
enum { EDGE, X }; /* arrays read */
static const redcc_array springs_arrays[] = {REDCC_ARRAY("b", REDCC_SUM, double, 3)};
static const redcc_source springs_sources[] = {REDCC_SUBSCRIPTS("edge"), REDCC_READ("x")};
static const redcc_stream springs_streams[] = {REDCC_KEPT(B, double, 3)};

REDCC_SLICE(springs, int t) {
    const int i = loop->edge[t][0], j = loop->edge[t][1];
    redcc_reads(it, X, loop->x, i);
    redcc_reads(it, X, loop->x, j);
    redcc_updates(it, B, loop->b, i);
    redcc_updates(it, B, loop->b, j);
}

REDCC_BODY(springs, int t) {
    const double(*x)[3] = loop->x;
    double(*b)[3] = redcc_base(it, B, loop->b);
    const int i = loop->edge[t][0], j = loop->edge[t][1];
    double *b_i = *redcc_row(it, B, &b[i]);
    double *b_j = *redcc_row(it, B, &b[j]);
    for (int c = 0; c < 3; c++) {
        const double f = loop->k * (x[j][c] - x[i][c]);
        b_i[c] += f;
        b_j[c] -= f;
    }
}

REDCC_DESCRIBE(springs) {
    redcc_iterations(it, 0, loop->n);
    redcc_updates_array(it, B, loop->b);
    redcc_reads_rows(it, EDGE, loop->edge, 0, loop->n);
    redcc_reads_named(it, X, loop->x);
}

#define REDCC_LOOP springs
/* For reports: the loop is executed on line 60, by springs_execute. */
#define REDCC_WHERE "springs.c", 60, "springs"
#define REDCC_ARRAYS 1
#define REDCC_SOURCES 2
#define REDCC_STREAMS /* springs_streams is defined */
/* Bits of the reads that redcc_reads_named declares: they may overlap b and are no subscripts. */
#define REDCC_NAMED (1u << X)
#define REDCC_FLAGS REDCC_VERIFIABLE | REDCC_LIGHT
#include <redcc/define_loop.h>

void springs(int n, const int (*edge)[2], const double (*x)[3], double k, double (*b)[3]) {
    springs_execute(&(struct springs){n, edge, x, k, b});
}
