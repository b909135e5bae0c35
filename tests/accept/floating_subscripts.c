/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts computed by floating-point arithmetic: histograms of measured values, particles
// assigned to cells, weights added to two neighbours, the nearest of several centres.
// covers: row 33, row 20 of docs/constructs.md
#include <math.h>

#include "case.h"

enum { N = 20000, BINS = 700, SIDE = 24, CENTRES = 12 };
static double x[N], y[N], w[N];
static float f[N];
static int plain[BINS], drawn[BINS];
static double weighted[BINS + 1], cell[SIDE][SIDE];
static unsigned char narrow[256];
static double centre[CENTRES][2], sum[CENTRES][2];
static int members[CENTRES];

static void histogram(int n, double low, double scale) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        plain[(int)((x[t] - low) * scale)]++;
}

static void shared_out(int n, float low, float scale) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const float at = (f[t] - low) * scale;
        const int k = (int)floorf(at);
        const float part = at - (float)k;
        weighted[k] += (1.0f - part) * w[t];
        weighted[k + 1] += part * w[t];
    }
}

static void cells(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = (int)((x[t] + 1.0) * (SIDE / 2.0)), j = (int)((y[t] + 1.0) * (SIDE / 2.0));
        if (i < 0 || i >= SIDE || j < 0 || j >= SIDE)
            continue;
        cell[i][j] += w[t];
    }
}

static inline int bin_of(double v, double scale) {
    double scaled = (v + 1.0) * scale;
    return (int)fmin(fmax(scaled, 0.0), BINS - 1);
}

static void clamped(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int k = bin_of(x[t], 0.5 * BINS);
        drawn[k] += t & 3;
        narrow[lround(100.0 * sqrt(y[t] + 1.0))]++;
    }
}

static int nearest(const double *p) {
    int best = 0;
    double least = 1e300;
    for (int c = 0; c < CENTRES; c++) {
        const double dx = p[0] - centre[c][0], dy = p[1] - centre[c][1], d = dx * dx + dy * dy;
        if (d < least) {
            least = d;
            best = c;
        }
    }
    return best;
}

static double point[N / 4][2];
static void assign(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int c = nearest(point[t]);
        members[c]++;
        sum[c][0] += point[t][0];
        sum[c][1] += point[t][1];
    }
}

static void near_ones(int n, double limit) {
    for (int t = 1; t < n; t++) { // EXPECT: transformed
        const double d = (x[t] - x[t - 1]) * (y[t] - y[t - 1]);
        if (d * d < limit)
            weighted[(int)((d + 4.0) * 80.0)] += d;
    }
}

/* limit[c] is a const object and part of the plan's key. */
static void by_limits(int n, const double *limit) {
    for (int c = 0; c < 3; c++)
        for (int t = 0; t < n; t++) // EXPECT: transformed
            plain[x[t] < limit[c] ? c : 3 + (t & 7)]++;
}

int main(void) {
    case_values(x, N);
    case_values(y, N);
    case_values(w, N);
    case_values(&point[0][0], N / 2);
    case_values(&centre[0][0], 2 * CENTRES);
    for (int i = 0; i < N; i++) {
        x[i] = x[i] > 0.999 || x[i] < -0.999 ? 0.125 : x[i] * (getenv("CASE_INTEGERS") ? 0.2 : 1.0);
        y[i] = y[i] > 0.999 || y[i] < -0.999 ? 0.625 : y[i] * (getenv("CASE_INTEGERS") ? 0.2 : 1.0);
        f[i] = (float)x[i];
    }
    for (int round = 0; round < 4; round++) {
        histogram(N - round, -1.0, 0.5 * BINS);
        shared_out(N, -1.0f, 0.5f * BINS);
        cells(N);
        clamped(N);
        assign(N / 4);
        near_ones(N, 0.3);
        by_limits(N, centre[0]);
        CASE_PRINT(plain);
        CASE_PRINT(weighted);
        CASE_PRINT(cell);
        CASE_PRINT(drawn);
        CASE_PRINT(narrow);
        CASE_PRINT(members);
        CASE_PRINT(sum);
        x[round * 7] *= 0.5;
        centre[round][0] *= -0.75;
    }
    return 0;
}
