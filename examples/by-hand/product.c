/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* y += A x, A by columns: column j updates those elements of y in whose rows it has entries. */
#include "kernels.h"

#include <redcc/parallel.h>

struct product {
    int n;
    const int *start;
    const int *row;
    const double *value;
    const double *x;
    double *y;
};
enum { Y };                    /* updated */
enum { START, ROW, VALUE, X }; /* read */
static const redcc_array product_arrays[] = {REDCC_ARRAY("y", REDCC_SUM, double, 1)};
static const redcc_source product_sources[] = {REDCC_SUBSCRIPTS("start"), REDCC_SUBSCRIPTS("row"),
                                               REDCC_READ("value"), REDCC_READ("x")};
static const redcc_stream product_streams[] = {REDCC_KEPT(Y, double, 1)};

REDCC_SLICE(product, int j) {
    for (int k = loop->start[j]; k < loop->start[j + 1]; k++) {
        redcc_reads(it, ROW, loop->row, k);
        redcc_reads(it, VALUE, loop->value, k);
        redcc_updates(it, Y, loop->y, loop->row[k]);
    }
}

REDCC_BODY(product, int j) {
    double *y = redcc_base(it, Y, loop->y);
    const double x_j = loop->x[j];
    for (int k = loop->start[j]; k < loop->start[j + 1]; k++)
        redcc_add(it, Y, &y[loop->row[k]], loop->value[k] * x_j);
}

REDCC_DESCRIBE(product) {
    redcc_iterations(it, 0, loop->n);
    redcc_updates_array(it, Y, loop->y);
    redcc_reads_rows(it, START, loop->start, 0, loop->n + 1);
    redcc_reads_named(it, ROW, loop->row);
    redcc_reads_named(it, VALUE, loop->value);
    redcc_reads_rows(it, X, loop->x, 0, loop->n);
}

#define REDCC_LOOP product
#define REDCC_WHERE "product.c", 57, "product"
#define REDCC_ARRAYS 1
#define REDCC_SOURCES 4
#define REDCC_STREAMS
/* Bits of the reads that redcc_reads_named declares: they may overlap y and are no subscripts. */
#define REDCC_NAMED (1u << VALUE)
#include <redcc/define_loop.h>

void product(int n, const int *start, const int *row, const double *value, const double *x,
             double *y) {
    product_execute(&(struct product){n, start, row, value, x, y});
}
