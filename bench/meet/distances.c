/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A histogram of the distances of all pairs of points. By hand: a private copy for each thread. */
#include "meet.h"

#include <math.h>

enum { POINTS = 3000, BINS = 512 };

static double (*at)[3];
static long *histogram;

static int bin_of(const double *a, const double *b) {
    const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
    return (int)(sqrt(dx * dx + dy * dy + dz * dz) * (BINS / 2));
}

#ifndef BY_HAND
static void count(int n, const double (*r)[3], long *h) {
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            h[bin_of(r[i], r[j])]++;
}
#else
static void count(int n, const double (*r)[3], long *h) {
#pragma omp parallel for schedule(dynamic, 16) reduction(+ : h[:BINS])
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            h[bin_of(r[i], r[j])]++;
}
#endif

void make(void) {
    at = room(POINTS * sizeof *at);
    histogram = room(BINS * sizeof *histogram);
    change();
}

void change(void) {
    for (int i = 0; i < POINTS; i++)
        at[i][0] = draw(), at[i][1] = draw(), at[i][2] = draw();
}

void call(void) {
    count(POINTS, (const double(*)[3])at, histogram);
}

const void *results(size_t *size) {
    *size = BINS * sizeof *histogram;
    return histogram;
}
