/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Functions that answer each thread otherwise.
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
