/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Times y = A*x + y by CSparse's cs_gaxpy on a large sparse matrix.
 *
 *     gaxpy SHAPE SIDE CALLS [SHIFT]
 *
 * prints the median of the calls' seconds, the seconds of the first call (in which redcc inspects
 * the subscripts), and a hash of the bits of x and y. The matrix has SIDE * SIDE rows and columns
 * and ten entries per column. With SHIFT, y begins SHIFT elements after x in the same array, so
 * that they overlap. SHAPE:
 * - banded: the entries of a column are within 1000 rows of the diagonal
 * - mesh: a grid of SIDE x SIDE points in the order of its rows
 * - shuffled: the same points numbered at random
 * - random: rows drawn at random
 */
#include <cs.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { PER_COLUMN = 10 };
static csi side, row_count;

static csi draw(uint32_t below) {
    static uint64_t state = 88172645463325252u; /* xorshift64, G. Marsaglia 2003 */
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (csi)((state >> 33) % below);
}

static csi wrapped(csi row) {
    return (row % row_count + row_count) % row_count;
}

static int by_row(const void *left, const void *right) {
    const csi a = *(const csi *)left, b = *(const csi *)right;
    return (a > b) - (a < b);
}

/* Returns the row of entry number `entry` of the column. It is the grid's point `column` itself,
 * one of its eight neighbours, or the point two columns to the right. */
static csi neighbour(csi column, int entry) {
    static const int right[PER_COLUMN] = {0, -1, 1, 0, 0, -1, 1, -1, 1, 2};
    static const int down[PER_COLUMN] = {0, 0, 0, -1, 1, -1, -1, 1, 1, 0};
    return wrapped(column + right[entry] + down[entry] * side);
}

static void fill_column(const char *shape, const csi *number, csi column, csi *rows) {
    for (int entry = 0; entry < PER_COLUMN; entry++) {
        if (strcmp(shape, "banded") == 0)
            rows[entry] = wrapped(column + draw(2001) - 1000);
        else if (strcmp(shape, "random") == 0)
            rows[entry] = draw((uint32_t)row_count);
        else
            rows[entry] = number[neighbour(column, entry)];
    }
    qsort(rows, PER_COLUMN, sizeof *rows, by_row);
}

/* Returns the numbering of the grid's points: point p has row number[p]. This is p itself or, if
 * `shuffled`, a random permutation (Fisher-Yates). */
static csi *numbering(int shuffled) {
    csi *number = malloc((size_t)row_count * sizeof *number);
    for (csi p = 0; p < row_count; p++)
        number[p] = p;
    for (csi p = row_count - 1; shuffled && p > 0; p--) {
        const csi other = draw((uint32_t)p + 1), saved = number[p];
        number[p] = number[other];
        number[other] = saved;
    }
    return number;
}

static cs *matrix(const char *shape) {
    const csi entries = row_count * PER_COLUMN;
    cs *a = cs_spalloc(row_count, row_count, entries, 1, 0);
    csi *number = numbering(strcmp(shape, "shuffled") == 0);
    csi *point = malloc((size_t)row_count * sizeof *point);
    for (csi p = 0; p < row_count; p++)
        point[number[p]] = p;
    for (csi column = 0; column < row_count; column++) {
        a->p[column] = column * PER_COLUMN;
        fill_column(shape, number, point[column], a->i + column * PER_COLUMN);
    }
    a->p[row_count] = entries;
    for (csi entry = 0; entry < entries; entry++)
        a->x[entry] = 1.0 / (double)(1 + draw(1000));
    free(number);
    free(point);
    return a;
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_size(const void *left, const void *right) {
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* FNV-1a of the bytes. */
static uint64_t hash(const void *bytes, size_t count) {
    uint64_t h = 14695981039346656037u;
    for (size_t i = 0; i < count; i++)
        h = (h ^ ((const unsigned char *)bytes)[i]) * 1099511628211u;
    return h;
}

int main(int argc, char **argv) {
    const int calls = argc > 3 ? atoi(argv[3]) : 0;
    const csi shift = argc > 4 ? atoi(argv[4]) : 0;
    side = argc > 2 ? atoi(argv[2]) : 0;
    if (calls < 1 || side < 1)
        return 2;
    row_count = side * side;
    cs *a = matrix(argv[1]);
    const csi count = row_count + (argc > 4 ? shift : row_count);
    double *x = calloc((size_t)count, sizeof *x), *y = x + (count - row_count);
    double *seconds = malloc((size_t)(calls + 1) * sizeof *seconds);
    for (csi i = 0; i < row_count; i++)
        x[i] = 1.0 / (double)(1 + draw(1000));
    for (int call = 0; call <= calls; call++) {
        const double start = now();
        cs_gaxpy(a, x, y);
        seconds[call] = now() - start;
    }
    qsort(seconds + 1, (size_t)calls, sizeof *seconds, by_size);
    printf("%.6f %.6f %016llx\n", seconds[1 + calls / 2], seconds[0],
           (unsigned long long)hash(x, (size_t)count * sizeof *x));
    free(x);
    free(seconds);
    cs_spfree(a);
    return 0;
}
