/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Objects that a pragma or asm label gives other names, and types whose attributes a macro hides:
// the guard finds the overlap.
// covers: row 29, row 30, row 44 of docs/constructs.md
// MAY-RUN-SERIALLY: reads and updates overlap
#include <string.h>

#include "case.h"

#define JOIN(a, b) a##b
enum { N = 6000, M = 500 };
typedef int __attribute__((may_alias)) any_int;

static int k[N];
double object[N];
#pragma redefine_extname by_pragma object
extern double by_pragma[N];
extern double by_macro[N] __attribute__((JOIN(al, ias)("object")));
extern double by_assembler[N];
__asm__(".globl by_assembler\n.set by_assembler, object");
static float h[N];

static void other_names(int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * by_pragma[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * by_macro[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        object[k[t]] += 0.5 * by_assembler[t];
}

__attribute__((noipa)) static void another_type(int n, const __typeof__(any_int) *subscript,
                                                float *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[subscript[t] % M] += 1.0f;
}

int main(void) {
    case_values(object, N);
    case_subscripts(k, N, M);
    const int one = 1;
    for (int i = 0; i < N; i++) /* read as integers these are small until 1.0f is added */
        memcpy(&h[i], i % 3 ? &one : &k[i], sizeof one);
    for (int round = 0; round < 3; round++) {
        other_names(N);
        another_type(M, (const any_int *)h, h);
        CASE_PRINT(object);
        CASE_PRINT(h);
        for (int i = 0; i < N; i++)
            object[i] *= 0x1p-40;
    }
    return 0;
}
