/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops for bench/generated.sh; the argument selects one: springs, a histogram, y = A x by columns,
 * and a loop with a live-out value. (redcc does not move the last loop's body to a separate
 * function.) */
#include <stdio.h>
#include <stdlib.h>
struct sys {
    double (*b)[3];
};
static void spring(const double (*x)[3], int i, int j, double *f) {
    for (int c = 0; c < 3; c++)
        f[c] = 0.5 * (x[j][c] - x[i][c]);
}
void springs(int n, const int (*edge)[2], const double (*x)[3], struct sys *s);
void springs(int n, const int (*edge)[2], const double (*x)[3], struct sys *s) {
    int t, i, j;
    double f[3];
    for (t = 0; t < n; t++) {
        i = edge[t][0];
        j = edge[t][1];
        spring(x, i, j, f);
        for (int c = 0; c < 3; c++) {
            s->b[i][c] += f[c];
            s->b[j][c] -= f[c];
        }
    }
}
void hist(int n, const unsigned char *v, int *h);
void hist(int n, const unsigned char *v, int *h) {
    for (int t = 0; t < n; t++)
        h[v[t]]++;
}
void spmv(int n, const int *colptr, const int *row, const double *val, const double *x, double *y);
void spmv(int n, const int *colptr, const int *row, const double *val, const double *x, double *y) {
    for (int j = 0; j < n; j++)
        for (int k = colptr[j]; k < colptr[j + 1]; k++)
            y[row[k]] += val[k] * x[j];
}
double leaving(int n, const int (*edge)[2], const double *x, double *h);
double leaving(int n, const int (*edge)[2], const double *x, double *h) {
    double e = 0;
    for (int t = 0; t < n; t++) {
        e = x[edge[t][1]] * 3;
        h[edge[t][0]] += e;
        h[edge[t][1]] -= e;
    }
    return e;
}
int main(int argc, char **argv) {
    enum { N = 40000, E = 100000 };
    static int edge[E][2];
    static double x[N][3], b[N][3];
    static unsigned char v[E];
    static int h[256];
    static int colptr[N + 1], row[N * 5];
    static double val[N * 5], y[N], xx[N];
    struct sys s = {b};
    unsigned r = 1;
    for (int i = 0; i < E; i++) {
        r = r * 1103515245u + 12345;
        edge[i][0] = i * 2 / 5;
        edge[i][1] = (i * 2 / 5 + 1 + (r >> 16) % 90) % N;
        v[i] = r >> 20;
    }
    for (int i = 0; i < N; i++) {
        x[i][0] = i * .1;
        x[i][1] = i * .3;
        x[i][2] = 1. / (i + 1);
        xx[i] = i;
    }
    for (int i = 0; i <= N; i++)
        colptr[i] = i * 5;
    for (int i = 0; i < N * 5; i++) {
        r = r * 1103515245u + 12345;
        row[i] = (i / 5 + (r >> 16) % 200) % N;
        val[i] = 1. / (i + 3);
    }
    int which = argc > 1 ? atoi(argv[1]) : 0;
    for (int k = 0; k < 3; k++) {
        if (which == 0)
            springs(E, (const int(*)[2])edge, (const double(*)[3])x, &s);
        if (which == 1)
            hist(E, v, h);
        if (which == 2)
            spmv(N, colptr, row, val, xx, y);
        if (which == 3)
            y[k] += leaving(E, (const int(*)[2])edge, xx, y);
    }
    printf("%a %d %a\n", b[7][1], h[3], y[77]);
    return 0;
}
