/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// The updated array contains the pointer to itself. Iterations are so short, and subscripts so scattered,
// that the inspection is postponed. One thread executes the loop to time it, but only after the guard.
// covers: row 29 of docs/constructs.md
// MAY-RUN-SERIALLY: array and pointer overlap
#include <string.h>

#include "case.h"

enum { N = 400000, ROOM = 1 << 22, OTHER = ROOM / 2, ALIGNED = 1 << 24 };
typedef struct histogram {
    unsigned char *bin;
    unsigned char room[ROOM];
} histogram;

static int s[N];

__attribute__((noipa)) static void count(histogram *h, const int *subscript, int n) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        h->bin[subscript[t]] += 1;
}

int main(void) {
    histogram *one = aligned_alloc(ALIGNED, ALIGNED); /* aligned so that the pointer's third byte is 0 */
    if (!one)
        return 1;
    memset(one, 0, sizeof *one);
    for (int round = 0; round < 3; round++) {
        one->bin = (unsigned char *)one;
        for (int t = 0; t < N; t++)
            s[t] = (int)sizeof one->bin + case_below(OTHER);
        s[N / 2] = 2; /* this update adds 65536 to the pointer */
        count(one, s, N);
        CASE_PRINT(one->room);
        printf("%ld\n", (long)(one->bin - (unsigned char *)one));
    }
    free(one);
    return 0;
}
