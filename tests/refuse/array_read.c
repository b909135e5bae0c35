/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The loop reads or stores elements of the array that it also updates.
// covers: row 25, row 28, row 45, row 44, row 36 of docs/constructs.md
struct particle {
    double x, fx;
};

/* As in CG of the NAS Parallel Benchmarks: the element is tested after its update. */
void tested(int n, const int *k, double *h, int *marks) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        h[k[t]] += 1.0;
        if (h[k[t]] > 3.0)
            marks[k[t]] += 1;
    }
}

void other_element(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[k[t]] += h[k[t] + 1];
}

void in_subscript(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        h[h[k[t]]] += 1;
}

void in_condition(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        if (h[0] < 10.0)
            h[k[t]] += 1.0;
}

void as_bound(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++)
        for (int u = 0; u < h[t]; u++) // EXPECT: nothing
            h[k[u]] += 1;
}

void whole_record(int n, const int *k, struct particle *p) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        struct particle q = p[t];
        p[k[t]].fx += q.x;
    }
    p[0].x = sum;
}

void through_callee(int n, const int *k, double *h);
static double first_of(const double *v) {
    return v[0];
}
void through_callee(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse callee-reads
        h[k[t]] += first_of(h);
}

void bytes_of_it(int n, const int *k, double *h) {
    unsigned char *bytes = (unsigned char *)h;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += bytes[t];
}

/* Other members may be read (accept/binned_members.c), but not the updated member of another record. */
struct pulled {
    double at[2], pull[2];
};
void other_record(int n, struct pulled *b, double reach) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        for (int j = i + 1; j < n; j++)
            if (b[j].at[0] - b[i].at[0] < reach) {
                b[i].pull[0] += b[j].at[1];
                b[j].pull[0] -= b[j].pull[0] * 0.5 + b[i].pull[0];
            }
}

/* A whole record contains the updated member. */
void whole_pulled(int n, struct pulled *restrict b, const int *k) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        const struct pulled one = b[k[t + 1]];
        b[k[t]].pull[1] += one.at[0];
    }
}
