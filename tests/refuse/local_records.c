/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Arrays in a local record that the loop also reads, or members that are no arrays. */
// covers: row 45 of docs/constructs.md
// covers: row 46 of docs/constructs.md
struct table {
    double own[64], other[64];
    int n;
};
union both {
    double own[64];
    long bits[64];
};
double use(const void *);

double another_element(int n, const int *k, const double *x) {
    struct table t = {.n = 1};
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        t.own[k[i]] += x[i] * t.own[k[i] + 1];
    return use(&t);
}

double all_of_it(int n, const int *k, const double *x) {
    struct table t = {.n = 1}, before = t;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        t.own[k[i]] += x[i];
        before = t;
    }
    return use(&t) + use(&before);
}

double by_a_pointer(int n, const int *k, const double *x) {
    struct table t = {.n = 1};
    const double *p = t.own;
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        t.own[k[i]] += x[i] * p[i];
    return use(&t);
}

double in_a_union(int n, const int *k, const double *x) {
    union both t = {{0}};
    for (int i = 0; i < n; i++) // EXPECT: refuse union
        t.own[k[i]] += x[i];
    return use(&t);
}

double as_a_whole(int n, const int *k, const double *x) {
    struct table t = {.n = 1}, u = t;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        u.own[k[i]] += x[i];
        t.n += k[i];
    }
    return use(&t) + use(&u);
}
