/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The program sets rounding upwards, or flushing of subnormal numbers, after OpenMP has made its threads.
// Inside the loop these threads use the settings of the thread that enters it.
// INTEGERS: no
#include "case.h"

#if defined(__x86_64__)
static unsigned control(void) {
    return __builtin_ia32_stmxcsr() & ~0x3fu;
}
static void set_control(unsigned wanted) {
    __builtin_ia32_ldmxcsr(wanted);
}
enum { UPWARDS = 2 << 13, FLUSH = 1 << 15 | 1 << 6 };
#else
static unsigned control(void) {
    return 0;
}
static void set_control(unsigned wanted) {
    (void)wanted;
}
enum { UPWARDS = 0, FLUSH = 0 };
#endif

enum { N = 30000, M = 500 };
static double h[M], w[N];
static float tiny[M], small[N];
static int s[N];

static void scatter(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[s[t]] += w[t];
}

static void scatter_tiny(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        tiny[s[t]] += small[t] * 0.5f;
}

static void both(void) {
    scatter();
    scatter_tiny();
    CASE_PRINT(h);
    CASE_PRINT(tiny);
}

int main(void) {
    const unsigned usual = control();
    case_values(w, N);
    case_subscripts(s, N, M);
    for (int t = 0; t < N; t++)
        small[t] = (float)(1 + case_below(100)) * 0x1p-140f;
    both();
    set_control(usual | UPWARDS);
    both();
    set_control(usual | FLUSH);
    both();
    set_control(usual);
    both();
    return 0;
}
