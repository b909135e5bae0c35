/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Floating-point exceptions trap (glibc), and the handler leaves by siglongjmp: the loop must run
 * in the thread that called it. */
// LINK: -lm
#define _GNU_SOURCE
#include <fenv.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>

enum { N = 50000, K = 1000 };
static int k[N];
static double v[N], h[K];
static sigjmp_buf out;

static void end(int number) {
    (void)number;
    siglongjmp(out, 1);
}

__attribute__((noinline)) static void divide(void) {
    for (int t = 0; t < N; t++) // EXPECT: transformed
        h[k[t]] += 1.0 / v[t];
}

__attribute__((noinline)) static void add(void) {
    for (int t = 0; t < N; t++) // EXPECT: parallel
        h[k[t]] += v[t];
}

int main(void) {
    signal(SIGFPE, end);
    for (int t = 0; t < N; t++) {
        k[t] = (int)(t * 17LL % K);
        v[t] = 1 + t % 5;
    }
    add();
    divide();
    v[N - 1] = 0;
    for (int round = 0; round < 3; round++) {
        feenableexcept(FE_DIVBYZERO);
        if (sigsetjmp(out, 1) == 0) {
            divide();
            puts("not reached");
        }
        fedisableexcept(FE_ALL_EXCEPT);
        v[N - 1] = 0;
        add();
    }
    double sum = 0;
    for (int i = 0; i < K; i++)
        sum = sum * 0.5 + h[i];
    printf("%a\n", sum);
    return 0;
}
