/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Which loop of a nest gets the verdict. Covers row 7 of docs/constructs.md. */
static void add(double *d, double v) {
    *d += v;
}

void repeated(int n, int times, const int *s, double *restrict h) {
    for (int r = 0; r < times; r++)
        for (int t = 0; t < n; t++) // EXPECT: transform h(+)
            h[s[t]] += r;
}

void repeated_by_call(int n, int times, const int *s, double *restrict h) {
    for (int r = 0; r < times; r++)
        for (int t = 0; t < n; t++) // EXPECT: transform h(+)
            add(&h[s[t]], r);
}

static double value_at(const double *x, int k) {
    return x[k] * x[k];
}
static void fill(const double *x, int k, double *v) {
    v[0] = x[k];
}
void repeated_reads_of_calls(int n, int times, const int *s, const double *x, double *restrict h) {
    for (int r = 0; r < times; r++)
        for (int t = 0; t < n; t++) // EXPECT: transform h(+)
            h[s[t]] += value_at(x, r);
    for (int r = 0; r < times; r++)
        for (int t = 0; t < n; t++) { // EXPECT: transform h(+)
            double v[1];
            fill(x, r, v);
            h[s[t]] += v[0];
        }
}

void few_around(int n, const int *s, double *restrict h) {
    for (int r = 0; r < 3; r++)
        for (int t = 0; t < n; t++) // EXPECT: transform h(+)
            h[s[t] + r] += 1.0;
}

void few_alone(const int *s, double *restrict h) {
    for (int r = 0; r < 8; r++) // EXPECT: transform h(+)
        h[s[r]] += 1.0;
}

void halves(int n, const int *s, double *restrict h) {
    for (int half = 0; half < 100; half++) // EXPECT: transform h(+)
        for (int t = 0; t < n; t++)
            if (s[t] % 100 == half)
                h[s[t]] += 1.0;
}

void by_callee_alone(int n, const int *s, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: transform h(+)
        add(&h[s[t]], 1.0);
}

void regular(int n, double *h) {
    for (int t = 0; t < n; t++)
        h[t] += 1.0;
    for (int t = 0; t < n; t++)
        for (int c = 0; c < 3; c++)
            h[3 * t + c] += 1.0;
    for (int t = 0, k = 0; t < n; t++) {
        h[k] += 1.0;
        k += 2;
    }
}

void inner_only(int n, const int *start, const int *col, double *restrict y) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-stored
        y[0] = i;
        for (int p = start[i]; p < start[i + 1]; p++) // EXPECT: transform y(+)
            y[col[p]] += 1.0;
    }
}

struct result {
    int at;
    double value[2];
};

void fields(int n, const int *s, const double *w, double *restrict h) {
    struct result r = {0, {0}};
    for (int t = 0; t < n; t++) { // EXPECT: transform h(+) verifiable
        r.at = s[t];
        r.value[0] = w[t] * 2.0;
        h[r.at] += r.value[0];
    }
}

void loaded_anyway(int n, const int *s, const double *x, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transform h(+) verifiable
        double d = x[s[t]] * 0.5;
        if (d < 1.0)
            continue;
        h[s[t]] += d;
    }
}

int scratch(int n, const int *s) {
    int last = 0, outside[4];
    for (int t = 0; t < n; t++) {
        int inside[4] = {0};
        inside[s[t] & 3]++;
        last = inside[0];
    }
    for (int t = 0; t < n; t++) {
        for (int c = 0; c < 4; c++)
            outside[c] = 0;
        outside[s[t] & 3]++;
        last = outside[0];
    }
    return last;
}

void volatile_start(int n, const int *s, double *h, volatile int *from) {
    for (int t = *from; t < n; t++) // EXPECT: refuse trip-count
        h[s[t]] += 1.0;
}

void segments(int n, const int *start, const double *x, double *restrict y) {
    for (int i = 0; i < n; i++)
        for (int p = start[i]; p < start[i + 1]; p++)
            y[p] *= x[i];
    for (int i = 0; i < n; i++) { // EXPECT: transform y(+) verifiable
        const int first = i * (i + 1) / 2;
        for (int p = first; p < first + i; p++)
            y[p] += x[i];
    }
}

void looked_up_segments(int n, const int *start, const int *row, double *restrict y) {
    for (int t = 0; t < n; t++) // EXPECT: transform y(+) verifiable
        for (int p = start[row[t]]; p < start[row[t] + 1]; p++)
            y[p] += 1.0;
}

/* Each counter's first value depends on the other counter: the search for dependences must end. */
void round_about(int n, const int *a, const int *b, double *restrict y) {
    int p = 0, q = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        for (p = a[q]; p < n; p++)
            y[p] += 1.0;
        for (q = b[p]; q < n; q++)
            y[q] += 1.0;
    }
}
