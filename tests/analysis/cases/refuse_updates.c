/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reasons R1xx. Covers rows 24, 25, 28, 31, 32, 34 to 37, 39, 43, 44, 48 and 49 of docs/constructs.md. */
#include <math.h>
#include <stdbool.h>

void pointers(int n, const int *s, const char **h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse element-type
        h[s[i]]++;
}

void counting_sort(int n, const int *key, int *place, int *out) {
    for (int i = 0; i < n; i++) // EXPECT: refuse update-value-used
        out[place[key[i]]++] = key[i];
}

int value_used(int n, const int *s, int *h) {
    int x = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse update-value-used
        x = h[s[i]]++;
    }
    return x;
}

void in_condition(int n, const int *s, int *h) {
    int many = 0;
    for (int i = 0; i < n; i++) // EXPECT: refuse update-value-used
        if (++h[s[i]] > 3)
            many = 1;
    h[0] = many;
}

void in_expression(int n, const int *s, int *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 verifiable
        h[s[i]]++, h[s[i] + 1]++;
}

void in_increment(int n, const int *s, int *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse update-in-expression
        for (int k = 0; k < 3; k++, h[s[i]]++)
            ;
}

void read_too(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        h[s[i]] += h[i];
}

double read_after(int n, const int *s, double *h) {
    double m = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        h[s[i]] += 1.0;
        m = h[0];
    }
    return m;
}

void read_in_subscript(int n, const int *s, int *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        h[h[s[i]]] += 1;
}

void read_through_copy(int n, const int *s, double *h) {
    const double *q = h + 4;
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        h[s[i]] += q[i];
}

struct cell {
    double value;
    int count;
};

double whole_struct(int n, const int *s, struct cell *p) {
    double sum = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        struct cell q = p[i];
        p[s[i]].value += q.count;
    }
    return sum;
}

void base_varies(int n, const int *s, double *a, double *b) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        double *h = i & 1 ? a : b;
        h[s[i]] += 1.0;
    }
}

void rows(int n, const int *s, double *a, double *b) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse row-pointers
        double *row[2] = {a + i, b + i};
        row[s[i]][0] += 1.0;
    }
}

struct bits {
    unsigned a : 4, b : 4;
};

void bit_field(int n, const int *s, struct bits *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse bit-field
        h[s[i]].a += 1;
}

void place_of_maximum(int n, const int *s, const double *e, double *h, int *at) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        if (h[s[i]] < e[i]) {
            h[s[i]] = e[i];
            at[s[i]] = i;
        }
}

void maximum_read_again(int n, const int *s, const double *e, double *h, double *o) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        if (h[s[i]] < e[i])
            h[s[i]] = e[i];
        o[i] = h[s[i]];
    }
}

void maximum_at_times(int n, const int *s, const double *e, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        if (i > 0 && h[s[i - 1]] < e[i])
            h[s[i - 1]] = e[i];
}

int maximum_counted(int n, const int *s, const double *e, double *h) {
    int changes = 0;
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        if (h[s[i]] < e[i]) {
            h[s[i]] = e[i];
            changes++;
        }
    return changes;
}

void stored_and_used(int n, const int *s, double *h) {
    double x = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-stored
        x = h[i] = 0;
        h[s[i]] += 1.0;
    }
    h[0] = x;
}

void stored_in_subscript(int n, int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse side-effect
        h[s[i] = i / 2] += 1.0;
}

void stored_first(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-stored
        h[0] = i;
        h[s[i]] *= 2.0;
    }
}

void index_written(int n, int *s, const int *key, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse index-array-written
        s[i] = key[i] & 7;
        h[s[i + 1]] += 1.0;
    }
}

void lazily_filled(int n, const int *key, int *pos, double *h) {
    int next = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse index-array-written
        if (pos[key[i]] == -1)
            pos[key[i]] = i;
        h[pos[key[i]]] += 1.0;
    }
    (void)next;
}

void side_effect(int n, const int *s, double *h) {
    int j = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        j = s[i];
        h[s[i]] += j++;
    }
}

void side_effect_in_index(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        int j = s[i];
        h[s[j++]] += 1.0;
        h[s[j]] += 1.0;
    }
}

union both {
    double d;
    long l;
};

void in_union(int n, const int *s, union both *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse union
        h[s[i]].d += 1.0;
}

void too_dear(int n, const double *x, double *restrict h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[(int)sin(x[i] * 3.7)] += 1.0;
}
