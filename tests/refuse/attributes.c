/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// Attributes and builtins that give a statement effects beyond those of its text.
// covers: row 57, row 61, row 62, row 63 of docs/constructs.md
void atomic_elsewhere(int n, const int *k, int *h, int *total) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        h[k[t]] += 1;
        __sync_fetch_and_add(total, 1);
    }
}

void stack_memory(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int *p = __builtin_alloca(8);
        p[0] = 1;
        h[k[t]] += p[0];
    }
}

void trapping(int n, const int *k, int *h) {
    for (int t = 0; t < n; t++) { // EXPECT: refuse no-return
        while (k[t] < 0)
            __builtin_trap();
        h[k[t]] += 1;
    }
}

void computed_goto(int n, const int *k, int *h) {
    void *to = &&update;
    for (int t = 0; t < n; t++) { // EXPECT: refuse goto
        goto *to;
    update:
        h[k[t]] += 1;
    }
}

void size_with_effect(int n, const int *k, int *h) {
    int m = 3;
    for (int t = 0; t < n; t++) // EXPECT: nothing
        h[k[t]] += (int)sizeof(int[m++]);
}

void length_with_effect(int n, const int *k, int *h) {
    int m = 3;
    for (int t = 0; t < n; t++) { // EXPECT: nothing
        int q[m++];
        q[0] = 1;
        h[k[t]] += q[0];
    }
}

#define RUN(...) __VA_ARGS__
void in_an_argument(int n, const int *k, int *h) {
    RUN(for (int t = 0; t < n; t++) h[k[t]] += 1;) // EXPECT: refuse in-macro
}
