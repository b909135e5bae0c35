/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What generated programs share. With FUZZ_INTEGERS in the environment all values are small
 * integers, so that sums do not depend on the order in which they are made. No system header, so
 * that translating takes little time.
 */
#ifndef FUZZ_H
#define FUZZ_H

typedef __SIZE_TYPE__ size_t;
void *memset(void *to, int byte, size_t bytes);
void *memcpy(void *to, const void *from, size_t bytes);

/** An object that the program does not write while fuzz_hold(1) holds: it ends the program. */
#define FUZZ_HELD static __attribute__((section("fuzz_held"), aligned(4096)))
void fuzz_hold(int is_held);
void __assert_fail(const char *text, const char *file, unsigned line, const char *function)
    __attribute__((noreturn));
#define ASSERT(condition)                                                                          \
    ((condition) ? (void)0 : __assert_fail(#condition, __FILE__, __LINE__, __func__))
/** In another file: ends the program. */
void fuzz_fail(void) __attribute__((noreturn));
/** In another file: what each thread has for itself. */
double fuzz_level(int i) __attribute__((pure));
double fuzz_scaled(double v) __attribute__((const));

#define ADD(target, value) target += (value)

#define EACH(declared, i, n) for (declared = 0; i < n; i++)
#define PUT(array, k, value)                                                                       \
    do {                                                                                           \
        (array)[k] += (value);                                                                     \
    } while (0)

static inline double damp(double x) {
    return x > 9.0 ? 9.0 : x < -9.0 ? -9.0 : x;
}

enum fuzz_type {
    FUZZ_DOUBLE,
    FUZZ_FLOAT,
    FUZZ_LONG_DOUBLE,
    FUZZ_COMPLEX,
    FUZZ_INT8,
    FUZZ_INT16,
    FUZZ_INT32,
    FUZZ_INT64
};

/** Does the program take part? Not if FUZZ_LEFT_OUT has its seed: seeds with commas between them.
 */
int fuzz_runs(unsigned long long seed);
/** Begins the values of one program. */
void fuzz_seed(unsigned long long seed);
int fuzz_below(int n);
/** `count` elements, `step` bytes apart: floating values, or integers in 0 ... below - 1. */
void fuzz_fill(void *to, int count, size_t step, enum fuzz_type type, int below);
/** to[k] < k, or 0, for k < below; 0 above. */
void fuzz_fill_chain(int *to, int count, int below);
/** Not decreasing, by steps of 0, 1 and 2; the fewer the smaller the mask. */
void fuzz_fill_first(int *to, int count, int mask);
/** In 0 ... below - 1, and some far out of range. */
void fuzz_fill_far(int *to, int count, int below);
/** Prints a hash of the bytes. */
void fuzz_print(const char *name, const void *bytes, size_t size);
/** As fuzz_print, of what depends on the order of updates, be they of integers or not. */
void fuzz_print_ordered(const char *name, const void *bytes, size_t size);

#endif
