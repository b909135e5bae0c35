/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// In addition to its arrays the loop updates scalars, in the order of the loop.
// covers: row 59, row 41 of docs/constructs.md
#include "case.h"

enum { N = 20000, M = 1200 };
struct parts {
    int low, high;
};
static int s[N], c[N];
static double v[N], h[M];
static float f[N], low;
static double total, product = 1.0, energy, halves;
static long entries;
static unsigned bits;
static unsigned char narrow;

#define NOTE(e) energy += 0.5 * (e)

static double plain(int n) {
    double sum = 0.25;
    int count = 3;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += v[t];
        sum += v[t];
        count++;
    }
    return sum + count;
}

static void under_conditions(int n) {
    float least = -0.0f;
    int negative = 0;
    unsigned long even = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double d = v[t] * v[s[t]];
        if (c[t] == 3)
            continue;
        if (d < 0.0) {
            negative++;
            halves -= 0.5 * d;
        } else {
            even += (unsigned long)t & 1u;
        }
        least += f[t];
        if (c[t])
            h[s[t]] += d;
        NOTE(d);
    }
    low = least;
    entries += negative * 1000L + (long)even;
}

static void several_operators(int n) {
    double x = 1.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        x = x + v[t];
        if (c[t] & 1)
            x *= 0.999;
        h[s[t]] += 1.0;
        bits ^= (unsigned)t << (c[t] & 7);
        narrow += c[t];
        product = (1.0 + 1e-5 * v[t]) * product;
        low += t;
    }
    total = x;
}

static void switched(int n) {
    long in[3] = {0};
    long a = 0, b = 0;
    for (int t = n - 1; t >= 0; t -= 2) { // EXPECT: transformed
        switch (c[t]) {
        case 0:
            a++;
            break;
        case 1:
            b += t;
            /* fallthrough */
        default:
            a -= 2;
        }
        h[s[t]] -= v[t];
    }
    in[0] = a;
    in[1] = b;
    entries += in[0] * 7 + in[1];
}

static void rarely_touching(int n) {
    long many = 0;
    double sum = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (t % 50 == 0)
            h[s[t]] += v[t];
        many += c[t];
        sum += v[t];
    }
    entries += many;
    total += sum;
}

/* If no iteration adds, -0.0 must remain: adding 0.0 as the neutral value would change it. */
static double never(int n) {
    double sum = -0.0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]] += v[t];
        if (c[t] > 100)
            sum += v[t];
    }
    return sum;
}

/* The call that computes the operand also fills an array private to the iteration. */
static double stress(double strain, double p[3]) {
    for (int i = 0; i < 3; i++)
        p[i] = strain * (i + 1) * (i + 1);
    return 0.5 * strain * strain;
}

static int split(int of, struct parts *p) {
    p->low = of & 7;
    p->high = of / 8;
    return of > 20;
}

static double filling(int n) {
    double work = 0.125;
    struct parts last = {1, 2};
    long many = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double p[3];
        work += 2 * stress(v[t], p);
        for (int i = 0; i < 3; i++)
            h[s[t] / 2 + i] -= p[i];
        if (c[t] > 1) {
            struct parts of;
            many += split(s[t], &of);
            h[s[t]] += of.low - of.high;
        }
        many += split(s[t], &last);
    }
    many += last.low * 3 + last.high;
    entries += many;
    return work;
}

int main(void) {
    case_values(v, N);
    for (int i = 0; i < N; i++) {
        c[i] = case_below(5);
        f[i] = case_below(3) ? (float)v[i] : -0.0f;
    }
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        const double sum = plain(N - round);
        case_print("sum", &sum, sizeof sum);
        const double work = filling(N - round);
        case_print("work", &work, sizeof work);
        const double zero = never(N);
        case_print("zero", &zero, sizeof zero);
        under_conditions(N);
        several_operators(N);
        switched(N);
        rarely_touching(N);
        CASE_PRINT(h);
        case_print("low", &low, sizeof low);
        case_print("total", &total, sizeof total);
        case_print("product", &product, sizeof product);
        case_print("energy", &energy, sizeof energy);
        case_print("halves", &halves, sizeof halves);
        case_print("entries", &entries, sizeof entries);
        case_print("bits", &bits, sizeof bits);
        case_print("narrow", &narrow, sizeof narrow);
    }
    return 0;
}
