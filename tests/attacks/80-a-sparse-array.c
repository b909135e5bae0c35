/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* An array of 96 GB, of which a few thousand rows are touched (Linux). A method's memory must depend on
 * the number of rows touched, not on the distance between them. */
// METHODS: auto binning localwrite graph-localwrite graph-localwrite-steal wavefront
// THREADS: 1 2 7
// SECONDS: 20
#define _GNU_SOURCE
#include <stdio.h>
#include <sys/mman.h>
#include <sys/resource.h>

struct row {
    double v[8];
};
enum { N = 4000, TOUCHED = 700 };
static const size_t rows = (size_t)96 << 30 >> 6;
static int k[N], m[N];

__attribute__((noinline)) static void fill(struct row *h) {
    for (int t = 0; t < N; t++) { // EXPECT: parallel
        h[k[t]].v[0] += 1.0 / (1 + t);
        h[m[t]].v[1] -= 1.0 / (2 + t);
    }
}

int main(void) {
    struct row *h = mmap(NULL, rows * sizeof *h, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (h == MAP_FAILED)
        return 1;
    for (int t = 0; t < N; t++) {
        k[t] = (int)(t * 7919LL % TOUCHED * (long long)(rows / TOUCHED));
        m[t] = (int)(t * 104729LL % TOUCHED * (long long)(rows / TOUCHED));
    }
    for (int round = 0; round < 3; round++)
        fill(h);
    double sum = 0;
    for (int t = 0; t < N; t++)
        sum = sum * 0.9 + h[k[t]].v[0] + h[m[t]].v[1];
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    printf("%a%s\n", sum, used.ru_maxrss > 300 * 1024 ? ", and a table of what lies between" : "");
    return 0;
}
