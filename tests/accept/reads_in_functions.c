/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions that read through their parameters, in loops of their own and at elements that tables give, as
// usual in finite-element assembly. Their reads may overlap updates.
// covers: row 80, row 81 of docs/constructs.md
#include <stddef.h>
#include "case.h"

enum { N = 2000, NODES = 300 };
struct mesh {
    int n;
    const double (*x)[3];
    const int (*node)[4];
    const int *ptr, *col;
    const double *val;
    double **rows;
};
static int node[N][4], ptr[N + 1], col[6 * N], to[N], edge[N][2], wanted[N];
static double memory[2 * NODES + 40][3], other[NODES][3], val[6 * N], y[NODES + 48], a[6 * N];
static double *rows[NODES];

/* ---- elements ---- */

static void element_force(const double (*x)[3], const int node[4], double f[4][3]) {
    double mean[3] = {0, 0, 0};
    for (int a = 0; a < 4; a++)
        for (int c = 0; c < 3; c++)
            mean[c] += 0.25 * x[node[a]][c];
    for (int a = 0; a < 4; a++)
        for (int c = 0; c < 3; c++)
            f[a][c] = x[node[a]][c] - mean[c];
}

static void assemble(const struct mesh *m, double (*b)[3]) {
    for (int e = 0; e < m->n; e++) { // EXPECT: transformed
        double f[4][3];
        element_force(m->x, m->node[e], f);
        for (int a = 0; a < 4; a++)
            for (int c = 0; c < 3; c++)
                b[m->node[e][a]][c] += f[a][c];
    }
}

/* A function in the old style, with parameters declared before its body. */
static double stretch(m, e) const struct mesh *m; int e; {
    int a, i, j;
    double sum = 0;
    for (a = 3; a >= 1; a--) {
        i = m->node[e][a];
        j = m->node[e][a - 1];
        sum += m->x[i][0] - m->x[j][2];
    }
    return sum;
}

static void by_struct(const struct mesh *m, double (*b)[3], const double *scale) {
    int a, i; /* names that the called function has as well */
    for (i = 0; i < m->n; i++) // EXPECT: transformed
        for (a = 0; a < 4; a += 2) {
            double w = stretch(m, i);
            b[m->node[i][a]][0] += w * *scale;
        }
}

static double one(const double (*x)[3], const int *list, unsigned char k) {
    return x[list[k]][1];
}

static double by_ones(const double (*x)[3], const int *list) {
    double sum = 0;
    for (unsigned char k = 1; k <= 3; k += 2)
        sum += one(x, list, k) - one(x, list, (unsigned char)(k - 1));
    return sum;
}

static void function_in_function(const struct mesh *m, double (*b)[3]) {
    for (int e = 0; e < m->n; e++) // EXPECT: transformed
        if (e % 7 != 3)
            b[m->node[e][0]][2] -= by_ones(m->x, m->node[e]);
}

static double by_rows(double *const *rows, const int *list) {
    double sum = 0;
    for (int k = 0; k < 4; k++)
        sum += rows[list[k]][1];
    return sum;
}

static void rows_by_pointers(const struct mesh *m, double *restrict to) {
    for (int e = 0; e < m->n; e++) // EXPECT: transformed
        to[m->node[e][2]] += by_rows(m->rows, m->node[e]);
}

/* ---- rows of a matrix ---- */

static double row_dot(const int *ptr, const int *col, const double *val, const double *x, int i) {
    double s = 0;
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        s += val[k] * x[col[k]];
    return s;
}

static void rows_of_matrix(int n, const int *ptr, const int *col, const double *val,
                           const double *x, const int *to, double *y) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        y[to[i]] += row_dot(ptr, col, val, x, i);
}

static double off_diagonal(const struct mesh *m, const double *x, long i) {
    const int last = m->ptr[i + 1] - 1;
    double s = 0;
    for (long k = last; k >= m->ptr[i]; --k) {
        const int j = m->col[k];
        if (j == i)
            continue;
        s -= m->val[k] * x[j];
    }
    return s;
}

static void rows_of_struct(const struct mesh *m, const double *x, const int *to, double *y) {
    for (size_t i = 0; i < (size_t)m->n; i++) { // EXPECT: transformed
        if (to[i] % 5 == 0)
            continue;
        y[to[i]] += off_diagonal(m, x, (long)i);
    }
}

static double in_pairs(const int *ptr, const int *col, const double (*x)[3], int i) {
    double s = 0;
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        for (int l = ptr[i]; l < k; l++)
            if (col[k] > col[l])
                s += x[col[k]][0] * x[col[l]][1];
    return s;
}

static void pairs(const struct mesh *m, const double (*x)[3], double (*b)[3]) {
    for (int i = 0; i < m->n; i += 3) // EXPECT: transformed
        b[m->node[i][3]][0] += in_pairs(m->ptr, m->col, x, i);
}

/* ---- searches that may fail ---- */

