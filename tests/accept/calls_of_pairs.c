/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions that update two elements given by their parameters.
// covers: row 15, row 18
// COMPILERS: gcc clang-19
// INTEGERS: no
// TILED: 42 47 75 93 112 168
#include "case.h"
#include <math.h>

enum { N = 240, PAIRS = 9000 };

typedef struct {
    double at[3], f[3];
    double x, y, fx, fy, mass;
    int met;
} body;
typedef struct {
    int count;
    body *bodies;
    double energy, *sums;
} world;
static body all[N], start[N];
static double place[N][3], pull[N][3], h[N], radius = 1.25;
static int pair_of[PAIRS][2];
static world w = {N, all, 0.0, h};
static long met;

/* by pointers, with a cut-off */
static void force(body *a, body *b) {
    const double dx = a->x - b->x, dy = a->y - b->y;
    double r2 = dx * dx + dy * dy;
    if (r2 > radius)
        return;
    r2 += 0.01;
    const double f = a->mass * b->mass / (r2 * sqrt(r2));
    a->fx += f * dx;
    a->fy += f * dy;
    b->fx -= f * dx;
    b->fy -= f * dy;
}
static void all_pairs(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++)
            force(&p[i], &p[j]);
}
static void by_sums(world *s) {
    for (int i = 0; i < s->count; i++) { // EXPECT: transformed
        body *a = s->bodies + i;
        for (int j = i + 1; j < s->count; j++) {
            body *b = j + s->bodies;
            force(a, b);
        }
    }
}
static void of_lists(int n, body *p) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        force(p + pair_of[t][0], p + pair_of[t][1]);
}

/* by an array and subscripts; a parameter changes */
static void by_subscripts(body *p, int i, int j, double scale) {
    const double d = p[i].x - p[j].x;
    if (d < 0)
        scale = -scale;
    scale *= d;
    if (scale > 0.5) {
        p[i].fx += 0.5;
        p[j].fx -= 0.5;
        return;
    }
    p[i].fx += scale;
    p[j].fx -= scale;
}
static void by_numbers(int n, body *p) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = 0; j < i; j++)
            by_subscripts(p, i, j, 0.25);
}

/* sums of pointers, a vector by value, a helper of the helper */
typedef struct {
    double x, y;
} vector;
static void add(body *a, vector f, double sign) {
    a->fx += sign * f.x;
    a->fy += sign * f.y;
}
static void add_force(body *a, body *b, vector f) {
    add(a, f, 1.0);
    add(b, f, -1.0);
}
static void vectors(int n, body *p) {
    for (int i = 0; i < n - 1; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++) {
            vector f = {0.5 * (p[j].x - p[i].x), p[j].y * p[i].y};
            add_force(p + i, p + j, f);
        }
}

/* the array in a struct, and sums by address */
static void contact(const body *a, const body *b, body *to, body *from, double *energy, long *count) {
    const double dx = a->x - b->x;
    if (dx * dx < 0.5) {
        to->fx += dx;
        from->fx -= dx;
        *energy += dx * dx;
        ++*count;
    }
}
static double in_struct(world *s) {
    double energy = 0.0;
    for (int i = 0; i < s->count; i++) // EXPECT: transformed
        for (int j = i + 1; j < s->count; j++)
            contact(&s->bodies[i], &s->bodies[j], &s->bodies[i], &s->bodies[j], &energy, &met);
    return energy;
}

/* the result is used; both elements may be one */
static double bond(body *a, body *b, double k) {
    const double d = a->x - b->x;
    if (d == 0.0)
        return 0.0;
    a->fx -= k * d;
    b->fx += k * d;
    if (k > 1.0)
        return 0.5 * k * d * d;
    return k * d;
}
static double bonds(int n) {
    double sum = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = pair_of[t][0];
        sum += 2.0 * bond(&all[i], &all[pair_of[t][1]], 1.5);
    }
    return sum;
}

/* A variable that a call sets by its address is as if assigned. */
static void weigh(body *a, body *b, double *weight) {
    a->fy += 1.0;
    b->fy -= 1.0;
    *weight = 0.5;
}
static double weighed(int n) {
    double sum = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double weight;
        weigh(&all[pair_of[t][0]], &all[pair_of[t][1]], &weight);
        sum += weight * bond(&all[pair_of[t][0]], &all[pair_of[t][1]], 1.5);
    }
    return sum;
}

