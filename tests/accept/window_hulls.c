/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -Wno-sign-compare
// INTEGERS: no
// Windows. HULL marks those whose first and last rows contain all extreme addresses: the inspector visits only these.
#include "case.h"

#include <math.h>

enum { N = 1500, SIDE = 40, REACH = 3, DEEP = 12, STRIPES = 4 };
static float x[N], y[N], z[N], value[N], grid[SIDE * SIDE], weight[SIDE * SIDE];
static double plane[SIDE][SIDE], box[DEEP * DEEP * DEEP], rows[SIDE * SIDE];
static int row_of[SIDE], width_of[SIDE], first_of[N], stripe_of[N], wide;
static double total[1];
static float striped[7 * STRIPES * 32 * 256];
static double far_rows[4 * (5 * N)], turns[2 * N + 4];
static int one_of[N], another_of[N];
typedef struct cell {
    float sum[2];
    int count;
} cell;
static cell cells[SIDE * SIDE];

static void spread(int n, const float *px, const float *py, const float *v, float *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int cx = (int)px[t], cy = (int)py[t];
        for (int i = cy - REACH; i <= cy + REACH; i++) { // HULL
            const float dy = py[t] - (float)i;
            for (int j = cx - REACH; j <= cx + REACH; j++) {
                const float dx = px[t] - (float)j;
                g[i * SIDE + j] += v[t] / (1 + dx * dx + dy * dy);
            }
        }
    }
}

/* Two arrays. One thread leads each iteration, since sqrtf may set errno. The rows' distance is a variable. */
static void two_arrays(int n, int pitch, const float *px, const float *py, float *g, float *w) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)px[t] - 1, top = (int)py[t] - 2;
        for (int i = top; i < top + 5; i++) // HULL
            for (int j = left; j < left + 3; j++) {
                const float d = sqrtf(((float)j - px[t]) * ((float)j - px[t]) + (float)(i - top));
                g[i * pitch + j] += d * value[t];
                w[i * pitch + j] += d;
            }
    }
}

/* Rows of a two-dimensional array, from the last one backwards. */
static void backwards(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t], top = (int)y[t];
        for (int i = 0; i < 4; i++) // HULL
            for (int j = left; j < left + 4; j++)
                plane[top + 3 - i][j] += (double)value[t] * (i + 1);
    }
}

/* Three nested loops, a row number in a variable, and counters of the width of addresses. */
static void in_space(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const size_t a = (size_t)(x[t] / 4), b = (size_t)(y[t] / 4), c = (size_t)(z[t] / 4);
        for (size_t i = a; i < a + 3; i++) // HULL
            for (size_t j = b; j < b + 3; j++) { // HULL
                const size_t row = (i * DEEP + j) * DEEP;
                for (size_t k = c; k < c + 3; k++)
                    box[row + k] += (double)value[t];
            }
    }
}

/* A pointer to the row, and a member of a record. */
static void by_pointer(int n, cell *all) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t], top = (int)y[t];
        for (int i = top; i <= top + 2; ++i) { // HULL
            cell *const row = all + i * SIDE;
            for (int j = left; j <= left + 2; ++j)
                row[j].sum[1] += value[t];
        }
    }
}

/* No row, or one. */
static void few_rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = first_of[t] % SIDE, count = first_of[t] % 3;
        for (int i = 1; i < 1 + count; i++) // HULL
            for (int j = left; j < SIDE; j++)
                rows[i * SIDE * 7 + j] += (double)value[t];
    }
}

/* Some iterations update several stripes of rows, so an owner has several ranges of rows. */
static void in_stripes(int n, const int *rows_at, float *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = first_of[t] + 4, top = rows_at[t];
        for (int i = top - 2; i <= top + 2; i++) // HULL
            for (int j = left - 2; j <= left + 2; j++)
                g[i * 256 + j] += value[t] * (float)(i - j);
    }
}

/* Each iteration updates a window and one far behind all windows: such rows are owned by whom they are nearest to. */
static void with_halo(int n, double *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = t % 2, near = 3 * t / 2, far = 4 * N + t / 4;
        for (int i = near; i < near + 2; i++) // HULL
            for (int j = left; j < left + 3; j++)
                g[i * 4 + j] += (double)value[t] * (i - near + 1);
        for (int i = far; i < far + 2; i++) // HULL
            for (int j = left; j < left + 3; j++)
                g[i * 4 + j] -= (double)value[t] * (i - far + 2);
    }
}

