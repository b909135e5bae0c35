/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Arrays that are members of a local record: of a large one, of one small enough to be copied, or
// of nested records. Meanwhile other members are read, or the record's address is known elsewhere.
// covers: row 45 of docs/constructs.md
// covers: row 46 of docs/constructs.md
#include "case.h"
#include <string.h>

enum { N = 12000, M = 900, FEW = 4 };
struct table {
    double own[M];
    int count[M], scale;
};
struct small {
    double own[FEW];
    int scale;
};
struct nested {
    int before;
    struct small in[30];
};
static int edge[N];
static double w[N];
static struct table *last;

static void keep(struct table *t) {
    last = t;
}

static void large(int n) {
    struct table t = {.scale = 3};
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        t.own[edge[i]] += w[i] * t.scale;
        t.count[edge[i]]++;
    }
    CASE_PRINT(t.own);
    CASE_PRINT(t.count);
}

static void small(int n) {
    struct small u = {.scale = 5};
    for (int i = 0; i < n; i++) // EXPECT: transformed
        u.own[edge[i] % FEW] += w[i] * u.scale;
    CASE_PRINT(u.own);
}

static void nested(int n) {
    struct nested v = {0};
    for (int i = 0; i < n; i++) // EXPECT: transformed
        v.in[edge[i] % 30].own[i % FEW] += w[i] + v.before;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        v.in[edge[i] % 30].scale += edge[i];
    for (int i = 0; i < n; i++) // EXPECT: transformed
        v.in[7].own[edge[i] % FEW] += w[i];
    for (int i = 0; i < 30; i++) {
        CASE_PRINT(v.in[i].own);
        printf("%d\n", v.in[i].scale);
    }
}

/* Another function has stored the record's address and may have changed the record before. */
static void known(int n) {
    struct table t;
    memset(&t, 0, sizeof t);
    keep(&t);
    for (int i = 0; i < n; i++) // EXPECT: transformed
        t.own[edge[i]] -= w[i];
    last->own[3] += 1;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        last->count[edge[i]] += i;
    CASE_PRINT(t.own);
    CASE_PRINT(t.count);
}

int main(void) {
    case_values(w, N);
    for (int round = 0; round < 5; round++) {
        case_subscripts(edge, N, M);
        large(N - round);
        small(N - round);
        nested(N - round);
        known(N - round);
    }
    return 0;
}