/* rows of arrays, a loop in the function */
static void rows(const double *a, const double *b, double *fa, double *fb) {
    double d[3], r2 = 0.0;
    for (int c = 0; c < 3; c++) {
        d[c] = a[c] - b[c];
        r2 += d[c] * d[c];
    }
    if (r2 > 2.0) return;
    for (int c = 0; c < 3; c++) {
        fa[c] += d[c] / (r2 + 0.1);
        fb[c] -= d[c] / (r2 + 0.1);
    }
}
static void of_rows(int n) {
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (int j = i + 1; j < n; j++)
            rows(place[i], place[j], pull[i], pull[j]);
}

/* one element, and a sum of the file */
static double total;
static void count(double *p, double v) {
    *p += v;
    total += v;
}
static void with_sum(int n, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        count(&h[pair_of[t][0]], v[pair_of[t][1]]);
}

/* elements at subscripts that the function computes, some of them under a condition */
typedef struct {
    int columns, *first;
    double *values;
} matrix;
static double values[8 * N];
static int first[N], list[N][4];
static matrix of_rows_and_columns = {4, first, values};
static void around(matrix *m, int i, int k, double v) {
    m->values[m->first[i] + k] += v;
    if (k + 1 < m->columns)
        m->values[i * m->columns + k + 1] -= v;
}
static void computed(int n, matrix *m, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        around(m, pair_of[t][0], t % 4, v[pair_of[t][1]]);
}
static void next_to(double *p, int i, double v) {
    p[1] += v;
    p[i] += v;
    p[2 * i] -= v;
}
static void neighbours(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        next_to(&values[pair_of[t][0]], t % 3, 0.5);
}
/* A parameter changes; the caller's variable does not. */
static void halves(double *p, int at, double v) {
    p[at + 1] += v;
    at = at / 2;
    p[at] -= v;
}
static void by_halves(int n, const double *v) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int at = pair_of[t][0];
        halves(values, at, v[at]);
        values[at] += 0.25;
    }
}
/* beyond the row's end, as far as C's rules let a compiler see */
static void four(double *to) {
    for (int c = 0; c < 4; c++)
        to[c] += 1.0;
}
static void long_rows(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        four(place[pair_of[t][0] % (N - 1)]);
}
static void renumber(const double *x, int *own, double *out) {
    for (int k = 0; k < 4; k++) {
        own[k] = 3 - k;
        *out += x[own[k]];
    }
}
static void stored_too(int n, const double *x) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        renumber(x, list[t], &values[pair_of[t][0]]);
}

static void reset(void) {
    for (int i = 0; i < N; i++)
        all[i] = start[i];
}

int main(void) {
    case_subscripts(&pair_of[0][0], 2 * PAIRS, N);
    case_values(&place[0][0], 3 * N);
    case_values(h, N);
    case_subscripts(first, N, 4 * N);
    for (int i = 0; i < N; i++)
        start[i] = (body){.x = 2 * case_value(), .y = case_value(), .mass = 1 + place[i][0] * place[i][0]};
    for (int round = 0; round < 3; round++) {
        reset();
        all_pairs(N, all);
        CASE_PRINT(all);
        by_sums(&w);
        of_lists(PAIRS, all);
        CASE_PRINT(all);
        by_numbers(N, all);
        vectors(N, all);
        CASE_PRINT(all);
        double sums[3] = {in_struct(&w), 0.0, 0.0};
        sums[1] = bonds(PAIRS);
        sums[2] = weighed(PAIRS);
        CASE_PRINT(sums);
        CASE_PRINT(all);
        of_rows(N);
        CASE_PRINT(pull);
        with_sum(PAIRS, &place[0][0]);
        CASE_PRINT(h);
        computed(PAIRS, &of_rows_and_columns, &place[0][0]);
        neighbours(PAIRS);
        by_halves(PAIRS, &place[0][0]);
        long_rows(PAIRS);
        stored_too(N, &place[0][0]);
        CASE_PRINT(values);
        CASE_PRINT(place);
        CASE_PRINT(list);
        printf("%a %ld\n", total, met);
    }
    return 0;
}
