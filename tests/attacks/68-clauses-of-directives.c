// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// After the loop the program has OpenMP directives. Their clauses read the loop's last value, or give
// a construct its own copy of the variable, so an assignment in it does not change the value. For
// comparison: the same function without directives.
// CFLAGS: -O2 -fopenmp
#include <omp.h>
#include <stdio.h>

enum { N = 20000 };
static int s[N], h[64];

static __attribute__((noinline)) int how_many(int n) {
    int x = 1, count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t] % 3 + 1;
        h[x] += 1;
    }
#pragma omp parallel num_threads(x) reduction(+ : count)
    count += 1;
    x = 5;
    return count;
}

static __attribute__((noinline)) int whether(int n) {
    int x = 1, count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
#pragma omp parallel if (x > 100) num_threads(2)
    {
#pragma omp single
        {
            x = 1;
            count = omp_get_num_threads();
        }
    }
    return count;
}

static __attribute__((noinline)) int chunks(int n) {
    int x = 1, sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t] % 3 + 1;
        h[x] += 1;
    }
#pragma omp parallel for schedule(static, x) reduction(+ : sum) num_threads(2)
    for (int i = 0; i < 10; i++)
        sum += omp_get_thread_num() * i;
    x = 5;
    return sum;
}

static __attribute__((noinline)) int own_copies(int n) {
    int x = 1;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
#pragma omp parallel private(x) num_threads(2)
    {
        x = 3;
    }
    return x;
}

/* No clause names x, but it is private to each thread as the counter of the loop after the directive. */
static __attribute__((noinline)) int counted(int n) {
    int x = 1;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
#pragma omp parallel for num_threads(2)
    for (x = 0; x < 64; x++)
        h[x] += 1;
    return x;
}

static __attribute__((noinline)) int without(int n) {
    int x = 1;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    x = 5;
    return x;
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = (int)((unsigned)t * 7919u % 1000u) + 100;
    for (int again = 0; again < 20; again++)
        printf("%d %d %d %d %d %d\n", how_many(N), whether(N), chunks(N), own_copies(N), counted(N),
               without(N));
    for (int i = 0; i < 64; i++)
        printf("%d\n", h[i]);
    return 0;
}
