// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Objects, read or updated, in an address space that has another base in each thread (__seg_gs of x86).
// For comparison: the same loops in the default address space.
// COMPILERS: gcc
#include <stdio.h>
#ifdef __x86_64__
#include <sys/syscall.h>
#include <unistd.h>
#define OWN __seg_gs
#else
#define OWN
#endif

enum { N = 20000, K = 300 };
static int s[N];
static double x[N], h[K], own[K];
struct part {
    double of[2];
};

#ifdef __x86_64__
static void read_there(int n, const double OWN *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse address-space
        h[s[t]] += v[s[t]];
}

static double first(const struct part OWN *p) {
    return p->of[1];
}

static void read_by_a_function(int n, const struct part OWN *p) {
    for (int t = 0; t < n; t++) // EXPECT: refuse address-space
        h[s[t]] += first(p) + x[t];
}

static void update_there(int n, double OWN *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse address-space
        v[s[t]] += x[t];
}

static void add_up_there(int n, double OWN *sum) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse address-space
        h[s[t]] += x[t];
        *sum += x[t];
    }
}

/* Only the pointer's value is used, which is the same in all threads. */
static void an_address_alone(int n, const double OWN *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse text
        h[s[t]] += v ? x[t] : 1;
}

enum { SET_GS = 0x1001 };
#endif

static void as_usual(int n, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[s[t]] += v[s[t]];
}

int main(void) {
    for (int t = 0; t < N; t++) {
        s[t] = (int)((t * 7919LL + t / 3) % K);
        x[t] = 1.0 + (t * 31 % 997) * 0.01;
    }
    for (int i = 0; i < K; i++)
        own[i] = i * 0.5;
#ifdef __x86_64__
    if (syscall(SYS_arch_prctl, SET_GS, own))
        return 1;
    read_there(N, (const double OWN *)8);
    read_by_a_function(N, (const struct part OWN *)16);
    update_there(N, (double OWN *)0);
    add_up_there(N, (double OWN *)24);
    an_address_alone(N, (const double OWN *)8);
#endif
    as_usual(N, own);
    for (int i = 0; i < K; i++)
        printf("%a %a\n", h[i], own[i]);
    return 0;
}
