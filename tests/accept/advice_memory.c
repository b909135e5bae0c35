/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops from docs/reasons.md, section on other memory, and changed as it advises (advice_updates.c explains BEFORE).
// CFLAGS: -Wno-unknown-pragmas
#include <stdint.h>
#include <string.h>
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N], c[N], ones[N], numbers[ROWS];
static double e[N], w[N], old[N + 1], sums[N], h[ROWS], g[ROWS];

struct node {
    struct node *next;
    double value;
};
static struct node nodes[N], *head[N];

/* Two of three ways to state that list and array do not overlap; tests/driver/advice.sh tests the third. */
#ifdef BEFORE
static void may_alias(int n, const int *s, double *h) {
    for (int t = 0; t < n; t++) { // BEFORE: may-alias
        double sum = 0;
        const struct node *p;
        for (p = head[t]; p; p = p->next)
            sum += p->value;
        h[s[t]] += sum;
    }
}
static void may_alias_again(int n, const int *s, double *h) {
    for (int t = 0; t < n; t++) { // BEFORE: may-alias
        double sum = 0;
        for (const struct node *p = head[t]; p; p = p->next)
            sum += p->value;
        h[s[t]] += sum;
    }
}
#else
static void may_alias(int n, const int *s, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double sum = 0;
        for (const struct node *p = head[t]; p; p = p->next)
            sum += p->value;
        h[s[t]] += sum;
    }
}
static void may_alias_again(int n, const int *s, double *h) {
#pragma redcc independent
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double sum = 0;
        for (const struct node *p = head[t]; p; p = p->next)
            sum += p->value;
        h[s[t]] += sum;
    }
}
#endif

static void other_store(int n, double *o) {
    memcpy(o + 1, e, sizeof e);
#ifdef BEFORE
    static double one[1];
    for (int t = 0; t < n; t++) { // BEFORE: other-store
        o[t] = e[t];
        h[s[t]] += o[t + 1];
    }
    for (int t = 0; t < n; t++) { // BEFORE: other-store
        one[0] = e[t] * 2;
        h[s[t]] += one[0] + one[0];
    }
    memcpy(o + 1, w, sizeof w);
    for (int t = 0; t < n; t++) { // BEFORE: other-store
        o[t] = e[t];
        h[s[t]] += o[t + 1];
    }
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = e[t];
        h[s[t]] += o[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double one = e[t] * 2;
        h[s[t]] += one + one;
    }
    memcpy(o + 1, w, sizeof w);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += o[t + 1];
    for (int t = 0; t < n; t++)
        o[t] = e[t];
#endif
}

static void scalar_carried(int n) {
    double sum = 0, d = 0;
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: scalar-carried
        sum += e[t];
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // BEFORE: scalar-carried
        if (c[t])
            d = w[t];
        if (c[t] & 1)
            h[s[t]] += d;
    }
    for (int t = 0; t < n; t++) { // BEFORE: scalar-carried
        if (c[t])
            d = w[t];
        if (c[t] & 1)
            h[s[t]] += d;
    }
#else
    for (int t = 0; t < n; t++) {
        sum += e[t];
        sums[t] = sum;
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += sums[t];
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double d;
        if (c[t])
            d = w[t];
        if (c[t] & 1)
            h[s[t]] += d;
    }
#pragma redcc private(d)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (c[t])
            d = w[t];
        if (c[t] & 1)
            h[s[t]] += d;
    }
#endif
}

static void private_not_proved(int n, const int *c) {
#ifdef BEFORE
    double f[3];
    int t;
    for (t = 0; t < n; t++) { // BEFORE: private-not-proved
        f[0] = e[t];
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#else
    int t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        double f[3];
        f[0] = e[t];
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#endif
}

static void private_written_first(int n, const int *c) {
    double f[3];
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: private-not-proved
        f[0] = e[t];
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[0] = e[t];
        f[1] = 0;
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#endif
}

static void private_asserted(int n, const int *c) {
    double f[3];
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: private-not-proved
        f[0] = e[t];
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#else
#pragma redcc private(f)
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        f[0] = e[t];
        if (c[t]) f[1] = 1;
        h[s[t]] += f[0] + f[1];
    }
#endif
}

