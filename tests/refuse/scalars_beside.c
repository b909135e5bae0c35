/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Scalars updated in addition to an array, whose values the loop uses or may use.
// covers: row 59, row 60 of docs/constructs.md
#include <stdbool.h>

static double total;
static int filled;
static volatile int watched;

double read_in_contribution(int n, const int *k, double *h) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += k[t];
        h[k[t]] += sum;
    }
    return sum;
}

int read_in_subscript(int n, const int *k, double *h) {
    int count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (k[t] > 3)
            count++;
        h[count] += k[t];
        h[k[t]] += 1.0;
    }
    return count;
}

int read_in_condition(int n, const int *k, double *h) {
    int count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (k[t] > 0)
            count++;
        if (count < 100)
            h[k[t]] += 1.0;
    }
    return count;
}

int read_as_bound(int n, const int *k, double *h) {
    int count = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        for (int i = 0; i < count; i++)
            h[k[t]] += 1.0;
        if (k[t] > 0)
            count++;
    }
    return count;
}

double also_assigned(int n, const int *k, double *h) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (k[t] == 0)
            sum = 0;
        sum += 0.5;
        h[k[t]] += 1.0;
    }
    return sum;
}

double operand_has_it(int n, const int *k, double *h) {
    double sum = 1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += 0.5 * sum;
        h[k[t]] += 1.0;
    }
    return sum;
}

double subtracted_from(int n, const int *k, double *h) {
    double sum = 1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum = k[t] - sum;
        h[k[t]] += 1.0;
    }
    return sum;
}

double divided(int n, const int *k, double *h) {
    double x = 1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        x /= 1.5;
        h[k[t]] += 1.0;
    }
    return x;
}

int rounded(int n, const int *k, double *h) {
    int sum = 1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += 0.75;
        h[k[t]] += 1.0;
    }
    return sum;
}

long double extended(int n, const int *k, double *h) {
    long double sum = 1;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += 0.1L;
        h[k[t]] += 1.0;
    }
    return sum;
}

bool flag(int n, const int *k, double *h) {
    bool any = false;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        any |= k[t] > 7;
        h[k[t]] += 1.0;
    }
    return any;
}

double value_used(int n, const int *k, double *h) {
    double sum = 0, last = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        last = sum += 0.1;
        h[k[t]] += 1.0;
    }
    return last + sum;
}

static int used(void) {
    return filled;
}

void read_by_callee(int n, const int *k, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        filled++;
        h[k[t]] += used();
    }
}

void written_by_callee(int n, const int *k, double *h, void (*f)(int *)) {
    int count = 0;
    f(&count);
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        count++;
        f(&count);
        h[k[t]] += 1.0;
    }
}

double by_pointer(int n, const int *k, double *restrict h) {
    double sum = 0, *p = &sum;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += 0.1;
        h[k[t]] += *p;
    }
    return sum;
}

void of_volatile(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse volatile
        watched++;
        h[k[t]] += 1.0;
    }
}

static _Thread_local int mine;
void of_thread(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse thread-local
        mine++;
        h[k[t]] += 1.0;
    }
}

void static_inside(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        static int calls;
        calls++;
        h[k[t]] += 1.0;
    }
}

double greatest(int n, const int *k, const double *v, double *restrict h) {
    double most = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        if (most < v[t])
            most = 2 * v[t];
        h[k[t]] += 1.0;
    }
    return most;
}

double in_the_header(int n, const int *k, double *h) {
    double sum = 0;
    for (int t = 0; t < n; t++, sum += 1.0) // EXPECT: nothing
        h[k[t]] += 1.0;
    return sum;
}
