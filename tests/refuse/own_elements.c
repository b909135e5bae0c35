/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// An element is read and stored to, but may not belong to this iteration alone.
// covers: row 93 of docs/constructs.md
struct particle {
    double x, v;
    unsigned flag : 3;
};
union word {
    int i;
    float f;
};
static int next_of(const int *m, int i) {
    return m[i] + 1;
}
static void put(int *m, int v) {
    if (*m < v)
        *m = v;
}

/* Two iterations may share an element. */
void by_index(int n, const int *restrict k, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse index-array-written
        const int v = m[k[i]] * 5 % 1000;
        m[k[i]] = v;
        c[v]++;
    }
}

void by_halves(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        m[i / 2] = m[i / 2] * 5 % 1000;
        c[m[i / 2]]++;
    }
}

void narrow(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        m[(unsigned char)i] = m[(unsigned char)i] * 5 % 1000;
        c[m[(unsigned char)i]]++;
    }
}

/* Another iteration reads the element. */
void neighbour(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        m[i] = (m[i] + m[i + 1]) % 1000;
        c[m[i]]++;
    }
}

void in_a_call(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse callee-reads
        m[i] = m[i] * next_of(m, i) % 1000;
        c[m[i]]++;
    }
}

void by_another_name(int n, int *restrict m, int *restrict c) {
    const int *behind = m - 1;
    for (int i = 1; i < n; i++) { // EXPECT: refuse array-read
        m[i] = (m[i] + behind[i]) % 1000;
        c[m[i]]++;
    }
}

/* `m` may overlap `k`, which the inspector would read before it is updated. */
void perhaps_subscripts(int n, const int *k, int *m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        m[i] = m[i] * 5 % 1000;
        c[k[m[i]]]++;
    }
}

/* The pointer to the array changes, or may change. */
int *shared;
void of_a_global(int n, const int *restrict k, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        shared[i] = shared[i] * 5 % 1000;
        c[k[i]] += shared[i];
    }
}

/* In some iterations the element may not exist. */
void under_a_condition(int n, const int *restrict k, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) // EXPECT: refuse index-array-written
        if (k[i]) {
            if (m[i] != k[i])
                m[i] = k[i];
            c[m[i]]++;
        }
}

/* The element's address is used, or its bytes are accessible through other names. */
void by_address(int n, int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        c[m[i]]++;
        put(&m[i], 5);
    }
}

void as_address(int n, const int *restrict k, int *restrict m, int *restrict c, const int *end) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        m[i] = m[i] * 5 % 1000;
        if (&m[i] < end)
            c[k[m[i]]]++;
    }
}

void of_a_union(int n, union word *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse union
        m[i].i = m[i].i * 5 % 1000;
        c[m[i].i]++;
    }
}

void of_bits(int n, struct particle *restrict p, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse bit-field
        p[i].flag = p[i].flag + 1u;
        c[p[i].flag]++;
    }
}

void as_observed(int n, volatile int *restrict m, int *restrict c) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse volatile
        m[i] = m[i] * 5 % 1000;
        c[m[i]]++;
    }
}

/* The loop copies the whole record. */
void as_a_record(int n, struct particle *restrict p, const int *restrict k, double *restrict h) {
    for (int i = 0; i < n; i++) { // EXPECT: refuse array-read
        struct particle q = p[i];
        p[i].x += q.v;
        h[k[i]] += p[i].x;
    }
}