static double last_value(int n) {
    double last = 0;
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: last-value
        if (c[t] > 0) {
            double d = last = w[t];
            h[s[t]] += d;
        }
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (c[t] > 0) {
            last = w[t];
            double d = last;
            h[s[t]] += d;
        }
#endif
    return last;
}

static double last_value_found_apart(int n) {
    double last = 0;
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: last-value
        if (c[t] > 0) {
            double d = last = w[t];
            h[s[t]] += d;
        }
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (c[t] > 0) {
            double d = w[t];
            h[s[t]] += d;
        }
    for (int t = 0; t < n; t++)
        if (c[t] > 0)
            last = w[t];
#endif
    return last;
}

static double *kept;

static void escapes(int n) {
    double f[3];
    int t;
    kept = f;
#ifdef BEFORE
    for (t = 0; t < n; t++) { // BEFORE: escapes
        f[0] = e[t];
        h[s[t]] += f[0];
    }
#else
    for (t = 0; t < n; t++) { // EXPECT: transformed
        double f[3];
        f[0] = e[t];
        h[s[t]] += f[0];
    }
#endif
    kept = NULL;
}

static void volatile_object(int n) {
    static volatile int seen[N];
    for (int t = 0; t < n; t++)
        seen[t] = (t * 7) % ROWS;
    volatile int *s;
    s = seen;
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: volatile
        h[s[t]]++;
#else
    static int copy[N];
    for (int t = 0; t < n; t++)
        copy[t] = s[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[copy[t]]++;
#endif
}

#ifndef BEFORE
struct either { double d; long l; };
#endif

static void union_of_two(int n) {
#ifdef BEFORE
    static union { double d; long l; } *h;
#else
    static struct either *h;
#endif
    if (!h)
        h = calloc(ROWS, sizeof *h);
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: union
        h[s[t]].d += 1;
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]].d += 1;
#endif
    for (int k = 0; k < ROWS; k++)
        g[k] += h[k].d;
}

static void thread_local_object(int n) {
    static _Thread_local double w;
    w = e[3];
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: thread-local
        h[s[t]] += w;
#else
    const double copy = w;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += copy;
#endif
}

static void type_punned(int n) {
#ifdef BEFORE
    double *h = (double *)numbers;
    for (int t = 0; t < n; t++) // BEFORE: type-punned
        ((int *)h)[s[t]]++;
#else
    int *h = numbers;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]]++;
#endif
}

#ifndef __x86_64__ /* In Linux programs on x86-64 this address space begins at address 0. */
#define __seg_gs __attribute__((address_space(256)))
#endif

static void address_space(int n) {
    const double __seg_gs *v;
    v = (const double __seg_gs *)(uintptr_t)e;
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: address-space
        h[s[t]] += v[t];
#else
    static double copy[N];
    for (int t = 0; t < n; t++)
        copy[t] = v[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += copy[t];
#endif
}

int main(void) {
    case_subscripts(s, N, ROWS);
    case_subscripts(c, N, 2);
    case_values(e, N);
    case_values(w, N);
    for (int t = 0; t < N; t++) {
        ones[t] = 1;
        nodes[t] = (struct node){t % 5 ? &nodes[t - 1] : NULL, e[t]};
        head[t] = &nodes[(t * 7) % N];
    }
    double lasts = 0;
    for (int round = 0; round < 3; round++) {
        may_alias(N, s, h);
        may_alias_again(N, s, g);
        other_store(N, old);
        scalar_carried(N);
        private_not_proved(N, ones);
        private_written_first(N, ones);
        private_asserted(N, ones);
        lasts += last_value(N) + last_value_found_apart(N - 50);
        escapes(N);
        volatile_object(N);
        union_of_two(N);
        thread_local_object(N);
        type_punned(N);
        address_space(N);
    }
    CASE_PRINT(h);
    CASE_PRINT(g);
    CASE_PRINT(numbers);
    CASE_PRINT(old);
    printf("%a\n", lasts);
    return 0;
}
