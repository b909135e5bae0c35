/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Iterations that may leave the loop by return, break, goto, exit or an assertion, in the loop itself or in an inner
// one, and iterations that print a message and continue. If no iteration leaves, the loop runs in parallel. If the
// first, a middle or the last one leaves, the result is that of the sequential loop, and messages appear in order.
// INTEGERS: no
// COMPILERS: gcc clang-19
#include <assert.h>
#include <signal.h>
#include <stdlib.h>

#include "case.h"
#include "child.h"

enum { N = 2500, M = 300 };
static int k[N + 4];
static double h[M], w[N];
static int limit = 1 << 30, most = N;

__attribute__((noinline)) static int by_return(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = k[t];
        if (i < 0)
            return -t;
        h[i] += w[t];
    }
    return 1;
}

__attribute__((noinline)) static int by_break(int n) {
    int t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        if (k[t] < 0)
            break;
        h[k[t]] += w[t] * 2;
    }
    return t;
}

__attribute__((noinline)) static int by_goto(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double v = w[t];
        if (v > 1e9) {
            printf("iteration %d: %g\n", t, v);
            goto fail;
        }
        h[k[t] < 0 ? 0 : k[t]] += v;
    }
    return 0;
fail:
    return 7;
}

__attribute__((noinline)) static int from_inside(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++) {
            int i = k[t + c];
            if (i == -7)
                return t;
            h[i < 0 ? 1 : i] += w[t];
        }
    return -1;
}

__attribute__((noinline)) static void by_exit(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = k[t];
        if (i > limit) {
            printf("iteration %d: %d\n", t, i);
            case_print("exit", h, sizeof h);
            exit(3);
        }
        if (i < 0)
            continue;
        h[i] += w[t];
    }
}

/* A jump that skips a condition also skips the division in it, which may trap. */
__attribute__((noinline)) static int by_quotient(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = k[t];
        if (w[t] * 2.0 < 0.5 || i < 0)
            continue;
        if (limit / ((t + 3) % 5) == 7)
            return t;
        h[i] += w[t];
    }
    return n;
}

static int checked(int i) {
    assert(i < most);
    return i;
}

__attribute__((noinline)) static void by_assert(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = k[t];
        assert(i > -100);
        int j = checked(t);
        h[i < 0 ? 2 : i] += w[j];
    }
}

static int warnings;

static void warn(const char *where, int t) {
    fprintf(stdout, "%s: %d\n", where, t);
}

/* The iterations continue after the message. */
__attribute__((noinline)) static int by_message(int n) {
    int here = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = k[t];
        if (w[t] > 1e9) {
            printf("iteration %d: %g, %g before\n", t, w[t], h[5]);
            warnings++;
            here = t;
        }
        for (int c = 0; c < 2; c++) {
            if (k[t + c] < -5)
                warn("subscript", t);
            h[i < 0 ? 3 : i] += w[t] * c;
        }
    }
    return here;
}

/* A condition to leave may assign a variable, which is used below and after the loop. */
__attribute__((noinline)) static int by_assigned(int n) {
    int i = -1;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int end, sum = 3;
        if ((i = k[t]) == -7 || (i > 10 && (sum = i + t) < 0))
            return t;
        if ((end = i < 0 ? 4 : i) > limit) {
            printf("iteration %d: %d\n", t, i);
            exit(3);
        }
        h[end] += w[t] * sum;
    }
    return i;
}

/* ... in an inner loop, with a message after which the loop continues. */
__attribute__((noinline)) static int by_assigned_inside(int n) {
    int i = 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 2; c++) {
            if ((i = k[t + c]) < -5)
                warn("assigned", t);
            h[i < 0 ? c : i] -= w[t];
        }
    return i;
}

static int is_bad(int t) {
    const int i = k[t];
    return i < 0 || i >= M;
}

/* A function without effects decides. */
__attribute__((noinline)) static int by_function(int n) {
    int t;
    for (t = 0; t < n; t++) { // EXPECT: transformed
        if (is_bad(t))
            break;
        h[k[t]] += w[t];
    }
    return t;
}

static int get(int t, int *i) {
    *i = k[t];
    return *i >= -5;
}

/* A function of the condition writes the variable through its address. */
__attribute__((noinline)) static int by_written(int n) {
    int i;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (!get(t, &i))
            return t;
        h[i < 0 ? 5 : i] += w[t];
    }
    return n;
}

static void run(const char *name) {
    int results[11];
    by_assert(N);
    results[5] = by_message(N);
    results[6] = warnings;
    results[0] = by_return(N);
    results[1] = by_break(N);
    results[2] = by_goto(N);
    results[3] = from_inside(N);
    by_exit(N);
    results[4] = by_quotient(N);
    results[7] = by_assigned(N);
    results[8] = by_assigned_inside(N);
    results[9] = by_function(N);
    results[10] = by_written(N);
    case_print(name, results, sizeof results);
    case_print("h", h, sizeof h);
    fflush(stdout);
}

/* Prints the updates of all earlier iterations. */
static void at_abort(int number) {
    (void)number;
    case_print("aborted", h, sizeof h);
    exit(0);
}

int main(void) {
    static const int places[] = {0, N / 2, N - 1};
    case_subscripts(k, N, M);
    case_values(w, N);
    for (int t = 2; t < N; t += 5)
        w[t] = 0.125;
    run("none leaves");
    run("none leaves again");
    for (int p = 0; p < 3; p++) {
        const int at = places[p], was = k[at];
        const double value = w[at];
        k[at] = -7;
        run("one leaves");
        k[at] = was;
        w[at] = 2e9;
        run("one prints");
        w[at] = value;
    }
    limit = M - 2;
    run_in_child(run, "exit");
    limit = 1 << 30;
    k[N / 3] = -200;
    run_in_child(run, "assertion");
    k[N / 3] = 0;
    most = N / 2;
    run_in_child(run, "assertion in a function");
    most = N;
    run("none leaves in the end");
    most = N / 2;
    signal(SIGABRT, at_abort);
    by_assert(N);
    return 0;
}
