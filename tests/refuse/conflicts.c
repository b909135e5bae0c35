/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ from those of accept/conflicts.c in one point and depend on their order, dense
// nests, and loops whose iterations update disjoint elements.
// covers: row 95 of docs/constructs.md
enum { N = 4000, ROOM = 8 };
typedef struct atom {
    double f[3], q;
    struct atom *head;
} atom;
struct bond {
    atom *a, *b;
    double k;
};
extern int s[N], count[N];
extern double e[N], h[N], force[N], r[N];

/* ---- loaded pointers ---- */

void same_end_is_read(int n, const struct bond *bond) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        bond[t].a->f[0] += e[t];
        bond[t].a->f[1] += bond[t].a->f[0];
    }
}

void pointer_moves(int n, double **where) {
    for (int t = 0; t < n - 1; t++) { // EXPECT: refuse other-store
        where[t + 1] = where[t] + s[t];
        *where[t] += e[t];
    }
}

void head_changes(int n, atom *const *leaf) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        leaf[t]->head->q += 0.5;
        leaf[t]->head = leaf[s[t]];
    }
}

void value_is_used(int n, double **where, double *out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse update-value-used
        out[t] = *where[t] += e[t];
}

void by_walking_pointer(int n, atom *const *of) {
    for (atom *const *p = of, *const *end = of + n; p < end; p++) // EXPECT: refuse base-varies
        (*p)->q -= 0.25;
}

/* ---- windows ---- */

void window_by_what_is_updated(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        for (int x = s[t]; x < s[t] + (int)h[t]; x++)
            h[x] += e[t];
}

void window_that_is_read(int n, int reach) {
    for (int t = 0; t < n; t++) // EXPECT: refuse array-read
        for (int x = s[t] - reach; x <= s[t] + reach; x++)
            h[x] += e[t] * h[t];
}

void window_moves(int n, int reach) {
    int lo = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse scalar-carried
        for (int x = lo; x <= lo + reach; x++)
            h[x] += e[t];
        lo += s[t];
    }
}

void window_by_break(int n, int reach) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse array-read
        for (int x = s[t]; x < s[t] + reach; x++)
            h[x] += e[t];
        if (h[t] > 4)
            break;
    }
}

void window_with_step_inside(int n, int reach, double *g) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse side-effect
        double *p = g + s[t];
        for (int x = 0; x < reach; x++)
            *p++ += e[t];
    }
}

/* ---- cells ---- */

void cells_fill(int n) {
    for (int d = 0; d < n; d++) // EXPECT: refuse array-read
        for (int b = ROOM * d, p = 0; p < count[d]; p++, b++) {
            force[b] += e[d];
            count[s[d]]++;
        }
}

void cells_are_read(int n) {
    for (int d = 0; d < n; d++) // EXPECT: refuse array-read
        for (int b = ROOM * d, p = 0; p < count[d]; p++, b++)
            force[b] += force[s[d]];
}

/* ---- pairs ---- */

void pairs_are_read(int n) {
    for (int i = 0; i < n; i++) // EXPECT: refuse array-read
        for (int j = i + 1; j < n; j++)
            h[j] -= h[i] * e[j];
}

void pairs_with_carried_sum(int n) {
    double own = 0;
    for (int i = 0; i < n - 1; i++) { // EXPECT: refuse scalar-carried
        for (int j = i + 1; j < n; j++) {
            own += e[i] * e[j];
            h[j] -= e[i];
        }
        h[i] += own;
    }
}

/* ---- dense nests ---- */

void product_by_columns(int n, int m, const double *a, const double *restrict x,
                        double *restrict y) {
    for (int j = 0; j < n; j++) // EXPECT: refuse regular-nest
        for (int i = 0; i < m; i++)
            y[i] += a[j * m + i] * x[j];
}

void convolution(int n, int m, const double *restrict a, const double *x, double *restrict y) {
    for (int j = 0; j < n; j++) // EXPECT: refuse regular-nest
        for (int i = 0; i < m; i++)
            y[i + j] += a[i] * x[j];
}

void ranks(int n, int m, const double *x, double (*restrict y)[16]) {
    for (int t = 0; t < n; t++) // EXPECT: refuse regular-nest
        for (int i = 0; i < m; i++)
            for (int j = 0; j < 16; j++)
                y[i][j] += x[t * m + i] * x[t * m + j];
}

void taps(int n, const double *x, double *restrict y) {
    for (int t = 0; t < n; t++) // EXPECT: refuse regular-nest
        for (int i = 0; i < 5; i++)
            y[t + i] += x[t];
}

void by_local_row(int n, int m, const double *a, double *restrict y) {
    for (int j = 0; j < n; j++) { // EXPECT: refuse regular-nest
        const double *row = a + j * m;
        for (int i = 0; i < m; i++)
            y[i] -= row[i];
    }
}

/* ---- no two iterations update the same element ---- */

void own_rows(int n, int m, const double *x, double *restrict y) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < m; j++) // EXPECT: nothing
            y[i * m + j] += x[j];
}

void own_triangle(int n, const double *x, double (*restrict y)[64]) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int j = 0; j < i; j++) // EXPECT: nothing
            y[i][j] *= x[j];
}

void own_segments(int n, const int *first, const double *x, double *restrict y) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int k = first[i]; k < first[i + 1]; k++) // EXPECT: nothing
            y[k] *= x[i];
}

void a_few_sums(int n, const double *x, double *restrict total) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        for (int c = 0; c < 3; c++) // EXPECT: nothing
            total[c] += x[3 * i + c];
}

double one_sum(int n, const double *x, double *restrict total) {
    for (int i = 0; i < n; i++) // EXPECT: nothing
        total[2] += x[i];
    return total[2];
}
