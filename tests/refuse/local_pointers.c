/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Local pointers that may point to another array, or whose element is read through another name.
// covers: row 44, row 45, row 48 of docs/constructs.md
struct cell {
    double x, sum;
    double *values;
    struct cell *next;
};

void one_of_two(int n, const int *k, double *a, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        double *h = t & 1 ? a : b;
        h[k[t]] += 1.0;
    }
}

void assigned_twice(int n, const int *k, double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double *row = b[k[t]];
        row[0] += 1.0;
        row = b[k[t] + 1];
        row[0] += 1.0;
    }
}

void of_the_iteration_before(int n, const int *k, double (*b)[3]) {
    double *row = b[0];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        row[1] += 1.0;
        row = b[k[t]];
    }
}

void set_at_times(int n, const int *k, double (*b)[3]) {
    double *row;
    row = b[0];
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (k[t] > 3)
            row = b[k[t]];
        row[1] += 1.0;
    }
}

void read_by_name(int n, const int *k, double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        double *row = b[k[t]];
        row[0] += b[t][1];
    }
}

void read_by_pointer(int n, const int *k, double (*b)[3]) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        double *row = b[k[t]], *other = b[t];
        row[0] += other[1];
    }
}

void read_after(int n, const int *k, struct cell *c, double *out) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        struct cell *p = &c[k[t]];
        p->sum += 1.0;
        out[t] = p->sum;
    }
}

void other_type(int n, const int *k, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse type-punned
        int *p = (int *)&b[k[t]];
        p[0] += 1;
    }
}

void address_kept(int n, const int *k, double (*b)[3], double **kept) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double *row = b[k[t]];
        *kept = row;
        row[0] += 1.0;
    }
}

double *given(double *b, int k);
void from_function(int n, const int *k, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double *p = given(b, k[t]);
        *p += 1.0;
    }
}

void address_of_pointer(int n, const int *k, double (*b)[3], void (*f)(double **)) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        double *row = b[k[t]];
        f(&row);
        row[0] += 1.0;
    }
}

struct mesh {
    struct cell *cells;
};

static int wrapped(int k) {
    while (k > 99)
        k -= 100;
    return k;
}

static int moving(struct mesh *m, int k) {
    m->cells++;
    return wrapped(k);
}

void base_set_in_the_loop(int n, const int *k, struct mesh *m, struct cell *other) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        struct cell *p = m->cells + wrapped(k[t]);
        p->sum += 1.0;
        if (k[t] > 200)
            m->cells = other;
    }
}

void base_set_by_the_call(int n, const int *k, struct mesh *m) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        struct cell *p = m->cells + moving(m, k[t]);
        p->sum += 1.0;
    }
}

void base_stepped(int n, const int *k, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        double *p = &b[wrapped(k[t])];
        *p += 1.0;
        b++;
    }
}

void read_by_distance(int n, const int *k, double *b) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        double *p = &b[wrapped(k[t])];
        *p += b[t];
    }
}

void chosen_with_a_cast(int n, const int *k, double *a, char *bytes, int flag) {
    double *h = flag ? (double *)bytes : a;
    for (int t = 0; t < n; t++) // EXPECT: refuse base-varies
        h[k[t]] += 1.0;
}

void chosen_and_read(int n, const int *k, double *a, double *b, int flag) {
    double *h = flag ? a : b;
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[k[t]] += h[t];
}

void chosen_again(int n, const int *k, double *a, double *b) {
    double *h = n > 9 ? a : b;
    for (int t = 0; t < n; t++) { // EXPECT: refuse base-varies
        h[k[t]] += 1.0;
        h = k[t] > 200 ? b : h;
    }
}
