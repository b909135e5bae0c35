/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Macros that check something, and macros whose call expands to several statements.
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19

#include "case.h"
#include "child.h"

enum { N = 2500, M = 300 };
typedef struct vector {
    int n;
    double *p;
} vector;
static int k[N];
static double elements[M], other[M], w[N];

#define CHECK(condition, code)                                                                                         \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            printf("line %d: %s\n", __LINE__, #condition);                                                             \
            case_print("elements", elements, sizeof elements);                                                         \
            exit(code);                                                                                                \
        }                                                                                                              \
    } while (0)
#define CHECK_ERROR(error)                                                                                             \
    {                                                                                                                  \
        if (error) {                                                                                                   \
            printf("line %d: error %d\n", __LINE__, error);                                                            \
            return error;                                                                                              \
        }                                                                                                              \
    }
#define GET(a, i, x) 0; { *(x) = (a).p[i]; }
#define ADD(a, i, x) 0; { if (x) { (a).p[i] += (x); } }
#define ADD_BOTH(i, x) elements[i] += (x); other[i] -= (x)

__attribute__((noinline)) static void by_check(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = k[t];
        CHECK(i < M, 5);
        elements[i < 0 ? 0 : i] += w[t];
    }
}

__attribute__((noinline)) static int by_error(vector a, vector b, int n) {
    int info, i;
    double x;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        i = k[t] < 0 ? 1 : k[t] % M;
        info = GET(b, i, &x); CHECK_ERROR(info);
        if (w[t] == 0)
            continue;
        const double y = x * w[t];
        info = ADD(a, i, y); CHECK_ERROR(info);
    }
    return 0;
}

__attribute__((noinline)) static int by_code(const int *code, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int error = code[t] < -5; CHECK_ERROR(error);
        elements[k[t] < 0 ? 3 : k[t] % M] += w[t];
    }
    return 0;
}

/* The counter steps in the body, whose text is printed. */
__attribute__((noinline)) static int in_while(int n) {
    int t = 0;
    while (t < n) { // EXPECT: transformed
        const int i = k[t] < 0 ? 3 : k[t] % M;
        ADD_BOTH(i, w[t]);
        if (i == 7) {
            ADD_BOTH(2, 1.0);
        }
        t++;
    }
    return t;
}

__attribute__((noinline)) static void in_branch(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (k[t] >= 0) {
            ADD_BOTH(k[t] % M, w[t] * 0.5);
        }
}

static void run(const char *name) {
    int results[3];
    const vector a = {M, elements}, b = {M, other};
    results[0] = by_error(a, b, N);
    results[1] = by_code(k, N);
    results[2] = in_while(N);
    in_branch(N);
    by_check(N);
    case_print(name, results, sizeof results);
    CASE_PRINT(elements);
    CASE_PRINT(other);
    fflush(stdout);
}

int main(void) {
    static const int places[] = {0, N / 2, N - 1};
    case_subscripts(k, N, M);
    case_values(w, N);
    case_values(other, M);
    run("none leaves");
    run("none leaves again");
    for (int p = 0; p < 3; p++) {
        const int at = places[p], was = k[at];
        k[at] = -7;
        run("error");
        k[at] = M;
        run_in_child(run, "exit");
        k[at] = was;
    }
    run("none leaves in the end");
    return 0;
}
