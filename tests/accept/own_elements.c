/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The iteration's own element is read, stored to and read again. Its final value is stored after the loop.
// covers: row 93 of docs/constructs.md
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
#include "case.h"

enum { N = 2500, M = 700, C = 12, F = 5 };
struct particle {
    double x, v[2];
    int cell;
    float weight;
};
static struct particle particle[N + 2];
static int member[N + 2], at[N], count[M], order[N + 1];
static double e[N], h[M + C], x[N], y[N], place[N][3], speed[N][3];
static float centre[C][F], feature[N][F], *row[C], *point[N];
static unsigned char seen[N];
static short level[N];

/* As in k-means programs: rows behind pointers, and a search in a function. */
static int nearest(const float *f, float **rows, int clusters) {
    int best = 0;
    float least = 1e30f;
    for (int c = 0; c < clusters; c++) {
        float sum = 0;
        for (int d = 0; d < F; d++)
            sum += (f[d] - rows[c][d]) * (f[d] - rows[c][d]);
        if (sum < least) {
            least = sum;
            best = c;
        }
    }
    return best;
}

static float assign(int n, float **f, float **centres, int *membership, int *length, float **sums) {
    float delta = 0;
    int i, d, index;
    for (i = 0; i < n; i++) { // EXPECT: transformed
        index = nearest(f[i], centres, C);
        if (membership[i] != index)
            delta += 1.0;
        membership[i] = index;
        length[index]++;
        for (d = 0; d < F; d++)
            sums[index][d] += f[i][d];
    }
    return delta;
}

/* The search begins with the first row, so each call reads that row's pointer. */
static float apart(const float *a, const float *b, int n) {
    float sum = 0;
    for (int d = 0; d < n; d++)
        sum += (a[d] - b[d]) * (a[d] - b[d]);
    return sum;
}

static int nearest_to(const float *f, float **rows, int clusters, int n) {
    int best = 0;
    float least = apart(f, rows[0], n);
    for (int c = 1; c < clusters; c++) {
        const float now = apart(f, rows[c], n);
        if (now < least) {
            least = now;
            best = c;
        }
    }
    return best;
}

static void assign_from_the_first(int n, int width, float **f, float **centres, int *membership,
                                  float **sums) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int index = nearest_to(f[i], centres, C, width);
        membership[i] += index;
        for (int d = 0; d < width; d++)
            sums[index][d] += f[i][d];
    }
}

/* Moves each particle, wraps its position around, and deposits at the new position. */
static void push(int n, struct particle *p, double *rho, double dt) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p[t].v[1] -= 0.125 * p[t].x;
        p[t].x += p[t].v[1] * dt;
        if (p[t].x < 0)
            p[t].x += 1;
        while (p[t].x >= 1)
            p[t].x -= 1;
        p[t].cell = (int)(p[t].x * M);
        rho[p[t].cell] += p[t].weight;
        rho[p[t].cell + 1] -= p[t].weight * p[t].x;
    }
}

/* Two components of each row; the velocities may overlap anything. */
static void drift(int n, double (*p)[3], const double (*v)[3], double *restrict rho) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        p[t][0] += v[t][0];
        p[t][2] -= v[t][2] * p[t][0];
        if (p[t][0] > 8)
            p[t][0] = 0;
        rho[at[t]] += p[t][0] * p[t][2];
    }
}

/* Two fields of one record; `g` may overlap anything. */
struct body {
    double at[2], speed;
};
static void fall(int n, struct body *b, const double *g, double *restrict rho) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        b[t].speed += g[t];
        b[t].at[1] += b[t].speed;
        rho[at[t]] -= b[t].at[1] * b[t].speed;
    }
}

/* The subscript is from another array; the guard compares `other` with the own elements. */
static void relax(int n, double *restrict sum, double *own, const double *other, const int *k) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        const double before = own[t];
        own[t] = 0.5 * (before + other[t]);
        sum[k[t]] += own[t] - before;
    }
}

/* Downwards, with steps, under conditions, and in small types. */
static void marks(int n, const int *restrict k, int *restrict c, unsigned char *s, short *l) {
    for (int t = n - 1; t >= 0; t--) { // EXPECT: transformed
        if (s[t] == 7)
            continue;
        s[t]++;
        c[k[t]] += s[t];
    }
    unsigned u = 0;
    while (u < (unsigned)n) { // EXPECT: transformed
        if (l[u] > 3)
            l[u] = (short)-l[u];
        else if (l[u] == 2)
            l[u] *= 3;
        c[k[u]] += l[u];
        u += 2;
    }
}

