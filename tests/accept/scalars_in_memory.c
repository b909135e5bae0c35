/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Sums beside the array that are no variables: members of records, elements of small arrays, what a
// pointer leads to; of the function's own, of the file, and of the caller.
// covers: row 59
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

/* By type alone nothing else of the loop is what the pointer leads to. */
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

/* Only where an iteration comes to the update is the pointer followed. */
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
    }
    return 0;
}