static int find(const int *ptr, const int *col, int i, int j) {
    for (int k = ptr[i]; k < ptr[i + 1]; k++)
        if (col[k] == j)
            return k;
    return -1;
}

static void entries(int n, const int *ptr, const int *col, const int (*edge)[2], const double *v,
                    double *a) {
    for (int e = 0; e < n; e++) { // EXPECT: transformed
        int k = find(ptr, col, edge[e][0], edge[e][1]);
        if (k >= 0)
            a[k] += v[e];
    }
}

static double first_above(const double *x, int from, int end, double limit) {
    for (int k = from; k < end; k++)
        if (x[k] > limit)
            return x[k];
    return 0;
}

static void first_ones(int n, const double *x, const int *to, double *y) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        y[to[i]] += first_above(x, to[i], to[i] + 40, 0.5);
}

/* ---- a plan, and tables read to find addresses ---- */

static double in_row(const double *x, const int *list) {
    double s = 0;
    for (int k = 0; k < 4; k++)
        s += x[list[k]];
    return s;
}

static void kept_apart(int n, const int (*list)[4], const double *x, const int *to, double *y) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        y[to[i]] += 0.25 * in_row(x, list[i]);
}

/* Only the lists change: in one call they select updated elements. */
static void change_lists(void) {
    static double both[2 * NODES];
    static int list[N][4];
    case_values(both, 2 * NODES);
    for (int again = 0; again < 4; again++) {
        for (int i = 0; i < N; i++)
            for (int c = 0; c < 4; c++)
                list[i][c] = NODES + (i * 7 + c) % NODES - (again == 2 && i > N / 2 ? NODES : 0);
        for (int twice = 0; twice < 2; twice++)
            kept_apart(N, (const int(*)[4])list, both, to, both);
        if (again == 2) {
            CASE_PRINT(both);
            case_values(both, 2 * NODES);
        }
    }
    CASE_PRINT(both);
}

static void fill(int round) {
    case_values(&memory[0][0], (long)(sizeof memory / sizeof(double)));
    case_values(&other[0][0], 3 * NODES);
    case_values(val, 6 * N);
    case_values(y, NODES + 48);
    for (int i = 0, k = 0; i < N; i++) {
        ptr[i] = k;
        for (int c = 0; c < 4; c++)
            node[i][c] = case_below(NODES);
        for (int c = case_below(7); c > 0; c--)
            col[k++] = case_below(NODES);
        ptr[i + 1] = k;
        edge[i][0] = case_below(N);
        edge[i][1] = case_below(NODES);
    }
    for (int i = 0; i < N; i++)
        edge[i][0] = wanted[i] = case_below(N);
    case_subscripts(to, N, NODES);
    for (int r = 0; r < NODES; r++)
        rows[r] = other[(r * 7 + round) % NODES];
}

/* Sums of sums are no longer small integers, so `y` begins with new values. */
static void begin_again(int is_needed) {
    if (is_needed) {
        CASE_PRINT(y);
        case_values(y, NODES + 48);
    }
}

int main(void) {
    for (int round = 0; round < 5; round++) {
        const int overlap = round == 1 ? 1 : round == 3 ? 2 : 0;
        fill(round);
        /* in some rounds the positions overlap the updated array, entirely or in its last element */
        double(*b)[3] = memory + 20;
        const int apart = overlap == 0 ? NODES + 20 : overlap == 1 ? 1 : NODES - 1;
        const double(*x)[3] = (const double(*)[3])(b + apart);
        if (overlap)
            for (int i = 0; i < N; i++)
                for (int c = 0; c < 4; c++)
                    node[i][c] %= overlap == 1 ? NODES - 1 : 21;
        if (overlap == 2) /* only one entry of one row reads the common element */
            for (int k = 0; k < ptr[N]; k++)
                col[k] = k == ptr[N] - 1 ? 1 : NODES - 2;
        const struct mesh m = {N - round, x, (const int(*)[4])node, ptr, col, val, rows};
        for (int again = 0; again < 3; again++) {
            assemble(&m, b);
            by_struct(&m, b, &val[again]);
            function_in_function(&m, b);
            rows_by_pointers(&m, y);
            rows_of_matrix(N, ptr, col, val, overlap == 2 ? y + 8 : (const double *)other, to, y);
            begin_again(overlap == 2);
            rows_of_struct(&m, overlap == 1 ? y : (const double *)other, to, y);
            begin_again(overlap == 1);
            if (overlap)
                break;
            pairs(&m, x, b);
            entries(N, ptr, col, (const int(*)[2])edge, val, a);
            first_ones(N, (const double *)memory, to, y);
            first_ones(100, y, to, a);
            if (again == 1)
                col[case_below(ptr[N])] = case_below(NODES - 1);
        }
    }
    change_lists();
    CASE_PRINT(memory);
    CASE_PRINT(y);
    CASE_PRINT(a);
    return 0;
}