#define STATE(i) state[(i) + 1]
static void by_macros(int n, const int *restrict k, double *restrict b, int *state) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (STATE(i) % 3 == 1)
            STATE(i) += 2;
        STATE(i) = STATE(i) * 5 % 1009;
        b[k[STATE(i)]] += STATE(i);
    }
}

/* The loop may end early: then the values already given to own elements are discarded. */
static int until(int n, const int *k, double *restrict b, double *own) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        if (own[i] > 1e6)
            return i;
        own[i] += 1;
        b[k[i]] += own[i];
    }
    return n;
}

/* Stores after a read, in more general forms than in distributed_stores.c. */
static void some_iterations_go_on(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        if (r[i] == 3)
            continue;
        t[i] = 0;
    }
}

static void read_after(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double v = t[i];
        t[i] = 0;
        y[r[i]] -= v + t[i];
    }
}

static void read_by_another_pointer(int n, const int *r, double *y, double *t, const double *u) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i] * u[i];
        t[i] = 0;
    }
}

static void read_as_bytes(int n, const unsigned char *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        t[i] = 0;
    }
}

static void value_is_of_the_iteration(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const double v = t[i] * 2;
        y[r[i]] -= v;
        t[i] = v;
    }
}

static void value_is_stepped(int n, const int *r, double *y, double *t, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        t[i] = k;
        k += 2;
    }
}

static void condition_is_of_the_iteration(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int k = r[i];
        y[k] -= t[i];
        if (k > 7)
            t[i] = 0;
    }
}

static void other_branch(int n, const int *r, double *y, double *t, double limit) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        if (t[i] > limit)
            t[i] = 0;
        else
            t[i] = 1;
    }
}

static void in_a_loop_inside(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        for (int k = 0; k < r[i]; k++)
            t[i] = 0;
    }
}

static void condition_reads_after(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        t[i] = 0;
        if (t[i] == 0)
            t[i] = 1;
    }
}

static void condition_reads_memory(int n, const int *r, double *y, double *t, const int *limit) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        if (*limit > i)
            t[i] = 0;
    }
}

static void condition_rounds(int n, const int *r, double *y, double *t, double by) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        y[r[i]] -= t[i];
        if (t[i] * by + 1.0 > 2.0)
            t[i] = 0;
    }
}

static void beside_reads(int n, int round) {
    static unsigned char small[N];
    static int bound[N];
    for (int i = 0; i < N; i++) {
        small[i] = (unsigned char)at[i];
        bound[i] = at[i] % 6;
    }
    some_iterations_go_on(n, bound, h, e);
    read_after(n, at, h, x);
    read_by_another_pointer(n, at, h, e, y);
    read_as_bytes(n, small, h, y);
    case_values(e, N);
    case_values(y, N);
    value_is_of_the_iteration(n, at, h, x);
    value_is_stepped(n, at, h, x, round);
    condition_is_of_the_iteration(n, at, h, e);
    other_branch(n, at, h, e, 0.25);
    in_a_loop_inside(n, bound, h, e);
    condition_reads_after(n, at, h, y);
    case_values(e, N);
    condition_reads_memory(n, at, h, e, &round);
    condition_rounds(n, at, h, e, 0.5);
    CASE_PRINT(x);
    CASE_PRINT(e);
    CASE_PRINT(h);
}

/* Each iteration stores its own element before it reads it; `o` and `h` may be one array. */
static void maybe_the_array(int n, const int *s, double *o, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = s[t];
        h[s[t]] += 1;
        h[s[t] + 1] += o[t];
    }
}

static void maybe_another_output(int n, const int *s, double *o, double *p, int *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = s[t];
        p[t] = 1;
        h[s[t]] += o[t] > 1;
    }
}

static void stored_again(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = s[t];
        o[t] = 2;
        h[s[t]] += o[t];
    }
}

static void written_in_between(int n, int *o, const int *key, int *count, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = key[t];
        count[key[t]]++;
        h[o[t]] += 1;
    }
}

static void written_before_the_last_read(int n, int *o, const int *key, int *count) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = key[t];
        count[o[t]]++;
        count[o[t] + 1]++;
    }
}

static void written_in_the_same_statement(int n, int *o, const int *key, int *count) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = key[t];
        if (key[t] > 0)
            count[o[t]] += 1;
    }
}

static void read_before(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[o[t]] += 1;
        o[t] = key[t];
    }
}

