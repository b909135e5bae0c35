/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops from the section on updates in docs/reasons.md. With -DBEFORE, each loop marked BEFORE: REASON is an example
// refused for that reason. Without it, the loops are changed as the page advises, and transformed (run/check-advice).
#include <math.h>
#include <string.h>
#include "case.h"

enum { N = 2000, ROWS = 80 };
static int s[N + 1], c[N], key[N], place[ROWS + 1], found[N], out[N], numbers[ROWS];
static double e[N], w[N], copy[ROWS], seen[N], h[ROWS], a[ROWS], b[ROWS], both[ROWS][2];

static void element_type(int n) {
    static const char text[N + 1];
#ifdef BEFORE
    static const char *starts[ROWS];
    for (int k = 0; k < ROWS; k++)
        starts[k] = text;
    const char **h;
    h = starts;
    for (int t = 0; t < n; t++) // BEFORE: element-type
        h[s[t]]++;
#else
    static int starts[ROWS];
    memset(starts, 0, sizeof starts);
    for (int t = 0; t < n; t++) // EXPECT: transformed
        starts[s[t]]++;
#endif
    for (int k = 0; k < ROWS; k++) {
#ifdef BEFORE
        numbers[k] += (int)(starts[k] - text);
#else
        numbers[k] += (int)(&text[starts[k]] - text);
#endif
    }
}

/* The counting loop is transformed. The loop that uses an updated count as a subscript stays sequential. */
static void update_value_used(int n) {
    memset(place, 0, sizeof place);
#ifdef BEFORE
    for (int t = 0; t < n; t++)
        place[key[t] + 1]++;
    for (int k = 0; k < ROWS; k++)
        place[k + 1] += place[k];
    for (int t = 0; t < n; t++) { // BEFORE: update-value-used
        h[s[t]] += e[t];
        out[place[key[t]]++] = key[t];
    }
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        place[key[t] + 1]++;
    for (int k = 0; k < ROWS; k++)
        place[k + 1] += place[k];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
    for (int t = 0; t < n; t++)
        out[place[key[t]]++] = key[t];
#endif
}

static void update_in_expression(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: update-in-expression
        s[t] && h[s[t]]++;
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        if (s[t])
            h[s[t]]++;
#endif
}

static void array_read(const int *s) {
#ifdef BEFORE
    for (int t = ROWS / 2; t < ROWS; t++) // BEFORE: array-read
        h[s[t]] += 0.5 * h[t];
#else
    memcpy(copy, h, sizeof h);
    for (int t = ROWS / 2; t < ROWS; t++) // EXPECT: transformed
        h[s[t]] += 0.5 * copy[t];
#endif
}

/* A local variable holds the element's value while the loop updates other elements of its array. */
static void array_read_and_kept(const int *s) {
#ifdef BEFORE
    for (int t = ROWS / 2; t < ROWS; t++) { // BEFORE: array-read
        double kept = h[t];
        for (int i = 0; i < 3; i++) {
            kept += e[t + i];
            h[s[t - i]] -= e[t + i];
        }
        h[t] = kept;
    }
#else
    for (int t = ROWS / 2; t < ROWS; t++) // EXPECT: transformed
        for (int i = 0; i < 3; i++) {
            h[t] += e[t + i];
            h[s[t - i]] -= e[t + i];
        }
#endif
}

