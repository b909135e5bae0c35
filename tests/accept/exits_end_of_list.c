/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A list ends before the loop's bound, and an iteration leaves the loop there. The memory after the list cannot be read:
// no sample of the subscripts may read it.
// MAY-RUN-SERIALLY: one iteration always leaves, so the original loop runs
// COMPILERS: gcc clang-19
#include <sys/mman.h>
#include <unistd.h>

#include "case.h"

enum { N = 5000, M = 300 };
static double h[M], w[N];

__attribute__((noinline)) static int until_end(const int *list, int n) {
    for (int t = 0; t < n; t++) { // EXPECT: transformed
        if (list[t] == -1)
            return t;
        h[list[t]] += w[t];
    }
    return n;
}

/* The list's last element is the last one before a page that cannot be read. */
static int *new_list(void) {
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), bytes = (N * sizeof(int) / page + 1) * page;
    char *memory =
        mmap(NULL, bytes + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    mprotect(memory + bytes, page, PROT_NONE);
    int *list = (int *)(void *)(memory + bytes) - N;
    for (int t = 0; t < N - 1; t++)
        list[t] = t * 7 % M;
    list[N - 1] = -1;
    return list;
}

int main(void) {
    const int *list = new_list();
    int results[8];
    case_values(w, N);
    for (int call = 0; call < 8; call++)
        results[call] = until_end(list, 1 << 28);
    case_print("results", results, sizeof results);
    case_print("h", h, sizeof h);
    return 0;
}
