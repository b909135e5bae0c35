/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Directives within a loop that must not occur in a second copy, or conditional groups that begin
// or end inside the loop.
// covers: row 3 of docs/constructs.md
#define TABLE_OF(t) k[t]
#define UNIQUE __COUNTER__

void defines(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#define STEP 2
        h[k[t]] += STEP;
#undef STEP
    }
}

void defines_elsewhere(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#ifdef OTHER
#define STEP 2
#endif
        h[k[t]] += 1;
    }
}

void head_in_a_branch(int n, const int *k, double *h) {
#ifdef BACKWARDS
    for (int t = n - 1; t >= 0; t--) {
#else
    for (int t = 0; t < n; t++) { // EXPECT: nothing
#endif
        h[k[t]] += 1;
    }
}

void begins_in_a_branch(int n, const int *k, double *h) {
#ifndef OTHER
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#else
    int t = 0; {
#endif
        h[k[t]] += 1;
    }
}

void ends_in_a_branch(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse directive-in-range
#ifdef OTHER
        h[k[t]] += 2;
#else
        h[k[t]] += 1;
#endif
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        h[k[t]] += 2;
#ifndef OTHER
    }
#endif
#ifdef OTHER
    }
#endif
}

/* HINT is in the branch that is compiled, and it may apply to the loop. */
#define HINT
void hint_in_a_branch(int n, const int *k, double *h) {
    h[0] = 0;
#ifdef OTHER
    h[0] = 1;
#else
    HINT
#endif
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
        h[k[t]] += 1;
    }
}

void before_the_semicolon(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse directive-in-range
        h[k[t]] += 1
#ifdef OTHER
            , h[0] = 1
#endif
        ;
}

void pragma_inside(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#ifndef OTHER
#pragma GCC diagnostic push
#endif
        h[k[t]] += 1;
    }
}

void pragma_that_means_something(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#pragma STDC FP_CONTRACT OFF
        h[k[t]] += 1;
    }
    for (int t = 0; t < n; t++) { // EXPECT: refuse directive-in-range
#pragma GCC ivdeps
        h[k[t]] += 1;
    }
}

int counts_compilations(int n, const int *k, double *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse counter-macro
#if UNIQUE == 0
        h[k[t]] += 1;
#endif
    }
    return UNIQUE;
}
