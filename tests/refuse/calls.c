/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Calls of functions that do more than compute a value.
// covers: row 14, row 15, row 16, row 17, row 18, row 19, row 57 of docs/constructs.md
#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double somewhere_else(int t);
int global_state;

void unknown(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += somewhere_else(t);
}

void printing(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        h[k[t]] += 1.0;
        printf("%d\n", k[t]);
    }
}

void random_numbers(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[rand() % 100] += 1.0;
}

void allocating(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        double *p = malloc(sizeof *p);
        *p = 1.0;
        h[k[t]] += *p;
        free(p);
    }
}

void through_pointer(int n, const int *k, double *h, double (*f)(int)) {
    for (int t = 0; t < n; t++) // EXPECT: refuse function-pointer
        h[k[t]] += f(t);
}

static int ticket(void) {
    static int next;
    return next++;
}

void static_inside(int n, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[ticket() % 10] += 1.0;
}

static void note(int v) {
    global_state = v;
}

void writes_global(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        note(k[t]);
        h[k[t]] += 1.0;
    }
}

static double deep(int v) {
    return v <= 0 ? 1.0 : deep(v - 1) + deep(v - 2);
}

void recursive(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse recursion
        h[k[t]] += deep(k[t]);
}

static double odd(int v);
static double even(int v) {
    return v <= 0 ? 1.0 : odd(v - 1);
}
static double odd(int v) {
    return v <= 0 ? 0.0 : even(v - 1);
}

void mutually_recursive(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse recursion
        h[k[t]] += odd(k[t]);
}

static double add_and_tell(double *target, double v) {
    return *target += v;
}

void value_of_callee_update(int n, const int *k, double *h, double *seen) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        seen[t] = add_and_tell(&h[k[t]], 1.0);
    }
}

double errno_reader(int n, const int *k, double *h, const double *v) {
    errno = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse errno
        h[k[t]] += sqrt(v[t]);
    return errno == EDOM ? -1.0 : 0.0;
}

static jmp_buf back;
void jumps_back(int n, const int *k, double *h) {
    if (setjmp(back))
        return;
    for (int t = 0; t < n; t++) // EXPECT: refuse setjmp
        h[k[t]] += 1.0;
}

static int looked;
static void leave(int v) {
    looked++;
    if (v < 0)
        exit(2);
}

void callee_exits(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse no-return
        leave(k[t]);
        h[k[t]] += 1.0;
    }
}

void copies(int n, const int *k, double *h, double *target, const double *from) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        memcpy(target, from + t, sizeof *target);
    }
}

void tokens(int n, char *text, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[strtok(text, ",") ? 1 : t * t] += 1.0;
}