static double array_stored(int n, double *restrict h) {
    double x = 1;
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: array-stored
        x = h[t] = 0;
        h[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) { // BEFORE: array-stored
        h[s[t]] += e[t];
        h[7] = 0;
    }
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        h[t] = 0;
        x = 0;
        h[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
    h[7] = 0;
#endif
    return x;
}

static void base_varies(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: base-varies
        double *h = c[t] ? a : b;
        h[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) { // BEFORE: base-varies
        double *h = a;
        if (c[t])
            h = b;
        h[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) { // BEFORE: base-varies
        double *row;
        row = both[s[t]];
        row[0] += e[t];
        row = row + 1;
        row[0] += e[t];
    }
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (c[t])
            a[s[t]] += e[t];
        else
            b[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (c[t])
            b[s[t]] += e[t];
        else
            a[s[t]] += e[t];
    }
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        double *row = both[s[t]];
        row[0] += e[t];
        row[1] += e[t];
    }
#endif
}

static double lines[2][N];

static void row_pointers(int n, const int *s) {
#ifdef BEFORE
    double *x = lines[0], *y = lines[1];
    for (int t = 0; t < n; t++) { // BEFORE: row-pointers
        double *a[2] = {x + t, y + t};
        a[s[t]][0] += e[t];
    }
    for (int t = 0; t < n; t++) { // BEFORE: row-pointers
        double *a[2] = {x + t, y + t};
        a[s[t]][0] += w[t];
    }
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        lines[s[t]][t] += e[t];
    double *a[2] = {lines[0], lines[1]};
    for (int t = 0; t < n; t++) // EXPECT: transformed
        a[s[t]][t] += w[t];
#endif
}

#ifndef BEFORE
struct fields { unsigned char a, b; };
#endif

static void bit_field(int n) {
#ifdef BEFORE
    static struct { unsigned a : 4, b : 4; } *h;
#else
    static struct fields *h;
#endif
    if (!h)
        h = calloc(ROWS, sizeof *h);
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: bit-field
        h[s[t]].a++;
#else
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]].a++;
#endif
    for (int k = 0; k < ROWS; k++)
        numbers[k] += h[k].a;
}

static void index_array_written(int n, int *s, const int *key) {
    s[0] = 1;
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: index-array-written
        s[t + 1] = s[t] + key[t];
        h[s[t]] += e[t];
    }
#else
    for (int t = 0; t < n; t++)
        s[t + 1] = s[t] + key[t];
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[s[t]] += e[t];
#endif
}

static void index_too_dear(int n, const double *x) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) { // BEFORE: index-too-dear
        if (x[t] <= 0)
            break;
        h[(int)(8.0 * log(x[t]))] += 1;
    }
#else
    int end = 0;
    while (end < n && !(x[end] <= 0))
        end++;
    for (int t = 0; t < end; t++)
        found[t] = (int)(8.0 * log(x[t]));
    for (int t = 0; t < end; t++) // EXPECT: transformed
        h[found[t]] += 1;
#endif
}

static void side_effect(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: side-effect
        h[s[t]] += (seen[t] = e[t]);
#else
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        seen[t] = e[t];
        h[s[t]] += e[t];
    }
#endif
}

static struct results { double *b; } store = {b}, *results;

static void base_conditional(int n) {
#ifdef BEFORE
    for (int t = 0; t < n; t++) // BEFORE: base-conditional
        if (results)
            results->b[s[t]] += e[t];
#else
    if (results) {
        double *b = results->b;
        for (int t = 0; t < n; t++) // EXPECT: transformed
            b[s[t]] += e[t];
    }
#endif
}

int main(void) {
    case_subscripts(s, N + 1, ROWS);
    case_subscripts(key, N, ROWS);
    case_subscripts(c, N, 2);
    case_values(e, N);
    case_values(w, N);
    static int chain[N + 1], lower[ROWS];
    case_subscripts(lower, ROWS, ROWS / 2);
    static double x[N], rows[ROWS + N];
    double x_sum = 0;
    for (int t = 0; t < N; t++)
        x[t] = t == N - 100 ? -1 : 1.5 + fabs(e[t]) * 100;
    for (int round = 0; round < 3; round++) {
        element_type(N);
        update_value_used(N);
        update_in_expression(N);
        array_read(lower);
        array_read_and_kept(lower);
        x_sum += array_stored(ROWS, rows);
        base_varies(N);
        row_pointers(N, c);
        bit_field(6);
        index_array_written(60, chain, c);
        index_too_dear(N, x);
        side_effect(N);
        results = round == 1 ? NULL : &store;
        base_conditional(N);
    }
    CASE_PRINT(out);
    CASE_PRINT(numbers);
    CASE_PRINT(h);
    CASE_PRINT(rows);
    CASE_PRINT(a);
    CASE_PRINT(b);
    CASE_PRINT(both);
    CASE_PRINT(lines);
    CASE_PRINT(seen);
    printf("%a\n", x_sum);
    return 0;
}
