/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Several declarators in one declaration: a bound in the header, and subscripts computed from each other.
// covers: row 8 of docs/constructs.md
// CFLAGS: -Wno-unused-variable
#include "case.h"

enum { N = 12000, M = 700 };
static int s[N];
static double w[N], h[M];
struct list {
    size_t length;
    const int *place;
};

static void several(int n) {
    for (int t = 0, last = n - 1; t <= last; t++) // EXPECT: transformed
        h[s[t]] += w[t];
}

static void members(const struct list *l) {
    for (size_t end = l->length, t = 0; t < end; t++) // EXPECT: transformed
        h[l->place[t]] += w[t];
}

static void unused(int n) {
    for (int none = 5, last = n, t = last - n + 2; t < n; t++) // EXPECT: refuse trip-count
        h[s[t]] += w[t];
    for (int none = 5, t = 2, last = 2 * n; t < last / 2; t++) // EXPECT: refuse trip-count
        h[s[t]] += w[t];
    for (int none = 5, t = n - 1, last = 3; t > last; t -= 2) // EXPECT: transformed
        h[s[t]] += w[t];
}

static void chained(int n, const int *from, const int *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = from[t], j = to[i], k = to[j] + 0 * i, *p = &to[k], l = *p;
        h[l] += w[t];
    }
}

int main(void) {
    const struct list l = {N, s};
    case_values(w, N);
    for (int round = 0; round < 3; round++) {
        case_subscripts(s, N, M);
        several(N);
        several(-3);
        members(&l);
        unused(N);
        chained(N, s, s);
        CASE_PRINT(h);
    }
    return 0;
}
