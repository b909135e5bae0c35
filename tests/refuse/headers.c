/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Unlike in accept/headers.c, header variables carry values between iterations, or a conversion changes a first value.
// covers: row 94 of docs/constructs.md
enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];
extern int global;

void narrowed(int n) {
    int i;
    unsigned char c;
    for (i = c = n; i < N; i++, c += 2) // EXPECT: refuse trip-count
        h[s[i]] += e[c];
}

void narrowed_constant(void) {
    int i;
    signed char c;
    for (i = c = 200; i < N; i++, c++) // EXPECT: refuse trip-count
        h[s[i]] += e[c];
}

void rounded(int n) {
    int i;
    float f;
    for (i = f = n; i < N; i++) { // EXPECT: refuse trip-count
        f = 2;
        h[s[i]] += f;
    }
}

void one_by_the_other(int n) {
    for (int i = 0, j = i + 1; i < n; i++, j += 2) // EXPECT: refuse trip-count
        h[s[i]] += e[j];
}

void sometimes(int n) {
    for (int i = 0, j = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[j];
        if (s[i] > 3)
            j++;
    }
}

void read_first(int n) {
    int i, k;
    for (i = k = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[k]] += e[i];
        k = s[i];
    }
}

void sum_that_is_read(int n) {
    for (int i = 0, c = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        c += s[i];
        h[s[i]] += c;
    }
}

void of_all(int n) {
    int i;
    for (i = global = 0; i < n; i++, global += 2) // EXPECT: refuse scalar-carried
        h[s[i]] += e[global];
}

void escaped(int n, int **out) {
    for (int i = 0, k = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        k = s[i];
        *out = &k;
        h[k] += e[i];
    }
}

void volatile_start(int n, volatile int *v) {
    int i, q;
    for (i = 0, q = *v; i < n; i++, q += 2) // EXPECT: refuse volatile
        h[s[i]] += e[q];
}
