/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Counters that stop at a limit commute: methods with private copies are possible. Elements begin below,
// at or above their limit, and signed ones below zero. In similar loops the order matters: the limit
// differs between iterations or updates, or a step may pass it.
// covers: row 97 of docs/constructs.md
#include "case.h"

enum { N = 6000, M = 100, FEW = 15 };
static int s[N], r[N];
static unsigned char at_most[N], bytes[M], other[M], pairs[M][2], two[M], varies[M], mixed[M];
static unsigned short words[M];
static signed char small[M];
static int numbers[M];
static long long wide[M];
static unsigned above[M];
static unsigned long long far[M];

static void count(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (bytes[s[t]] < 255)
            ++bytes[s[t]];
        if (FEW > other[r[t]]) {
            other[r[t]] += 1;
        }
        if (t & 1)
            if (pairs[s[t]][t & 1] <= 40)
                pairs[s[t]][t & 1]++;
        if (words[s[t]] != 65535)
            words[s[t]] = words[s[t]] + 1;
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (small[r[t]] < 100)
            small[r[t]] = 1 + small[r[t]];
        if (200 >= numbers[s[t]])
            numbers[s[t]]++;
        if (wide[r[t]] < 70LL)
            wide[r[t]]++;
        if (above[s[t]] < 4000000000u)
            above[s[t]]++;
    }
}

/* The element is compared with a signed constant that is not a literal. */
static void alone(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (far[s[t]] < (53 + (FEW & 1)))
            ++far[s[t]];
    }
}

static void keep_order(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (varies[s[t]] < at_most[t])
            varies[s[t]]++;
        if (two[r[t]] < 9)
            two[r[t]] += 2;
        if (mixed[s[t]] < 9)
            mixed[s[t]]++;
        if (mixed[r[t]] < 30)
            mixed[r[t]]++;
    }
}

static void keep_order_below(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (bytes[s[t]] != 200)
            bytes[s[t]]++;
        if (small[s[t]] > 3)
            small[s[t]]++;
        if (other[r[t]] < 200)
            other[r[t]]--;
        if (numbers[r[t]] < 90.5)
            numbers[r[t]]++;
        if (words[s[t]] < 100)
            words[s[t]]++;
        else
            words[s[t]] = 7;
    }
}

int main(void) {
    for (int t = 0; t < N; t++)
        at_most[t] = (unsigned char)case_below(90);
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < M; i++) {
            bytes[i] = (unsigned char)(i * (round + 1));
            far[i] = (unsigned)(i % 60);
            other[i] = two[i] = mixed[i] = (unsigned char)(i % 40);
            pairs[i][0] = pairs[i][1] = varies[i] = (unsigned char)(i % 90);
            words[i] = (unsigned short)(65535 - i);
            small[i] = (signed char)(i - 128);
            numbers[i] = i - 150;
            wide[i] = (long long)i - 1000000000000LL * (i % 3);
            above[i] = 4000000000u - 30u + (unsigned)i;
        }
        case_subscripts(s, N, M);
        case_subscripts(r, N, M);
        count(N - round);
        alone(N - round);
        CASE_PRINT(far);
        CASE_PRINT(bytes);
        CASE_PRINT(other);
        CASE_PRINT(pairs);
        CASE_PRINT(words);
        CASE_PRINT(small);
        CASE_PRINT(numbers);
        CASE_PRINT(wide);
        CASE_PRINT(above);
        keep_order(N);
        keep_order_below(N - 1);
        CASE_PRINT(varies);
        CASE_PRINT(two);
        CASE_PRINT(mixed);
        CASE_PRINT(bytes);
        CASE_PRINT(small);
        CASE_PRINT(other);
        CASE_PRINT(numbers);
        CASE_PRINT(words);
    }
    return 0;
}
