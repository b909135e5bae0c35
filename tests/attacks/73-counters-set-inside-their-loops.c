// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A loop's body sets the loop's counter under a condition of the iteration. With --lanes several
// iterations are executed at once, and none may leave the loop because another one does.
// OPTIONS: --lanes=4
// CFLAGS: -O1 -ffp-contract=off
// METHODS: localwrite localwrite-steal
#include <stdio.h>

enum { N = 9000, K = 300 };
static int s[N];
static double x[N], h[K];

/* Newton's method until it has converged. */
static void until_converged(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t], last;
        for (int step = 0; step < 20; step++) {
            last = r;
            r = 0.5 * (r + x[t] / r);
            const int converged = last - r < 1e-9;
            if (converged)
                step = 20;
        }
        h[s[t]] += r;
    }
}

static void declared_outside(int n) {
    int step;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        for (step = 0; step < 9; step += 1) {
            r = r * 0.75 + 0.125;
            if (r < 1.5)
                step += 3;
            else if (r > 3.0)
                step--, r -= 1.0;
        }
        h[s[t]] += r;
    }
}

/* A variable that some lanes set ends the loop two steps later. */
static void by_another(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        int last = 6;
        for (int step = 0; step < last; step++) {
            r = r * 0.5 + 1.0;
            if (r < 2.5)
                last = 3;
        }
        h[s[t]] += r;
    }
}

/* Two nested loops with one counter, the inner one under a condition. */
static void inside_itself(int n) {
    int step;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        for (step = 0; step < 8; step++) {
            r = r * 0.5 + 1.0;
            if (r < 2.25)
                for (step = 4; step < 7; step++)
                    r += 0.25;
        }
        h[s[t]] += r;
    }
}

/* The counter is set by && and by ?:. */
static void by_operators(int n) {
    int step;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        for (step = 0; step < 8; step++) {
            r = r * 0.5 + 1.0;
            r < 2.25 && (step = 7);
        }
        for (step = 0; step < 8; step++) {
            r = r * 0.75 + 1.0;
            r > 3.25 ? (step = 7) : (step += 0);
        }
        h[s[t]] += r;
    }
}

static void through_a_pointer(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        int step;
        int *const at = &step;
        for (step = 0; step < 8; step++) {
            r = r * 0.5 + 1.0;
            if (r < 2.25)
                *at = 7;
        }
        h[s[t]] += r;
    }
}

static void leave(int *step) {
    *step = 30;
}

static double in_a_function(double v) {
    double r = v;
    for (int step = 0; step < 9; step++) {
        r = r * 0.5 + 1.0;
        if (r < 2.25)
            step = 9;
    }
    return r;
}

static void in_functions(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = in_a_function(x[t]);
        for (int step = 0; step < 8; step++) {
            r = r * 0.5 + 1.0;
            if (r < 2.125)
                leave(&step);
        }
        h[s[t]] += r;
    }
}

static void by_while(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        int step = 0;
        while (step < 8) {
            r = r * 0.5 + 1.0;
            step += r < 2.25 ? 8 : 1;
        }
        do {
            r = r * 0.75 + 1.0;
            step--;
            if (r > 3.5)
                step = 0;
        } while (step > 0);
        h[s[t]] += r;
    }
}

/* The loop contains updates, which are made lane by lane. */
static void around_updates(int n) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        const double r = x[t] * 0.5;
        for (int c = 0; c < 4; c++) {
            h[s[t]] += r + c;
            if (r > 1.0)
                c = 3;
        }
    }
}

/* For comparison: conditions that are the same in all iterations. */
static void by_all(int n, int few) {
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        double r = x[t];
        for (int step = 0; step < 8; step++) {
            r = r * 0.5 + 1.0;
            if (few)
                step += 2;
            if (r < 2.5)
                for (int c = 0; c < 2; c++)
                    r += 0.25;
        }
        h[s[t]] += r;
    }
}

int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
    }
    for (int round = 0; round < 2; round++) {
        until_converged(N);
        declared_outside(N);
        by_another(N);
        inside_itself(N);
        by_operators(N);
        through_a_pointer(N);
        in_functions(N);
        by_while(N);
        around_updates(N);
        by_all(N, round);
    }
    for (int i = 0; i < K; i++)
        printf("%a\n", h[i]);
    return 0;
}
