/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops without a bound, whose end cannot be searched for in advance: the loop may write what tells the end, or the
// condition has effects or depends on a sum. Or the search takes as long as the loop.
/* An update may set an element of the list to -1, or may replace the end. */
void same_type(int n, const int *list, int *h) {
    for (int i = 0; list[i] != -1; i++) { // EXPECT: refuse text
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
    }
}

void itself(int n, int *list) {
    for (int i = 0; list[i] != -1; i++) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            list[list[i]] += c;
    }
}

void changing(int n, const volatile int *list, double *h) {
    for (int i = 0; list[i] != -1; i++) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
    }
}

int next(void);
void effect(int n, const int *list, double *h) {
    for (int i = 0; list[i] != next(); i++) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
    }
}

int state;
void global(int n, const int *list, double *h) {
    for (int i = 0; (state = list[i]) != -1; i++) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
    }
}

void sum(int n, const int *list, double *h) {
    double all = 0;
    for (int i = 0; all < 100; i++) { // EXPECT: refuse trip-count
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
        all += list[i];
    }
}

/* The sum's operands need memory for each iteration. */
double operands(int n, const int *list, double *h) {
    double all = 0;
    for (int i = 0; list[i] != -1; i++) { // EXPECT: refuse text
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
        all += 0.5;
    }
    return all;
}

void light(int n, const int *list, double *h) {
    for (int i = 0; list[i] != -1; i++) { // EXPECT: refuse trip-count
        h[list[i]] += 1;
    }
}

void other_step(int n, const int *list, const int *next_of, double *h) {
    for (int i = 0; list[i] != -1; i = next_of[i]) { // EXPECT: refuse step
        for (int c = 0; c < n; c++)
            h[list[i]] += c;
    }
}
