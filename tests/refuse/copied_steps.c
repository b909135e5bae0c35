/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Loops that differ in one point from those of accept/copied_steps.c: the copies do not add the
// same amount in each iteration.
// covers: row 79 of docs/constructs.md
enum { N = 4000 };
extern int s[N];
extern double e[N], h[N];

void step_changes(const double *p, int n, int m) {
    const double *q;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        q = p + m;
        h[s[i]] += *p - *q;
        p = q + m;
        m++;
    }
}

void step_is_updated(int *sizes, int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        next = k + sizes[0];
        sizes[s[i]] += e[k] > 0;
        k = next + 1;
    }
}

void step_by_address(int n, int k, int by, int **out, int *q) {
    int next;
    *out = &by;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + by;
        q[s[i]] += 3;
        h[s[i]] += e[k];
        k = next + 1;
    }
}

void conditional_step(int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + 1;
        h[s[i]] += e[k];
        if (s[i] > 3)
            next++;
        k = next;
    }
}

void conditional_copy(int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + 1;
        h[s[i]] += e[k];
        if (s[i] > 3)
            k = next;
    }
}

void copy_after_continue(int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + 1;
        if (s[i] % 3 == 0)
            continue;
        h[s[i]] += e[k];
        k = next;
    }
}

/* `k` gets the value of the iteration before, so its first value differs. */
void copied_late(int n, int k, int next) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k = next + 2;
        next = k + 1;
    }
}

void exchanged(int n, int k, int other) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int old = k;
        h[s[i]] += e[k];
        k = other + 1;
        other = old + 1;
    }
}

void of_element(int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + 1;
        h[s[i]] += e[k];
        k = s[next] + 1;
    }
}

void value_of_subscript(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int *p = s + k;
        h[s[i]] += e[k];
        k = p[2];
    }
}

void doubled(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int half = k;
        h[s[i]] += e[k];
        k = half + half;
    }
}

void subtracted_from(int n, int k, int m) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int old = k + 1;
        h[s[i]] += e[k];
        k = m - old;
    }
}

/* A narrow variable loses a part of the value. */
void narrowed(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const unsigned char low = k + 3;
        h[s[i]] += e[k];
        k = low + 1;
    }
}

void narrowed_by_cast(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int next = (signed char)(k + 3);
        h[s[i]] += e[k];
        k = next + 1;
    }
}

void through_double(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const int next = k + 3.5;
        h[s[i]] += e[k];
        k = next + 1;
    }
}

/* The step counts elements of another size. */
void other_elements(const double *p, int n, int m) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        const char *q = (const char *)p + m;
        h[s[i]] += *p;
        p = (const double *)q + m;
    }
}

void in_an_inner_loop(int n, int k) {
    int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k;
        h[s[i]] += e[k];
        for (int c = 0; c < s[i] % 5; c++)
            next++;
        k = next;
    }
}

void copy_through_address(int n, int k) {
    int next;
    int *const here = &next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        next = k + 1;
        h[s[i]] += e[k];
        *here += s[i];
        k = next;
    }
}

extern int shared;

void copy_in_global(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse other-store
        shared = k + 1;
        h[s[i]] += e[k];
        k = shared;
    }
}

void copy_in_static(int n, int k) {
    static int next;
    for (int i = 0; i < n; i++) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k = next + 1;
        next = k + 1;
    }
}

void in_order_of_text(int n, int k) {
    int next = k;
    for (int i = 0; i < n; i++, next = k + 2) { // EXPECT: refuse scalar-carried
        h[s[i]] += e[k];
        k = next + 1;
        k = i;
    }
}

void volatile_copy(int n, int k) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse volatile
        volatile int next = k + 1;
        h[s[i]] += e[k];
        k = next;
    }
}
