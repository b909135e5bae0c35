/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Look-ups whose narrow cursor wraps around to 0, or in which the conversion to a narrower type
// changes the start or the result. Before a plan is reused, redcc compares the elements on which it
// depends: these must be the elements that the look-up reads.
#include <stdio.h>

enum { N = 4000, ROOM = 600 };
static double bins[ROOM];
static int numbers[ROOM], first[N];

#define KEEP __attribute__((noipa)) static

static int narrow(const int *a, int from, int wanted) {
    unsigned char c = (unsigned char)from;
    while (a[c] != wanted)
        c++;
    return c;
}

static unsigned char narrow_alike(const int *a, unsigned char from, int wanted) {
    unsigned char c = from;
    while (a[c] != wanted)
        c++;
    return c;
}

static int converted(const int *a, int from, int wanted) {
    int c = (signed char)from;
    while (a[c] != wanted)
        c++;
    return c;
}

static int converted_silently(const int *a, double from, int wanted) {
    int c = from;
    while (a[c] != wanted)
        c++;
    return c;
}

static unsigned char narrow_result(const int *a, int from, int wanted) {
    int c = from;
    while (a[c] != wanted)
        c++;
    return c;
}

static int plain(const int *a, int from, int wanted) {
    int c = from;
    while (a[c] != wanted)
        c++;
    return c;
}

KEEP void loop_narrow(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int f = narrow(table, start[t], wanted);
        h[f] += t + 1.5;
    }
}

KEEP void loop_narrow_alike(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const unsigned char f = narrow_alike(table, (unsigned char)start[t], wanted);
        h[f] += t + 1.5;
    }
}

KEEP void loop_converted(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int f = converted(table, start[t] + 256, wanted);
        h[f] += t + 1.5;
    }
}

KEEP void loop_converted_silently(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int f = converted_silently(table, start[t] + 0.75, wanted);
        h[f] += t + 1.5;
    }
}

KEEP void loop_narrow_result(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int f = narrow_result(table, start[t], wanted);
        h[f] += t + 1.5;
    }
}

KEEP void loop_plain(int n, int wanted, const int *start, const int *table, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int f = plain(table, start[t], wanted);
        h[f] += t + 1.5;
    }
}

static void all(void (*loop)(int, int, const int *, const int *, double *restrict), int at, int nearer) {
    for (int i = 0; i < ROOM; i++)
        numbers[i] = 0;
    numbers[at] = numbers[ROOM - 1] = 1;
    for (int r = 0; r < 5; r++)
        loop(N, 1, first, numbers, bins);
    numbers[nearer] = 1; /* from now on the search finds this element */
    for (int r = 0; r < 3; r++)
        loop(N, 1, first, numbers, bins);
    double sum = 0;
    for (int i = 0; i < ROOM; i++)
        sum += bins[i] * (i % 31);
    printf("%a\n", sum);
}

int main(void) {
    for (int i = 0; i < N; i++)
        first[i] = 200 + i % 7;
    all(loop_narrow, 100, 50);
    all(loop_narrow_alike, 100, 50);
    for (int i = 0; i < N; i++)
        first[i] = 20 + i % 7;
    all(loop_converted, 100, 50);
    all(loop_converted_silently, 100, 50);
    all(loop_narrow_result, 300, 280);
    all(loop_plain, 300, 280);
    return 0;
}
