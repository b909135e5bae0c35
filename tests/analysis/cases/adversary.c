/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops for which a verdict may easily be wrong. Covers rows 18, 29, 30, 45, 59 and 60 of docs/constructs.md. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

void index_through_pointer(int n, const int *s, double *h) {
    int k;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        int *p = &k;
        *p = s[i];
        h[k] += 1.0;
    }
}

void index_in_array_through_pointer(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        int idx[2] = {0, 0};
        int *p = idx;
        p[1] = s[i];
        h[idx[1]] += 1.0;
    }
}

static void get(const int *s, int i, int *k) {
    *k = s[i];
}

void index_by_callee(int n, const int *s, double *h) {
    int k;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        get(s, i, &k);
        h[k] += 1.0;
    }
}

static void load(const int (*tri)[3], int t, int *v) {
    for (int a = 0; a < 3; a++)
        v[a] = tri[t][a];
}

void indices_by_callee(int n, const int (*tri)[3], double *h) {
    int v[3];
    for (int t = 0; t < n; t++) { // EXPECT: transform h(+) privates=1
        load(tri, t, v);
        for (int a = 0; a < 3; a++)
            h[v[a]] += 1.0;
    }
}

static double add_and_count(double x, int *count) {
    ++*count;
    return x;
}

void effect_in_value(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        int count = 0;
        h[s[i]] += add_and_count(1.0, &count);
        h[s[i]] += count;
    }
}

void assigned_in_subscript(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse side-effect
        int k;
        h[k = s[i]] += 1.0;
        h[k] += 1.0;
    }
}

void same_array_two_names(int n, const int *s, double *a) {
    double *b = a + 12;
    for (int i = 0; i < n; i++) { // EXPECT: transform a(+) b(+)
        a[s[i]] += 1.0;
        b[s[i]] += 1.0;
    }
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        a[s[i]] += b[i];
}

void two_steps(int n, const int *s, double *a) {
    double *b = a, *c = b;
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        a[s[i]] += c[i];
}

void chosen(int n, const int *s, double *a, double *x) {
    double *c = n > 3 ? a : x;
    for (int i = 0; i < n; i++) // EXPECT: transform a(+) guards=1
        a[s[i]] += c[i];
}

void local_chosen(int n, const int *s, double *x) {
    double a[100] = {0};
    double *c = n > 3 ? a : x;
    for (int i = 0; i < n; i++) // EXPECT: transform a(+) guards=1
        a[s[i]] += c[i];
    x[0] = a[3];
}

static const double *pick(const double *p, int k) {
    if (k < 0)
        return p;
    return p + k;
}

void picked(int n, const int *s, double *x) {
    double a[100] = {0};
    const double *c = pick(a, 3);
    for (int i = 0; i < n; i++) // EXPECT: transform a(+) guards=1
        a[s[i]] += c[i];
    x[0] = a[3];
}

void picked_inside(int n, const int *s, double *x) {
    double a[100] = {0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse may-alias
        const double *c = pick(a, 3);
        a[s[i]] += c[i];
    }
    x[0] = a[3];
}

static double sum_of(const double *p, int k) {
    const double *q = k > 2 ? p : p + 1;
    return q[0];
}

void callee_unknown(int n, const int *s, double *x) {
    double a[100] = {0};
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        a[s[i]] += sum_of(a, i);
    x[0] = a[3];
}

struct node {
    int *count;
    int n;
};

void bound_in_reach(struct node *v, const int *s) {
    for (int i = 0; i < v->n; i++) // EXPECT: transform v->count(+) guards=2
        v->count[s[i]] += 1;
}

void bytes(int n, struct node *v, unsigned char *h, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=4
        h[s[i] + v->n] += (unsigned char)v->count[0];
}

void pointer_moves(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse base-varies
        h[s[i]] += 1.0;
        h++;
    }
}

void deref_forms(int n, const int *s, double *h, double (*g)[8]) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) g(+)
        *(h + s[i]) += 1.0;
        (*g)[s[i]] += 1.0;
    }
}

void private_read_by_next(int n, const int *s, double *h) {
    int idx[2] = {0, 0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        idx[i & 1] = s[i];
        h[idx[0]] += 1.0;
    }
}

void inner_carried(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        int k = 0;
        for (int c = 0; c < 3; c++) {
            h[k] += 1.0;
            k = s[i + c];
        }
    }
}

struct pair {
    int a, b;
};

void whole_copy(int n, const struct pair *p, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        struct pair q = p[i];
        h[q.a] += 1.0;
        h[q.b] -= 1.0;
    }
}

