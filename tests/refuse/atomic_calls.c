/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Updates by atomic operations, under OpenMP directives of called functions, under locks and in other files: each loop
 * is listed, however deep its update is hidden. Loops that only load, or store values of their own, are not. */
// FLAGS: -fopenmp
#include <stdatomic.h>

enum { N = 1000 };
static int s[N], count[N];
static double h[N], e[N], f[N][3];
static _Atomic int shared[N];
static atomic_long wide[N];
static atomic_flag flag[N];

/* ---- directives in called functions ---------------------------------------------------------- */

static void add(double *x, double v) {
#pragma omp atomic
    *x += v;
}
static void add_at(double *x, int k, double v) {
#pragma omp critical(adds)
    x[k] += v;
}
static void add_global(int k, double v) {
#pragma omp atomic
    h[k] += v;
}
static void add_row(double (*x)[3], const double *v) {
    for (int i = 0; i < 3; i++) // EXPECT: unlisted
#pragma omp atomic
        (*x)[i] += v[i];
}
static void add_deeper(double *x, double v) {
    add(x, 2 * v);
}
static double read(const double *x) {
    double v;
#pragma omp atomic read
    v = *x;
    return v;
}

void directives(int n, double *out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add(&h[s[t]], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add_at(h, s[t], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add_global(s[t], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add_row(&f[s[t]], f[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add_deeper(&h[s[t]], e[t]);
#pragma omp parallel for
    for (int t = 0; t < n; t++) // EXPECT: refuse existing-openmp
        add(&h[s[t]], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        add(&h[t], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        out[t] = read(&h[s[t]]);
}

/* ---- operations of the compiler -------------------------------------------------------------- */

#define INCREASE(p, v) __atomic_fetch_add(p, v, __ATOMIC_RELAXED)

static void fetch(int *x, int v) {
    __sync_fetch_and_add(x, v);
}
static void fetch_global(int k) {
    __atomic_fetch_add(&count[k], 1, __ATOMIC_RELAXED);
}
static void fetch_deeper(int *x) {
    fetch(x, 2);
}

void builtins(int n) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        fetch(&count[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        fetch_global(s[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        fetch_deeper(&count[s[t]]);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        INCREASE(&count[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        __atomic_store_n(&count[s[t]], count[s[t]] + 2, __ATOMIC_RELAXED);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        __atomic_store_n(&count[s[t]], t, __ATOMIC_RELAXED);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        fetch(&count[t], 2);
}

/* ---- <stdatomic.h> --------------------------------------------------------------------------- */

static void increase(_Atomic int *x, int v) {
    atomic_fetch_add_explicit(x, v, memory_order_relaxed);
}
static void increase_plainly(_Atomic int *x, int v) {
    *x += v;
}

int standard(int n) {
    int all = 0;
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        atomic_fetch_add(&shared[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        atomic_fetch_sub_explicit(&wide[s[t]], 2, memory_order_relaxed);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        increase(&shared[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        increase_plainly(&shared[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse volatile
        shared[s[t]] += 2;
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        int old = atomic_load(&shared[s[t]]);
        while (!atomic_compare_exchange_weak(&shared[s[t]], &old, old + 2)) // EXPECT: unlisted
            ;
    }
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        atomic_store(&shared[s[t]], shared[s[t]] + 2);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        if (atomic_flag_test_and_set(&flag[s[t]]))
            count[t] = 1;
#pragma omp parallel for
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        atomic_fetch_add(&shared[s[t]], 2);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        atomic_store(&shared[s[t]], t);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        atomic_fetch_add(&shared[t], 2);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        all ^= atomic_load(&shared[s[t]]);
    return all;
}

/* ---- functions of other files ---------------------------------------------------------------- */

void accumulate(double *x, double v);
double inspect(const double *x);
void advance(double *x, int step);

void elsewhere(int n, double *out) {
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        accumulate(&h[s[t]], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: refuse impure-call
        accumulate(h + s[t], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        accumulate(&h[t], e[t]);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        out[t] = inspect(&h[s[t]]);
    for (int t = 0; t < n; t++) // EXPECT: unlisted
        advance(h, t);
}

/* ---- locks ----------------------------------------------------------------------------------- */

typedef struct omp_lock_t {
    void *lock;
} omp_lock_t;
void omp_set_lock(omp_lock_t *);
void omp_unset_lock(omp_lock_t *);

void locks(int n, omp_lock_t *lock) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse impure-call
        omp_set_lock(lock);
        h[s[t]] += e[t];
        omp_unset_lock(lock);
    }
}
