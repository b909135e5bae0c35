/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops without a bound that step their counter inside an expression, but not once in each iteration, or not after its
// last use. Or the loop may change its list.
void used_after(int n, const int *p, double *h) {
    int k;
    while ((k = *p++) != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[k] += *p;
    }
}

void stepped_twice(int n, const int *p, double *h) {
    int k;
    while ((k = *p++) != -1) { // EXPECT: refuse trip-count
        if (k == 3)
            p++;
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

void sometimes(int n, const int *p, const int *q, double *h) {
    int k = 0;
    while (q[k] && (k = *p++) != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

void passed_over(int n, const int *p, const double *w, double *h) {
    for (;;) { // EXPECT: refuse break
        if (w[*p] > 0)
            continue;
        int k = *p++;
        if (k == -1)
            break;
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

void in_a_branch(int n, const int *p, double *h) {
    while (*p != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[*p] += c;
        if (n > 5)
            h[*p++] += 1;
    }
}

void in_an_inner_loop(int n, const int *p, double *h) {
    while (*p != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < 2; c++)
            h[*p++] += c;
    }
}

void downwards(int n, const int *p, double *h) {
    int k;
    while ((k = *p--) != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

const int *shared;
void of_the_file(int n, double *h) {
    int k;
    while ((k = *shared++) != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

/* An update may set an element of the list to -1, or may replace the end. */
void same_type(int n, const int *p, int *h) {
    int k;
    while ((k = *p++) != -1) { // EXPECT: refuse text
        for (int c = 0; c < n; c++)
            h[k] += c;
    }
}

void in_header(int n, const int *list, int *h) {
    const int *p;
    int k;
    for (p = list; (k = *p++) != -1;) // EXPECT: refuse text
        for (int c = 0; c < n; c++)
            h[k] += c;
}

void itself(int n, int *p) {
    int k;
    while ((k = *p++) != -1) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            p[k] += c;
    }
}

void light(const int *p, double *h) {
    int k;
    while ((k = *p++) != -1) // EXPECT: refuse trip-count
        h[k] += 1;
}

/* The outer loop is refused for the second list, which it reads in the condition of a do loop. */
void with_do(int n, int *const *row, int *b) {
    for (int i = 0; i + 1 < n; i++) {
        const int *p = row[i], *q = row[i + 1];
        int k;
        while ((k = *q++) != -1) // EXPECT: refuse trip-count
            b[k]++;
        do
            b[*p]++;
        while (*++p != -1);
    }
}

/* The condition reads what it assigned, or reads twice, so its addresses are not known before it. */
void condition_reads_on(int n, int *const *row, const int *most, int *b) {
    for (int i = 0; i < n; i++) {
        const int *p = row[i];
        int k;
        while ((k = *p++) != -1 && most[k] > 0) // EXPECT: refuse trip-count
            b[k]++;
    }
}

void condition_reads_twice(int n, int *const *row, int *b) {
    for (int i = 0; i < n; i++) {
        const int *p = row[i];
        int k;
        while ((k = *p++) != -1 && *p++ > 5) // EXPECT: refuse trip-count
            b[k]++;
    }
}

void condition_by_header(int n, int *const *row, int *b) {
    int k;
    for (int i = 0; i < n; i++)
        for (int j = 0; (k = row[i][j++]) > -1 && row[i][j] < 9; j++) // EXPECT: refuse trip-count
            b[k]++;
}
