/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Elements whose addresses are no multiples of their size, in packed records or records with
// complex numbers. Two pointers to them overlap. No element may get two owners.
// covers: row 30, row 45 of docs/constructs.md
// CFLAGS: -fno-strict-aliasing
// INTEGERS: no
// MAY-RUN-SERIALLY: the updated elements overlap
#include <string.h>

#include "case.h"

enum { N = 6000, M = 1900, BYTES = 100000 };
struct __attribute__((packed)) after_byte {
    char byte;
    double value;
};
struct __attribute__((packed)) padded {
    char byte;
    double value;
    char rest[7];
};
struct __attribute__((packed)) longer {
    char byte;
    double value;
    short rest[5];
};
struct holder {
    double x;
    double _Complex z;
};
static _Alignas(16) char memory[BYTES];
static int s[N];

__attribute__((noipa)) static void complex_numbers(int n, struct holder *h, double *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]].z += t;
        g[s[t]] *= 0.5;
        g[s[t] + 1] += 3;
    }
}

__attribute__((noipa)) static void packed(int n, struct padded *h, double *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]].value += t;
        g[s[t]] *= 0.5;
    }
}

__attribute__((noipa)) static void unlike(int n, struct after_byte *h, struct longer *g) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[s[t]].value += t;
        g[s[t]].value += 7;
    }
}

int main(void) {
    case_subscripts(s, N, M);
    for (int from = 0; from < 10; from++) {
        memset(memory, 0, sizeof memory);
        complex_numbers(N, (struct holder *)memory, (double *)memory + from);
        CASE_PRINT(memory);
        memset(memory, 0, sizeof memory);
        packed(N, (struct padded *)memory, (double *)memory + from);
        CASE_PRINT(memory);
        memset(memory, 0, sizeof memory);
        unlike(N, (struct after_byte *)(memory + 8), (struct longer *)(memory + from));
        CASE_PRINT(memory);
    }
    return 0;
}
