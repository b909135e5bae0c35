/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Functions that return an element's address but have, or may have, other effects. */
// covers: row 92 of docs/constructs.md
#include <stddef.h>

static double *field;
static int calls, table[100];
static _Thread_local double own[100];
static double *volatile moving;

static double *counting(int k) {
    return &field[k + calls++];
}

static double *or_nothing(double *h, int k) {
    return k < 0 ? NULL : &h[k];
}

static double *of_its_own(int k) {
    static double values[100];
    return &values[k];
}

static double *of_the_thread(int k) {
    return &own[k];
}

static double *of_moving(int k) {
    return &moving[k];
}

static double *by_table(int k) {
    return &field[table[k]];
}

__attribute__((weak)) double *another(double *h, int k) {
    return &h[k];
}

static double *checked(double *h, int k) {
    if (k < 0)
        return h;
    return &h[k];
}

static void *anything(double *h, int k) {
    return &h[k];
}

static double *slot(double *h, int k) {
    return &h[k];
}

static double *in_rows(int size, double h[size][size], int i, int j) {
    return &h[i][j];
}

static double *in_field(int k) {
    return &field[k];
}

void counts_its_calls(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        *counting(s[i]) += 1.0;
}

void somewhere_or_nowhere(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *or_nothing(h, s[i]) += 1.0;
}

void hidden(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *of_its_own(s[i]) += 1.0;
}

void the_threads(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse thread-local
        *of_the_thread(s[i]) += 1.0;
}

void from_a_volatile(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        *of_moving(s[i]) += 1.0;
}

void written_table(int n, const int *s) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        table[s[i]] += 1;
        *by_table(i) += 1.0;
    }
}

void replaced(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse impure-call
        *another(h, s[i]) += 1.0;
}

void with_a_condition(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *checked(h, s[i]) += 1.0;
}

void of_another_type(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse type-punned
        *(double *)anything(h, s[i]) += 1.0;
}

void steps_on_the_way(int n, const int *s, double *h) {
    int next = 0;
    for (int i = 0; i < n; i++) // EXPECT: refuse side-effect
        *slot(h, s[next++]) += 1.0;
}

void another_of_its_name(int n, const int *s, const double *field) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *in_field(s[i]) += field[i];
}

void of_other_rows(int n, int wide, double h[wide][wide], const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *in_rows(wide, h, s[i], s[i] % wide) += 1.0;
}

struct later;
static double *in_later(struct later *l, int k);

void before_its_definition(int n, struct later *l, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse base-varies
        *in_later(l, s[i]) += 1.0;
}

struct later {
    double values[100];
};

static double *in_later(struct later *l, int k) {
    return &l->values[k];
}

void read_as_well(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        field[s[i]] += *in_field(i);
}

void moved_in_the_loop(int n, const int *s) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        *in_field(s[i]) += 1.0;
        field++;
    }
}

void by_two_ways(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        *slot(h, s[i]) += 1.0;
        h[i] = *slot(h, s[i + 1]);
    }
}
