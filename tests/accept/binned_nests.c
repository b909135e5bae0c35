// Inner loops with constant bounds update the parts of a row. WIDE lists the loops for which one record, made
// before the inner loop, holds all operands of that loop. Other loops make a record for each element.
// INTEGERS: no
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "case.h"

enum { N = 3000, M = 150 };
static int i1[N], i2[N], several[N][2];
static double at[M][3], w[N], u[N], by[N][3], blocks_by[N][3][3];
static float part[N][4];

static double f[M + 4][3], g[M][3], a[M][3][3], s[M], flat[3 * M];
static float single[M][4];
static int counts[M][2];
static unsigned char bytes[M][4];
// Records whose members are rows of 24 and of 48 bytes.
static struct particle {
    double force[3];
    double mass[3];
    struct {
        double turn[3][2];
    } spin;
} particle[M];
static struct wide {
    double many[20];
} wide[M];

static void both_ends(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = i1[t], j = i2[t];
        for (int c = 0; c < 3; c++) {
            f[i][c] += at[i][c] - at[j][c];
            f[j][c] -= at[i][c] - at[j][c];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            f[i1[t]][c] = f[i1[t]][c] * w[t] + by[t][c];
        for (int c = 0; c < 3; c++)
            f[i2[t]][c] -= by[t][2 - c];
    }
} // WIDE: 33 40

// The counters belong to the function. Loops cover a part of the row, contain two loops, or use the counter as a value.
static void of_blocks(int n) {
    int r, c;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (r = 0; r < 3; r++)
            for (c = 1; c < 3; c++)
                a[i1[t]][r][c] += blocks_by[t][c][r];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (r = 1; r < 3; r++)
            for (c = 0; c <= 2; ++c)
                a[i1[t]][c][r] -= blocks_by[t][r][c] * (r - c * 2.5);
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (r = 0; r < 3; r++) {
            for (c = 0; c < 3; c += 1)
                a[i1[t]][r][c] *= w[t];
            g[i1[t]][r] += w[t];
            for (c = 0; c < 3; c += 1)
                a[i2[t]][r][c] += blocks_by[t][r][c];
        }
    }
} // WIDE: 51 56 60

// Updates without operands, next to others and alone.
static void without_values(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            f[i1[t]][c] *= 0.5;
            f[i2[t]][c] += by[t][c];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 2; c++)
            counts[i1[t]][c]++;
    }
} // WIDE: 73 79

static void of_two_arrays(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            f[i1[t]][c] += by[t][c];
            s[i2[t]] += by[t][c] * 2;
            g[i1[t]][c] -= by[t][c];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[i1[t]][0] += w[t];
        f[i1[t]][1] -= w[t];
        for (int c = 0; c < 3; c++)
            g[i1[t]][c] += by[t][c];
        s[i1[t]] += u[t];
    }
} // WIDE: 86 93

// Two successive updates of one element, and updates of two elements that may be the same: their order must be kept.
static void in_order(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            f[i1[t]][c] += by[t][c];
            f[i1[t]][c] = f[i1[t]][c] * 0.5 - w[t];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                a[i1[t]][r][c] = a[i1[t]][r][c] * 0.5 + w[t];
                a[i2[t]][c][r] = a[i2[t]][c][r] * 0.75 - by[t][c];
            }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            f[i1[t]][c] = f[i1[t]][c] * 0.5 + w[t];
            f[i2[t]][2 - c] = f[i2[t]][2 - c] * 0.75 - by[t][c];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int r = 0; r < 3; r++) {
            f[i1[t]][r] = f[i1[t]][r] * 0.5 + w[t];
            for (int c = 0; c < 3; c++)
                f[i2[t]][c] = f[i2[t]][c] * 0.75 - by[t][c] * r;
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            for (int k = 0; k < 2; k++)
                f[i2[t]][c] = f[i2[t]][c] * 0.75 - by[t][k];
            f[i1[t]][c] = f[i1[t]][c] * 0.5 + w[t];
        }
    }
} // WIDE: 104
// ELEMENTS: 110 117 123 130

static void under_conditions(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (i2[t] % 3)
            for (int c = 0; c < 3; c++)
                f[i1[t]][c] += by[t][c];
        else
            for (int k = 0; k < 2; k++)
                for (int c = 0; c < 3; c++)
                    f[several[t][k]][c] -= by[t][c] * k;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int k = 0; k < i2[t] % 3; k++)
            for (int c = 0; c < 3; c++)
                f[several[t][k]][c] = f[several[t][k]][c] * by[t][k] + by[t][c];
    }
} // WIDE: 141 150

static void extrema(int n, double (*restrict low)[3], double (*restrict high)[3], const int *restrict k,
                    const double (*restrict x)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            if (x[t][c] < low[k[t]][c])
                low[k[t]][c] = x[t][c];
            high[k[t]][c] = fmax(high[k[t]][c], x[t][c]);
        }
    }
} // WIDE: 159

