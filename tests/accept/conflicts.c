/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Iterations that update the same elements, though no table gives the subscripts. The elements are
// found through loaded pointers, windows, cells and pairs.
// covers: row 95 of docs/constructs.md
// THREADS: 1 2 3 7 16 33
#include "case.h"

#include <string.h>

enum { N = 1500, ROWS = 400, CELLS = 40, ROOM = 8, POINTS = 150, WIDE = 20 };
typedef struct atom {
    double f[3], q;
    struct atom *head;
} atom;
struct bond {
    atom *a, *b;
    double k;
};

static atom atoms[ROWS], *first_of[N];
static struct bond bonds[N];
static double *entry[N], h[ROWS], grid[WIDE * WIDE], e[N], r[CELLS * ROOM], force[CELLS * ROOM];
static double point[POINTS], sum[POINTS];
static int s[N], u[N], count[CELLS], next_cell[CELLS][3];

/* ---- loaded pointers ---- */

static void bonds_of_atoms(int n, const struct bond *bond) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double d = bond[t].k * e[t];
        bond[t].a->f[0] += d;
        bond[t].b->f[0] -= d;
    }
}

static void devices(int n, double **where) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        *where[t] += e[t];
}

static void first_elements(int n, double *const *where) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        where[t][0] += e[t];
}

static void vectors(int n, atom *const *of) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            of[t]->f[c] += e[t] * c;
}

static void by_local_pointer(int n, atom *const *of) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        atom *const p = of[t];
        p->q += e[t];
    }
}

static void heads(int n, atom *const *leaf) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        leaf[t]->head->q += 0.5;
}

/* ---- windows ---- */

static void window(int n, int reach) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int x = s[t] - reach; x <= s[t] + reach; x++)
            h[x] += e[t];
}

static void window_by_local_bounds(int n, int reach) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int lo = s[t], hi = lo + reach;
        for (int x = lo; x < hi; x++)
            h[x] += e[t] * (x - lo);
    }
}

static void window_of_two(int n, int reach) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int y = u[t]; y < u[t] + reach; y++)
            for (int x = u[t + 1]; x < u[t + 1] + reach; x++)
                grid[y * WIDE + x] += e[t];
}

static void window_of_rows(int n, int reach, double (*g)[WIDE]) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int y = u[t]; y < u[t] + reach; y++)
            for (int x = u[t + 1]; x < u[t + 1] + reach; x++)
                g[y][x] -= e[t];
}

static void window_up_to(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int x = 0; x < s[t] / 8; x++)
            h[x] += e[t];
}

/* ---- cells ---- */

static void cells(int n) {
    for (int d = 0; d < n; d++) // EXPECT: transformed
        for (int k = 0; k < 3; k++) {
            const int o = next_cell[d][k];
            for (int b = ROOM * d, p = 0; p < count[d]; p++, b++)
                for (int c = ROOM * o, q = 0; q < count[o]; q++, c++) {
                    const double z = r[b] - r[c];
                    force[b] += z;
                    force[c] -= z;
                }
        }
}

static void cells_by_assignment(int n) {
    int d, b, p;
    for (d = 0; d < n; d++) // EXPECT: transformed
        for (b = ROOM * (n - 1 - d), p = 0; p < count[d]; b++, p++)
            force[b] += e[d];
}

static void cells_beside(int n) {
    for (int d = 0; d + 1 < n; d++) // EXPECT: transformed
        for (int b = ROOM * d; b < ROOM * d + ROOM + count[d]; b++)
            force[b] += e[d];
}

static void cells_of_list(int n) {
    for (int d = 0; d < n; d++) // EXPECT: transformed
        for (int b = ROOM * next_cell[d][1]; b < ROOM * next_cell[d][1] + count[d]; ++b)
            force[b] -= r[b] * e[d];
}

static void cells_down(int n) {
    for (int d = 0; d < n; d++) // EXPECT: transformed
        for (int b = ROOM * d + count[d] - 1; b >= ROOM * d; b--)
            force[b] *= 1.0 + r[b] / 64;
}

/* ---- pairs ---- */

static void pairs(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            const double z = point[i] - point[j];
            sum[i] += z;
            sum[j] -= z;
        }
}

static void pairs_below(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i; j++) {
            sum[i] += point[j];
            sum[j] -= point[i];
        }
}

static void pairs_with_row_sum(int n) {
    for (int i = 0; i < n - 1; i++) { // EXPECT: transformed
        double own = 0;
        for (int j = i + 1; j < n; j++) {
            const double z = point[i] * point[j];
            own += z;
            sum[j] -= z;
        }
        sum[i] += own;
    }
}

static void pairs_within_reach(int n, double cut) {
    int i, j;
    for (i = 0; i < n - 1; i++) // EXPECT: transformed
        for (j = i + 1; j < n; j++) {
            const double z = point[i] - point[j];
            if (z * z > cut)
                continue;
            sum[i] += z;
            sum[j] -= z;
        }
}

static void pairs_of_two(int n) {
    for (int i = 1; i < n; ++i) // EXPECT: transformed
        for (int j = i - 1; j >= 0; --j) {
            sum[j] += point[i];
            h[i - j] += point[j];
        }
}

static void fill(void) {
    case_values(e, N);
    case_values(r, CELLS * ROOM);
    case_values(point, POINTS);
    for (int t = 0; t < N; t++) {
        s[t] = 4 + case_below(ROWS - 16);
        u[t] = case_below(WIDE - 8);
        entry[t] = &h[case_below(ROWS)];
        first_of[t] = &atoms[case_below(ROWS)];
        bonds[t] = (struct bond){&atoms[case_below(ROWS)], &atoms[case_below(ROWS)], case_value()};
    }
    for (int i = 0; i < ROWS; i++)
        atoms[i].head = &atoms[case_below(1 + i)];
    for (int d = 0; d < CELLS; d++) {
        count[d] = case_below(ROOM + 1);
        for (int k = 0; k < 3; k++)
            next_cell[d][k] = case_below(CELLS);
    }
}

int main(void) {
    fill();
    for (int round = 0; round < 4; round++) {
        bonds_of_atoms(N, bonds);
        devices(N, entry);
        first_elements(N - round, entry);
        vectors(N, first_of);
        by_local_pointer(N, first_of);
        heads(N, first_of);
        window(N, round);
        window_by_local_bounds(N, 5);
        window_of_two(N - 1, 4);
        window_of_rows(N - 1, 3, (double (*)[WIDE])grid);
        window_up_to(N);
        cells(CELLS);
        cells_by_assignment(CELLS);
        cells_beside(CELLS - 2);
        cells_of_list(CELLS);
        cells_down(CELLS);
        pairs(POINTS);
        pairs_below(POINTS);
        pairs_with_row_sum(POINTS);
        pairs_within_reach(POINTS, 0.25);
        pairs_of_two(POINTS);
    }
    double all[4 * ROWS];
    for (int i = 0; i < ROWS; i++) {
        memcpy(all + 4 * i, atoms[i].f, sizeof atoms[i].f);
        all[4 * i + 3] = atoms[i].q;
    }
    CASE_PRINT(all);
    CASE_PRINT(h);
    CASE_PRINT(grid);
    CASE_PRINT(force);
    CASE_PRINT(sum);
    return 0;
}
