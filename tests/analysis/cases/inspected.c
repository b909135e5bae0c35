/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Conditions under which a plan is kept, and computations that the inspector repeats. */

struct pair {
    int place, other;
};

struct table {
    const int *s;
};

extern void keep(int *p);
extern int *given(void);

void base_that_is_read_under_a_condition(int n, const int *z, const struct table *c, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) not-verifiable
        if (z[i])
            h[c->s[i]] += 1;
}

void base_as_a_value(int n, const int *s, double *q, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+,kept) keys=3
        h[s[i] + (q - h)] += 1;
}

void one_text_two_places(int n, const int *a, const int *b, const int *t, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) subscripts=4
        int k = a[i];
        h[t[k]] += 1;
        k = b[i];
        h[t[k]] += 1;
    }
}

static void add_first(double *e, const int *v) {
    *e += v[0];
}

void handed_to_the_update(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        int v[1];
        v[0] = s[i];
        add_first(&h[v[0]], v);
    }
}

void written_as_a_whole(int n, const struct pair *q, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) subscripts=1
        struct pair p;
        p = q[i];
        h[p.place] += 1;
    }
}

void other_field_written(int n, const struct pair *q, const double *w, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) subscripts=2
        struct pair p;
        p.place = q[i].place;
        p.other = q[i].other;
        h[p.place] += w[p.other];
    }
}

/* ---- along rows ---- */

void along_a_row(int n, int m, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) spans=1
        for (int c = 0; c < m; c++)
            h[s[i] * m + c] += w[c];
}

void along_a_row_unsigned(int n, unsigned m, const unsigned *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) spans=0
        for (unsigned c = 0; c < m; c++)
            h[s[i] * m + c] += w[c];
}

void along_a_row_by_two(int n, int m, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) spans=0
        for (int c = 0; c < m; c += 2)
            h[s[i] * m + c] += w[c];
}

void along_a_row_reading_elsewhere(int n, int m, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) spans=0 told=2
        for (int c = 0; c < m; c++)
            h[s[i] * m + c] += w[c * (m - c)];
}

/* ---- only some iterations read ---- */

void behind_a_continue(int n, const int *s, const int *z, const double *w, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) sometimes=1
        if (z[i])
            continue;
        h[s[i]] += w[i];
    }
}

void behind_and(int n, const int *s, const int *z, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) sometimes=1
        h[s[i]] += z[i] && w[i] > 0;
}

void in_a_branch_of_a_value(int n, const int *s, const int *z, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) sometimes=1
        h[s[i]] += z[i] ? w[i] : 1;
}

/* ---- functions ---- */

static int low_byte(const int *t, int i) {
    unsigned char c = i;
    return t[c];
}

static double narrow(const double *w, int i) {
    short c = i;
    return w[c];
}

void narrow_local_of_a_function(int n, const int *s, const double *w, const int *t, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 told=1
        h[s[i]] += narrow(w, i);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        h[low_byte(t, i)] += 1;
}

struct cursor {
    int k;
};

static double at(struct cursor *c, const double *w, int i) {
    c->k = i;
    return w[c->k];
}

void stored_on_the_way(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse callee-reads
        struct cursor c = {0};
        double v = at(&c, w, i);
        h[s[i]] += v;
    }
}

static int place_of(struct cursor *c, const int *t, int i) {
    c->k = i;
    return t[c->k];
}

void subscript_stored_on_the_way(int n, const int *t, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) not-verifiable
        struct cursor c = {0};
        int k = place_of(&c, t, i);
        h[k] += 1;
    }
}

static double unless(const double *w, const int *z, int i) {
    if (z[i])
        return 1;
    return w[i];
}

void behind_a_return(int n, const int *s, const int *z, const double *w, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) sometimes=1
        h[s[i]] += unless(w, z, i);
    }
}

static int offset;

static void add_behind(double *h, int k, double x) {
    h[k + offset] += x;
}

void element_by_a_global(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        add_behind(h, s[i], w[i]);
}

static int find(const double *v, int from, double x) {
    int k = from;
    while (v[k] < x)
        k++;
    return k;
}

