// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A call fills the subscript variable through its address, and another call gets its value. The
// second call must not be mistaken for one that may fill it: the inspector would execute it, and
// sums, extrema and stores that belong to the executor would be made twice. For comparison: a call
// that does fill the variable.
#include <stdio.h>
#include <string.h>

enum { N = 20000 };
static int s[N], h[1024];
static double x[1024], own[N];

static double half(double v) {
    return v > 9 ? 9 : 0.5 * v;
}

static void find(const int *from, int t, int *k) {
    *k = from[t] & 1023;
}

static double look_up(const int *k) {
    return x[*k];
}

static double find_and_tell(int t, int *k) {
    *k = s[t] & 1023;
    return x[*k];
}

static __attribute__((noinline)) double a_sum(int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int k;
        find(s, t, &k);
        sum += half(x[k]) - t;
        h[k] += t & 31;
    }
    return sum;
}

static __attribute__((noinline)) double a_sum_of_a_copy(int n) {
    double sum = 0;
    for (int t = 0; t < n - 1; t++) { // EXPECT: parallel
        int k[2];
        memcpy(k, &s[t], sizeof k);
        sum += half(x[k[1] & 1023]);
        h[k[1] & 1023] += t & 31;
    }
    return sum;
}

static __attribute__((noinline)) double an_extremum(int n) {
    double most = -1e9;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int k;
        find(s, t, &k);
        const double v = half(x[k]) + t % 77;
        if (v > most)
            most = v;
        h[k] += t & 31;
    }
    return most;
}

static __attribute__((noinline)) int a_count(int n) {
    int count = 3;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int k;
        find(s, t, &k);
        count += half(x[k]) > 2;
        h[k] += t & 31;
    }
    return count;
}

/* The update itself calls a function with the value. */
static __attribute__((noinline)) void an_update(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int k;
        find(s, t, &k);
        h[k] += (int)half(x[k]);
    }
}

/* An element of the iteration itself, which the iteration changes. */
static __attribute__((noinline)) void a_store(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        int k;
        find(s, t, &k);
        own[t] = half(own[t] + x[k]);
        h[k] += t & 31;
    }
}

/* The call gets the address and, as far as the analysis knows, may fill the variable. */
static __attribute__((noinline)) double a_sum_by_address(int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k;
        find(s, t, &k);
        sum += look_up(&k);
        h[k] += t & 31;
    }
    return sum;
}

/* The call that fills the subscript is the sum's operand: both are in one statement. */
static __attribute__((noinline)) double a_sum_that_finds(int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        int k;
        sum += find_and_tell(t, &k);
        h[k] += t & 31;
    }
    return sum;
}

static __attribute__((noinline)) double a_condition_that_sums(int n) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        int k;
        find(s, t, &k);
        if ((sum += half(x[k])) > 1e3)
            h[k] += t & 31;
    }
    return sum;
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = (int)((unsigned)t * 7919u % 5003u);
    for (int i = 0; i < 1024; i++)
        x[i] = (double)(i * 37 % 101) * 0.17 - 3;
    for (int again = 0; again < 20; again++) {
        an_update(N);
        a_store(N);
        printf("%.17g %.17g %.17g %d %.17g %.17g %.17g\n", a_sum(N), a_sum_of_a_copy(N),
               an_extremum(N), a_count(N), a_sum_by_address(N), a_sum_that_finds(N),
               a_condition_that_sums(N));
    }
    double all = 0;
    for (int t = 0; t < N; t++)
        all += own[t] * (t % 13);
    printf("%.17g\n", all);
    for (int i = 0; i < 1024; i++)
        printf("%d\n", h[i]);
    return 0;
}
