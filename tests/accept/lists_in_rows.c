/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Lists whose end an element tells, as inner loops: the list of a row is read in the inner loop's condition. The array
// that is updated is apart from the lists, or overlaps them, perhaps only behind their first elements, so that updates
// change what later rows read.
// THREADS: 1 2 3 7 16 33
// INTEGERS: no
// COMPILERS: gcc clang-19
// MAY-RUN-SERIALLY: lists that overlap the array make the loops sequential
#include "case.h"

enum { ROWS = 500, LONGEST = 12, TAIL = 600, M = 900, END = -1, LISTS = ROWS * LONGEST + TAIL + 1 };
static int pool[LISTS + 2 * M];
static int *rows[ROWS];

__attribute__((noinline)) static void stepped(int n, int *const *row, int *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        int k;
        const int *p = row[i];
        while ((k = *p++) != END)
            b[k]++;
    }
}

__attribute__((noinline)) static void by_subscript(int n, int *const *row, int *b) {
    int j, k;
    for (int i = 0; i < n; i++) // EXPECT: transformed
        for (j = 0; (k = row[i][j]) > -1; j++)
            b[k] += 2;
}

__attribute__((noinline)) static void by_pointer(int n, int *const *row, int *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        for (const int *p = row[i]; *p != END; p++) {
            if (*p == 7)
                continue;
            b[*p] += 1;
        }
    }
}

__attribute__((noinline)) static void at_the_end(int n, int *const *row, int *b) {
    for (int i = 0; i < n; i++) { // EXPECT: transformed
        const int *p = row[i];
        int count = 0;
        while (count < 400 && *p > END) {
            const int k = *p;
            b[k + (count & 1)]++;
            if (k == 49)
                break;
            count++;
            p++;
        }
    }
}

__attribute__((noinline)) static void of_two(int n, int *const *row, int *b) {
    int k;
    for (int i = 0; i + 1 < n; i++) { // EXPECT: transformed
        const int *p = row[i], *q;
        while ((k = *p++) >= 0)
            for (q = row[i + 1]; *q >= 0 && q < row[i + 1] + 20; q++)
                b[k + *q]++;
    }
}

__attribute__((noinline)) static void halves(int n, int *const *row, int *b) {
    int i, s, k, j;
    for (i = 0; i < n / 2; i++) // EXPECT: transformed
        for (s = 0; s < 2; s++)
            for (j = 0; (k = row[2 * i + s][j]) > -1; j++)
                b[k]++;
}

/* Makes rows of at most LONGEST - 1 elements, and a last one of TAIL elements. All elements are far below M. */
static void make_rows(void) {
    int *at = pool;
    for (int i = 0; i < ROWS; i++) {
        const int length = i == ROWS - 1 ? TAIL : i % LONGEST;
        rows[i] = at;
        for (int c = 0; c < length; c++)
            *at++ = case_below(50);
        *at++ = END;
    }
    for (; at < pool + sizeof pool / sizeof *pool; at++)
        *at = 0;
}

int main(void) {
    static void (*const calls[])(int, int *const *, int *) = {stepped, by_subscript, by_pointer, at_the_end, of_two, halves};
    for (unsigned c = 0; c < sizeof calls / sizeof *calls; c++)
        for (int apart = 0; apart < 3; apart++) {
            make_rows();
            int *last = rows[ROWS - 1];
            /* after all lists; behind the first elements of the last one; there, with its end in it */
            int *b = apart == 0 ? pool + LISTS : last + (apart == 1 ? 5 : TAIL - 300);
            calls[c](ROWS, rows, b);
            calls[c](ROWS, rows, b);
            CASE_PRINT(pool);
        }
    return 0;
}
