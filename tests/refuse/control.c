/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops whose trip count is unknown before they begin, or that end early.
// covers: row 4, row 5, row 7, row 8, row 10 of docs/constructs.md
#include <float.h>
#include <limits.h>
#include <stdlib.h>

int next(int);

void broken_off(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse break
        if (next(t) < 0)
            break;
        h[k[t]] += 1.0;
    }
}

int returned(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse return
        if (next(t) < 0)
            return t;
        h[k[t]] += 1.0;
    }
    return n;
}

void jumped_out(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse goto
        if (next(t) < 0)
            goto out;
        h[k[t]] += 1.0;
    }
out:
    h[0] = 0.0;
}

void label_inside(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse goto
        int again = k[t] & 1;
    repeat:
        h[k[t]] += 1.0;
        if (again--)
            goto repeat;
    }
}

void jumped_into(int n, const int *k, double *h) {
    int t = 0;
    if (n > 10)
        goto middle;
    for (t = 0; t < n; t++) { // EXPECT: refuse goto
    middle:
        h[k[t]] += 1.0;
    }
}

void counter_changed(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse counter-modified
        h[k[t]] += 1.0;
        if (k[t] == 5)
            t++;
    }
}

void counter_passed(int n, const int *k, double *h) {
    int t, *p = &t;
    for (t = 0; t < n; t++) { // EXPECT: refuse counter-modified
        h[k[t]] += 1.0;
        *p += k[t] & 1;
    }
}

void bound_changed(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse bound-varies
        h[k[t]] += 1.0;
        if (k[t] == 7)
            n--;
    }
}

void step_from_memory(int n, const int *step, const int *k, double *h) {
    for (int t = 0; t < n; t += step[t]) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void doubled(int n, const int *k, double *h) {
    for (int t = 1; t < n; t *= 2) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void wrong_way(unsigned n, const int *k, double *h) {
    for (unsigned t = n; t >= 0; t--) { // EXPECT: nothing
        h[k[t]] += 1.0;
        if (t == 0)
            abort();
    }
}

void unequal_by_two(int n, const int *k, double *h) {
    for (int t = 0; t != n; t += 2) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void floating_counter(const int *k, double *h) {
    int t = 0;
    for (float x = 0.0f; x < 100.0f; x += 0.5f) // EXPECT: nothing
        h[k[t++]] += x;
}

void sentinel(const int *k, double *h) {
    for (int t = 0; k[t] >= 0; t++) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void list(const int *next, const int *k, double *h) {
    for (int at = 0; at >= 0; at = next[at]) // EXPECT: nothing
        h[k[at]] += 1.0;
}

void two_conditions(int n, const int *k, double *h) {
    for (int t = 0; t < n && k[t] >= 0; t++) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void endless(const int *k, double *h) {
    for (int t = 0;; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        if (k[t] == 0)
            exit(0);
    }
}

void ended(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (next(t) < 0)
            exit(1);
        h[k[t]] += 1.0;
    }
}

void with_do(int n, const int *k, double *h) {
    int t = 0;
    do // EXPECT: nothing
        h[k[t]] += 1.0;
    while (++t < n && k[t] > 0);
}

int global_t;
void global_counter(int n, const int *k, double *h) {
    for (global_t = 0; global_t < n; global_t++) // EXPECT: refuse counter-type
        h[k[global_t]] += 1.0;
}

void while_increment_skipped(int n, const int *k, double *h) {
    int t = 0;
    while (t < n) { // EXPECT: nothing
        if (k[t] == 3 && n-- > 0)
            continue;
        h[k[t]] += 1.0;
        t++;
    }
}

int length_of(const int *k);

void declared_and_stepped(int n, const int *k, double *h) {
    for (int t = 0, last = n - 1; t <= last; t++, last--) // EXPECT: refuse trip-count
        h[k[t]] += last;
}

void declared_and_changed(int n, const int *k, double *h) {
    for (int t = 0, last = n - 1; t <= last; t++) { // EXPECT: refuse trip-count
        h[k[t]] += 1.0;
        last -= k[t] & 1;
    }
}

void declared_by_call(const int *k, double *h) {
    for (int t = 0, last = length_of(k); t < last; t++) // EXPECT: refuse trip-count
        h[k[t]] += 1.0;
}

void declared_by_each_other(int n, const int *k, double *h) {
    for (int t = 0, last = t + n; t < last; t++) // EXPECT: refuse trip-count
        h[k[t]] += 1.0;
}

void declared_narrower(long n, const int *k, double *h) {
    for (int t = 0, last = n; t < last; t++) // EXPECT: refuse trip-count
        h[k[t]] += 1.0;
}

void declared_volatile(int n, const int *k, double *h) {
    for (volatile int last = n, t = 0; t < last; t++) // EXPECT: nothing
        h[k[t]] += 1.0;
}

void declared_without_value(int n, const int *k, double *h) {
    for (int t = 0, last; t < last; t++) // EXPECT: refuse trip-count
        h[k[t]] += n;
}

void declared_with_effect(int n, const int *k, double *h) {
    for (int t = 0, before = n--; t < n; t++) // EXPECT: refuse trip-count
        h[k[t]] += 1.0;
}
