/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads that may overlap the array. In each loop one fact seems to exclude the overlap. */

struct one {
    double x;
};

void a_record_that_begins_with_the_type(int n, const int *s, const struct one *r, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) guards=1
        struct one v = r[i];
        h[s[i]] += v.x;
    }
}

union both {
    double d;
    long l;
};

void a_member_of_a_union(int n, const int *s, const union both *u, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += (double)u[i].l;
}

void restrict_that_is_assigned(int n, int m, const int *s, const double *w, double *restrict h,
                               double *g) {
    if (m)
        h = g;
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += w[i];
}

void restrict_that_is_not(int n, const int *s, const double *w, double *restrict h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0
        h[s[i]] += w[i];
}

/* ---- rows: the addresses of the first and last iteration do not bound the others ---- */

void rows_of_anywhere(int n, const int *s, double *const *rows, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=1
        h[s[i]] += rows[i][0];
}

void a_square(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=1
        h[s[i]] += w[(i - 8) * (i - 8)];
}

void a_row(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=0 checked=0
        h[s[i]] += w[3 * i];
}

void an_unsigned_difference(unsigned n, const int *s, const double *w, double *h) {
    for (unsigned i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=0 checked=1
        h[s[i]] += w[i + 5];
}

void a_narrow_conversion(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=1
        h[s[i]] += w[(unsigned char)i];
}

/* ---- local objects ---- */

void a_scalar_that_a_pointer_leads_to(int n, const int *s, int *const *p, int *h) {
    int a = 1;
    p[0] == &a ? (void)h : (void)s;
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[s[i]] += a;
}