static int find_below(const double *v, int from, double x) {
    int k = from;
    while (v[k] > x)
        k--;
    return k;
}

static int find_some(const double *v, int from, double x) {
    int k = from;
    while (k < 5 || v[k] < x)
        k++;
    return k;
}

void searches(int n, const double *v, const double *x, int *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        int k;
        k = find(v, 0, x[i]);
        h[k] += 1;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) not-verifiable
        int k;
        k = find_below(v, 9, x[i]);
        h[k] += 1;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) not-verifiable
        int k;
        k = find_some(v, 0, x[i]);
        h[k] += 1;
    }
}

static void both(double *a, double *b, double x) {
    *a += x;
    *b += x;
}

void written_by_two_parameters(int n, const int *s, const double *w, double *h, double *g) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        both(&h[s[i]], &g[s[i]], w[i]);
}

void escaped_scalar(int n, const int *s) {
    int a = 1;
    keep(&a);
    int *h = given();
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=2
        h[s[i]] += a;
}

void reads_its_element(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+,kept)
        h[s[i]] += h[s[i]] * 0.5;
}

struct two {
    double x, y;
};

void operators_on_two_fields(int n, const int *s, struct two *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) interleaved=h
        h[s[i]].x += 2;
        h[s[i]].y *= 2;
    }
}

void operators_on_the_second_field(int n, const int *s, struct two *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+,kept)
        h[s[i]].x += 2;
        h[s[i]].y += 2;
        h[s[i]].y *= 2;
    }
}

static void add_products(double *row, double x) {
    for (int a = 0; a < 4; a++) // EXPECT: transform row(+)
        for (int b = 0; b < 4; b++)
            row[a * b] += x;
}

void beyond_the_row(int n, const int *s, const double *w, double (*h)[8]) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        add_products(h[s[i]], w[i]);
}

void within_the_row(int n, const int *s, const double *w, double (*h)[10]) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        add_products(h[s[i]], w[i]);
}

void counter_moved_by_its_address(int n, const int *s, const int *z, const double *w, double *h) {
    double f[3] = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        int c;
        int *p = &c;
        for (c = 0; c < 3; c++) {
            f[c] = w[i];
            *p += z[i];
        }
        h[s[i]] += f[0] + f[1] + f[2];
    }
}

void volatile_records(int n, const volatile struct pair *q, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        h[q[i].place] += 1;
}

struct watched {
    volatile struct pair p;
    int plain;
};

void volatile_member(int n, const struct watched *q, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        h[q[i].p.place] += 1;
    for (int i = 0; i < n; i++) { // EXPECT: refuse volatile
        struct watched v = q[i];
        h[v.plain] += 1;
    }
}

struct open_first {
    double v[0];
    double w[64];
};

void open_array_updated(int n, const int *s, struct open_first *o) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        o->v[s[i]] += o->w[i];
}

struct open_last {
    double w[64];
    double v[];
};

void open_array_behind(int n, const int *s, struct open_last *o) {
    for (int i = 0; i < n; i++) // EXPECT: transform o->v(+) guards=0
        o->v[s[i]] += o->w[i];
}

void fields_of_bytes(int n, const int *s, const char *bytes, struct two *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]].x += ((const struct two *)(bytes + 8))[i].y;
}

void restrict_of_the_body(int n, const int *s, const double *w, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+,kept) guards=1
        double *restrict p = h;
        p[s[i]] += w[i];
    }
}

static int table[64];

static int looked_up(int k) {
    return table[k & 63];
}

void hidden_table(int n, const int *s, double *h) {
    int table[2] = {1, 2};
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) not-verifiable
        h[looked_up(s[i])] += table[i & 1];
}

void atomic_condition(int n, const int *s, const _Atomic int *z, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse volatile
        if (z[i])
            h[s[i]] += 1;
}

void while_that_continues(int n, const int *s, const int *z, double *h) {
    int t = 0;
    while (t < n) { // EXPECT: refuse trip-count
        if (z[t])
            continue;
        h[s[t]] += 1;
        t++;
    }
}
