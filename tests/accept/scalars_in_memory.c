/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Sums, in addition to the array, that are not variables: members of records, elements of small arrays, and
// targets of pointers. They belong to the function, the file or the caller.
// covers: row 59 of docs/constructs.md
#include "case.h"

enum { N = 9000, M = 700 };
struct moments {
    double x, y[2];
    int n;
};
struct body {
    struct moments of[3];
    unsigned char bits;
};
static int s[N], c[N];
static double v[N], h[M];
static struct moments all;
static float few[4];

static struct moments own_record(int n) {
    struct moments m = {.x = 0.5};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += v[i];
        m.x += v[i];
        m.y[0] -= v[i] * v[i];
        m.y[1] = 0.25 * v[i] + m.y[1];
        m.n++;
    }
    return m;
}

static double own_array(int n) {
    double sum[3] = {1, 2, 3};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] -= v[i];
        sum[0] += v[i];
        if (c[i] > 2)
            sum[2] -= v[i] * c[i];
    }
    return sum[0] * 3 + sum[1] + sum[2];
}

static void of_the_file(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        h[s[i]] += v[i] * 2;
        all.x -= v[i];
        few[2] += 0.5f;
        if (c[i] == 1)
            all.n += c[i];
    }
}

static void of_the_caller(int n, const int *restrict k, double *restrict to, double *restrict sum,
                          struct body *restrict b, long *restrict count) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        to[k[i]] += 1.5;
        *sum += v[i];
        b->of[1].y[1] += v[i] + 1;
        b->bits ^= (unsigned char)k[i];
        count[3] += k[i];
    }
}

/* Types show that nothing else in the loop overlaps the pointer's target. */
static void of_another_type(int n, const int *k, double *to, long *count) {
    struct moments own = {.n = 7};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        to[k[i]] -= 0.5;
        for (int j = 0; j < 2; j++)
            own.n += j;
        *count += k[i];
    }
    *count -= own.n;
}

/* The pointer may be dereferenced only if an iteration executes the update. */
static void perhaps_never(int n, int from, const int *restrict k, double *restrict to,
                          double *restrict sum, struct body *restrict b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        to[k[i]] += 1.5;
        if (k[i] >= from) {
            *sum -= v[i];
            b->of[0].n++;
        }
    }
}

/* For the analysis the sum may overlap the arrays, the reads or other sums. The guard compares them at run time. */
struct sums {
    double energy, virial, *force;
    const double *place;
};

static void in_a_record(int n, struct sums *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double d = t->place[s[i]] - t->place[c[i]];
        t->force[s[i]] += d;
        t->force[c[i]] -= d;
        if (d > 0.25)
            continue;
        t->energy += d;
        t->virial += d * d;
    }
}

static void in_inner_loops(int n, struct sums *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double here = t->place[s[i]];
        for (int j = i; j < i + 3; j++) {
            const int k = s[j];
            const double d = here - t->place[k];
            if (d < 0.125) {
                t->energy += d;
                t->force[i % M] += d;
                t->force[k] -= d;
            }
        }
    }
}

static void two_pointers(int n, double *to, const double *from, double *sum, double *other) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        to[s[i]] += from[s[i]];
        *sum += from[i];
        *other *= 1 + from[i] * 0x1p-12;
    }
}

double total = 0.25;
static void of_the_program(int n, double *to, const double *from) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        total -= from[s[i]];
        to[s[i]] += from[s[i]] + 1;
    }
}

static void compared(void) {
    static double a[N], b[N], e[2] = {1, 1.5};
    for (int i = 0; i < N; i++)
        b[i] = v[i];
    /* Here the sum is an element, is read, or is another sum: only the original loop is correct. */
    two_pointers(N, a, b, &a[s[5]], &e[1]);
    two_pointers(N, a, b, &b[s[N / 2]], &e[1]);
    two_pointers(N, a, b, &b[N - 1], &e[0]);
    two_pointers(N, a, b, &e[0], &e[0]);
    struct sums t = {.energy = 0.5, .force = a, .place = v};
    in_a_record(N, &t);
    in_inner_loops(N / 2, &t);
    two_pointers(N, a, b, &e[0], &e[1]);
    case_print("apart", &t, 2 * sizeof(double));
    for (int i = 0; i < N; i++)
        c[i] = s[i], s[i] = 0;
    of_the_program(N, &total, v);
    of_the_program(N, a, &total);
    for (int i = 0; i < N; i++)
        s[i] = c[i], c[i] = i % 5;
    of_the_program(N, a, v);
    CASE_PRINT(a);
    CASE_PRINT(b);
    CASE_PRINT(e);
    case_print("total", &total, sizeof total);
}

int main(void) {
    case_values(v, N);
    for (int i = 0; i < N; i++)
        c[i] = case_below(5);
    static struct body b;
    double sum = 0.25;
    long count[5] = {1};
    for (int round = 0; round < 4; round++) {
        case_subscripts(s, N, M);
        const struct moments m = own_record(N - round);
        case_print("x", &m.x, sizeof m.x);
        case_print("y", m.y, sizeof m.y);
        printf("%d\n", m.n);
        const double three = own_array(N - round);
        case_print("three", &three, sizeof three);
        of_the_file(N);
        of_the_caller(N, s, h, &sum, &b, count);
        of_the_caller(0, s, h, NULL, NULL, NULL);
        perhaps_never(N, M, s, h, NULL, NULL);
        perhaps_never(N, M / 2, s, h, &sum, &b);
        of_another_type(N - round, s, h, count + 1);
        case_print("all", &all.x, sizeof all.x);
        printf("%d %d %u %ld %ld\n", all.n, b.of[0].n, b.bits, count[3], count[1]);
        case_print("sum", &sum, sizeof sum);
        case_print("of", b.of[1].y, sizeof b.of[1].y);
        CASE_PRINT(few);
        CASE_PRINT(h);
        compared();
    }
    return 0;
}
