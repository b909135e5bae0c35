/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Rows behind pointers in bins: an inner loop over a row becomes one record, whose operands are read when it is
// applied. The loops are k-means, overlapping rows, bounds and operands that depend on the iteration, conditions,
// and floats that may overlap other floats.
// MAY-RUN-SERIALLY: reads overlap rows, or rows each other
#include <math.h>
#include <string.h>

#include "case.h"

enum { N = 4000, D = 10, CENTRES = 14, ROWS = 600 };
static float points[N][D + 1], centres[CENTRES][D], sums[CENTRES][D];
static float *point[N], *centre[CENTRES], *sum[CENTRES], *same[CENTRES + 64];
static double far[ROWS * 3 + D], *row[ROWS], w[N], wide[ROWS][D + 2], *apart[ROWS], drawn[N], whole[ROWS][D + 2];
static struct sphere {
    double mass, spin[2];
} ball[ROWS][D + 2], *balls[ROWS];
static int member[N], count[CENTRES], key[N], length[N], pairs[N][4];

static float distance(const float *a, const float *b, int n) {
    float all = 0;
    for (int j = 0; j < n; j++)
        all += (a[j] - b[j]) * (a[j] - b[j]);
    return all;
}
static int nearest(const float *p, int dimensions, float **from, int n) {
    int best = 0;
    float least = 1e30f;
    for (int k = 0; k < n; k++) {
        const float d = distance(p, from[k], dimensions);
        if (d < least) {
            least = d;
            best = k;
        }
    }
    return best;
}

static double kmeans(int n, int d, float **p, float **from, float **to, int *its, int *members) {
    double changed = 0;
    int k, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = nearest(p[t], d, from, CENTRES);
        if (its[t] != k)
            changed += 1.0;
        its[t] = k;
        members[k]++;
        for (j = 0; j < d; j++)
            to[k][j] += p[t][j];
    }
    return changed;
}

/* Each element belongs to several rows. */
static void overlapping(int n, int d) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < d; j++)
            row[key[t]][j] = w[t] - row[key[t]][j] * 0.5;
} // BINNED: 56

static void bounds(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double scale = w[t] * 0.25;
        const short shift = (short)(t & 3);
        for (unsigned j = 2; j <= (unsigned)length[t]; j++)
            apart[key[t]][j] -= scale * (double)(j + shift) + (double)points[t][0];
    }
} // BINNED: 62

static void conditions(int n, int d) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (key[t] % 3 == 0)
            continue;
        if (w[t] > 0)
            for (int j = 0; j < d; j++) {
                apart[key[t]][j] *= 1.0 + w[t] * 1e-3;
            }
    }
}

/* The members updated are not adjacent. */
static void records(int n, int d) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < d; j++)
            balls[key[t]][j].spin[1] += w[t];
}

/* Only some iterations read centres, but not the first ones; or some iterations read other centres. */
static void sometimes(int n, int d, float **p, float **from, float **to, int *members) {
    int k, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = 0;
        if (t % 256 == 37)
            k = nearest(p[t], d, from, CENTRES);
        members[k]++;
        for (j = 0; j < d; j++)
            to[k][j] += p[t][j];
    }
}
static void others(int n, int d, float **p, float **from[2], float **to, int *members) {
    int k, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        k = nearest(p[t], d, from[t % 256 == 37], CENTRES);
        members[k]++;
        for (j = 0; j < d; j++)
            to[k][j] += p[t][j];
    }
}
static void after(int n, int d, float **p, float **from, float **to, int *members) {
    int k, j;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (t % 256 != 37)
            continue;
        k = nearest(p[t], d, from, CENTRES);
        members[k]++;
        for (j = 0; j < d; j++)
            to[k][j] += p[t][j];
    }
}

/* Since exp may set errno, one thread executes each inner iteration. Rows of records then have no spans. */
static void led(int n, const int *many, const int *k, const int (*list)[4], const double *x, double *to, double (*rows)[D + 2]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int i = 0; i < many[t] % 4; i++) {
            const int j = list[t][i];
            const double d = 1 / (1 + fabs(x[t] - x[j]));
            const double e = floor(exp(d) + exp(d * d) + exp(d * 3) + d * d * d);
            to[j] += e;
        }
        const int width = many[t];
        for (int j = 0; j < width; j++)
            rows[k[t]][j] += x[j];
    }
} // BINNED: 123

int main(void) {
    for (int t = 0; t < N; t++) {
        point[t] = points[t];
        for (int j = 0; j <= D; j++)
            points[t][j] = (float)case_value();
        w[t] = case_value();
        key[t] = case_below(ROWS);
        length[t] = case_below(D + 2);
        for (int i = 0; i < 4; i++)
            pairs[t][i] = (t * 7 + i * 31) % N;
        member[t] = -1;
    }
    points[77][3] = NAN;
    for (int k = 0; k < CENTRES; k++) {
        centre[k] = centres[k];
        sum[k] = same[k + 32] = sums[k];
        for (int j = 0; j < D; j++)
            centres[k][j] = points[k * 7][j];
    }
    for (int k = 0; k < ROWS; k++) {
        row[k] = far + 3 * k;
        balls[k] = ball[(k * 11) % ROWS];
        apart[k] = wide[(k * 7) % ROWS];
    }
    apart[5] = apart[9]; /* rows 5 and 9 are the same */
    for (int round = 0; round < 4; round++) {
        printf("%a\n", kmeans(N - round, D, point, centre, sum, member, count));
        overlapping(N, D);
        bounds(N);
        conditions(N, D);
        records(N, D);
        led(N, length, key, pairs, w, drawn, whole);
        CASE_PRINT(drawn);
        CASE_PRINT(whole);
        CASE_PRINT(ball);
        CASE_PRINT(sums);
        CASE_PRINT(count);
        CASE_PRINT(member);
        CASE_PRINT(far);
        CASE_PRINT(wide);
        for (int k = 0; k < CENTRES; k++)
            for (int j = 0; j < D; j++)
                centres[k][j] = sums[k][j] / (float)(count[k] + 1);
        w[round * 5] *= 2;
    }
    /* The sums are the centres as well. */
    printf("%a\n", kmeans(N, D, point, sum, sum, member, count));
    /* The nearest centre depends on sums updated before. */
    float **either[2] = {centre, same + 32};
    memset(sums, 0, sizeof sums);
    sometimes(N, D, point, same + 32, sum, count);
    CASE_PRINT(sums);
    memset(sums, 0, sizeof sums);
    others(N, D, point, either, sum, count);
    CASE_PRINT(sums);
    memset(sums, 0, sizeof sums);
    after(N, D, point, same + 32, sum, count);
    /* Points that are sums: a point read too early would select another row. */
    for (int t = 0; t < 40; t++)
        point[t * 3 + 5] = sums[t % CENTRES];
    printf("%a\n", kmeans(N, D, point, centre, sum, member, count));
    CASE_PRINT(sums);
    CASE_PRINT(count);
    CASE_PRINT(member);
    return 0;
}
