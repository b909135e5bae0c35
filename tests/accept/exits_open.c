/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops without a bound: an element of the list tells its end. The memory after it cannot be read. Lists have no, one
// or many elements, end at the borders of blocks, and change between executions.
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19
#include "ended_list.h"

enum { MOST = ENDED_MOST, M = 200 };
static double h[M], w[MOST + 1];
static int turns = 2; /* iterations are long */

static double work(double x, int turns) {
    for (int c = 0; c < 3 + turns % 3; c++)
        x = x * 0.99 + 1.0 / (1.0 + x * x);
    return x;
}

__attribute__((noinline)) static int assigned(const int *list) {
    int i, j;
    for (i = 0; (j = list[i]) > -1; i++) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[j] += work(w[i], j);
    }
    return i + j;
}

__attribute__((noinline)) static int declared(const int *list) {
    int last = -5;
    for (long i = 0; list[i] != -1; i++) { // EXPECT: transformed
        last = list[i];
        h[last] += work(0.25, 1);
        for (int c = 0; c < turns; c++)
            h[(last + c) % M] -= w[i] * c;
    }
    return last;
}

__attribute__((noinline)) static int by_pointer(const int *list) {
    const int *p;
    for (p = list; *p != -1; ++p) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[*p] = h[*p] * 1.0001 + c;
    }
    return (int)(p - list);
}

__attribute__((noinline)) static int pointer_declared(const int *list, const double *v) {
    for (const int *p = list, *q = list + 1; *p != -1; p++, q++, v++) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[*p] += *v * c;
    }
    return list[0];
}

__attribute__((noinline)) static int by_while(const int *list) {
    unsigned i = 0;
    while (list[i] != -1) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[list[i]] += w[i] + c;
        i++;
    }
    return (int)i;
}

__attribute__((noinline)) static int endless(const int *list, int most) {
    int i = 0;
    for (;; i++) { // EXPECT: transformed
        if (list[i] == -1)
            break;
        if (list[i] > most)
            return -i;
        for (int c = 0; c < turns; c++)
            h[list[i]] += w[i] - c;
    }
    return i;
}

static void run(const int *list, int most) {
    int results[6];
    results[0] = assigned(list);
    results[1] = declared(list);
    results[2] = by_pointer(list);
    results[3] = pointer_declared(list, w);
    results[4] = by_while(list);
    results[5] = endless(list, most);
    CASE_PRINT(results);
    CASE_PRINT(h);
}

int main(void) {
    static const int counts[] = {0, 1, 2, 15, 16, 17, 48, 1000, 999, MOST};
    case_values(w, MOST + 1);
    for (unsigned c = 0; c < sizeof counts / sizeof *counts; c++) {
        int *list = ended_list(counts[c], M);
        run(list, M);
        if (counts[c] < 3)
            continue;
        list[counts[c] - 1] = M - 1; /* the list changes, and becomes shorter */
        run(list, M - 2);
        list[counts[c] - 2] = -1;
        run(list, M);
    }
    return 0;
}
