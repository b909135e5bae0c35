/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Private variables that only some iterations assign (conditional lastprivate), and their values after the loop.
// covers: row 59 of docs/constructs.md
// COMPILERS: gcc clang-19
#include "case.h"

enum { N = 9000, M = 400 };
static int s[N], r[N];
static double v[N], h[M], g[M];
static double kept[17];

/* The last iteration that assigns may be any one, and need not update an element. */
static void under_conditions(int n, int bound) {
    int k = -1, twice = -2, none = -3;
    double d = 0.5;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (s[t] < bound) {
            k = s[t] + r[t];
            d = v[t];
            d *= 0.5;
        }
        if (r[t] == 7 && s[t] > 30) {
            twice = t;
            h[s[t]] += twice;
            twice++;
        }
        if (v[t] > 2.0) {
            none = t;
            h[none % M] += 1;
        }
        if (s[t] % 5 == 1) {
            k = t;
            h[k % M] += v[t];
        }
    }
    kept[0] = k;
    kept[1] = twice;
    kept[2] = none;
    kept[3] = d;
}

static const double *inner_loops(int n) {
    int c = 0, last = 0;
    const double *at = g;
    float narrow = 0;
    for (int t = n - 1; t >= 0; t -= 2) { // EXPECT: transformed
        for (int i = 0; i < r[t] % 4; i++) {
            c = i + t;
            at = &v[c % N];
            if (i == 2)
                last = t;
            else
                narrow = 0.1 * t;
            h[(s[t] + c) % M] += v[c % N];
        }
    }
    kept[4] = c;
    kept[5] = last;
    kept[6] = narrow;
    return at;
}

static double after_continue(int n) {
    double d = -1.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (s[t] % 3 != 1)
            continue;
        d = v[t];
        if (r[t] < 20)
            continue;
        h[s[t]] += d;
    }
    return d;
}

/* The value leaves the loop, and an enclosing loop uses it. */
static void in_a_loop(int n) {
    int k = 3;
    for (int round = 0; round < 4; round++) {
        kept[7] += k;
        for (int t = 0; t < n / 4; t++) { // EXPECT: transformed
            if (s[t] > M - 20 * round) {
                k = t + round;
                g[r[t]] += k;
            }
            h[s[t]] += v[t];
        }
    }
    kept[8] = k;
}

#define NOTE(x, y)                                                                                 \
    do {                                                                                           \
        x = (y);                                                                                   \
    } while (0)
#define SET(x, y) x = (y)
static void macros(int n) {
    long first = 1, k = 2;
    enum colour { RED, GREEN } colour = RED;
    _Bool is_odd = 0;
    int t = 0;
    while (t < n) { // EXPECT: refuse text
        switch (s[t] % 4) {
        case 0:
            NOTE(k, t);
            g[r[t]] += k;
            break;
        case 1:
            SET(first, s[t] + 1L);
            SET(is_odd, first & 1);
            break;
        default:
            if (r[t] > M / 2)
                colour = GREEN;
        }
        h[s[t]] += 1;
        t++;
    }
    kept[9] = (double)first;
    kept[10] = (double)k;
    kept[11] = colour;
    kept[12] = is_odd;
    kept[13] = t;
}

/* Compilers see that this loop never iterates: `d` keeps its value. */
static void never(void) {
    double d = 3;
    for (int i = 0 - 1; i >= 0; i--) { // EXPECT: transformed
        h[s[i]] += 1;
        d = v[i] * 2;
    }
    kept[16] = d;
}

int main(void) {
    never();
    static const int trips[] = {N, 0, 3, N, 1, N - 1};
    case_values(v, N);
    for (int round = 0; round < 6; round++) {
        case_subscripts(s, N, M);
        case_near_subscripts(r, N, M);
        under_conditions(trips[round], round == 3 ? 0 : 40);
        kept[14] = *inner_loops(trips[round]);
        kept[15] = after_continue(trips[round]);
        in_a_loop(N - round);
        macros(trips[round]);
        CASE_PRINT(h);
        CASE_PRINT(g);
        CASE_PRINT(kept);
    }
    return 0;
}
