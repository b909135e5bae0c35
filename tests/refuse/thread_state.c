/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions whose result depends on the calling thread.
#include <errno.h>
#include <pthread.h>

__attribute__((const)) const double *own_table(int k);

void reads_errno(int n, const int *restrict s, int *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += errno;
}

void asks_who(int n, const int *restrict s, int *restrict h, pthread_t first) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += pthread_self() == first;
}

void follows_address(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse thread-state
        h[s[t]] += own_table(t)[0];
}

__attribute__((pure)) double level(int k);
__attribute__((const)) double scaled(double v);

void reads_perhaps_its_own(int n, const int *restrict s, double *restrict h) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        h[s[t]] += level(t);
}

void is_perhaps_its_own(int n, const int *restrict s, double *restrict h, const double *restrict v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse unseen-pure
        h[s[t]] += scaled(v[t]);
}

#define ELSEWHERE __attribute__((address_space(256)))

void in_an_address_space(int n, const int *restrict s, double *restrict h, const double ELSEWHERE *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse address-space
        h[s[t]] += v[t];
}

void updates_an_address_space(int n, const int *restrict s, double ELSEWHERE *h, const double *v) {
    for (int t = 0; t < n; t++) // EXPECT: refuse address-space
        h[s[t]] += v[t];
}
