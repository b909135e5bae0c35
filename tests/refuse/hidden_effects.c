/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Side effects inside types, and attributes in unusual spellings.
// covers: row 58, row 61, row 63 of docs/constructs.md
// FLAGS: -std=gnu2x -w
static int calls;

static void count(int *p) {
    calls += *p;
}

int length_in_typedef(int n, const int *k, double *h) {
    int m = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        typedef char row[m++ + 1];
        h[k[t]] += 1.0;
    }
    return m;
}

static int length_of_parameter(int t, int (*a)[calls++]) {
    return t + (a != 0);
}
int in_parameter(int n, const int *k, double *h, int (*a)[4]) {
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        h[k[t]] += length_of_parameter(t, (void *)a);
    return calls;
}

int length_behind_function(int n, const int *k, double *h) {
    int m = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        int (*(*f)(void))[m++] = 0;
        h[k[t]] += f == 0;
    }
    return m;
}

int chosen_by_a_type(int n, const int *k, double *h) {
    int m = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse opaque
        h[k[t]] += _Generic(int, int : m++, char : 1);
    return m;
}

#define JOIN(a, b) a##b
void joined(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        int z __attribute__((JOIN(clean, up)(count))) = k[t];
        h[z] += 1.0;
    }
}

void spliced(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        int z __attribute__((clean\
up(count))) = k[t];
        h[z] += 1.0;
    }
}

void of_a_namespace(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        [[gnu::cleanup(count)]] int z = k[t];
        h[z] += 1.0;
    }
}

__attribute__((JOIN(we, ak))) double replaceable(int t) {
    return t;
}
void other_definition(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += replaceable(t);
}

#pragma weak replaced
double replaced(int t) {
    return t;
}
void weak_by_pragma(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += replaced(t);
}
