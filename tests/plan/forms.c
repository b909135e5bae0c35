/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Loops, and the decisions of tool/plan about them (see plan_test.c). */
/* The PLAN comment on a loop's line lists the decisions. */
/* clang-format off */

#include <math.h>

enum { DOWN = -5 };

struct vector {
    double x, y, z;
};

/* Each of the two rows has its own record, since one update adds and the other subtracts. */
void springs(int n, const int (*edge)[2], const double (*restrict x)[3], double k,
             double (*restrict b)[3]) {
    for (int t = 0; t < n; t++) { // PLAN: bins: 2 records of 1 values, 2 tags in 1 streams; prefetch: 16 if light; gathers: 2; lanes: yes
        int i = edge[t][0], j = edge[t][1];
        for (int c = 0; c < 3; c++) {
            double f = k * (x[j][c] - x[i][c]);
            b[i][c] += f;
            b[j][c] -= f;
        }
    }
}

/* Three adjacent elements form one row. */
void vectors(int n, const int *restrict s, const double *restrict w, struct vector *restrict f) {
    for (int t = 0; t < n; t++) { // PLAN: bins: 1 records of 3 values, 1 tags in 1 streams; no prefetch: an iteration is too short
        f[s[t]].x += w[t];
        f[s[t]].y += w[t] * 2;
        f[s[t]].z -= w[t] * 3;
    }
}

/* Updates that differ only in their operands share a tag; another operator has another tag. */
void tags(int n, const int *restrict s, const int *restrict r, const double *restrict w,
          double *restrict h) {
    for (int t = 0; t < n; t++) { // PLAN: bins: 2 records of 1 values, 1 tags in 1 streams
        h[s[t]] += w[t];
        h[r[t]] += w[n - 1 - t];
    }
    for (int t = 0; t < n; t++) { // PLAN: bins: 2 records of 1 values, 2 tags in 1 streams
        h[s[t]] += w[t];
        h[r[t]] -= w[t];
    }
}

/* With an unverified value of w the body may read s beyond its end. */
void decided(int n, const int *restrict s, const double *w, double *h) {
    for (int t = 0; t < n; t++) // PLAN: no bins: its body may fail with values that are not verified
        if (w[t] > 0)
            h[s[t]] += w[t];
}

/* With an unverified value the while loop may not end, so reads are compared with updates before the body. */
void repeated(int n, const int *restrict s, const double *w, double *h) {
    for (int t = 0; t < n; t++) { // PLAN: bins: 1 records of 1 values, 1 tags in 1 streams; compared before
        double d = w[t];
        while (d > 1)
            d -= 1;
        h[s[t]] += d;
    }
}

/* The inner counter may never reach the bound: its type does not have all values of the bound's
 * type, or the comparison converts it. */
