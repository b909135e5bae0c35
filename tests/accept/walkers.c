/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Local pointers, set once in an iteration or in an inner loop, that step through windows, lists of points in
// cells, or elements of records. Loop headers step other variables as well.
// covers: row 47, row 89 of docs/constructs.md
// MAY-RUN-SERIALLY: one call of reads_walk reads the plane that it updates
#include "case.h"

enum { N = 3000, W = 60, H = 50, CELLS = 70 };
struct point {
    float x, y, q;
};
struct both {
    double v, w;
};
struct lattice {
    int nx, ny;
    float *at;
};
static struct point points[N];
static int first[CELLS], next[N], place[N], length[N], count_of[W * H + 40];
static double grid[W * H + 40], e[N + 40], weight[40];
static struct both records[W * H + 40];
static float plane[W * H], other_plane[W * H];

/* The atoms of a cell form a list. Each atom spreads over a window, row by row. */
static void spread(struct lattice *l, int cells, const struct point *p, float cut, float h) {
    const int nx = l->nx, ny = l->ny, radius = (int)(cut / h);
    int g, n, i, j, ia, ib, ja, jb, index;
    float x, y, q, dx, dy, r2, *pg;
    for (g = 0; g < cells; g++) { // EXPECT: transformed
        for (n = first[g]; n != -1; n = next[n]) {
            x = p[n].x;
            y = p[n].y;
            q = p[n].q;
            ia = (int)(x / h) - radius;
            ib = (int)(x / h) + radius + 1;
            ja = (int)(y / h) - radius;
            jb = (int)(y / h) + radius + 1;
            if (ia < 0)
                ia = 0;
            if (ib >= nx)
                ib = nx - 1;
            if (ja < 0)
                ja = 0;
            if (jb >= ny)
                jb = ny - 1;
            dy = ja * h - y;
            for (j = ja; j <= jb; j++, dy += h) {
                if (dy * dy >= cut * cut)
                    continue;
                dx = ia * h - x;
                index = j * nx + ia;
                pg = l->at + index;
                for (i = ia; i <= ib; i++, pg++, dx += h) { // INNER
                    r2 = dx * dx + dy * dy;
                    if (r2 >= cut * cut)
                        continue;
                    *pg += q * (1 - r2 / (cut * cut));
                }
            }
        }
    }
}

static void set_in_header(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *q;
        int c;
        for (q = to + place[t], c = 0; c < length[t]; c++, q++)
            *q += weight[c] * e[t];
    }
}

static void stepped_in_body(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *q = &to[place[t]];
        int c = length[t];
        while (c-- > 0) {
            *q -= weight[c] * e[t];
            q += 2;
            *q += weight[c];
            --q;
        }
    }
}

static void rows_of_rows(int n, double *to, int width) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = to + place[t] % 40;
        for (int y = 0; y < 3; y++, row += width)
            for (int x = 0; x < 3; x++)
                row[x] += e[t] * weight[x + y];
    }
}

static void of_records(int n, struct both *to) {
    struct both *b;
    int t, c;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        b = to + place[t];
        for (c = 0; c < 5; c++, b++) {
            b->v += e[t];
            b->w -= weight[c];
        }
        b[-1].v += 3;
    }
}

/* The pointer is the loop's counter. */
static void to_an_end(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (double *q = to + place[t], *end = q + length[t]; q < end; q++)
            *q += e[t];
}

/* An integer is stepped along with the pointer and is a subscript afterwards. */
static void counted_besides(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double *const end = to + place[t] + length[t];
        const double *r;
        int k;
        for (r = to + place[t], k = place[t]; r < end; r++, k++)
            count_of[k]++;
        count_of[k] += 7;
    }
}

/* The variable `w` decides which element is the last. */
static void step_is_a_subscript_later(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *q = to + place[t], w = 1.0;
        int c;
        for (c = 0; c < length[t]; c++, q++, w += 1.5)
            *q += w;
        to[place[t] + (int)w] -= 1.0;
    }
}

/* The window read may be the window updated. */
static void reads_walk(int n, float *to, const float *from) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        float *q = to + place[t];
        const float *r = from + place[(t * 7) % n];
        for (int c = 0; c < 4; c++, q++, r++)
            *q += *r;
    }
}

/* The element's address decreases while the pointer increases. */
static void mirrored(int n, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double *q = to + place[t];
        for (int c = 0; c < length[t]; c++, q++)
            *(to + (2 * place[t] + 8 - (q - to))) += weight[c];
    }
}

/* Only some iterations use the pointer. */
static void some_cells(const struct lattice *l, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (length[t] > 3) {
            float *q = l->at + place[t];
            for (int c = 0; c < 4; c++, ++q)
                *q += (float)c;
        }
}

int main(void) {
    struct lattice l = {W, H, plane};
    for (int c = 0; c < CELLS; c++)
        first[c] = -1;
    for (int i = 0; i < N; i++) {
        const int cell = case_below(CELLS);
        next[i] = first[cell];
        first[cell] = i;
        points[i] = (struct point){(float)case_below(W * 8) / 8, (float)case_below(H * 8) / 8,
                                   (float)case_value()};
        place[i] = case_below(W * H - 30);
        length[i] = case_below(8);
    }
    case_values(e, N);
    case_values(weight, 40);
    for (int k = 0; k < 3; k++) {
        spread(&l, CELLS - k, points, 4.5f, 1.0f);
        set_in_header(N - k, grid);
        stepped_in_body(N, grid);
        rows_of_rows(N, grid, W);
        of_records(N, records);
        to_an_end(N, grid);
        counted_besides(N, grid);
        step_is_a_subscript_later(N, grid);
        reads_walk(N, other_plane, plane);
        reads_walk(k == 1 ? N : 5, plane, plane);
        mirrored(N, grid);
        some_cells(&l, N);
        place[k * 100] = 3;
    }
    CASE_PRINT(grid);
    CASE_PRINT(records);
    CASE_PRINT(plane);
    CASE_PRINT(other_plane);
    CASE_PRINT(count_of);
    return 0;
}