// Floats that each update rounds, integers that stay int, counters of one byte, and unsigned counters.
static void types(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (unsigned c = 0; c < 4; c++) {
            single[i1[t]][c] += w[t] * -c;
            single[i1[t]][c] -= part[t][c];
        }
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (unsigned char c = 0; c < 4; c++)
            bytes[i1[t]][c] += c * i2[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (long c = 0; c < 2; c++)
            counts[i1[t]][c] += several[t][c];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (unsigned c = 0; c < 4; c++)
            single[i1[t]][c] += part[t][c] * (-c >> 8);
    }
} // WIDE: 176 180 184
// ELEMENTS: 170

static void of_members(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = i1[t];
        for (int c = 0; c < 3; c++)
            particle[i].force[c] += by[t][c];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int r = 0; r < 2; r++)
            for (int c = 0; c < 3; c++)
                particle[i1[t]].spin.turn[c][r] += blocks_by[t][c][r];
    }
} // WIDE: 192 197

#define EACH(c) for (int c = 0; c < 3; c++)
#define ADD(to, value)                                                                             \
    for (int c = 0; c < 3; c++) {                                                                  \
        (to)[i1[t]][c] += value[t][c];                                                             \
        (to)[i2[t]][c] -= value[t][c];                                                             \
    }
#define EACH_IF(when, c)                                                                           \
    if (when)                                                                                      \
    EACH(c)
#define EACH_OF(row, c)                                                                            \
    const int k = (row);                                                                           \
    EACH(c)
static void by_macro(int n, double (*restrict to)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        EACH(c) to[i1[t]][c] += by[t][c];
        ADD(to, by)
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        EACH_OF(i1[t], c) to[k][c] += by[t][c];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        EACH_IF(i2[t] % 3, c) to[i1[t]][c] += by[t][c];
    }
} // WIDE: 217 224
// ELEMENTS: 221

// No wide records: the elements are not one row, or no loop counts up by one between constant bounds.
static void no_nests(int n, int m) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            flat[3 * i1[t] + c] += by[t][c];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c += 2)
            f[i1[t]][c] += by[t][c];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 2; c >= 0; c--)
            f[i1[t]][c] += by[t][c];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < m; c++)
            f[i1[t]][c] += by[t][c];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 2; k++)
                f[i1[t]][c] = f[i1[t]][c] * 0.5 + by[t][k];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 20; c++)
            wide[i1[t]].many[c] += w[t] * c;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            a[i1[t]][c][c] += by[t][c];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            const double half = by[t][c] * 0.5;
            f[i1[t]][c] += half;
        }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[i1[t]][1] *= 0.5;
        for (int c = 0; c < 3; c++)
            f[i2[t]][c] += by[t][c];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            f[i1[t] + c][c] += by[t][c];
} // ELEMENTS: 232 235 238 241 244 248 251 254 264
// WIDE: 259

static void that_overlap(int n, double (*rows)[3], const double *x) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            rows[i1[t]][c] = rows[i1[t]][c] * 0.5 + x[3 * t + c];
    }
} // WIDE: 271

static void show_all(void) {
#define SHOW(array) case_print(#array, array, sizeof array)
    SHOW(f), SHOW(g), SHOW(a), SHOW(s), SHOW(flat), SHOW(single), SHOW(counts), SHOW(bytes);
    SHOW(particle), SHOW(wide);
}

int main(void) {
    static double space[3 * N + 3 * M];
    case_subscripts(i1, N, M);
    case_subscripts(i2, N, M);
    case_subscripts(&several[0][0], 2 * N, M);
    case_values(&at[0][0], 3 * M);
    case_values(w, N);
    case_values(u, N);
    case_values(&by[0][0], 3 * N);
    case_values(&blocks_by[0][0][0], 9 * N);
    case_values(&f[0][0], 3 * M);
    for (int t = 0; t < 4 * N; t++)
        part[t / 4][t % 4] = (float)case_value();
    for (int i = 0; i < M; i++)
        f[i][2] = g[i][1] = a[i][1][2] = -0.0;
    by[5][0] = INFINITY, by[7][1] = -INFINITY, by[8][2] = -0.0, w[9] = 1.7e308, by[10][0] = 5e-324;
    for (int round = 0; round < 2; round++) {
        both_ends(N);
        of_blocks(N);
        without_values(N);
        of_two_arrays(N);
        in_order(N);
        under_conditions(N);
        extrema(N, f, g, i1, by);
        types(N);
        of_members(N);
        by_macro(N, g);
        no_nests(N, 3);
        that_overlap(N, (double(*)[3])(void *)space, space + 3 * M);
        that_overlap(N, (double(*)[3])(void *)space, space);
        that_overlap(N, f, &by[0][0]);
        show_all();
        case_print("space", space, sizeof space);
        memset(space, 0, sizeof space);
        memset(f, 0, sizeof f);
    }
}
