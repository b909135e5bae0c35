// Binning computes contributions before its overlap check, which compares reads with writes. Where outdated
// values could be harmful, the check comes first. `w` may overlap `to`; an int cannot overlap a long.
// INTEGERS: no
#include <stdio.h>

#include "case.h"

enum { N = 1500, M = 100, BACK = -1 };
static int k[N], few[N];
static long values[N], table[N];

static void subscript(int n, const int *at, const long *w, const long *restrict deep, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += deep[w[t] & 7];
} // CHECKED: 13

static void chosen(int n, const int *at, const long *w, const long *deep, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int i = 0;
        if (w[t] > 30)
            i = 1;
        to[at[t]] += deep[i];
    }
} // CHECKED: 18

static void in_turns(int n, const int *at, const long *w, const long *deep, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        long a = 0, b = 0, sum = 0;
        for (int i = 0; i < 3; i++) {
            sum += deep[a & 7];
            a = b;
            b = w[t];
        }
        to[at[t]] += sum;
    }
} // CHECKED: 27

static void length(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const long count = w[t] % 4, most = count + 1;
        long sum = 0;
        for (long i = 0; i < most; i++)
            sum += i;
        to[at[t]] += sum;
    }
} // CHECKED: 39

static void divided(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t] / 3;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t] / BACK;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += 100 % (w[t] | 1);
} // BINNED: 49

static void passed_by(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = at[t];
        if (w[t] > 40)
            continue;
        to[i] += 1;
    }
} // CHECKED: 58

static void after_jump(int n, const int *at, const long *w, const long *deep, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = at[t];
        if (t % 3 == 0)
            continue;
        to[i] += deep[t];
        if (w[t] > 0)
            to[i] += deep[t];
    }
} // CHECKED: 67

static void read_anyway(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const int i = at[t];
        if (w[t] > 40)
            to[i] += w[t];
    }
} // BINNED: 78

static void alternative(int n, const int *at, const long *w, const long *deep, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t] > 40 ? deep[t] : 0;
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t] > 40 && deep[t] > 40;
} // CHECKED: 86 88

static long shared[N], numbers[8];
static long pick(int i) {
    return shared[i];
}
static long pick_twice(int i) {
    return numbers[shared[i] & 7];
}
static long pick_at(long i) {
    return numbers[i & 7];
}

static void by_functions(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += pick(t);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += pick_twice(t);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += pick_at(w[t]);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t] > 40 ? pick(t) : 0;
} // BINNED: 104

// CHECKED: 51 53 106 108 110
// CHECKED: 122
static long *either[2];
static long at_either(int which, int i) {
    return table[either[which][i] & 7] + numbers[0];
}

static void read_in_callee(int n, const int *at, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += at_either(1, t);
}

static void lengths(int n, const int *at, const int *count, const long *w, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int i = 0; i < count[t]; i++)
            to[at[t]] += w[t] * i;
} // BINNED: 127

// An update under a condition on its own element: the record holds the subscript. Bytes may alias anything.
static void saturated(int n, const unsigned *at, unsigned char *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const unsigned value = at[t] & 63;
        if (h[value] < 9)
            ++h[value];
        h[63 - value] = h[63 - value] > 100 ? h[63 - value] / 2 : h[63 - value] * 3 + 1;
    }
} // BINNED: 134

int main(void) {
    static long to[M + N];
    static unsigned char bytes[64];
    static unsigned own[N];
    case_subscripts(k, N, M);
    case_subscripts(few, N, 4);
    for (int t = 0; t < N; t++) {
        values[t] = case_below(80);
        table[t] = shared[t] = case_below(80);
        numbers[t % 8] = t;
    }
    for (int round = 0; round < 3; round++) {
        /* in the second round `w` and `to` overlap: the first element read is the last one written */
        const long *w = round == 1 ? to + M - 1 : values;
        for (int i = 0; i < M + N; i++)
            to[i] = i % 50;
        subscript(N, k, w, table, to);
        chosen(N, k, w, table, to);
        in_turns(N, k, w, table, to);
        length(N, k, w, to);
        divided(N, k, w, to);
        passed_by(N, k, w, to);
        after_jump(N, k, w, table, to);
        read_anyway(N, k, w, to);
        alternative(N, k, w, table, to);
        by_functions(N, k, w, to);
        lengths(N, k, few, w, to);
        either[1] = round == 1 ? to : table;
        read_in_callee(N, k, to);
        for (int t = 0; t < N; t++)
            own[t] = (unsigned)few[t];
        saturated(N, own, round == 1 ? (unsigned char *)(own + 700) : bytes);
        CASE_PRINT(bytes);
        CASE_PRINT(own);
        CASE_PRINT(to);
    }
}
