/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An attribute, a label or a macro just outside the loop changes its meaning.
// covers: row 3, row 4, row 17, row 45 of docs/constructs.md
struct interior {
    double none[0];
    double w[100];
};
struct nested {
    struct {
        int n;
        double rest[];
    } head;
    double w[100];
};

void array_without_length(int n, const int *k, struct interior *z) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        z->none[k[t]] += z->w[t];
}

void open_array_inside(int n, const int *k, struct nested *z) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        z->head.rest[k[t]] += z->w[t];
}

__attribute__((weak)) double replaceable(int t) {
    return t;
}

void other_definition(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        h[k[t]] += replaceable(t);
}

void led_into(int n, int from, const int *k, double *h) {
    int t = 0;
    switch (from) {
    case 0:
        for (t = 0; t < n; t++) { // EXPECT: refuse goto
            h[k[t]] += 1.0;
        case 1:
            h[k[t] + 1] += 2.0;
        }
    }
}

#define INDEPENDENT _Pragma("GCC ivdep")
void pragma_of_a_macro(int n, const int *k, double *h) {
    h[0] = 1;
    /* for (;;) */ INDEPENDENT
    for (int t = 0; t < n; t++) // EXPECT: refuse directive-in-range
        h[k[t]] += 1.0;
}
