/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Covers rows 9, 11, 20, 21, 26, 46, 47, 51, 53, 54, 58 and 59 of docs/constructs.md. */
#include <math.h>
#include <stddef.h>

void direct(int n, const int *s, const double *e, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 verifiable
        h[s[i]] += e[i];
}

void spellings(int n, const int *restrict s, const double *restrict e, double *restrict h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] -= e[i];
        h[s[i]] = h[s[i]] + e[i];
        h[s[i]] = e[i] + h[s[i]];
        h[s[i]] = h[s[i]] - e[i];
        h[s[i]] = e[i] + h[s[i]] - 1.0;
        h[s[i]]++;
        --h[s[i]];
    }
}

void local_index(int n, const int *s, const double *e, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) guards=1 verifiable
        int k = s[i];
        h[k] += e[i];
    }
}

void chain(int n, const int *s, const int *m, const double *e, double *h) {
    int k, l;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable privates=2
        k = s[i];
        l = m[k] + 1;
        if (l > 4)
            l = l - 4;
        k = l > 2 ? l : 0;
        h[k] += e[i];
    }
}

void components(int n, const int (*edge)[2], const double (*f)[3], double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transform b(+) guards=1 verifiable
        int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            b[i][c] += f[t][c];
            b[j][c] -= f[t][c];
        }
    }
}

void index_inside(int n, const int (*tri)[3], const double (*f)[3], double (*b)[3]) {
    for (int t = 0; t < n; t++) // EXPECT: transform b(+) verifiable
        for (int a = 0; a < 3; a++) {
            int row = tri[t][a];
            for (int c = 0; c < 3; c++)
                b[row][c] += f[a][c];
        }
}

void flat(int n, const int *s, const double *f, double *b) {
    for (int t = 0; t < n; t++) // EXPECT: transform b(+) verifiable
        for (int c = 0; c < 3; c++)
            b[3 * s[t] + c] += f[c];
}

void csr(int n, const int *start, const int *col, const double *val, const double *x, double *y) {
    for (int i = 0; i < n; i++) // EXPECT: transform y(+) guards=3 verifiable
        for (int p = start[i]; p < start[i + 1]; p++) {
            int j = col[p];
            y[i] += val[p] * x[j];
            y[j] += val[p] * x[i];
        }
}

void local_sum(int n, const int *start, const int *col, double (*val)[3][3], double (*x)[3],
               double (*y)[3]) {
    for (int i = 0; i < n; i++) { // EXPECT: transform y(+) verifiable
        double sum[3] = {0};
        for (int p = start[i]; p < start[i + 1]; p++) {
            int j = col[p];
            for (int r = 0; r < 3; r++)
                for (int c = 0; c < 3; c++) {
                    sum[r] += val[p][r][c] * x[j][c];
                    y[j][c] += val[p][r][c] * x[i][r];
                }
        }
        for (int c = 0; c < 3; c++)
            y[i][c] += sum[c];
    }
}

int while_loop(int n, const int *s, double *h) {
    int i = 0;
    while (i < n) { // EXPECT: transform h(+) counter-live
        h[s[i]] += 1.0;
        i++;
    }
    return i;
}

int last_value(int n, const int *s, double *h) {
    int k = -1;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) last=k
        k = s[i];
        h[k] += 1.0;
    }
    return k;
}

void other_operators(int n, const int *s, unsigned *a, unsigned *b, unsigned *c, unsigned *d) {
    for (int i = 0; i < n; i++) { // EXPECT: transform a(*) b(&) c(|) d(^) guards=1
        a[s[i]] *= 3;
        b[s[i]] &= 7;
        c[s[i]] |= 8;
        d[s[i]] ^= 1;
    }
}

static double global_h[100];

void globals(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: transform global_h(+) guards=0
        global_h[s[i]] += sqrt((double)i);
}

int local_array(int n, const int *s) {
    int h[10] = {0};
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0
        h[s[i]]++;
    return h[3];
}

void conditional(int n, const int *s, const double *e, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        if (s[i] < 0)
            continue;
        switch (s[i] & 3) {
        case 0:
            h[s[i]] += e[i];
            break;
        default:
            h[s[i] + 1] += e[i];
        }
    }
}

void unsigned_counter(size_t n, const unsigned *s, double *restrict h) {
    for (size_t i = 0; i < n; ++i) // EXPECT: transform h(+) verifiable
        h[s[i]] += 1.0;
    for (int i = 0; i < n; ++i) // EXPECT: transform h(+)
        h[s[i]] += 1.0;
    for (long i = (long)n - 1; i >= 0; i -= 2) // EXPECT: transform h(+)
        h[s[i]] += 1.0;
}
