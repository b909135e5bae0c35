/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An iteration leaves the loop. The iterations before it run in parallel, and the original loop continues with it: all
// variables have their values there, and its branch reads sums, arrays and what the iteration before has left.
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19
#include "case.h"

enum { N = 1500, M = 200, RESULTS = 32 };
static int k[N + 4];
static double h[M], w[N + 4];
static double results[RESULTS];
static int result_count;

static void note(double value) {
    results[result_count++] = value;
}

__attribute__((noinline)) static int declared(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0)
            return t;
        h[k[t]] += w[t];
    }
    return -1;
}

__attribute__((noinline)) static int outside(int n) {
    int t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t] * 2;
    }
    return t;
}

__attribute__((noinline)) static int by_while(int n) {
    int t = 0;
    while (t < n) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t] * 3;
        t++;
    }
    return t;
}

/* The iteration that leaves makes its update. */
__attribute__((noinline)) static int updates_first(int n) {
    int t = 0;
    while (t < n) { // EXPECT: transformed
        h[k[t] < 0 ? 0 : k[t]] += w[t];
        if (k[t] < 0)
            break;
        t++;
    }
    return t;
}

__attribute__((noinline)) static int by_do(int n) {
    int t = 0;
    do { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t] * 5;
        t++;
    } while (t < n);
    return t;
}

__attribute__((noinline)) static int by_pointer(int n) {
    for (const int *p = k; p < k + n; p++) { // EXPECT: transformed
        if (*p < 0)
            return (int)(p - k);
        h[*p] += 0.1;
    }
    return -2;
}

__attribute__((noinline)) static int pointer_outside(int n) {
    const int *p, *end = k + n;
    for (p = k; p != end; ++p) { // EXPECT: transformed
        if (*p < 0)
            break;
        h[*p] *= 1.0001;
    }
    return (int)(p - k);
}

__attribute__((noinline)) static int downwards(int n) {
    int t = n;
    while (t-- > 0) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t];
    }
    return t;
}

__attribute__((noinline)) static int downwards_declared(int n) {
    for (int t = n; --t >= 0;) { // EXPECT: transformed
        if (k[t] < 0)
            return t;
        h[k[t]] -= w[t] / 3;
    }
    return -5;
}

__attribute__((noinline)) static int downwards_unsigned(unsigned n) {
    unsigned t;
    for (t = n; t--;) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] -= w[t] / 7;
    }
    return (int)t;
}

__attribute__((noinline)) static int by_three(int n) {
    int t;
    for (t = 1; t < n; t += 3) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t] * 7;
    }
    return t;
}

/* Other variables that the header and the body step, and one of the header that is the bound. */
__attribute__((noinline)) static int stepped(int n) {
    int j = 7, q, result = 0;
    for (int t = 0, i = 3, e = n; t < e; t++, i += 2) { // EXPECT: transformed
        if (k[t] < 0) {
            result = i * 1000 + j;
            break;
        }
        h[(k[t] + i + j) % M] += w[t];
        j += 3;
    }
    const double *v;
    int t;
    for (t = 0, q = 5, v = w; t < n; t++, q--, v++) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += *v * q;
    }
    return result + j + q + (int)(v - w) + t;
}

__attribute__((noinline)) static int step_inside(int n) {
    int t = 0;
    while (t < n) { // EXPECT: transformed
        if (w[t] > 1e8)
            break;
        h[k[t++]] += 0.3;
    }
    return t;
}

/* What the iteration before has left is read at the exit only, or after the loop as well. */
__attribute__((noinline)) static void last_values(int n) {
    double last = -1;
    int where = -1, large = -1, t, i;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0) {
            note(last + where);
            break;
        }
        last = w[t] * 3;
        where = k[t];
        if (where > M / 2)
            large = t;
        h[where] += last;
    }
    note(t + large + where);
    for (int s = 0; s < n; s++) { // EXPECT: transformed
        i = k[s];
        if (i < 0) {
            note(i * 1.5);
            return;
        }
        h[i] += 1;
    }
}

__attribute__((noinline)) static void sums(int n) {
    double sum = 0.5, least = 1e9, inner = 0;
    int at = -1, count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0) {
            note(sum);
            note(h[3]);
            break;
        }
        sum += w[t];
        if (w[t] < least) {
            least = w[t];
            at = t;
        }
        count++;
        for (int c = 0; c < k[t] % 4; c++) {
            inner += w[t] * c;
            h[(k[t] + c) % M] += c;
        }
    }
    note(sum + least);
    note(at + count);
    note(inner);
}

/* A message, after which the loop continues, and an exit. */
__attribute__((noinline)) static int messages(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (w[t] == 2e6)
            printf("large: %d %.17g\n", t, h[0]);
        if (k[t] < 0)
            goto fail;
        h[k[t]] += w[t];
    }
    return 0;
fail:
    return 1;
}

/* In an inner loop, and by an assigned condition. */
__attribute__((noinline)) static int inside(int n) {
    int i;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            if ((i = k[t + c]) < 0)
                return t * 10 + c;
            h[i] += w[t];
        }
    return -1;
}

/* A loop that leaves twice, within another one. */
__attribute__((noinline)) static int in_a_loop(int n) {
    int found = 0;
    for (int from = 0; from < 3; from++)
        for (int t = from; t < n; t++) { // EXPECT: transformed
            if (k[t] < 0) {
                found += t;
                break;
            }
            h[k[t]] += w[t] * from;
        }
    return found;
}

static void run(int n) {
    result_count = 0;
    note(declared(n));
    note(outside(n));
    note(by_while(n));
    note(updates_first(n));
    note(by_do(n));
    note(by_pointer(n));
    note(pointer_outside(n));
    note(downwards(n));
    note(downwards_declared(n));
    note(downwards_unsigned((unsigned)n));
    note(by_three(n));
    note(stepped(n));
    note(step_inside(n));
    last_values(n);
    sums(n);
    note(messages(n));
    note(inside(n));
    note(in_a_loop(n));
    case_print("results", results, sizeof results);
    CASE_PRINT(h);
}

int main(void) {
    static const int places[] = {N + 3, 0, 1, 2, 16, 49, N - 1, 700};
    for (unsigned p = 0; p < sizeof places / sizeof *places; p++) {
        case_subscripts(k, N + 4, M);
        case_values(w, N + 4);
        k[places[p]] = -1;
        w[places[p]] = 1e9;
        if (p == 3)
            w[places[p] / 2] = 2e6;
        run(N);
        if (p < 2)
            run(0), run(1);
    }
    return 0;
}
