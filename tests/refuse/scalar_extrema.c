/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/scalar_extrema.c: iterations carry more than the extremum.
// covers: row 88 of docs/constructs.md
#include <math.h>

enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];

double read_too(int n) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += big;
        if (e[i] > big)
            big = e[i];
    }
    return big;
}

int place_read(int n) {
    double big = -1;
    int at = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[at];
        if (e[i] > big) {
            big = e[i];
            at = i;
        }
    }
    return at;
}

int place_set_besides(int n) {
    double big = -1;
    int at = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        at = 0;
        h[s[i]] += e[i];
        if (e[i] > big) {
            big = e[i];
            at = i;
        }
    }
    return at;
}

int place_of_two(int n) {
    double big = -1, low = 1;
    int at = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big) {
            big = e[i];
            at = i;
        }
        if (e[i] < low) {
            low = e[i];
            at = i;
        }
    }
    return at + (int)low;
}

double other_value(int n) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big)
            big = 2 * e[i];
    }
    return big;
}

double with_itself(int n) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] + big > big)
            big = e[i] + big;
    }
    return big;
}

double otherwise(int n) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big)
            big = e[i];
        else
            big -= 1;
    }
    return big;
}

double more_than_that(int n, int *times) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big) {
            big = e[i];
            *times += 1;
        }
    }
    return big;
}

int place_of_data(int n) {
    double big = -1;
    int at = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big) {
            big = e[i];
            at = s[i];
        }
    }
    return at;
}

double in_a_loop_inside(int n) {
    double big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        for (int c = 0; c < 3; c++)
            if (e[i] * c > big)
                big = e[i] * c;
    }
    return big;
}

float rounded(int n) {
    float big = -1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big)
            big = (float)e[i];
    }
    return big;
}

double by_pointer(int n, int *q) {
    double big = -1;
    double *const now = &big;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[i];
        if (e[i] > big)
            big = e[i];
        q[i] = *now > 0;
    }
    return big;
}
