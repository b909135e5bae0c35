/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -Wno-sign-compare
// INTEGERS: no
// Tables declared outside the loop, through which pointers step: inner loops with one header fill them and read them.
#include "case.h"

enum { N = 1500, SIDE = 24, TABLE = 12 };
static int s[N], c[N], lows[N], highs[N];
static double e[N], x[N], y[N], h[SIDE * 4], grid[SIDE * SIDE], line[SIDE];

/* A window clipped to the grid; the pointers are null before the first window. */
static void clipped(int n, double radius) {
    double across[TABLE], down[TABLE], *dx = NULL, *dy = NULL;
    int i, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        unsigned left = x[t] - radius < 0 ? 0 : (unsigned)(x[t] - radius);
        unsigned right = x[t] + radius < SIDE ? (unsigned)(x[t] + radius) : SIDE - 1;
        unsigned top = y[t] - radius < 0 ? 0 : (unsigned)(y[t] - radius);
        unsigned bottom = y[t] + radius < SIDE ? (unsigned)(y[t] + radius) : SIDE - 1;
        if (e[t] != 0.0) {
            for (dx = across, i = left; i <= right; ++i, ++dx)
                *dx = (x[t] - i) * (x[t] - i);
            for (dy = down, j = top; j <= bottom; ++j, ++dy) {
                *dy = (y[t] - j) * (y[t] - j);
            }
            for (dy = down, j = top; j <= bottom; ++j, ++dy)
                if (*dy < radius * radius)
                    for (dx = across, i = left; i <= right; ++i, ++dx) {
                        const double v = *dx + *dy;
                        if (v < radius * radius)
                            grid[j * SIDE + i] += e[t] * v;
                    }
        }
    }
}

/* The pointers are stepped where they are used; each loop has its own pointer. */
static void stepped_at_use(int n) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int low = lows[t], high = highs[t];
        double *to;
        const double *from;
        int k;
        for (to = w, k = low; k < high; k++)
            *to++ = e[t] * k;
        for (from = w, k = low; k < high; k++) {
            const double v = *from++;
            line[k] += v;
        }
    }
}

/* The pointer is set before the loops, by an assignment or a declaration, and stepped at the end of their bodies. */
static void set_before(int n, int order) {
    double w[TABLE], *to;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to = &w[0];
        for (int k = 0; k < order; k++) {
            *to = x[t] - k;
            to++;
        }
        const int first = s[t];
        const double *from = &w[0], scale = y[t];
        for (int k = 0; k < order; k++) {
            h[(first + k) % SIDE] += *from * scale;
            from++;
        }
    }
}

/* Two elements at a time, with one pointer for all loops; the second reader ends early. */
static void in_pairs(int n, int order) {
    double w[2 * TABLE + 2], *p;
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (p = w + 2, k = 0; k < order; p += 2, k++) {
            p[0] = x[t] * k;
            p[1] = y[t] - k;
        }
        for (p = w + 2, k = 0; k < order; p += 2, k++)
            h[s[t] / 2 + k] += p[0] * p[1];
        for (p = w + 2, k = 0; k < order; p += 2, k++) {
            if (k > c[t])
                break;
            h[s[t] / 8 + k] -= p[1];
        }
    }
}

/* The pointer is the loop's counter and runs up to an end. */
static void to_an_end(int n, int order) {
    double w[TABLE];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *const end = w + order;
        for (double *p = w; p != end; p++)
            *p = e[t] + x[t];
        for (const double *q = w; q != end; q++)
            h[s[t] % SIDE] += *q;
    }
}

/* Downwards through the whole table, so its length is known from its declaration. */
static void all_of_it(int n) {
    double w[TABLE], *p = NULL;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p = w + TABLE - 1;
        for (int k = TABLE; k > 0; k--, p--)
            *p = e[t] / k;
        p = w;
        for (int k = 0; k < c[t] + 3; k++, p++)
            h[s[t] / 2 + k] += *p;
    }
}

/* The table gives the subscripts. */
static void subscripts(int n, int order) {
    int place[TABLE], *to, *from;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k;
        for (to = place, k = 0; k < order; k++)
            *to++ = (s[t] + k * 5) % (SIDE * 4);
        for (from = place, k = 0; k < order; k++) {
            const int at = *from++;
            h[at] += e[t] * k;
        }
        for (from = place, k = 0; k < order; k++) {
            h[*from] -= 0.5;
            from++;
        }
    }
}

/* Elements written through pointers are read through the table's name, as bounds and as steps. */
static void read_by_name(int n) {
    int w[4] = {0}, *p;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p = w;
        for (int k = 0; k < 4; k++)
            *p++ = 1 + c[(t + k) % n];
        for (int j = 0; j < w[1]; j++)
            h[s[t] / 2 + j] += e[t];
        for (int j = 0; j < 9; j += w[2])
            h[s[t] / 2 + j] -= x[t];
    }
}

int main(void) {
    case_subscripts(s, N, SIDE * 4);
    case_subscripts(c, N, 3);
    case_values(e, N);
    for (int t = 0; t < N; t++) {
        lows[t] = case_below(SIDE / 2);
        highs[t] = lows[t] + case_below(TABLE);
        x[t] = case_below(SIDE) + (case_value() > 0 ? 0.25 : 0.5);
        y[t] = case_below(SIDE) + (case_value() > 0 ? 0.75 : 0.5);
    }
    for (int round = 0; round < 3; round++) {
        clipped(N, 2.5 + round);
        stepped_at_use(N);
        set_before(N, 3 + round);
        in_pairs(N, 4 + round);
        to_an_end(N, 5 + round);
        all_of_it(N);
        read_by_name(N);
        subscripts(N, 3 + 2 * round);
    }
    CASE_PRINT(grid);
    CASE_PRINT(line);
    CASE_PRINT(h);
    return 0;
}
