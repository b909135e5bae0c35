/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The advice of docs/reasons.md, followed: each loop is the example of a reason, changed as it says.
// ADVICE: R106 R107 R108 R109 R110 R113 R114 R115 R116 R202 R203 R204 R205 R207 R208 R301 R303 R304
// ADVICE: R305 R306 R307 R402 R403 R404 R406 R501 R502 R504
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N + 1], c[N], key[N], place[N], found[N], flags[ROWS];
static double e[N], w[N], o[N], copy[ROWS], sums[N], seen[N], h[ROWS], g[ROWS], rows[ROWS][3];
static struct { unsigned char a, b; } small[ROWS];
static struct { double d; long l; } both[ROWS];
static struct results { double *b; } store = {g};
static volatile double input = 0.75;
static double last_value;

static void updates(int n) {
    memcpy(copy, h, sizeof h);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += 0.5 * copy[t % ROWS];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
    h[7] = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = rows[s[t]];
        row[1] += e[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        rows[s[t]][0] += e[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        small[s[t]].a++;
    for (int t = 0; t < n; t++)
        place[t] = (s[t] + key[t]) % ROWS;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[place[t]] += e[t];
    for (int t = 0; t < n; t++)
        found[t] = (int)(8.0 * fabs(log(1.5 + fabs(e[t])))) % ROWS;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        flags[found[t]] += 1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        seen[t] = e[t];
        h[s[t]] += e[t];
    }
}

static void add_to(const struct results *results, int n) {
    if (results) {
        double *b = results->b;
        for (int t = 0; t < n; t++) // EXPECT: transformed
            b[s[t]] += e[t];
    }
}

static double memory(int n) {
    double last = 0, sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = e[t];
        h[s[t]] += o[t];
    }
    for (int t = 0; t < n; t++)
        sums[t] = sum += e[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += sums[t];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double f[3] = {e[t], 0, 0};
        if (c[t])
            f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (c[t] > 0) {
            last = w[t];
            h[s[t]] += last;
        }
    const double once = input;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += once;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        both[s[t]].d += 1;
    return last;
}

static void control(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        flags[s[t]]++;
    const int first_bound = n;
    for (int t = 0; t < first_bound; t++) { // EXPECT: transformed
        flags[s[t]]++;
        n -= c[t];
    }
    for (int t = 1; t < first_bound; t += 2) // EXPECT: transformed
        flags[s[t]]++;
    for (unsigned t = 0; t < (unsigned)first_bound; t++) // EXPECT: transformed
        flags[s[t]]++;
    int end = 0;
    while (end < first_bound && key[end] != 77)
        end++;
    for (int t = 0; t < end; t++) // EXPECT: transformed
        h[s[t]] += n;
}

static double value(int t) { return e[t] * 2; }
static double depth(int k) {
    double d = 0;
    for (; k > 0; k /= 2)
        d++;
    return d;
}
static void add(double *p, double v) { *p += v; }

static void calls(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += value(t);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += depth(t);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add(&h[s[t]], e[t]);
    for (int t = 0; t < n; t++)
        if (s[t] < 0)
            return;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        g[s[t]]++;
}

#define WEIGHT 2
static void text(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += WEIGHT;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int k = s[t];
        h[k] += 1;
    }
}

int main(void) {
    case_subscripts(s, N + 1, ROWS);
    case_subscripts(key, N, ROWS);
    case_subscripts(c, N, 2);
    case_values(e, N);
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        updates(N);
        add_to(round == 1 ? NULL : &store, N);
        last_value += memory(N);
        control(N);
        calls(N);
        text(N);
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(flags);
    for (int k = 0; k < ROWS; k++)
        printf("%a %a %d %a\n", rows[k][0], rows[k][1], small[k].a, both[k].d);
    printf("%a %a\n", last_value, seen[3]);
    return 0;
}
