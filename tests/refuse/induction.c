/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/induction.c: the secondary counter's value
// does not follow from the loop's counter.
// covers: row 79 of docs/constructs.md
enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];

void sometimes(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        if (s[i] > 3)
            k++;
    }
}

void skipped(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        if (s[i] % 3 == 0)
            continue;
        h[s[i]] += e[k];
        k++;
    }
}

void twice_in_a_row(int n, int m, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        for (int c = 0; c < s[i] % m; c++)
            k++;
    }
}

void by_what_is_read(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k += s[i] & 1;
    }
}

void by_what_is_written(int n, int k, int by) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k += by;
        by = s[i];
    }
}

extern int stride;

void by_global(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k += stride;
    }
}

void by_itself(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k = k + (k & 1);
    }
}

void by_fraction(int n, int k, float by) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k += by;
    }
}

void from_the_stride(int n, int k, int by) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k = by - k;
    }
}

void doubled(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k % N];
        k *= 2;
    }
}

void on_one_side(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const double v = s[i] > 3 && e[k++] > 0 ? 1 : 2;
        h[s[i]] += v;
    }
}

void in_the_update(int n, int k) {
    for (int i = 0; i < n; i++) // EXPECT: refuse side-effect
        if (s[i] > 3)
            h[s[i]] += e[k++];
}

void behind_the_counter(int n, int k) {
    for (int i = 0; i < n; i++, k += i) // EXPECT: refuse scalar-carried
        h[s[i]] += e[k % N];
}

void set_by_each_other(int n, int k) {
    int i, q;
    for (i = 0, q = i + 1; i < n; i++, q++) // EXPECT: refuse trip-count
        h[s[i]] += e[q + k];
}

void set_and_stored(int n, int k) {
    int i, q;
    for (i = 0, q = k; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[q];
        q = s[i];
    }
}

void bound_goes_along(int n, int k) {
    for (int i = 0; i < n; i++, n--) // EXPECT: refuse bound-varies
        h[s[i]] += e[k];
}

void by_pointer(int n, int k) {
    int *const here = &k;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k++;
        *here += 1;
    }
}

void counter_twice(int n) {
    for (int i = 0; i < n; i++, i++) // EXPECT: refuse counter-modified
        h[s[i]] += e[i];
}

void counter_twice_behind(int n, int k) {
    for (int i = 0; i < n; i++, k = i++) // EXPECT: refuse counter-modified
        h[s[i]] += e[i];
}

extern int shared;

void global(int n) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[shared];
        shared++;
    }
}

void not_counted_whole(int n, float k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += k;
        k += 1;
    }
}

/* The step `by` is in memory that an update may overwrite. */
void by_address(int n, int k, int by, int **out, int *q) {
    *out = &by;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        q[s[i]] += 3;
        h[s[i]] += e[k];
        k += by;
    }
}