static void read_before_and_after(int n, int *restrict o, const int *key, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[o[t]] += 1;
        o[t] = key[t];
        h[o[t]] += 1;
    }
}

static void stored_again_below(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = s[t];
        h[s[t]] += o[t];
        o[t]++;
        h[s[t]] += o[t];
    }
}

static void of_itself(int n, const int *s, double *restrict o, double *restrict h) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        o[t] = o[t] + 1;
        h[s[t]] += o[t];
    }
}

static void stored_first(int n) {
    static double o[N + M], p[N], sums[M + 4];
    static int kept[N + M], counts[M + 4], whole[M + 4];
    maybe_the_array(M / 2, at, o, o + 1); /* the arrays overlap */
    maybe_the_array(n, at, o, sums);
    maybe_another_output(n / 2, at, o, o + 7, whole); /* the arrays overlap */
    maybe_another_output(n, at, o, p, whole);
    stored_again(n, at, o, sums);
    stored_again_below(n, at, o, sums);
    of_itself(n, at, o, sums);
    written_in_between(M / 2, kept, at, kept + 1, sums); /* the arrays overlap */
    written_in_between(n, kept, at, counts, sums);
    written_before_the_last_read(M / 2, kept, at, kept + 2); /* the arrays overlap */
    written_before_the_last_read(n, kept, at, counts);
    written_in_the_same_statement(n, kept, at, counts);
    read_before(n, kept, at, sums);
    read_before_and_after(n, kept, at, sums);
    CASE_PRINT(o);
    CASE_PRINT(p);
    CASE_PRINT(sums);
    CASE_PRINT(kept);
    CASE_PRINT(counts);
    CASE_PRINT(whole);
}

static struct body body[N];

int main(void) {
    for (int i = 0; i < N; i++) {
        for (int d = 0; d < F; d++)
            feature[i][d] = (float)case_value();
        point[i] = feature[i];
        particle[i] = (struct particle){.x = i % 97 / 97.0, .weight = (float)case_value()};
        particle[i].v[1] = case_value() * 3;
        seen[i] = (unsigned char)(i * 7 % 251);
        level[i] = (short)(i % 5);
        order[i + 1] = i % 997;
    }
    static float sum[C][F], *sums[C];
    static float total[C + 8][F], *totals[C]; /* the pointers do not overlap the rows */
    static int length[C];
    for (int c = 0; c < C; c++) {
        row[c] = centre[c];
        sums[c] = sum[c];
        totals[c] = total[c + 4];
        for (int d = 0; d < F; d++)
            centre[c][d] = feature[c * 31][d];
    }
    case_values(&place[0][0], 3 * N);
    case_values(&speed[0][0], 3 * N);
    case_values(e, N);
    case_values(x, N);
    case_values(y, N);
    case_subscripts(at, N, M);
    for (int round = 0; round < 5; round++) {
        const int n = round == 3 ? N / 2 : N;
        printf("%a\n", (double)assign(n, point, row, member, length, sums));
        CASE_PRINT(length);
        assign_from_the_first(n, F, point, totals, member, totals); /* rows and sums overlap */
        assign_from_the_first(n, F, point, row, member, totals);
        CASE_PRINT(member);
        CASE_PRINT(sum);
        CASE_PRINT(total);
        for (int c = 0; c < C; c++)
            for (int d = 0; d < F; d++)
                centre[c][d] = (centre[c][d] + sum[(c + 1) % C][d] / 100) / 2;
        push(n, particle, h, 0.0625);
        CASE_PRINT(particle);
        CASE_PRINT(h);
        drift(n / 2, place, (const double(*)[3])place + n / 4, h); /* `v` overlaps the rows */
        drift(n, place, (const double(*)[3])speed, h);
        CASE_PRINT(place);
        fall(n, body, e, h);
        fall(n / 2, body, &body[1].speed, h); /* `g` overlaps the records */
        fall(n, body, e, h);
        CASE_PRINT(body);
        relax(n - 1, h, x, x + 1, at); /* `other` overlaps `own` */
        relax(n, h, x, y, at);
        CASE_PRINT(x);
        marks(n, at, count, seen, level);
        CASE_PRINT(seen);
        CASE_PRINT(level);
        CASE_PRINT(count);
        by_macros(n, at, h, order);
        CASE_PRINT(order);
        y[N / 3] = round == 2 ? 1e7 : 1;
        printf("%d\n", until(n, at, h, y));
        CASE_PRINT(y);
        beside_reads(n, round);
        stored_first(n);
    }
    return 0;
}
