/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The element is reached through a local pointer that the iteration sets, by a call that returns the distance from the
// array.
// covers: row 17, row 47 of docs/constructs.md
// MAY-RUN-SERIALLY: in some calls the arrays overlap
#include "case.h"

enum { N = 9000, WIDE = 30, HIGH = 30, M = WIDE * HIGH };
typedef struct {
    double rho, jx;
    int hits;
} node;
typedef struct {
    int nx, ny;
    node *nodes;
} mesh;
static int s[N];
static double x[N], y[N], h[2 * M];
static node nodes[M];

static inline size_t at(const mesh *m, int i, int j) {
    if (i >= m->nx)
        i -= m->nx;
    if (j >= m->ny)
        j -= m->ny;
    return (size_t)j * (size_t)m->nx + (size_t)i;
}

static inline int wrapped(int i, int n) {
    while (i >= n)
        i -= n;
    return i;
}

static void deposit(mesh *m, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = (int)x[t], j = (int)y[t];
        const double w[2] = {x[t] - i, y[t] - j};
        for (int c = 0; c < 4; c++) {
            node *nd = m->nodes + at(m, i + (c & 1), j + (c >> 1));
            nd->rho += w[c & 1];
            nd->jx += w[c & 1] * w[c >> 1];
            nd->hits++;
        }
    }
}

static void to_elements(double *a, const double *from, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *to = &a[wrapped(s[t], M)], *next = wrapped(s[t] + 1, M) + a;
        *to += from[t % M];
        *next -= 0.5 * from[t % M];
    }
}

static void to_rows(double (*a)[3], int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = a[wrapped(s[t], M / 3)];
        row[0] += x[t];
        row[2] -= y[t];
    }
}

static void walks(double *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *to = a + wrapped(s[t], M);
        for (int c = 0; c < 3; c++, to++)
            *to += x[t];
    }
}

static void from_a_place(double *a, int n, int first) {
    double *to = a + wrapped(first, M);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[wrapped(s[t], M)] += x[t];
}

static void show(void) {
    CASE_PRINT(h);
    for (int i = 0; i < M; i++) {
        case_print("node", &nodes[i].rho, 2 * sizeof(double));
        case_print("hits", &nodes[i].hits, sizeof(int));
    }
}

int main(void) {
    mesh m = {WIDE, HIGH, nodes};
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, 2 * M);
        for (int t = 0; t < N; t++) {
            x[t] = case_below(WIDE) + 0.5 * case_below(2);
            y[t] = case_below(HIGH) + 0.25 * case_below(4);
        }
        case_values(h, 2 * M);
        deposit(&m, N);
        to_elements(h, x, N);
        to_elements(h, h + M, N);
        to_elements(h, h + M / 2, N); /* overlapping */
        to_rows((double (*)[3])h, N);
        walks(h, N);
        from_a_place(h, N, 3 * M / 2);
        show();
    }
    return 0;
}
