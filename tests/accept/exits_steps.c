/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops without a bound whose counter is stepped where it is used, in the condition or in the body. An element of the
// list tells its end, and the memory after it cannot be read. Lists have no, one or many elements, end at the borders of
// blocks, and change between executions.
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19
#include "ended_list.h"

enum { M = 200, END = -1 };
static double h[M], w[ENDED_MOST + 1];
static int turns = 2; /* iterations are long */

static double work(double x, int turns) {
    for (int c = 0; c < 3 + turns % 3; c++)
        x = x * 0.99 + 1.0 / (1.0 + x * x);
    return x;
}

__attribute__((noinline)) static long in_condition(const int *list) {
    const int *p = list;
    int k;
    while ((k = *p++) != END) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[k] += work(w[k], c);
    }
    return p - list + k;
}

__attribute__((noinline)) static long without_braces(const int *list) {
    const int *p = list;
    int k;
    while ((k = *p++) != END) // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[k] = h[k] * 1.0001 + c;
    return p - list + k;
}

__attribute__((noinline)) static long in_header(const int *list) {
    const int *p;
    int k;
    for (p = list; (k = *p++) > -1;) // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[k] -= work(c, k);
    return p - list + k;
}

__attribute__((noinline)) static int with_a_subscript(const int *list) {
    int k, i = 0;
    while ((k = list[i++]) >= 0) { // EXPECT: transformed
        if (k == 3)
            continue;
        for (int c = 0; c < turns; c++)
            h[k] += work(w[k], c);
    }
    return i;
}

__attribute__((noinline)) static int in_body(const int *list, int most) {
    const int *p = list;
    for (;;) { // EXPECT: transformed
        const int k = *p++;
        if (k == END)
            break;
        if (k > most)
            return -(int)(p - list);
        for (int c = 0; c < turns; c++)
            h[k] += work(k, c);
    }
    return (int)(p - list);
}

__attribute__((noinline)) static int with_others(const int *list) {
    const double *v = w;
    const int *p = list;
    int k, n = 5;
    for (; (k = *p++) != END; n += 2, v++) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[k] += *v * c + n;
    }
    return n + (int)(p - list) + (int)(v - w);
}

__attribute__((noinline)) static int at_end(const int *list) {
    const int *p = list;
    while (*p != END) { // EXPECT: transformed
        for (int c = 0; c < turns; c++)
            h[*p] += work(*p, c);
        if (*p++ == 7)
            continue;
    }
    return (int)(p - list);
}

__attribute__((noinline)) static int counted_without_clause(const int *list, int n) {
    int k, i;
    for (i = 0; i < n;) { // EXPECT: transformed
        k = list[i++];
        if (k % 5 == 0)
            continue;
        for (int c = 0; c < turns; c++)
            h[k] += w[k] + c;
    }
    return i;
}

static void run(const int *list, int n, int most) {
    long results[8];
    results[0] = in_condition(list);
    results[1] = without_braces(list);
    results[2] = in_header(list);
    results[3] = with_a_subscript(list);
    results[4] = in_body(list, most);
    results[5] = with_others(list);
    results[6] = at_end(list);
    results[7] = counted_without_clause(list, n);
    CASE_PRINT(results);
    CASE_PRINT(h);
}

int main(void) {
    static const int counts[] = {0, 1, 2, 15, 16, 17, 48, 1000, 999, ENDED_MOST};
    case_values(w, ENDED_MOST + 1);
    for (unsigned c = 0; c < sizeof counts / sizeof *counts; c++) {
        int *list = ended_list(counts[c], M);
        run(list, counts[c], M);
        if (counts[c] < 3)
            continue;
        list[counts[c] - 1] = M - 1; /* the list changes, and becomes shorter */
        run(list, counts[c] - 1, M - 2);
        list[counts[c] - 2] = END;
        run(list, counts[c] - 3, M);
    }
    return 0;
}