void never_reached(int n, long m, unsigned u, unsigned long lu, double x, const int *restrict s,
                   const double *w, double *h) {
    for (int t = 0; t < n; t++) { // PLAN: compared before
        int sum = 0;
        if (w[t] > 0)
            for (int j = 0; j < m; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared before
        int sum = 0;
        if (w[t] > 0)
            for (int j = 0; j < u; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared before
        long sum = 0;
        if (w[t] > 0)
            for (long j = 0; j < lu; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared before
        int sum = 0;
        if (w[t] > 0)
            for (int j = 9; j > u; j--)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared before
        int sum = 0;
        if (w[t] > 0)
            for (unsigned j = 0; j < DOWN; j += 7)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared before
        int sum = 0;
        if (w[t] > 0)
            for (int j = 0; j < x; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
}

void always_reached(int n, short m, unsigned u, unsigned char c, const int *restrict s,
                    const double *w, double *h) {
    for (int t = 0; t < n; t++) { // PLAN: compared after
        int sum = 0;
        if (w[t] > 0)
            for (int j = 0; j < m + c; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared after
        long sum = 0;
        if (w[t] > 0)
            for (long j = 0; j < u; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared after
        long sum = 0;
        if (w[t] > 0)
            for (unsigned j = 0; j < n; j++)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared after
        long sum = 0;
        if (w[t] > 0)
            for (int j = 900; j > c; j--)
                sum ^= j;
        h[s[t]] += sum;
    }
    for (int t = 0; t < n; t++) { // PLAN: compared after
        long sum = 0;
        if (w[t] > 0)
            for (int j = 900; j >= DOWN; j -= 3)
                sum ^= j;
        h[s[t]] += sum;
    }
}

double summed(int n, const int *restrict s, const double *w, double *h) {
    double sum = 0;
    for (int t = 0; t < n; t++) { // PLAN: bins: 1 records of 1 values, 1 tags in 1 streams; compared after
        h[s[t]] += w[t];
        sum += w[t];
    }
    return sum;
}

/* Without a sum the reads are compared after the bodies. */
void unsummed(int n, const int *restrict s, const double *w, double *h) {
    for (int t = 0; t < n; t++) // PLAN: bins: 1 records of 1 values, 1 tags in 1 streams; compared after
        h[s[t]] += w[t];
}

/* The loop of `decided`, with w disjoint from h. */
void decided_apart(int n, const int *restrict s, const double *restrict w, double *restrict h) {
    for (int t = 0; t < n; t++) // PLAN: bins: 1 records of 1 values, 1 tags in 1 streams; precheck: none
        if (w[t] > 0)
            h[s[t]] += w[t];
}

/* k[t] may be out of bounds of map until an earlier iteration has changed it. */
void made_valid(int n, const int *map, const int *k, int *g) {
    for (int t = 0; t < n; t++) // PLAN: precheck: updates
        g[map[k[t]]] += 1;
}

void not_made_valid(int n, const int *restrict map, const int *restrict k, int *restrict g) {
    for (int t = 0; t < n; t++) // PLAN: bins: 1 records of 0 values, 1 tags in 1 streams; precheck: none
        g[map[k[t]]] += 1;
}

/* Most work follows the subscript, so a thread that owns neither row can skip it. */
void neighbours(int n, const int *restrict begin, const int *restrict list,
                const double *restrict x, double *restrict f) {
    for (int i = 0; i < n; i++) // PLAN: no prefetch: its subscripts are computed in a loop of unknown length; skip: 2 rows
        for (int k = begin[i]; k < begin[i + 1]; k++) {
            int j = list[k];
            double d = x[i] - x[j], r = d * d + 1, e = d / (r * r * r) - d / (r * r);
            f[i] += e;
            f[j] -= e;
        }
}

/* Once the row is known, no work remains that a thread could skip. */
void light_neighbours(int n, const int *restrict begin, const int *restrict list,
                      const double *restrict x, double *restrict f) {
    for (int i = 0; i < n; i++) // PLAN: no skip: the rows that an inner iteration updates are not known before its work
        for (int k = begin[i]; k < begin[i + 1]; k++)
            f[list[k]] += x[i];
}

/* The inner sum is also read by a statement that is no update. */
void sums(int n, const int *restrict begin, const int *restrict list, const double *restrict x,
          double *restrict f) {
    for (int i = 0; i < n; i++) { // PLAN: no skip: a sum that an inner iteration adds to is read other than by an update
        double sum = 0;
        for (int k = begin[i]; k < begin[i + 1]; k++) {
            int j = list[k];
            double d = x[i] - x[j], r = d * d + 1, e = d / (r * r * r) - d / (r * r);
            sum += e;
            f[j] -= e;
        }
        if (sum > 0)
            f[i] += sum;
    }
}

/* A counter that is a pointer has no lanes. */
void pointers(const int *begin, const int *end, double *restrict h) {
    for (const int *p = begin; p < end; p++) // PLAN: lanes: counter; keys: 1
        h[*p] += 1;
}

/* The generated code contains the body twice, but a static variable must not exist twice. */
void statics(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) { // PLAN: obstacle: its body declares 'table' static
        static int table[2] = {1, 2};
        h[s[t]] += table[t & 1];
    }
}

/* The plan's key consists of the trip count, the row's base and the subscript array. */
struct system {
    double *b;
};

void keys(int n, const int *restrict s, struct system *restrict m) {
    for (int t = 0; t < n; t++) // PLAN: keys: 3
        m->b[s[t]] += 1;
}

/* Rows behind pointers: one record stands for an inner loop and reads its operands when it is applied. */
void rows(int n, int m, const int *restrict s, double **restrict row, double *const *restrict x,
          const double *restrict w) {
    for (int t = 0; t < n; t++) { // PLAN: span of 2 variables; bins: 1 records of 0 values, 1 tags in 1 streams
        const double scale = w[t];
        for (int j = 0; j < m; j++)
            row[s[t]][j] += scale * x[t][j];
    }
}

/* Since exp may set errno, one thread must execute each inner iteration that others may skip: no span. */
void led(int n, const int *restrict c, const int *restrict s, const int (*restrict list)[8],
         const double *restrict x, double *restrict w, double (*restrict h)[4]) {
    for (int t = 0; t < n; t++) { // PLAN: skip: 1 rows; bins: 2 records of 2 values, 2 tags in 2 streams
        for (int k = 0; k < c[t]; k++) {
            const int j = list[t][k];
            const double d = x[t] - x[j];
            const double e = exp(d) + exp(d * d) + exp(d * 3) + d * d * d;
            w[j] += e;
        }
        const int width = c[t];
        for (int j = 0; j < width; j++)
            h[s[t]][j] += x[j];
    }
}

double half(double x);
#pragma redcc pure(half)

/* No span if later execution could give other values: a call, two updates, an own element, a counter used later. */
void not_later(int n, int m, const int *restrict s, double **restrict row, double *restrict own,
               const double *restrict w, int *restrict last) {
    for (int t = 0; t < n; t++) // PLAN: no span
        for (int j = 0; j < m; j++)
            row[s[t]][j] += half(w[j]);
    for (int t = 0; t < n; t++) { // PLAN: no span
        for (int j = 0; j < m; j++)
            row[s[t]][j] += w[j];
        row[s[t]][0] *= 2;
    }
    for (int t = 0; t < n; t++) { // PLAN: no span
        own[t] = own[t] * 0.5;
        for (int j = 0; j < m; j++)
            row[s[t]][j] += own[t];
        own[t] = own[t] + 1;
    }
    for (int t = 0; t < n; t++) { // PLAN: no span
        int j;
        for (j = 0; j < m; j++)
            row[s[t]][j] += w[j];
        last[t] = j;
    }
    for (int t = 0; t < n; t++) { // PLAN: no span
        double some[8];
        for (int j = 0; j < 8; j++)
            some[j] = w[t + j];
        for (int j = 0; j < m; j++)
            row[s[t]][j] += some[j & 7];
    }
}

/* A sample records the rows of a block at once, unless a table gives each row or a search gives the block. */
void blocks(int n, int m, const int *restrict at, const int *restrict list, const double *restrict w,
            double *restrict h) {
    for (int t = 0; t < n; t++) // PLAN: over blocks
        for (int j = at[t]; j < at[t] + m; j++)
            h[j] += w[j - at[t]];
    for (int t = 0; t < n; t++) // PLAN: no blocks
        for (int j = at[t]; j < at[t + 1]; j++)
            h[list[j]] += w[j];
    for (int t = 0; t < n; t++) { // PLAN: no blocks
        int first = 0;
        for (int k = 1; k < m; k++)
            if (list[k] < list[first])
                first = k;
        for (int j = at[t] + first; j < at[t] + m; j++)
            h[j] += w[j];
    }
    for (int t = 0; t < n; t++) // PLAN: no blocks
        for (int c = 0; c < 3; c++)
            h[at[t] + c] += w[c];
}
