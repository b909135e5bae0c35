/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An iteration stores a value and reads it again, but the value read may not be the one stored.
// covers: row 31, row 59 of docs/constructs.md
#include <math.h>

typedef struct item {
    int k;
    double x;
    union {
        int whole;
        float part;
    } u;
} item;

void next_element(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        o[t] = key[t];
        h[o[t + 1]] += 1;
    }
}

void element_before(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 1; t < n; t++) { // EXPECT: refuse index-array-written
        o[t] = key[t];
        h[o[t]] += o[t - 1];
    }
}

void stored_sometimes(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        if (key[t] > 0)
            o[t] = key[t];
        h[o[t]] += 1;
    }
}

void stored_in_one_branch(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse index-array-written
        if (key[t] > 0) {
            o[t] = key[t];
        } else {
            h[o[t]] += 1;
        }
}

void stored_in_inner_loop(int n, int m, int *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        for (int k = 0; k < m; k++) {
            o[t] = k;
        }
        h[o[t]] += 1;
    }
}

void subscript_moves(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int k = s[t];
        o[k] = 1.5;
        k++;
        h[s[t]] += o[k];
    }
}

void subscript_moves_in_loop(int n, const int *s, double *restrict o, double *restrict h) {
    int k;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        k = s[t];
        o[k] = 1.5;
        for (; k < 3; k++)
            h[s[t]] += o[k];
    }
}

void subscript_loaded(int n, int *restrict s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        o[s[t]] = 1.5;
        h[s[t]] += o[s[t]];
    }
}

static int place;
void subscript_global(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse other-store
        o[t + place] = 1.5;
        h[s[t]] += o[t + place];
    }
}

void of_the_array(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        o[t] = h[t];
        h[s[t]] += o[t];
    }
}

void same_array(int n, const int *s, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        h[t] = 1;
        h[s[t]] += h[t];
    }
}

static int look(const int *p) {
    return *p;
}
static int look_at(const int *p, int t) {
    return p[t] + p[t - 1];
}
void by_address(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        o[t] = key[t];
        h[o[t]] += look(&o[t]);
    }
}
void by_array(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 1; t < n; t++) { // EXPECT: nothing
        o[t] = key[t];
        h[o[t]] += look_at(o, t);
    }
}

void address_compared(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        o[t] = key[t];
        h[o[t]] += &o[t] == o;
    }
}

void by_pointer(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int *p = &o[t];
        o[t] = key[t];
        h[*p] += 1;
    }
}

static int fixed[100];
void by_other_name(int n, const int *key, double *restrict h) {
    int *other = fixed;
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-array-written
        fixed[t] = key[t];
        h[other[t]] += fixed[t];
    }
}

void one_element(int n, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        fixed[3] = key[t];
        h[fixed[3]] += 1;
    }
}

void whole_structure(int n, const int *key, item *restrict p, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        item all;
        p[t].k = key[t];
        all = p[t];
        h[all.k] += p[t].k;
    }
}

void member_of_union(int n, const int *key, item *restrict p, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        p[t].u.whole = key[t];
        h[p[t].u.whole] += p[t].u.part;
    }
}

void jumped_over(int n, const int *key, int *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        switch (key[t] & 3) {
        case 0: {
            o[t] = key[t];
        case 1:
            h[o[t]] += 1;
        }
        }
}

void chained_store(int n, const int *key, int *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int k;
        k = o[t] = key[t];
        h[o[t]] += k;
    }
}

void watched(int n, const int *key, volatile int *o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse volatile
        o[t] = key[t];
        h[o[t]] += 1;
    }
}

void approximated(int n, const double *x, int *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse index-too-dear
        o[t] = (int)log(x[t]);
        h[o[t]] += 1;
    }
}

void by_pointers_of_rows(int n, int **o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        o[t][0] = key[t];
        h[o[t][0]] += 1;
    }
}