void cleared(int n, const struct pair *p, int *h) {
    int idx[2];
    for (int i = 0; i < n; i++) { // EXPECT: refuse callee-reads
        memcpy(idx, &p[i], sizeof idx);
        h[idx[0]] += 1;
    }
}

void freed(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse impure-call
        double *t = malloc(8);
        h[s[i]] += 1.0;
        free(t);
    }
}

void conditional_load(int n, int m, const int *s, const int *map, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        int k = 0;
        if (i < m)
            k = map[i];
        h[k] += 1.0;
    }
}

void dear_condition_protects_load(int n, const double *x, const int *map, double *restrict h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        if (exp(x[i]) < 3.0)
            h[map[i]] += 1.0;
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) verifiable
        if (x[i] * 2.0 < 3.0)
            h[map[i]] += 1.0;
}

void dear_continue_protects_load(int n, const double *x, const int *map, double *restrict h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        if (x[i] * 2.0 > 3.0)
            continue;
        int k = map[i];
        h[k] += 1.0;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        if (exp(x[i]) > 3.0)
            continue;
        int k = map[i];
        h[k] += 1.0;
    }
}

void dear_condition_is_left_out(int n, const double *x, const int *map, double *restrict h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable
        int k = map[i];
        if (x[i] * 2.0 < 3.0)
            h[k] += 1.0;
    }
}

static double table[100], tabled[100];
double *exported = table;

void exported_by_initialiser(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: transform table(+) guards=1
        table[s[i]] += exported[i];
    for (int i = 0; i < n; i++) // EXPECT: transform tabled(+) guards=1
        tabled[s[i]] += exported[i];
}

static void passed_table(int n, const int *s, const double *x) {
    static double passed[100];
    for (int i = 0; i < n; i++) // EXPECT: transform passed(+) guards=1
        passed[s[i]] += x[i];
    if (n > 4)
        passed_table(n - 1, s, passed);
}

void start_passing(int n, const int *s, const double *x) {
    passed_table(n, s, x);
}

int struct_member_index(int n, struct pair *p, double *h) {
    struct pair q = {0, 0};
    for (int i = 0; i < n; i++) { // EXPECT: refuse private-not-proved
        h[q.a] += 1.0;
        q.a = p[i].b;
    }
    return q.b;
}

void update_skipped_by_jump(int n, const int *s, int *h, int *last) {
    int k = 0;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        if (s[i] < 0)
            continue;
        k += s[i];
        h[k] += 1;
    }
    *last = k;
}

void conditional_operator_load(int n, int m, const int *s, const int *map, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) not-verifiable
        int k = i < m ? map[s[i]] : 0;
        h[k] += 1.0;
    }
}

void comma_definition(int n, const int *s, double *h) {
    int k;
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+)
        k = s[i], k++;
        h[k] += 1.0;
    }
}

static int short_table[4];

/* Conditions protect short_table[m] and a[5], so neither may be read before the loop. The plan's
 * keys are s and m in the first loop, and also a and a[0] in the second. */
void protected_elements(int n, int m, const int *s, const int *a, double *restrict h) {
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable keys=2
        int k = s[i];
        if (m < 4)
            k = short_table[m];
        h[k] += 1.0;
    }
    for (int i = 0; i < n; i++) { // EXPECT: transform h(+) verifiable keys=4
        int k = a[0];
        if (m > 5)
            k = a[5];
        h[k + s[i]] += 1.0;
    }
}

/* ---- a pointer to one member reaches the next: undefined in C, but programs do it -------------- */

struct point {
    double x, y, z;
};
static struct point points[64];

static double coordinate(const double *p, int k) {
    return p[k];
}
static double first_coordinate(const double *p) {
    return p[0] + *p;
}
static void add_to_three(double *p, double v) {
    p[0] += v;
    p[1] += v;
    p[2] += v;
}

void member_to_member_in_callee(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        points[s[i]].y += coordinate(&points[0].x, i);
}

void member_to_member(int n, const int *s) {
    const double *all = &points[0].x;
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        points[s[i]].y += *(all + 3 * i);
}

void member_to_member_of_parameter(int n, const int *s, struct point *q) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-reads
        q[s[i]].y += coordinate(&q->x, i);
}

void members_updated_in_callee(int n, const int *s, const double *w) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        add_to_three(&points[s[i]].x, w[i]);
}

void one_member(int n, const int *s) {
    for (int i = 0; i < n; i++) // EXPECT: transform points(+)
        points[s[i]].y += first_coordinate(&points[i].x);
}
