/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions that get an element's address, and do more than update it or update another element.
// covers: row 18, row 87 of docs/constructs.md
struct cell {
    double low, high;
    double row[3];
};
static double total;
static double *kept;

static void beyond(double *p, int i, double v) {
    p[i] += v;
    p[2 * i] = p[i] - v;
}
void by_subscript(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        beyond(h, k[t], 1.0);
}

static void add_to(double *p, double v) {
    *p += v;
}
static void pair(double *p, int i, int j, double v) {
    p[i] += v * p[j]; /* what other pairs update */
    p[j] -= v;
}
void by_pairs(int n, const double *x, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            pair(h, i, j, x[i] - x[j]);
}

static void pair_and_sum(double *p, int i, int j, double v, double *sum) {
    *sum += v;
    p[i] += v * *sum; /* what the pairs before have added up */
    p[j] -= v;
}
double by_pairs_and_sum(int n, const double *x, double *h) {
    double sum = 0.0;
    for (int i = 0; i < n; i++) // EXPECT: refuse callee-updates
        for (int j = i + 1; j < n; j++)
            pair_and_sum(h, i, j, x[i] - x[j], &sum);
    return sum;
}
void dense_by_call(int n, int m, const double *x, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++)
            add_to(&h[j], x[i]);
}

static void next_to(double *p, double v) {
    p[1] += v * p[0];
}
void neighbour(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        next_to(&h[k[t]], 1.0);
}

static void two(double *p, double *q, double v) {
    for (int c = 0; c < 2; c++)
        if (v < c)
            return; /* in a loop */
    *p += v;
    *q -= v;
}
void both_ends(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        two(&h[k[t]], &h[k[t + 1]], 1.0);
}

static int calls;
static void counted(double *p, double v) {
    *p += v * ++calls;
    total += v;
}
void with_global(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        counted(&h[k[t]], 1.0);
}

static void keeps(double *p, double v) {
    *p += v;
    kept = p;
}
void address_kept(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        keeps(&h[k[t]], 1.0);
}

static double add_and_tell(double *p, double v) {
    return *p += v;
}
double value_used(int n, const int *k, double *h) {
    double last = 0;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        last = add_and_tell(&h[k[t]], 1.0);
    return last;
}

static void add(double *p, double v) {
    *p += v;
}
void of_itself(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add(&h[k[t]], h[t]);
}

static void add_from(double *p, const double *q) {
    *p += *q;
}
void from_another_element(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_from(&h[k[t]], &h[t]);
}

static void add_row(double to[3], const double from[3]) {
    for (int c = 0; c < 3; c++)
        to[c] += from[c];
}
void linear_rows(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_row(&h[3 * k[t] + 1], h);
}

void row_of_member(int n, const int *k, struct cell *p) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_row(p[k[t]].row, p->row);
}

static void add_four(double to[4]) {
    for (int c = 0; c < 4; c++)
        to[c] += to[0];
}
void too_long(int n, const int *k, double (*h)[3]) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_four(h[k[t]]);
}

static void bytes(double *p) {
    *(int *)p += 1;
}
void punned(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        bytes(&h[k[t]]);
}

void side_effect(int n, const int *k, double *h) {
    int j = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        j = t;
        add(&h[k[j++]], 1.0);
        h[j] += 1.0;
    }
}

void in_expression(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        k[t] > 0 ? add(&h[k[t]], 1.0) : (void)0;
}

void by_pointer(int n, const int *k, double *h, void (*f)(double *, double)) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        f(&h[k[t]], 1.0);
}

static void add_deep(double *p, int depth) {
    if (depth > 0)
        add_deep(p, depth - 1);
    *p += 1.0;
}
void recursive(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_deep(&h[k[t]], t & 3);
}

void same_one(int n, const int *k, double *h, double *sum) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1.0;
        add(sum, h[0]);
    }
}

static void moved(double *p, double v) {
    p++;
    *p += v;
}
void moved_pointer(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        moved(&h[k[t]], 1.0);
}

/* ---- a function gets the address of a struct that holds the array ---- */

typedef struct matrix {
    int columns;
    double *value;
} matrix;
static matrix *last;

static void add_and_move(matrix *m, int row, double v) {
    m->value[row] += v;
    m->value++;
}
void member_changed(int n, const int *k, double *h) {
    matrix m = {3, h};
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_and_move(&m, k[t], 1.0);
}

static void add_and_keep(matrix *m, int row, double v) {
    m->value[row] += v;
    last = m;
}
void struct_kept(int n, const int *k, double *h) {
    matrix m = {3, h};
    for (int t = 0; t < n; t++) // EXPECT: nothing
        add_and_keep(&m, k[t], 1.0);
}

static void add_by_pointer(matrix *m, int row, double v) {
    int *columns = &m->columns;
    m->value[row * m->columns] += v;
    ++*columns;
}
void subscript_changed(int n, const int *k, double *h) {
    matrix m = {3, h};
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-updates
        add_by_pointer(&m, k[t], 1.0);
}

static int step(int *i) {
    return ++*i;
}
void counter_by_address(int n, const int *k, double *h) {
    int i = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse side-effect
        h[k[step(&i)]] += 1.0;
}
