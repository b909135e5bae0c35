/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "kernels.h"

#include <math.h>

#define KERNEL(name) KERNELS_JOIN(PREFIX, name)

void KERNEL(histogram)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v;
    double *h = p->h;
    for (int t = 0; t < n; t++)
        h[k[t]] += v[t];
}

void KERNEL(counts)(problem *p) {
    const int n = p->n, *k = p->k;
    int *count = p->count;
    for (int t = 0; t < n; t++)
        count[k[t]]++;
}

void KERNEL(springs)(problem *p) {
    const int n = p->n, *k = p->k;
    const double(*x)[3] = (const double(*)[3])p->v;
    double(*b)[3] = (double(*)[3])p->h;
    for (int t = 0; t < n; t++) {
        const int i = k[2 * t], j = k[2 * t + 1];
        for (int c = 0; c < 3; c++) {
            const double f = 0.5 * (x[j][c] - x[i][c]);
            b[i][c] += f;
            b[j][c] -= f;
        }
    }
}

/* Much arithmetic for each update. */
void KERNEL(heavy)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v;
    double *h = p->h;
    for (int t = 0; t < n; t++) {
        double e = v[t];
        for (int i = 0; i < 16; i++)
            e = e * 0.99 + sqrt(e * e + i);
        h[k[t]] += e;
        h[k[n + t]] -= 0.5 * e;
    }
}

void KERNEL(sums)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v;
    double *h = p->h, sum = 0;
    for (int t = 0; t < n; t++) {
        h[k[t]] += v[t];
        sum += v[t] * v[t];
    }
    p->sum = sum;
}

/* y += A x, column by column. */
void KERNEL(columns)(problem *p) {
    const int n = p->n, *first = p->first, *row = p->k;
    const double *a = p->v, *x = p->v;
    double *y = p->h;
    for (int j = 0; j < n; j++)
        for (int q = first[j]; q < first[j + 1]; q++)
            y[row[q]] += a[q] * x[j];
}

void KERNEL(passed_over)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v, cut = p->cut;
    double *h = p->h;
    for (int t = 0; t < n; t++) {
        if (v[t] > cut)
            continue;
        h[k[t]] += v[t];
    }
}

void KERNEL(minimum)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v;
    double *h = p->h;
    for (int t = 0; t < n; t++)
        if (v[t] < h[k[t]])
            h[k[t]] = v[t];
}

static int interval_of(const double *edges, double value) {
    int low = 0, high = EDGES - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (edges[middle] < value)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

void KERNEL(bisection)(problem *p) {
    const int n = p->n;
    const double *v = p->v, *edges = p->edges;
    double *h = p->h;
    for (int t = 0; t < n; t++)
        h[interval_of(edges, v[t])] += v[t];
}

void KERNEL(through_a_table)(problem *p) {
    const int n = p->n, *k = p->k, *m = p->m;
    const float *f = p->f;
    float *s = p->s;
    for (int t = 0; t < n; t++)
        s[m[k[t]]] += f[t];
}

void KERNEL(two_arrays)(problem *p) {
    const int n = p->n, *k = p->k, *m = p->m;
    const double *v = p->v;
    double *h = p->h, *g = p->g;
    for (int t = 0; t < n; t++) {
        h[k[t]] += v[t];
        g[m[k[n + t]]] = 0.25 * v[t] - g[m[k[n + t]]];
    }
}

void KERNEL(last_value)(problem *p) {
    const int n = p->n, *k = p->k;
    const double *v = p->v;
    double *h = p->h;
    int last = p->last;
    for (int t = 0; t < n; t++) {
        if (v[t] > 0) {
            last = t;
            h[k[t]] -= v[t];
        }
    }
    p->last = last;
}
