/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions that check their arguments before they update an element: a bad argument ends the program, prints, or gives
// a result that ends the loop. If no call fails, the loop runs in parallel. If one does, messages and elements are those
// of the sequential loop.
// covers: row 18, row 20
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19
#include <assert.h>

#include "case.h"
#include "child.h"

enum { N = 2500, M = 300 };
typedef struct vector {
    int n;
    double *p;
} vector;
static int k[N + 4];
static double elements[M + 1], w[N]; /* an error prints and goes on with element M */
static vector all = {M, elements};
static int messages;

static void add(vector *a, int i, double x) {
    if (!a || i >= a->n) {
        case_print("bad", elements, sizeof elements);
        fprintf(stdout, "subscript %d\n", i);
        exit(4);
    }
    a->p[i] += x;
}
__attribute__((noinline)) static void by_exit(vector *a, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add(a, k[t] < 0 ? 0 : k[t], w[t]);
}

/* An error code, which the loop tests in several ways. */
static int add_or_fail(vector *a, int i, double x) {
    if (i < 0)
        return -1;
    if (i >= a->n) {
        fprintf(stdout, "subscript %d is too large\n", i);
        return -2;
    }
    a->p[i] += x;
    return 0;
}
__attribute__((noinline)) static int by_result(vector *a, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (add_or_fail(a, k[t], w[t]))
            return t;
    return -1;
}
__attribute__((noinline)) static int by_comparison(vector *a, int n) {
    int error = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double x = w[t] * 0.5;
        if ((error = add_or_fail(a, k[t], x)) != 0)
            break;
        if (add_or_fail(a, k[t] / 2, 1.0) < 0) {
            printf("iteration %d\n", t);
            goto fail;
        }
    }
    return error;
fail:
    return 100;
}
__attribute__((noinline)) static int by_variable(vector *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int info = add_or_fail(a, k[t], 0.25);
        if (info)
            return info;
        info = add_or_fail(a, k[t], w[t] * w[t]);
        if (info)
            return info;
    }
    return 0;
}
/* The result is not used: bad arguments are passed over, or print. */
__attribute__((noinline)) static void by_nothing(vector *a, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add_or_fail(a, k[t], w[t]);
}

/* The loop goes on after the message, or after one of both branches. */
static void add_or_tell(vector *a, int i, double x) {
    if (i < 0) {
        printf("message %d: %d, %g before\n", messages++, i, a->p[0]);
        return;
    }
    a->p[i] += x;
}
__attribute__((noinline)) static void by_message(vector *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = k[t];
        add_or_tell(a, i, w[t]);
        if (i < -100)
            printf("far below: %d\n", i);
        else if (i >= 0)
            a->p[i] -= 0.125;
    }
}

/* The other branch tells. */
static void add_or_else(vector *a, int i, double x) {
    if (i >= 0 && i < a->n)
        a->p[i] += x;
    else
        printf("%d is out of bounds\n", i);
}
__attribute__((noinline)) static void by_other_branch(vector *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        add_or_else(a, k[t], w[t]);
        if (w[t] < 1e9) {
            a->p[(t + 1) % M] += 0.5;
        } else {
            printf("%d: %g is too large\n", t, w[t]);
            exit(6);
        }
    }
}

/* A helper of the helper updates, in a nest. */
static int add_plain(vector *a, int i, double x) {
    a->p[i] += x;
    return i < 0 ? 7 : 0;
}
static void add_twice(vector *a, int i, int j, double x) {
    if (j >= a->n || i >= a->n) {
        printf("%d and %d\n", i, j);
        exit(5);
    }
    if (add_plain(a, i, x))
        return;
    add_plain(a, j, -x);
}
__attribute__((noinline)) static void by_helpers(vector *a, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            add_twice(a, k[t] < 0 ? 1 : k[t], k[t + c] < 0 ? 2 : k[t + c], w[t]);
}

/* The loop continues after either branch of the caller's `if`. */
static int add_positive(vector *a, int i, double x) {
    if (x < 0)
        return 0;
    a->p[i] += x;
    return 1;
}
__attribute__((noinline)) static void by_branches(vector *a, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = k[t] < 0 ? 2 : k[t];
        if (add_positive(a, i, w[t]))
            a->p[(i + 1) % M] -= 1.0;
        else
            a->p[i] *= 0.5;
    }
}

static void add_asserted(vector *a, int i, double x) {
    assert(i < a->n);
    a->p[i] += x;
}
__attribute__((noinline)) static void by_assertion(vector *a, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        add_asserted(a, k[t] < 0 ? 0 : k[t], w[t]);
}

/* Arrays are never NULL, which compilers know. */
double shared[M];
static void add_to(double *a, int i, double x) {
    if (!a || (a && i >= M) || a == NULL)
        exit(7);
    a[i] += x;
}
__attribute__((noinline)) static void of_arrays(int n) {
    double own[M] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = k[t] < 0 ? 0 : k[t];
        add_to(elements, i % M, w[t]);
        add_to(shared, i % M, w[t]);
        add_to(own, i % M, w[t]);
    }
    elements[1] += own[2];
}

static void run(const char *name) {
    int results[4];
    results[0] = by_result(&all, N);
    results[1] = by_comparison(&all, N);
    results[2] = by_variable(&all, N);
    by_nothing(&all, N);
    by_message(&all, N);
    by_other_branch(&all, N);
    results[3] = messages;
    by_exit(&all, N);
    by_helpers(&all, N);
    by_branches(&all, N);
    by_assertion(&all, N);
    of_arrays(N);
    CASE_PRINT(shared);
    case_print(name, results, sizeof results);
    case_print("elements", elements, sizeof elements);
    fflush(stdout);
}

int main(void) {
    static const int places[] = {0, N / 2, N - 1};
    case_subscripts(k, N, M);
    case_values(w, N);
    run("none fails");
    run("none fails again");
    for (int p = 0; p < 3; p++) {
        const int at = places[p], was = k[at];
        k[at] = -7;
        run("one is negative");
        k[at] = M;
        run_in_child(run, "one is too large");
        k[at] = was;
    }
    run("none fails in the end");
    return 0;
}
