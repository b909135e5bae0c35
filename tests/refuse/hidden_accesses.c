/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Accesses to the updated array that do not use the array's name.
// covers: row 14, row 25, row 29, row 44 of docs/constructs.md
#include <stdlib.h>
#include <string.h>
struct sys {
    unsigned char *h;
    const int *k;
    int n;
    double *b;
    int **rows;
};
extern int gn;
extern int gk[];
void local_alias(double *h, const int *k, int n) {
    double *g = h;
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[k[t]] += g[t];
}

void wrap(int *h, const int *k, unsigned n) {
    for (unsigned t = 0; t <= n; t++) // EXPECT: refuse counter-wraps
        h[k[t]]++;
}

void dec(int *h, const int *k, unsigned n) {
    for (unsigned t = n; t-- > 1;) // EXPECT: refuse counter-wraps
        h[k[t]]++;
}

double table[100];
double entry(int i) {
    return table[i];
}

void callee_reads_global(const int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        table[k[t]] += entry(t);
}

__attribute__((pure)) double peek(void);
void pure_reads(const int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        table[k[t]] += peek();
}

__attribute__((pure)) double peekp(int);
void pure_reads2(double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        h[k[t]] += peekp(t);
}

static double *gp;
static void swap_gp(double *o) {
    gp = o;
}

void base_by_callee(const int *k, int n, double *o) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        gp[k[t]] += 1;
        swap_gp(o);
    }
}

void carried_i(double *h, int n, int m) {
    int i = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        i = (i * 7 + 3) % m;
        h[i] += 1;
    }
}

void vari_step(double *h, const int *k, int n) {
    int t = 0;
    while (t < n) { // EXPECT: refuse trip-count
        h[k[t]] += 1;
        t += k[t] > 3 ? 1 : 2;
    }
}

void mset(double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse callee-updates
        memset(h, 0, 8);
        h[k[t]] += 1;
    }
}

void mcpy(double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse callee-reads
        double v;
        memcpy(&v, h + t, 8);
        h[k[t]] += v;
    }
}

static double norm(const double *h) {
    return h[0] + h[1];
}

void usenorm(double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        h[k[t]] += norm(h);
}

void cast_const(const double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        ((double *)h)[k[t]] += h[t];
    }
}

void cmp(double *h, const int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[k[t]] += (t == n - 1) ? h[0] : 1.0;
}

void local_h(const int *k, int n, double *out) {
    double h[10] = {0};
    double *p = &h[0];
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-stored
        h[k[t]] += 1;
        p[1] = 2;
    }
    out[0] = h[1];
}

struct p {
    double x, y;
};
void selfsub(int *k, int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        k[k[t]] += 1;
}

void fl(float *h, const float *w, const int *k, int n) {
    float acc = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        acc = acc + w[t];
        h[k[t]] += acc;
    }
}

void outer(double *h, const int *k, int n, int m) {
    for (int r = 0; r < m; r++)
        for (int t = 0; t < n; t++) // EXPECT: refuse array-read
            h[k[t]] += h[r];
}

void bsearchy(double *h, const int *k, int n, int (*cmp2)(const void *, const void *)) {
    for (int t = 0; t < n; t++) // EXPECT: refuse counter-modified
        h[(int *)bsearch(&t, k, (size_t)n, 4, cmp2) - k] += 1;
}
