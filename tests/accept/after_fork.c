/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// A child of fork has only the thread that called fork. A parallel loop runs sequentially in the
// child and does not wait for the parent's other threads.
// covers: row 72 of docs/constructs.md
// INTEGERS: no
#include <sys/wait.h>
#include <unistd.h>

#include "case.h"

enum { N = 9000, M = 500 };
static int k[N];
static double h[M], w[N];

__attribute__((noipa)) static void accumulate(int n, double *to) {
    for (int t = 0; t < n; t++) // EXPECT: transformed
        to[k[t]] += w[t];
}

static void print_after_one_more(const char *name) {
    accumulate(N, h);
    case_print(name, h, sizeof h);
    fflush(stdout);
}

int main(void) {
    case_subscripts(k, N, M);
    case_values(w, N);
    print_after_one_more("before");
    const pid_t child = fork();
    if (child == 0) {
        print_after_one_more("child");
        const pid_t grandchild = fork();
        if (grandchild == 0) {
            print_after_one_more("grandchild");
            _exit(0);
        }
        waitpid(grandchild, NULL, 0);
        _exit(0);
    }
    waitpid(child, NULL, 0);
    print_after_one_more("parent");
    return 0;
}
