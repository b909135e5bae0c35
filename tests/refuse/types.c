/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Objects whose accesses do more than read or write, and types without accepted updates.
// covers: row 12, row 13, row 42, row 43, row 44, row 48, row 49 of docs/constructs.md
struct flags {
    unsigned low : 4, high : 4;
};

union number {
    double d;
    unsigned long long bits;
};

void bit_fields(int n, const int *k, struct flags *f) {
    for (int t = 0; t < n; t++) // EXPECT: refuse bit-field
        f[k[t]].low += 1;
}

void bit_fields_or(int n, const int *k, struct flags *f) {
    for (int t = 0; t < n; t++) // EXPECT: refuse bit-field
        f[k[t]].high |= 2;
}

void unions(int n, const int *k, union number *u) {
    for (int t = 0; t < n; t++) // EXPECT: refuse union
        u[k[t]].d += 1.0;
}

void volatile_array(int n, const int *k, volatile double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        h[k[t]] += 1.0;
}

void volatile_subscripts(int n, const volatile int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        h[k[t]] += 1.0;
}

void atomic_array(int n, const int *k, _Atomic int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        h[k[t]] += 1;
}

void volatile_scalar(int n, const int *k, double *h) {
    volatile double v = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse volatile
        v = 1.0;
        h[k[t]] += v;
    }
}

static _Thread_local double own[100];
static _Thread_local int chosen;

void thread_local_array(int n, const int *k) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-local
        own[k[t]] += 1.0;
}

void thread_local_scalar(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += chosen;
}

typedef double four __attribute__((vector_size(32)));
void vectors(int n, const int *k, four *h, four v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse element-type
        h[k[t]] += v;
}

void wide_integers(int n, const int *k, __int128 *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse element-type
        h[k[t]] += t;
}

void pointers(int n, const int *k, char **h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse element-type
        h[k[t]] += 1;
}

void base_moves(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        h[k[t]] += 1.0;
        h += t & 1;
    }
}

void base_chosen(int n, const int *k, double *a, double *b) {
    double *h = a;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        h = k[t] & 1 ? a : b;
    }
}

struct watched {
    volatile int state;
    int weight;
};

void copied_with_volatile_member(int n, const int *k, const struct watched *w, int *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse volatile
        struct watched copy = w[t];
        h[k[t]] += copy.weight;
    }
}
