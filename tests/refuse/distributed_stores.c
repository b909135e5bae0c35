/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Each iteration reads from and stores to one array, and the stores cannot be made after all iterations. */
// covers: row 93 of docs/constructs.md
static double *shared, one[1000];
static _Thread_local double own[1000];
static volatile double moving[1000];

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
