/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The address of a scalar is a mark in a table. A thread with its own copy of the scalar would
 * compare with the copy's address. */
#include <stdio.h>
#include <string.h>

enum { N = 3000, ROWS = 32 };

static char deleted_everywhere;
char deleted_outside;
static double value_of(double v);
static int empty_place, *const empty = &empty_place;
static void *entry[N];
static double h[ROWS];
static int k[N];

static double value_of(double v) {
    return 0.1 * v;
}

__attribute__((const)) static int is_same(const void *a, const void *b) {
    return a == b;
}

static void static_local(int n) {
    static char deleted;
    for (int t = 0; t < n; t += 3)
        entry[t] = &deleted;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        if (entry[t] == &deleted)
            continue;
        h[k[t]] += value_of(t);
    }
}

static void file_scope(int n) {
    for (int t = 1; t < n; t += 3)
        entry[t] = t % 2 ? (void *)&deleted_everywhere : (void *)&deleted_outside;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        if (entry[t] != &deleted_everywhere && entry[t] != (void *)&deleted_outside)
            h[k[t]] += 0.3 * t;
}

static void local(int n) {
    int mark = 7;
    for (int t = 2; t < n; t += 3)
        entry[t] = &mark;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const void *const is_mark = &mark;
        double v = mark;
        if (entry[t] == is_mark)
            v = 1e-3;
        h[k[t]] += v;
    }
    for (int t = 2; t < n; t += 3)
        entry[t] = 0;
}

static void parameter(int n, long here) {
    for (int t = 0; t < n; t += 4)
        entry[t] = &here;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += is_same(entry[t], &here) ? 0.7 + (double)here : 0.9;
    for (int t = 0; t < n; t += 4)
        entry[t] = 0;
}

static void pointer_to_itself(int n) {
    void *self = &self;
    void **list = &self;
    for (int t = 0; t < n; t += 5)
        entry[t] = list;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += entry[t] == (void *)&self ? 1.1 : 1.3;
    for (int t = 0; t < n; t += 5)
        entry[t] = 0;
}

static void outer_scope(int n) {
    float bound = 3;
    {
        for (int t = 0; t < n; t += 7)
            entry[t] = &bound;
        {
            for (int t = 0; t < n; t++) { // EXPECT: parallel
                int is_bound = (char *)entry[t] - (char *)&bound == 0;
                h[(k[t] + is_bound) % ROWS] += bound;
            }
        }
    }
    for (int t = 0; t < n; t += 7)
        entry[t] = 0;
}

/* the subscript depends on the mark: the inspector compares as well */
static void in_the_subscript(int n) {
    static unsigned char sentinel;
    for (int t = 0; t < n; t += 6)
        entry[t] = &sentinel;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const int to = entry[t] == &sentinel ? 5 : k[t];
        h[to] += 0.1;
    }
}

/* the address of the pointer to the array, of which the generated code makes a copy */
static void base_pointer(int n, double *b) {
    for (int t = 0; t < n; t += 6)
        entry[t] = &b;
    for (int t = 0; t < n; t++) { // EXPECT: refuse
        if (entry[t] == &b)
            continue;
        b[k[t]] += 0.1;
    }
}

/* each thread has copies of the variables that iterations assign and of the counter, but not of a sum */
static void private_mark(int n) {
    int i = 0;
    for (int t = 0; t < n; t += 6)
        entry[t] = &i;
    for (int t = 0; t < n; t++) { // EXPECT: refuse escapes
        i = k[t];
        if (entry[t] != &i)
            h[i] += 0.2;
    }
}

static void counter_mark(int n) {
    int t;
    for (t = 0; t < n; t += 6)
        entry[t] = &t;
    for (t = 0; t < n; t++) // EXPECT: refuse
        if (entry[t] != &t)
            h[k[t]] += 0.2;
}

static void sum_mark(int n) {
    double sum = 0;
    for (int t = 0; t < n; t += 6)
        entry[t] = &sum;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        if (entry[t] == &sum)
            sum += 0.1;
        h[k[t]] += 0.2;
    }
    h[0] += sum;
    for (int t = 0; t < n; t += 6)
        entry[t] = 0;
}

static _Thread_local int own_mark;

static void thread_local_mark(int n) {
    for (int t = 0; t < n; t += 6)
        entry[t] = &own_mark;
    for (int t = 0; t < n; t++) // EXPECT: refuse
        if (entry[t] != &own_mark)
            h[k[t]] += 0.2;
}

struct shape {
    int rows, columns;
};

static void record(int n) {
    struct shape one = {2, 3};
    for (int t = 0; t < n; t += 3)
        entry[t] = &one.columns;
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += entry[t] == &one.columns ? one.rows : 0.25;
}

static void constant(int n) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += entry[t] == empty ? 0.1 : 0.2;
}

int main(void) {
    for (int t = 0; t < N; t++)
        k[t] = t * 7 % ROWS;
    static_local(N);
    file_scope(N);
    local(N);
    parameter(N, 3);
    pointer_to_itself(N);
    outer_scope(N);
    in_the_subscript(N);
    base_pointer(N, h);
    private_mark(N);
    counter_mark(N);
    sum_mark(N);
    thread_local_mark(N);
    record(N);
    constant(N);
    for (int i = 0; i < ROWS; i++)
        printf("%a\n", h[i]);
    return 0;
}
