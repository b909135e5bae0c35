/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Functions that generated programs share. With FUZZ_INTEGERS in the environment all values are
 * small integers, so sums do not depend on the order of additions. No system header is included, to
 * shorten the translation.
 */
#ifndef FUZZ_H
#define FUZZ_H

typedef __SIZE_TYPE__ size_t;
void *memset(void *to, int byte, size_t bytes);
void *memcpy(void *to, const void *from, size_t bytes);

/** For an object that the program must not write after fuzz_hold(1): a write ends the program. */
#define FUZZ_HELD static __attribute__((section("fuzz_held"), aligned(4096)))
void fuzz_hold(int is_held);
void __assert_fail(const char *text, const char *file, unsigned line, const char *function)
    __attribute__((noreturn));
#define ASSERT(condition)                                                                          \
    ((condition) ? (void)0 : __assert_fail(#condition, __FILE__, __LINE__, __func__))
/** In another file: ends the program. */
void fuzz_fail(void) __attribute__((noreturn));
/** fuzz_level and fuzz_scaled are in another file. Their results depend on a variable of the
 * calling thread, although they are declared pure and const. */
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

/** Returns false if the environment variable FUZZ_LEFT_OUT contains the program's seed (seeds with
 * commas between them). */
int fuzz_runs(unsigned long long seed);
/** Starts the random values of one program. */
void fuzz_seed(unsigned long long seed);
/** Returns a random number in 0 ... n - 1. */
int fuzz_below(int n);
/** Fills `count` elements, `step` bytes apart, with floating-point values or with integers in 0 ...
 * below - 1. */
void fuzz_fill(void *to, int count, size_t step, enum fuzz_type type, int below);
/** For k < below, sets to[k] to less than k, or to 0; for k >= below, sets it to 0. */
void fuzz_fill_chain(int *to, int count, int below);
/** Fills `to` with numbers that begin with 0 and never decrease: to[i] exceeds to[i - 1] by
 * (i & mask) % 3. */
void fuzz_fill_first(int *to, int count, int mask);
/** Fills in numbers in 0 ... below - 1, and some far out of range. */
void fuzz_fill_far(int *to, int count, int below);
/** Prints a hash of the bytes. */
void fuzz_print(const char *name, const void *bytes, size_t size);
/** Like fuzz_print, for values that depend on the order of updates even if they are integers. */
void fuzz_print_ordered(const char *name, const void *bytes, size_t size);

#endif
