/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Memory with two names, or read as another type through the attribute may_alias. The guard detects
// the overlap at run time; no static proof by names or types may omit the guard.
// covers: row 29, row 30, row 44 of docs/constructs.md
// MAY-RUN-SERIALLY: reads and updates overlap
#include <string.h>

#include "case.h"

enum { N = 6000, M = 500 };
typedef int __attribute__((may_alias)) any_int;

static int s[2 * N], k[N];
double object[N];
extern double by_alias[N] __attribute__((alias("object")));
extern double by_label[N] __asm__("object");
static float h[N];

static void two_names(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * by_alias[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * by_label[t];
}

__attribute__((noipa)) static void another_type(int n, const any_int *subscript, float *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[subscript[t] % M] += 1.0f;
}

/* Only the asm statements show that the pointers point into `object`. */
static void by_assembler(int n) {
    static double other[N];
    double *once = other, own[M] = {0}, *twice = own;
    twice = own;
    __asm__("" : "=r"(once) : "0"(&object[3]));
    __asm__("" : "=r"(twice) : "0"(&object[5]));
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * once[0];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.25 * twice[0];
}

int main(void) {
    case_values(object, N);
    case_subscripts(k, N, M);
    for (int i = 0; i < N; i++)
        h[i] = (float)case_value();
    const int one = 1;
    for (int i = 0; i < N; i++) /* read as integers these are small until 1.0f is added */
        memcpy(&h[i], i % 3 ? &one : &k[i], sizeof one);
    case_subscripts(s, 2 * N, M);
    for (int round = 0; round < 3; round++) {
        two_names(N);
        by_assembler(N);
        another_type(N, s, h);
        another_type(M, (const any_int *)h, h);
        CASE_PRINT(object);
        CASE_PRINT(h);
        for (int i = 0; i < N; i++)
            object[i] *= 0x1p-40;
    }
    return 0;
}
