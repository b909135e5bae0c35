/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Scalars that carry values from one iteration to another.
// covers: row 59, row 34, row 60, row 32 of docs/constructs.md
void previous(int n, const int *k, double *h, const double *v) {
    double last = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        h[k[t]] += last;
        last = v[t];
    }
}

void previous_under_condition(int n, const int *k, double *h, const double *v) {
    double d = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (v[t] > 0.0)
            d = v[t];
        h[k[t]] += d;
    }
}

void running_sum(int n, const int *k, double *h, const double *v) {
    double sum = 0.0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        sum += v[t];
        h[k[t]] += sum;
    }
}

void own_counter(int n, const int *k, double *h) {
    int j = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[j]] += 1.0;
        if (t % 3)
            j++;
    }
}

void walking_pointer(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[*k++] += 1.0 + *k;
}

void list_walk(int n, const int *next, double *h) {
    int at = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        h[at] += 1.0;
        at = next[at];
    }
}

void global_scalar(int n, const int *k, double *h);
int current;
void global_scalar(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        current = k[t];
        h[current] += 1.0;
    }
}

/* Numbers are assigned on first use: they depend on the order of the iterations. */
void numbered(int n, const int *k, int *number, double *h) {
    int next = 0;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        if (number[k[t]] < 0)
            number[k[t]] = next++;
        h[number[k[t]]] += 1.0;
    }
}

void address_kept(int n, const int *k, double *h, double **where) {
    double d = 0.0;
    *where = &d;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        d = 1.0;
        h[k[t]] += d;
    }
}

void random_state(int n, unsigned seed, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        seed = seed * 1664525u + 1013904223u;
        h[seed % 1000u] += 1.0;
    }
}

static int both(int of, int *p) {
    p[0] = of & 7;
    return of / 8;
}

/* `both` stores to `p`, which the next iteration reads. */
long filled_outside(int n, const int *k, double *restrict h) {
    long sum = 0;
    int p[1] = {0};
    for (int t = 0; t < n; t++) { // EXPECT: refuse private-not-proved
        h[k[t]] += p[0];
        sum += both(k[t], p);
    }
    return sum;
}

long filled_elsewhere(int n, const int *k, double *restrict h, int *p) {
    long sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse callee-updates
        h[k[t]] += 2.0;
        sum += both(k[t], p);
    }
    return sum;
}
