/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Sums that other accesses may read or write, or that are another object in each iteration. */
// covers: row 59 of docs/constructs.md
struct moments {
    double x, y;
    int n;
};
struct system {
    double energy, *force;
};
double use(const struct moments *);

double read_meanwhile(int n, const int *k, double *h, const double *v) {
    struct moments m = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        m.x += v[i];
        h[k[i]] += m.x;
    }
    return m.x;
}

double copied_meanwhile(int n, const int *k, double *h, const double *v) {
    struct moments m = {0}, last = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        m.x += v[i];
        last = m;
        h[k[i]] += 1;
    }
    return m.x + last.y;
}

double seen_by_a_call(int n, const int *restrict k, double *restrict h, const double *v) {
    struct moments m = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse impure-call
        m.x += v[i];
        h[k[i]] += use(&m);
    }
    return m.x;
}

/* `count` may overlap the subscripts, which are read before the loop. */
void perhaps_a_subscript(int n, const int *k, double *restrict h, int *count) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[k[i]] += 1;
        *count += 2;
    }
}

/* Each iteration's store to `to[1]` may overwrite `*sum`. */
void perhaps_stored(int n, const int *k, double *restrict h, double *o, double *sum) {
    double own[2];
    double *to = n > 5 ? own : o;
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        h[k[i]] += to[1];
        to[1] = *sum;
        *sum += 2;
    }
}

/* The sum is read under another name. */
void certainly_read(int n, const int *k, double *restrict h, struct system *s) {
    double *const e = &s->energy;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[k[i]] += s->energy;
        *e += 2;
    }
}

void the_pointer_moves(int n, const int *restrict k, double *restrict h, double *restrict sum) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        h[k[i]] += 1;
        *sum += 2;
        if (k[i] > 7)
            sum++;
    }
}

double the_subscript_moves(int n, const int *restrict k, double *restrict h) {
    double sum[4] = {0};
    int j = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[k[i]] += 1;
        sum[j] += 2;
        j = k[i] & 3;
    }
    return sum[0] + sum[3];
}

double two_operators(int n, const int *restrict k, double *restrict h) {
    struct moments m = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        h[k[i]] += 1;
        m.x = 2 - m.x;
    }
    return m.x;
}

double an_element_by_two_names(int n, const int *restrict k, double *restrict h) {
    double sum[4] = {0}, *first = sum;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[k[i]] += 1;
        sum[0] += 2;
        *first *= 0.5;
    }
    return sum[0];
}
