/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Uses of a restrict pointer's value, and constant objects: loops with a guard or without one.
 * Covers rows 17, 29 and 54 of docs/constructs.md. */
#include <string.h>

double *kept;
long kept_number;
struct holder {
    const double *pointer;
} kept_holder;
void unknown(const void *);

static double element(const double *p, int i) {
    return p[i];
}

static double difference(const double (*p)[3], int i, int j) {
    double d = 0;
    for (int c = 0; c < 3; c++)
        d += p[i][c] - p[j][c];
    return d;
}

static double walk(const double *p, int i) {
    while (i--)
        p++;
    return *p;
}

static double through_two(const double (*p)[3], int i) {
    return element(p[i], 1) + difference(p, i, 0);
}

void passed_on(int n, const int *s, const double *restrict x, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += element(x, i);
}

void rows_passed_on(int n, const int (*s)[2], const double (*restrict x)[3], double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i][0]] += difference(x, s[i][0], s[i][1]);
}

void passed_twice(int n, const int *s, const double (*restrict x)[3], double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += through_two(x, s[i]);
}

void used_before(int n, const int *s, const double *restrict x, double *h) {
    double start = walk(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += start * x[i];
}

/* The second parameter `q` does not get the restrict pointer. */
static double both(const double *p, const double *q, int i) {
    return p[i] + q[i];
}

void one_of_two(int n, const int *s, const double *restrict x, const double *y, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 verifiable
        h[s[i]] += both(x, y, i);
}

void not_restrict(int n, const int *s, const double *x, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 verifiable
        h[s[i]] += element(x, i);
}

/* ---- a callee stores the pointer: another pointer may then legally lead to the array ---------- */

static void keep(double *p) {
    kept = p;
}
static void keep_number(double *p, int i) {
    kept_number = (long)p + i;
}
static void keep_part(double *p, int i) {
    kept_holder.pointer = &p[i];
}
static double *hand_back(double *p, int i) {
    return p + i;
}
static void keep_in_struct(double *p) {
    struct holder h;
    h.pointer = p;
    kept_holder = h;
}
static void keep_by_address(double *p) {
    double **q = &p;
    kept = *q;
}
static void keep_by_copy(double *p) {
    double *q;
    memcpy(&q, &p, sizeof q);
    kept = q;
}
static void keep_bytes(double *p) {
    const unsigned char *byte = (const unsigned char *)&p;
    long number = 0;
    for (int k = 0; k < 8; k++)
        number |= (long)byte[k] << (8 * k);
    kept_number = number;
}
static void keep_moved(double *p, int i) {
    while (i--)
        p++;
    kept = p;
}
static void keep_in_array(double *p, int i) {
    double *a[2];
    a[0] = p;
    a[1] = p;
    kept = a[i & 1];
}
static void keep_by_choice(double *p, int i) {
    kept = i ? p : 0;
}
static void keep_by_comma(double *p, int i) {
    kept = (i, p);
}
static void keep_in_static(double *p) {
    static double *there;
    there = p;
    (void)there;
}
static void keep_below(double *p, int i) {
    if (i)
        keep(p);
}

void kept_(int n, const int *s, double *restrict x, double *h) {
    keep(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_number_(int n, const int *s, double *restrict x, double *h) {
    keep_number(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_part(int n, const int *s, double *restrict x, double *h) {
    keep_part(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void handed_back(int n, const int *s, double *restrict x, double *h) {
    kept = hand_back(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_in_struct(int n, const int *s, double *restrict x, double *h) {
    keep_in_struct(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_by_address(int n, const int *s, double *restrict x, double *h) {
    keep_by_address(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_by_copy(int n, const int *s, double *restrict x, double *h) {
    keep_by_copy(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_bytes(int n, const int *s, double *restrict x, double *h) {
    keep_bytes(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_moved(int n, const int *s, double *restrict x, double *h) {
    keep_moved(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_in_array(int n, const int *s, double *restrict x, double *h) {
    keep_in_array(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_by_choice(int n, const int *s, double *restrict x, double *h) {
    keep_by_choice(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_by_comma(int n, const int *s, double *restrict x, double *h) {
    keep_by_comma(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_in_static(int n, const int *s, double *restrict x, double *h) {
    keep_in_static(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_below(int n, const int *s, double *restrict x, double *h) {
    keep_below(x, n);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

void kept_by_the_unknown(int n, const int *s, double *restrict x, double *h) {
    unknown(x);
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1
        h[s[i]] += x[i];
}

/* ---- objects defined const ------------------------------------------------------------------- */

static const double weight = 0.5;
static const double weights[4] = {1, 2, 3, 4};
static double changing = 0.5;
static const double *const pointer_to_it = &changing;
static const struct {
    double factor;
} settings = {2};

void constant_scalar(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += weight;
}

void constant_array(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += weights[i & 3];
}

void constant_struct(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=0 verifiable
        h[s[i]] += settings.factor;
}

void constant_pointer(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+) guards=1 verifiable
        h[s[i]] += *pointer_to_it;
}
