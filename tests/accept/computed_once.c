/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Subscripts that an inspector cannot compute a second time with certainty: votes by angle, distances of pairs,
// logarithmic bins. Each iteration is executed once, in bins or on private copies.
// covers: row 33 of docs/constructs.md
// MAY-RUN-SERIALLY: no plan exists for these loops, which some methods need
#include <math.h>
#include <string.h>

#include "case.h"

enum { N = 70000, FEW = 300, BINS = 900, SIDE = 40, ANGLES = 45 };
static double x[N], y[N], w[N], h[BINS + 1], other[BINS + 1], shared[N];
static float image[SIDE * SIDE], votes[ANGLES * 4 * SIDE];
static int pairs[BINS], counts[BINS], table[64];
static long double wide;

static void hough(int n, const float *pixel, float *vote) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int row = i / SIDE, column = i % SIDE;
        const float magnitude = pixel[i];
        for (int angle = 0; angle < ANGLES; angle++) {
            const float theta = (float)angle * 0.0174533f;
            const float rho = (float)column * cosf(theta) + (float)row * sinf(theta);
            vote[(int)roundf(rho) * ANGLES + angle] += magnitude;
        }
    }
} // BINNED: 18

static void distances(int n, double width) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            const double r = sqrt(pow(x[i] - x[j], 2) + pow(y[i] - y[j], 2));
            const int k = (int)(r / width);
            if (k < BINS)
                pairs[k] += 2;
        }
} // BINNED: 30

static void logarithms(int n, const double *v, double *to) { // v may overlap to
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[(int)(log(fabs(v[t]) + 3.0) * 400)] += v[t];
}

static void extended(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        counts[(int)((x[t] + wide) * 200.0L)]++;
} // BINNED: 45

static int __attribute__((target("sse2"))) bin_of(double v) {
    return (int)((v + 1.0) * 400);
}
static void by_function(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        counts[bin_of(x[t])] += t & 3;
} // BINNED: 53

static void through_a_pointer(int n) {
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int *p = &k;
        *p = bin_of(y[t]);
        h[k] += w[t];
    }
} // BINNED: 59

/* The condition protects the load from `map`, and exp cannot be evaluated a second time. */
static void under_a_condition(int n, const int *map) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (exp(x[t]) < 2.0)
            other[map[(int)((x[t] + 1.0) * 20)]] += w[t];
} // BINNED: 68

static int both(int of, int *p) {
    p[0] = of & 127;
    return of / 8;
}
static double with_sums(int n) {
    double sum = 0;
    double most = -9;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int p[1];
        sum += both(bin_of(x[t]), p);
        if (w[t] > most)
            most = w[t];
        other[p[0]] -= 1.5;
    }
    return sum + most;
} // BINNED: 80

/* Each set pixel votes. Pixels may overlap the votes; everything else is private to a vote. */
static void edges(int n, int width, const unsigned char *set, int *vote) {
    int row, column, angle, rho;
    for (row = 0; row < n; row++) // EXPECT: transformed
        for (column = 0; column < width; column++)
            if (set[row * width + column] == 255)
                for (angle = 0; angle < ANGLES; angle++) {
                    const double theta = angle * 0.0174533;
                    rho = (int)(column * cos(theta) + row * sin(theta));
                    rho += SIDE;
                    vote[rho * ANGLES + angle]++;
                }
} // BINNED: 93

int main(void) {
    static unsigned char set[SIDE * SIDE];
    static int marks[3 * SIDE * ANGLES];
    case_values(x, N);
    case_values(y, N);
    case_values(w, N);
    for (int i = 0; i < N; i++) {
        x[i] = x[i] > 0.999 || x[i] < -0.999 ? 0.125 : x[i] * (getenv("CASE_INTEGERS") ? 0.2 : 1.0);
        y[i] = y[i] > 0.999 || y[i] < -0.999 ? 0.625 : y[i] * (getenv("CASE_INTEGERS") ? 0.2 : 1.0);
    }
    for (int i = 0; i < SIDE * SIDE; i++)
        image[i] = (float)w[i];
    for (int i = 0; i < 64; i++)
        table[i] = i * 5;
    memcpy(shared, x, sizeof shared);
    wide = 1;
    for (int round = 0; round < 3; round++) {
        hough(SIDE * SIDE, image, votes);
        distances(FEW, 0.002);
        logarithms(N, x, h);
        logarithms(N - 7, shared, shared + 100); /* the arrays overlap */
        extended(N);
        by_function(N);
        through_a_pointer(N);
        under_a_condition(N, table);
        printf("%a\n", with_sums(N));
        for (int i = 0; i < SIDE * SIDE; i++) {
            set[i] = i % 7 == round ? 255 : (unsigned char)i;
            marks[i] = i % 5 == round ? -1 : i;
        }
        edges(SIDE, SIDE, (const unsigned char *)marks + 1800, marks); /* pixels and votes overlap */
        edges(SIDE, SIDE, set, marks);
        CASE_PRINT(marks);
        CASE_PRINT(votes);
        CASE_PRINT(pairs);
        CASE_PRINT(h);
        CASE_PRINT(shared);
        CASE_PRINT(counts);
        CASE_PRINT(other);
        x[round * 7] *= 0.5;
        shared[round * 9] *= -0.25;
    }
    return 0;
}
