/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reasons R3xx. Covers rows 4, 5, 7, 8 and 10 of docs/constructs.md. */
#include <limits.h>
#include <stddef.h>

void endless(int n, const int *s, double *h) {
    int i = 0;
    while (s[i] >= 0) { // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
        i++;
    }
    do { // EXPECT: refuse trip-count
        h[s[i]] += 1.0;
        i--;
    } while (i > 0 && s[i] > 0);
    for (double t = 0; t < n; t += 1) // EXPECT: refuse counter-type
        h[s[(int)t]] += 1.0;
    for (int a = 0, b = 0; a < n; a++, b += 2) // EXPECT: transform h(+) verifiable privates=1
        h[s[b]] += 1.0;
    for (int a = 0; a < n && s[a] > 0; a++) // EXPECT: refuse trip-count
        h[s[a]] += 1.0;
}

void counter_modified(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse counter-modified
        h[s[i]] += 1.0;
        if (s[i] > 4)
            i++;
    }
}

void bound_varies(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse bound-varies
        h[s[i]] += 1.0;
        n = n - s[i];
    }
}

void bound_is_array(int n, const int *s, int *h) {
    for (int i = 0; i < h[0]; i++) // EXPECT: refuse array-read
        h[s[i]] += 1;
    (void)n;
}

void step(int n, const int *s, double *h) {
    for (int i = 0; i < n; i += h[0]) // EXPECT: refuse step
        h[s[i]] += 1.0;
    for (int i = 0; i < n; i *= 2) // EXPECT: refuse step
        h[s[i]] += 1.0;
    for (int i = 0; i < n; i--) // EXPECT: refuse step
        h[s[i]] += 1.0;
    for (int i = 0; i < n; i += 0) // EXPECT: refuse step
        h[s[i]] += 1.0;
    for (int i = 0; i != n; i += 2) // EXPECT: refuse step
        h[s[i]] += 1.0;
}

int shared_counter;

void counter_type(int n, const int *s, double *h) {
    for (shared_counter = 0; shared_counter < n; shared_counter++) // EXPECT: refuse counter-type
        h[s[shared_counter]] += 1.0;
    const int(*rows)[3] = (const int(*)[3])s;
    for (const int(*p)[3] = rows; p < rows + n; p++) // EXPECT: refuse counter-type
        h[(*p)[1]] += 1.0;
}

void wraps(unsigned n, long m, const int *s, double *h) {
    for (unsigned i = n; i >= 0; i--) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
    for (unsigned i = 0; i <= n; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
    for (unsigned char i = 0; i < m; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
    for (unsigned i = n; i > 2; i -= 2) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
    for (int i = (int)m; i < n; i++) // EXPECT: refuse counter-wraps
        h[s[i]] += 1.0;
}

const int *next(const int *);

void leaves(int n, const int *s, double *h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse break
        if (*next(s) < 0)
            break;
        h[s[i]] += 1.0;
    }
    for (int i = 0; i < n; i++) { // EXPECT: refuse return
        if (*next(s) < 0)
            return;
        h[s[i]] += 1.0;
    }
    for (int i = 0; i < n; i++) { // EXPECT: refuse goto
        if (*next(s) < 0)
            goto out;
        h[s[i]] += 1.0;
    }
out:
    for (int i = 0; i < n; i++) { // EXPECT: refuse goto
    inner:
        h[s[i]] += 1.0;
        if (s[i] == INT_MIN)
            goto inner;
    }
}

void inner_break(int n, const int *start, const int *s, double *h) {
    for (int i = 0; i < n; i++) // EXPECT: transform h(+)
        for (int p = start[i]; p < start[i + 1]; p++) {
            if (s[p] < 0)
                break;
            h[s[p]] += 1.0;
        }
}

void outer_refused(int n, const int *s, const double *v, double *h, double *x) {
    for (int step = 0; step < 100; step++) {
        for (int i = 0; i < n; i++) // EXPECT: transform h(+)
            h[s[i]] += v[i];
        for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
            x[0] = i;
            h[s[i]] += 1.0;
        }
        for (int i = 0; i < n; i++)
            x[i] += h[i];
    }
}
