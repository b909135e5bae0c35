// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// An assignment in an operand that is never evaluated, such as sizeof's. After the loop it changes
// nothing, so the loop's last value is read. Within the loop it does not step a counter. For
// comparison: the same assignments where they are evaluated.
#include <stdio.h>

enum { N = 20000 };
static int s[N], h[64];

static __attribute__((noinline)) int constant(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    (void)__builtin_constant_p(x = 1);
    return x;
}

static __attribute__((noinline)) int size(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    (void)__builtin_object_size((x = 1, h), 0);
    return x;
}

static __attribute__((noinline)) int types(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    (void)__builtin_classify_type(x = 1);
    (void)_Generic((x = 1), int : 0, default : 1);
    (void)__builtin_choose_expr(1, 0, x = 1);
    (void)sizeof(x = 1);
    __typeof__(x = 1) y = 2;
    return x + y;
}

static __attribute__((noinline)) int step(int n) {
    int q = 0;
    for (int t = 0; t < n; t++) { // EXPECT: refuse opaque
        h[(s[t] + q) & 63] += 1;
        (void)__builtin_constant_p(q++);
    }
    return q;
}

static __attribute__((noinline)) int evaluated(int n) {
    int x = 7;
    for (int t = 0; t < n; t++) { // EXPECT: parallel
        x = s[t];
        h[x & 63] += 1;
    }
    return (int)__builtin_expect(x = 1, 1) + x;
}

int main(void) {
    for (int t = 0; t < N; t++)
        s[t] = (int)((unsigned)t * 7919u % 1000u) + 100;
    for (int again = 0; again < 20; again++)
        printf("%d %d %d %d %d\n", constant(N), size(N), types(N), step(N), evaluated(N));
    for (int i = 0; i < 64; i++)
        printf("%d\n", h[i]);
    return 0;
}
