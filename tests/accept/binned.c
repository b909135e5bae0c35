// Forms of updates that binning can defer as records, and loops that have no binned form.
// INTEGERS: no
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { N = 4000, M = 300 };
static int k[N + 1], j[N];
static double value[N], h[M + 1];
static float sums[M];
static long counts[M];
static unsigned char small[M];
static struct row {
    double x[3];
    float y;
} rows[M];

static void counted(int n, const int *restrict at, long *restrict c, unsigned char *restrict s) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        c[at[t]]++;
        s[at[t]] ^= (unsigned char)t;
    }
} // BINNED: 19

static void added(int n, const int *at, const double *w, double *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        to[at[t]] += w[t] * 0.3;
        to[at[t + 1]] -= w[t];
    }
} // BINNED: 26

static void conditional(int n, const int *at, const double *restrict w, double *restrict to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0)
            to[at[t]] += w[t];
} // BINNED: 33

static void functions_of(int n, const int *restrict at, const double *restrict w, double c,
                         double *restrict to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] = to[at[t]] * c + w[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] = w[t] - to[at[t]];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] < to[at[t]])
            to[at[t]] = w[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] = fmax(to[at[t]], w[t] - 90);
} // BINNED: 40 42 44 47

static void rounded(int n, const int *restrict at, const double *restrict w, float *restrict to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += w[t];
} // BINNED: 52

static void in_rows(int n, const int *restrict at, const double *restrict w, struct row *restrict r) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        for (int c = 0; c < 3; c++)
            r[at[t]].x[c] += w[t] * (c + 1);
} // BINNED: 57

// During a round of binning `w` may lack pending updates. Here it decides where to read, or whether to read.
static void stale_condition(int n, const int *at, const int *deep, const double *w, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (w[t] > 0)
            to[at[t]] += w[deep[t]];
} // NOT-BINNED: 64

static void stale_divisor(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[at[t]] += t / w[t];
} // CHECKED: 70

static void stale_bound(int n, const int *at, const long *w, long *to) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        long sum = 0;
        for (long i = 0; i < w[t]; i++)
            sum += i;
        to[at[t]] += sum;
    }
} // CHECKED: 75

static void show(const char *what, const void *bytes, size_t size) {
    unsigned long hash = 5381;
    for (size_t i = 0; i < size; i++)
        hash = hash * 33 + ((const unsigned char *)bytes)[i];
    printf("%s %lx\n", what, hash);
}

int main(void) {
    static long divisors[N], totals[M];
    unsigned state = 7;
    for (int t = 0; t < N; t++) {
        state = state * 1664525u + 1013904223u;
        k[t] = (int)((state >> 8) % M);
        j[t] = (int)((state >> 10) % N);
        value[t] = ((int)(state >> 9) % 1001 - 300) * 0.37;
        divisors[t] = 1 + (long)(state >> 20) % 9;
    }
    value[5] = -0.0;
    for (int i = 0; i < 3; i++) {
        counted(N, k, counts, small);
        added(M / 2, k, h + M / 2, h); /* The arrays overlap: the original loop runs. */
        added(N - 1, k, value, h);
        conditional(N, k, value, h);
        functions_of(N, k, value, 0.7, h);
        rounded(N, k, value, sums);
        in_rows(N, k, value, rows);
        stale_condition(N, k, j, value, h);
        stale_divisor(N, k, divisors, totals);
        stale_bound(N, k, divisors, totals);
    }
    show("counts", counts, sizeof counts);
    show("small", small, sizeof small);
    show("h", h, sizeof h);
    show("sums", sums, sizeof sums);
    show("rows", rows, sizeof rows);
    show("totals", totals, sizeof totals);
}
