/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Stores with a read of the same array that cannot be made after all iterations, or that need more than that. */
// covers: row 93
static double *shared, one[1000];
static _Thread_local double own[1000];
static volatile double moving[1000];

void some_iterations_go_on(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        if (r[i] == 3)
            continue;
        t[i] = 0;
    }
}

void read_after(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        const double v = t[i];
        t[i] = 0;
        y[r[i]] -= v + t[i];
    }
}

void the_next_is_read(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i] + t[i + 1];
        t[i] = 0;
    }
}

void another_is_stored(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        t[i + 1] = 0;
    }
}

void read_by_another_pointer(int n, const int *r, double *y, double *t, const double *u) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i] * u[i];
        t[i] = 0;
    }
}

void read_as_bytes(int n, const unsigned char *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        t[i] = 0;
    }
}

void read_in_some_iterations(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        if (r[i] > 0)
            y[r[i]] -= t[i];
        t[i] = 0;
    }
}

void several_of_one(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        y[r[i]] -= t[i / 2];
        t[i / 2] = 0;
    }
}

void narrow_subscript(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[(unsigned char)i];
        t[(unsigned char)i] = 0;
    }
}

void subscript_moves(int n, const int *r, double *y, double *t, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        y[r[i]] -= t[i - k];
        t[i - k] = 0;
        k += r[i] & 1;
    }
}

void value_is_of_the_iteration(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        const double v = t[i] * 2;
        y[r[i]] -= v;
        t[i] = v;
    }
}

void value_is_stepped(int n, const int *r, double *y, double *t, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        t[i] = k;
        k += 2;
    }
}

void condition_is_of_the_iteration(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        const int k = r[i];
        y[k] -= t[i];
        if (k > 7)
            t[i] = 0;
    }
}

void other_branch(int n, const int *r, double *y, double *t, double limit) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        if (t[i] > limit)
            t[i] = 0;
        else
            t[i] = 1;
    }
}

void in_a_loop_inside(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        for (int k = 0; k < r[i]; k++)
            t[i] = 0;
    }
}

void pointer_may_be_stored_to(int n, const int *r, double *y, double **others) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= shared[i];
        shared[i] = 0;
        others[i] = y;
    }
}

void of_the_thread(int n, const int *r, double *y) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse thread-local
        y[r[i]] -= own[i];
        own[i] = 0;
    }
}

void of_moving(int n, const int *r, double *y) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse volatile
        y[r[i]] -= moving[i];
        moving[i] = 0;
    }
}

void one_array(int n, const int *r) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        one[r[i]] -= one[i];
        one[i] = 0;
    }
}

void condition_reads_after(int n, const int *r, double *y, double *t) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        t[i] = 0;
        if (t[i] == 0)
            t[i] = 1;
    }
}

void condition_reads_memory(int n, const int *r, double *y, double *t, const int *limit) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        if (*limit > i)
            t[i] = 0;
    }
}

void condition_rounds(int n, const int *r, double *y, double *t, double by) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        y[r[i]] -= t[i];
        if (t[i] * by + 1.0 > 2.0)
            t[i] = 0;
    }
}
