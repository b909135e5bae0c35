/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// CFLAGS: -Wno-sign-compare
// INTEGERS: no
// MAY-RUN-SERIALLY: tables may overlap the updated array
// Look-up functions that change their parameters, or set a local variable several times, before they use it as a
// subscript. The table may be the updated array: the guard detects this only if it computes the subscripts correctly.
#include "case.h"

enum { N = 3000, CELLS = 90, FAR = 40 };
struct table {
    int last;
    const float *values;
};
static int s[N], k[N], list[N][3];
static float z[N], memory[40 * CELLS], elsewhere[40 * CELLS];

/* Scales `v` in place, as gridding programs do to look up a window's weights. */
static float scaled(float v, const float *table, int size, float per_cell) {
    unsigned at;
    float from;
    v *= (float)size;
    at = (unsigned)(v * per_cell);
    from = (float)at / per_cell;
    return table[at] + (v - from) * (table[at + 1] - table[at]);
}

static void grid(int n, float *b, const float *table) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += scaled(z[t], table, CELLS - 2, 1.0f);
}

/* Clamps the subscript at both ends. */
static float clamped(const struct table *in, int at) {
    if (at > in->last)
        at = in->last;
    if (at < 2)
        at = 2;
    return in->values[at];
}

static void clamps(int n, float *b, const struct table *in) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += clamped(in, k[t]);
}

/* Reflects the subscript in nested branches; `sign` changes too, but is not a subscript. */
static float reflected(const float *table, int at, int last) {
    float sign = 1;
    if (at < 0) {
        at = -at;
        sign = -1;
    } else if (at > last) {
        at -= FAR * last;
        sign++;
    } else
        --at;
    at++;
    return sign * table[at];
}

static void reflects(int n, float *b, const float *table) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] -= reflected(table, k[t], CELLS - 1);
}

/* A narrow subscript wraps around, and the conversion to short cuts off bits. */
static float narrow(const float *table, unsigned char at, double w) {
    short cut;
    at += 200;
    cut = (short)(w * 65537 + at);
    cut = (short)(cut & 31);
    return table[at] + table[cut + CELLS];
}

static void narrows(int n, float *b, const float *table) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += narrow(table, (unsigned char)(55 + CELLS - s[t]), z[t]);
}

/* Reads the table in a loop, at a subscript that each turn computes. */
static float in_turns(const float *table, const int *at, int shift) {
    float sum = 0;
    shift = shift % 5;
    for (int a = 0; a < 3; a++) {
        int j = at[a] + shift;
        if (j >= CELLS)
            j = j % CELLS;
        sum += table[j];
    }
    return sum;
}

static void turns(int n, float *b, const float *table, const int (*nodes)[3]) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += in_turns(table, nodes[t], t);
}

/* Some calls return before they read the table. */
static float some(const float *table, int at) {
    if (at < 0)
        return 0;
    at = at >> 1;
    {
        at %= CELLS;
    }
    switch (at % 3) {
    case 0:
        return 1;
    default:
        return table[at];
    }
}

static void sometimes(int n, float *b, const float *table) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += some(table, k[t] - 3);
}

/* `at` is replaced by a value of another table; `half` is initialised from `twice`, declared just before it. */
static float by_tables(const float *table, const int *first, int at) {
    at = first[at];
    const int twice = 2 * at, half = twice / 4;
    at = at < 7 ? half : twice - at;
    return table[at];
}

static void tables(int n, float *b, const float *table, const int *first) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        b[s[t]] += by_tables(table, first, t);
}

static void fill(void) {
    for (int i = 0; i < 40 * CELLS; i++)
        memory[i] = elsewhere[i] = (float)case_value();
}

static void all(float *b, const float *table) {
    const struct table in = {CELLS - 1, table};
    grid(N, b, table);
    clamps(N, b, &in);
    reflects(N, b, table);
    narrows(N, b, table);
    turns(N, b, table, (const int (*)[3])list);
    sometimes(N, b, table);
    tables(N, b, table, s);
}

int main(void) {
    case_subscripts(s, N, CELLS);
    for (int t = 0; t < N; t++) {
        z[t] = (float)case_below(1000) / 1000;
        k[t] = FAR * (CELLS - 1) + case_below(CELLS - 1); /* beyond the table unless the function reduces it */
        for (int a = 0; a < 3; a++)
            list[t][a] = case_below(40 * CELLS - 5);
    }
    fill();
    for (int i = 0; i < 3; i++) {
        all(memory, elsewhere);
        CASE_PRINT(memory);
    }
    fill();
    all(memory, memory); /* the table is in the updated memory */
    CASE_PRINT(memory);
    return 0;
}
