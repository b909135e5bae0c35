/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Unsigned subscripts that wrap around in iterations that do not read, or between two iterations that
// do. An if, a continue, a conditional expression, a block or a conversion skips reads. The extent of
// x must contain all elements read, or the guard misses the overlap with h.
#include <stdio.h>
#include <sys/mman.h>

enum { N = 4000 };
static double memory[4 * N];
static int k[N];

#define KEEP __attribute__((noipa)) static

KEEP void jumped(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: parallel
        if (t == 0)
            continue;
        h[k[t]] += x[t - 1];
    }
}

KEEP void apart(unsigned n, unsigned u, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: parallel
        double v = 0.5;
        if (t >= u)
            v = x[t - u];
        h[k[t]] += v;
    }
}

KEEP void threefold(unsigned n, unsigned u, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += t * 3 >= u ? x[t * 3 - u] : 2.0;
}

KEEP void chosen(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += t ? x[t - 1] : 2.0;
}

KEEP void joined(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: parallel
        double v = 1.0;
        if (t != 0 && x[t - 1] > 0.001)
            v = 3.0;
        h[k[t]] += v;
    }
}

KEEP void marked(unsigned n, const int *mark, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: parallel
        double v = 1.0;
        if (mark[t])
            v = x[t - 1u];
        h[k[t]] += v;
    }
}

KEEP void signed_again(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += t > 0 ? x[(int)(t - 1)] : 2.0;
}

KEEP void widened(unsigned n, unsigned long u, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += t > 0 ? x[u + (t - 1)] : 2.0;
}

KEEP void down(unsigned n, const double *x, double *h) {
    for (unsigned t = n; t > 0; t--) { // EXPECT: parallel
        double v = 1.0;
        if (t < n)
            v = x[n - 1 - t];
        h[k[t - 1]] += v;
    }
}

KEEP void pointer(unsigned n, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: parallel
        h[k[t]] += t > 0 ? *(x + (t - 1)) : 2.0;
}

/* a case label inside the condition's branch */
KEEP void labelled(unsigned n, const int *mark, const double *x, double *h) {
    for (unsigned t = 0; t < n; t++) { // EXPECT: transformed
        double v = 1.0;
        switch (mark[t]) {
        case 0:
            if (t > 5) {
            case 1:
                v = x[t + 7];
            }
        }
        h[k[t]] += v;
    }
}

/* each iteration reads, and t + u wraps around at 2^32 */
KEEP void around(unsigned n, unsigned u, const unsigned char *x, int *h) {
    for (unsigned t = 0; t < n; t++) // EXPECT: transformed
        h[k[t]] += x[t + u] + 1;
}

static double sum_of(const double *p, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += p[i] * (i % 7);
    return sum;
}

static void fill(void) {
    for (int i = 0; i < 4 * N; i++)
        memory[i] = 1.0 / (i + 1);
}

static void far(void) {
    const size_t size = ((size_t)1 << 32) + 65536;
    unsigned char *all = mmap(NULL, size, PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED)
        return;
    for (int r = 0; r < 3; r++)
        around(N, 0u - N / 2, all, (int *)all);
    long sum = 0;
    for (int i = 0; i < 4 * N; i++)
        sum += all[i] * (i % 7);
    printf("%ld\n", sum);
}

int main(void) {
    static int mark[N];
    for (int i = 0; i < N; i++) {
        k[i] = (int)((i * 2654435761u) % (N - 9));
        mark[i] = i % 3 == 1;
    }
    for (int apart_by = 0; apart_by <= 2 * N; apart_by += 2 * N)
        for (int r = 0; r < 3; r++) {
            fill();
            double *h = memory + apart_by;
            jumped(N, memory, h);
            apart(N, 5, memory, h);
            threefold(N / 4, 5, memory, h);
            chosen(N, memory, h);
            joined(N, memory, h);
            marked(N, mark, memory, h);
            signed_again(N, memory, h);
            widened(N, 2, memory, h);
            down(N, memory, h);
            pointer(N, memory, h);
            labelled(N, mark, memory, h);
            printf("%a\n", sum_of(memory, 4 * N));
        }
    far();
    return 0;
}