/* The owners of the first rows lead in turn: one of two threads keeps an iteration's operands, the other the next one's. */
static double in_turn(int n, const int *one, const int *another, double *g) {
    double sum = 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int j = 0; j < first_of[t] % 4; j++) {
            const double v = (double)value[t] / (1 + j);
            g[one[t] + j] += v;
            g[another[t] + j] -= v;
            sum += v;
        }
    return sum;
}

/* A sum in the order of the loop, also in iterations that update no element. */
static void with_sum(int n, float *g) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t], top = (int)y[t], count = first_of[t] % 4;
        sum += (double)value[t];
        for (int i = top; i < top + count; i++) // HULL
            for (int j = left; j < left + 3; j++) {
                const float v = value[t] / (float)(1 + j + i);
                g[i * SIDE + j] += v;
                sum += (double)v;
            }
    }
    total[0] += sum;
}

/* ---- the first and last rows are not the extreme ones ---- */

static void circle(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int cx = (int)x[t], cy = (int)y[t];
        for (int i = cy - REACH; i <= cy + REACH; i++)
            for (int j = cx - width_of[i - cy + REACH]; j <= cx + width_of[i - cy + REACH]; j++)
                rows[j * SIDE + i] += (double)value[t];
    }
}

static void by_table(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t] / 4;
        for (int i = 0; i < 6; i++)
            for (int j = left; j < left + 4; j++)
                rows[row_of[i] * SIDE + j] += (double)value[t];
    }
}

static void squares(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t] / 4;
        for (int i = -5; i <= 2; i++)
            for (int j = left; j < left + 4; j++)
                rows[i * i * SIDE + j] += (double)value[t];
    }
}

static void squares_in_a_variable(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t] / 4;
        for (int i = -5; i <= 2; i++) {
            const int row = i * i * SIDE;
            for (int j = left; j < left + 4; j++)
                rows[row + j] += (double)value[t];
        }
    }
}

static void remainders(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const unsigned left = (unsigned)x[t] / 4, top = (unsigned)y[t];
        for (unsigned i = top; i < top + 5u; i++)
            for (unsigned j = left; j < left + 4; j++)
                rows[(i % 16u) * SIDE + j] += (double)value[t];
    }
}

/* A row that the condition skips may have any address. */
static void some_rows(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t] / 4;
        for (size_t i = 0; i < 9; i++)
            if (i >= 4 && i <= 5)
                for (int j = left; j < left + 4; j++)
                    rows[(i - 4) * (size_t)wide * SIDE + (size_t)j] += (double)value[t];
    }
}

static void narrow_counter(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int left = (int)x[t] / 4;
        for (int i = 250; i < 260; i++)
            for (int j = left; j < left + 4; j++)
                rows[(unsigned char)i % 30 * SIDE + j] += (double)value[t];
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        x[t] = 3 + (float)case_below((SIDE - 8) * 8) / 8;
        y[t] = 3 + (float)case_below((SIDE - 8) * 8) / 8;
        z[t] = 3 + (float)case_below((SIDE - 8) * 8) / 8;
        value[t] = (float)case_value();
        first_of[t] = case_below(SIDE);
        one_of[t] = t % 2 ? t / 2 : N + t / 2;
        another_of[t] = t % 2 ? N + t / 2 : t / 2;
        stripe_of[t] = (t * 7 / N + 7 * case_below(STRIPES)) * 32 + 2 + case_below(28);
    }
    for (int i = 0; i < SIDE; i++) {
        row_of[i] = case_below(SIDE);
        width_of[i] = i < 2 * REACH + 1 ? REACH - abs(i - REACH) : 0;
    }
    wide = 3;
    for (int repeat = 0; repeat < 3; repeat++) {
        spread(N, x, y, value, grid);
        two_arrays(N, SIDE, x, y, grid, weight);
        backwards(N);
        in_space(N);
        by_pointer(N, cells);
        few_rows(N);
        circle(N);
        by_table(N);
        squares(N);
        squares_in_a_variable(N);
        with_sum(N, grid);
        in_stripes(N, stripe_of, striped);
        with_halo(N, far_rows);
        printf("%a\n", in_turn(N, one_of, another_of, turns));
        remainders(N);
        some_rows(N);
        narrow_counter(N);
    }
    CASE_PRINT(grid);
    CASE_PRINT(weight);
    CASE_PRINT(plane);
    CASE_PRINT(box);
    CASE_PRINT(rows);
    CASE_PRINT(cells);
    CASE_PRINT(striped);
    CASE_PRINT(total);
    CASE_PRINT(far_rows);
    CASE_PRINT(turns);
}
