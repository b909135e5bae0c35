/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// METHODS: auto binning binning:records binning:copies localwrite
// An element that is updated twice may have its first value in the end, as after two `^= 2` or after
// `+= 1` and `+= -1`. Its private copies are then neutral, as if nothing had updated it. But if x and
// h overlap, the second of two iterations with the same t & ~1 may read what the first one has
// updated, as x[4] = 1 is h[1].
#include <stdio.h>
#include <string.h>

enum { N = 4096, ROWS = 16, READ = 128 };
static int memory[READ + ROWS];
static const int first[READ] = {1, 4, 3, 2, 1, 6, 3, 8, 5, 12, 7, 0, 9, 1, 11, 2, 13};
static int sign[N];

__attribute__((noipa)) static void flipped(int n, const int *x, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[(unsigned)x[t & (READ - 2)] % ROWS] ^= 2;
}

__attribute__((noipa)) static void added(int n, const int *x, const int *s, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[(unsigned)x[t & (READ - 2)] % ROWS] += s[t];
}

__attribute__((noipa)) static void multiplied(int n, const int *x, const int *s, unsigned *h) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h[(unsigned)x[t & (READ - 2)] % ROWS] *= s[t] > 0 ? 3u : 0xaaaaaaabu; /* 3 times this is 1 */
}

/* Here nothing that is read is updated. */
__attribute__((noipa)) static void apart(int n, const int *x, int *h) {
    for (int t = 0; t < n; t++) // EXPECT: parallel
        h[(unsigned)x[t & (READ - 2)] % ROWS] ^= 2;
}

static void fill(void) {
    memset(memory, 0, sizeof memory);
    memcpy(memory, first, sizeof first);
}

static void print(void) {
    unsigned sum = 0;
    for (int i = 0; i < READ + ROWS; i++)
        sum = sum * 31u + (unsigned)memory[i];
    printf("%x\n", sum);
}

int main(void) {
    for (int t = 0; t < N; t++)
        sign[t] = t % 2 ? -1 : 1;
    /* each of 1, 2, 3 or 7 threads gets an even number of iterations */
    for (int n = 84; n <= N; n += n) {
        fill();
        flipped(n, memory, memory + 3);
        print();
        fill();
        added(n, memory, sign, memory + 3);
        print();
        fill();
        multiplied(n, memory, sign, (unsigned *)(memory + 3));
        print();
        fill();
        apart(n, memory, memory + READ);
        print();
    }
}
