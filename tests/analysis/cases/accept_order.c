/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Updates that do not commute: each element's updates must keep their order. Covers rows 22, 23,
 * 27, 28, 37 and 39 of docs/constructs.md, and its note on methods that keep the order. */
#include <math.h>
#include <stdbool.h>

#define MAX(a, b) ((a) > (b) ? (a) : (b))

void several_operators(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+,kept)
        h[s[i]] += 2.0;
        h[s[i]] *= 2.0;
    }
}

void no_operator(int n, const int *s, const double *e, double *restrict h, unsigned *restrict u) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        h[s[i]] /= 2.0;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        h[s[i]] = e[i] - h[s[i]];
    for (int i = 0; i < n; i++) // EXPECT: transform u(kept)
        u[s[i]] <<= 1;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        h[s[i]] = h[s[i]] + h[s[i]];
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        h[s[i]] = sqrt(h[s[i]] + 1.0);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+,kept)
        h[s[i]] += 0.5 * h[s[i]];
}

/* A counter that stops at a constant limit has an operator of its own if all its updates have one
 * limit, which no step passes. */
void saturating(int n, const int *s, const int *r, unsigned limit, unsigned char *restrict h,
                signed char *restrict g) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+limit)
        if (h[s[i]] < 255)
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(+limit)
        if (i % 3) {
            if (30 >= h[s[i]])
                h[s[i]] = 1 + h[s[i]];
        }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+limit)
        if (h[s[i]] < 20)
            h[s[i]]++;
        if (h[r[i]] <= 19)
            h[r[i]] += 1;
        if (20 > h[i])
            ++h[i];
        if (19 >= h[r[i]])
            h[r[i]]++;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+limit,kept)
        if (h[s[i]] < 20)
            h[s[i]]++;
        if (h[r[i]] <= 20)
            h[r[i]]++;
    }
    for (int i = 0; i < n; i++) // EXPECT: transform g(+limit)
        if (g[s[i]] != 127)
            g[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform g(kept)
        if (g[s[i]] < 100u)
            g[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform g(kept)
        if (g[s[i]] != 126)
            g[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < 256)
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] <= 255)
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < limit)
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] > 7)
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (7 < h[s[i]])
            h[s[i]]++;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < 9)
            h[s[i]]--;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < 9)
            h[s[i]] += 2;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < 9)
            h[s[i]] = 1 - h[s[i]];
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < 9)
            h[s[i]]++;
        else
            h[s[i]] = 0;
}

void rounded(int n, const int *s, int *h, bool *seen) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+,kept)
        h[s[i]] += 0.5;
    for (int i = 0; i < n; i++) // EXPECT: transform seen(|,kept)
        seen[s[i]] |= 1;
}

void minima(int n, const int *s, const double *e, double *restrict h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        if (h[s[i]] < e[i])
            h[s[i]] = e[i];
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        if (e[i] > h[s[i]]) {
            h[s[i]] = e[i];
        }
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        h[s[i]] = h[s[i]] < e[i] ? e[i] : h[s[i]];
    for (int i = 0; i < n; i++) // EXPECT: transform h(min,kept)
        h[s[i]] = fmin(h[s[i]], e[i]);
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        h[s[i]] = MAX(h[s[i]], e[i]);
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] < e[i])
            h[s[i]] = e[i] + 1.0;
    for (int i = 0; i < n; i++) // EXPECT: transform h(kept)
        if (h[s[i]] > 100.0)
            h[s[i]] = 0.0;
        else
            h[s[i]] += e[i];
}

void integer_minima(int n, const int *s, const int *e, int *restrict h, const short *small) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(max)
        if (h[s[i]] < e[i])
            h[s[i]] = e[i];
    for (int i = 0; i < n; i++) // EXPECT: transform h(min)
        h[s[i]] = e[i] >= h[s[i]] ? h[s[i]] : e[i];
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        if (h[s[i]] < small[i])
            h[s[i]] = small[i];
    for (int i = 0; i < n; i++) // EXPECT: transform h(max,kept)
        if (h[s[i]] < h[s[i]] + e[i])
            h[s[i]] = h[s[i]] + e[i];
}

void stored(int n, const int *s, double *h, double *restrict o) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+,kept) guards=1
        h[i] = 0;
        h[s[i]] += 1.0;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) o(kept)
        o[i] = i;
        h[s[i]] += 1.0;
    }
}

void rows(int n, const int *start, const int *col, double *restrict y) {
    for (int i = 0; i < n; i++) { // EXPECT: transform y(+,kept)
        y[i] = 0;
        for (int p = start[i]; p < start[i + 1]; p++)
            y[col[p]] += 1.0;
    }
}

/* Covers rows 45 and 47. */
void local_row(int n, const int *s, double (*b)[3]) {
    for (int i = 0; i < n; i++) { // EXPECT: transform b(+,kept)
        double *row = b[s[i]];
        row[1] += 1.0;
    }
}
