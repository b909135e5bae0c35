/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Adds matrices of triangles to a sparse matrix of 3 x 3 blocks, and loads to the corners. */
#include "kernels.h"

#include "element.h"

#include <redcc/parallel.h>

struct assemble {
    int n;
    const struct triangle *triangle;
    const double (*x)[3];
    double (*load)[3];
    double (*block)[3][3];
};
enum { LOAD, BLOCK }; /* updated */
enum { TRIANGLE, X }; /* read */
static const redcc_array assemble_arrays[] = {REDCC_ARRAY("load", REDCC_SUM, double, 3),
                                              REDCC_ARRAY("block", REDCC_SUM, double, 9)};
static const redcc_source assemble_sources[] = {REDCC_SUBSCRIPTS("triangle"), REDCC_READ("x")};

REDCC_SLICE(assemble, int t) {
    const struct triangle *triangle = &loop->triangle[t];
    for (int p = 0; p < 3; p++) {
        redcc_reads(it, X, loop->x, triangle->corner[p]);
        redcc_updates(it, LOAD, loop->load, triangle->corner[p]);
        for (int q = 0; q < 3; q++)
            redcc_updates(it, BLOCK, loop->block, triangle->place[p][q]);
    }
}

/* The body is compiled once instead of being inlined several times, because it is long. This
 * requires REDCC_ONE_BODY below.
 */
REDCC_HEAVY_BODY(assemble, int t) {
    const struct triangle *triangle = &loop->triangle[t];
    double(*load)[3] = redcc_base(it, LOAD, loop->load);
    double(*block)[3][3] = redcc_base(it, BLOCK, loop->block);
    double force[3][3], derivative[3][3][3][3];
    compute_element(triangle, loop->x, force, derivative);
    for (int p = 0; p < 3; p++) {
        double *row = *redcc_row(it, LOAD, &load[triangle->corner[p]]);
        for (int c = 0; c < 3; c++)
            row[c] += force[p][c];
        for (int q = 0; q < 3; q++) {
            double(*of_pair)[3] = *redcc_row(it, BLOCK, &block[triangle->place[p][q]]);
            for (int c = 0; c < 9; c++)
                of_pair[c / 3][c % 3] += derivative[p][q][c / 3][c % 3];
        }
    }
}

REDCC_DESCRIBE(assemble) {
    redcc_iterations(it, 0, loop->n);
    redcc_updates_array(it, LOAD, loop->load);
    redcc_updates_array(it, BLOCK, loop->block);
    redcc_reads_rows(it, TRIANGLE, loop->triangle, 0, loop->n);
    redcc_reads_named(it, X, loop->x);
}

#define REDCC_LOOP assemble
#define REDCC_WHERE "assemble.c", 70, "assemble"
#define REDCC_ARRAYS 2
#define REDCC_SOURCES 2
#define REDCC_ONE_BODY
#include <redcc/define_loop.h>

void assemble(int n, const struct triangle *triangle, const double (*x)[3], double (*load)[3],
              double (*block)[3][3]) {
    assemble_execute(&(struct assemble){n, triangle, x, load, block});
}
