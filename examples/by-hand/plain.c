/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The sequential loops. This file is compiled three times: as it is, and for comparison with OpenMP
 * and ATOMIC or REDUCTION defined. */
#include "kernels.h"

#include "element.h"

#if defined(ATOMIC)
#define NAME(loop) loop##_atomic
#define LOOP(...) _Pragma("omp parallel for")
#define UPDATE _Pragma("omp atomic")
#elif defined(REDUCTION)
#define NAME(loop) loop##_reduction
#define TEXT(text) #text
#define LOOP(...) _Pragma(TEXT(omp parallel for reduction(+ : __VA_ARGS__)))
#define UPDATE
#else
#define NAME(loop) loop##_plain
#define LOOP(...)
#define UPDATE
#endif

void NAME(springs)(int n, const int (*edge)[2], const double (*x)[3], double k, double (*b)[3]) {
    double *sum = *b;
    LOOP(sum[:3 * lengths.particles])
    for (int t = 0; t < n; t++) {
        const int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            const double f = k * (x[j][c] - x[i][c]);
            UPDATE
            sum[3 * i + c] += f;
            UPDATE
            sum[3 * j + c] -= f;
        }
    }
}

void NAME(product)(int n, const int *start, const int *row, const double *value, const double *x,
                   double *y) {
    LOOP(y[:lengths.rows])
    for (int j = 0; j < n; j++)
        for (int k = start[j]; k < start[j + 1]; k++) {
            UPDATE
            y[row[k]] += value[k] * x[j];
        }
}

void NAME(histogram)(int n, const int *key, unsigned *count) {
    LOOP(count[:lengths.keys])
    for (int t = 0; t < n; t++) {
        UPDATE
        count[key[t]]++;
    }
}

void NAME(assemble)(int n, const struct triangle *triangle, const double (*x)[3], double (*load)[3],
                    double (*block)[3][3]) {
    double *sum = *load, *matrix = **block;
    LOOP(sum[:3 * lengths.particles], matrix[:9 * lengths.blocks])
    for (int t = 0; t < n; t++) {
        const struct triangle *it = &triangle[t];
        double force[3][3], derivative[3][3][3][3];
        compute_element(it, x, force, derivative);
        for (int p = 0; p < 3; p++) {
            for (int c = 0; c < 3; c++) {
                UPDATE
                sum[3 * it->corner[p] + c] += force[p][c];
            }
            for (int q = 0; q < 3; q++)
                for (int c = 0; c < 9; c++) {
                    UPDATE
                    matrix[9 * it->place[p][q] + c] += derivative[p][q][c / 3][c % 3];
                }
        }
    }
}
