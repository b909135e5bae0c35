/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays that would be private to an iteration, but an iteration may read elements that it has not written.
// covers: row 58, row 59, row 60 of docs/constructs.md
#include <string.h>

void one_missing(int n, const int *k, double *h, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int c = 0; c < 2; c++)
            f[c] = v[t] * c;
        h[k[t]] += f[0] + f[1] + f[2];
    }
}

void read_first(int n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        h[k[t]] += f[1];
        f[0] = f[1] = v[t];
    }
}

void under_condition(int n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        f[0] = v[t];
        if (v[t] > 0.0)
            f[1] = v[t];
        h[k[t]] += f[0] + f[1];
    }
}

void unknown_rounds(int n, int m, const int *k, double *h, const double *v) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int c = 0; c < m; c++)
            f[c] = v[t];
        h[k[t]] += f[0];
    }
}

void left_early(int n, const int *k, double *h, const double *v) {
    double f[3] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        for (int c = 0; c < 3; c++) {
            if (v[t] < c)
                break;
            f[c] = v[t];
        }
        h[k[t]] += f[2];
    }
}

// n + (2^63 - 1) - (n - 5) exceeds the 64 bits in which rounds are counted.
void rounds_beyond_64_bits(long n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < 5; t++) { // EXPECT: refuse private-not-proved
        double sum = 0.0;
        for (long c = n - 5; c < 9223372036854775807L + n; c++) {
            sum += f[1];
            if (c >= n - 4)
                break;
        }
        f[0] = f[1] = v[t];
        h[k[t]] += sum;
    }
}

void only_in_one_case(int n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        switch (k[t] % 3) {
        case 0:
            f[0] = f[1] = 1.0;
            break;
        case 1:
            f[0] = v[t];
        }
        h[k[t]] += f[0];
    }
}

static void fill_half(const double *v, double *f) {
    f[0] = v[0];
    if (v[1] > 0.0)
        f[1] = v[1];
}

void callee_half(int n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        fill_half(&v[t], f);
        h[k[t]] += f[0] + f[1];
    }
}

static void accumulate(double value, double *f) {
    f[0] += value;
}

void callee_adds(int n, const int *k, double *h, const double *v) {
    double f[1] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        accumulate(v[t], f);
        h[k[t]] += f[0];
    }
}

void fill_somewhere(double *f);
void callee_unknown(int n, const int *k, double *h) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        fill_somewhere(f);
        h[k[t]] += f[0];
    }
}

void short_memset(int n, const int *k, double *h) {
    double f[4] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        memset(f, 0, 3 * sizeof f[0]);
        f[k[t] % 2] = 1.0;
        h[k[t]] += f[0] + f[3];
    }
}

void own_subscript(int n, const int *k, double *h, const double *v) {
    double f[8] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        f[k[t] % 8] = v[t];
        h[k[t]] += f[(k[t] + 1) % 8];
    }
}

double last_in_part(int n, const int *k, double *h, const double *v) {
    double f[2] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        f[0] = v[t];
        if (v[t] > 0.0)
            f[1] = v[t];
        h[k[t]] += f[0];
    }
    return f[1];
}

void pointer_kept(int n, const int *k, double *h, const double *v) {
    double f[2] = {0}, g[2] = {0};
    double *p = g;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        p[0] = v[t];
        f[0] = v[t] + 1.0;
        h[k[t]] += p[0] + f[0];
        p = k[t] % 2 ? f : g;
    }
}

struct record {
    double a, b;
};

void half_a_record(int n, const int *k, double *h, const double *v) {
    struct record r = {0, 0}, copy;
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        r.a = v[t];
        copy = r;
        h[k[t]] += copy.a + copy.b;
    }
}

void static_array(int n, const int *k, double *h, const double *v) {
    static double f[2];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        f[0] = v[t];
        h[k[t]] += f[0];
    }
}

/* ---- a function fills a list of neighbours, whose bounds do not show that it writes all elements ---- */

static int *keep(int *to, int value) {
    *to = value;
    return to;
}
static void set(int *to, int value) {
    *to = value;
}
/* The bound decreases while the loop runs. */
static int around_kept(int t, int *to) {
    int x, count = 0;
    int *const bound = keep(&x, t);
    for (int i = x - 1; i <= x + 1; i++) {
        to[count++] = i < 0 ? 0 : i;
        *bound -= 1;
    }
    return count;
}

static int around_two(int t, int *to) {
    int x, y, count = 0;
    set(&x, t);
    set(&y, t / 2);
    for (int i = x - 1; i <= y + 1; i++)
        to[count++] = i < 0 ? 0 : i;
    return count;
}

/* If x + 2 wraps around, the loop ends at once. */
static int around_unsigned(unsigned x, int *to) {
    int count = 0;
    for (unsigned i = x - 1; i < x + 2; i++)
        to[count++] = (int)(i % 8);
    return count;
}

static int around_left(int x, int *to) {
    int count = 0;
    for (int i = x - 1; i <= x + 1; i++) {
        if (i > 5)
            break;
        to[count++] = i < 0 ? 0 : i;
    }
    return 3;
}

static int around_few(int x, int *to) {
    int count = 0;
    for (int i = x - 1; i < x + 1; i++)
        to[count++] = i < 0 ? 0 : i;
    return 3;
}

void around(int n, const int *k, double *restrict h, const double *v) {
    int list[3] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        around_kept(k[t], list);
        for (int q = 0; q < 3; q++)
            h[list[q]] += v[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        around_two(k[t], list);
        for (int q = 0; q < 3; q++)
            h[list[q]] += v[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        around_unsigned((unsigned)k[t], list);
        for (int q = 0; q < 3; q++)
            h[list[q]] += v[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        around_left(k[t], list);
        for (int q = 0; q < 3; q++)
            h[list[q]] += v[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        around_few(k[t], list);
        for (int q = 0; q < 3; q++)
            h[list[q]] += v[t];
    }
}

/* The array's length is computed by a function that stores the address of `q`. */
int kept_by_length(int *p);
void length_keeps(int n, const int *k, double *restrict h) {
    int q;
    double other[kept_by_length(&q)];
    other[0] = n;
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        q = k[t];
        h[q] += other[0];
    }
}
