/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions that generated attacks share (tests/fuzz/attacks). No system header is included, to
 * shorten the translation. */
#ifndef ATTACK_SUPPORT_H
#define ATTACK_SUPPORT_H

typedef __SIZE_TYPE__ size_t;
void *memcpy(void *to, const void *from, size_t bytes);
void *malloc(size_t bytes);
void free(void *block);

static inline double attack_damp(double v) {
    return v > 99.0 ? 99.0 : v < -99.0 ? -99.0 : v == v ? v : 1.0;
}

#define ATTACK_IS_FLOATING(v) _Generic((v), float : 4, double : 8, default : 0)
#define ATTACK_FILL(array, count)                                                                  \
    attack_fill(array, count, sizeof *(array), ATTACK_IS_FLOATING((array)[0]))

/** Starts the random values of one program. */
void attack_seed(unsigned long long seed);
/** Returns a random number in 0 ... n - 1. */
int attack_below(int n);
/** Fills `count` elements of `size` bytes with random values. is_floating as for attack_print. */
void attack_fill(void *to, int count, size_t size, int is_floating);
/** Fills `to` with random numbers in 0 ... below - 1. */
void attack_fill_ints(int *to, int count, int below);
void attack_fill_doubles(double *to, int count);
/** Prints a hash of the bytes, in which all NaNs are equal. is_floating: the size of a
 * floating-point value, or 0 for others. */
void attack_print(unsigned seed, const void *bytes, size_t size, int is_floating);
/** Adds the value to the hash that attack_print prints next. */
void attack_note(double value);

/* The functions below are in another file, so the translator does not see their bodies. */

/** Sets the `count` bytes of which each function from attack_watched to expectf reads one. Its
 * argument determines which byte. */
void attack_watch(const void *bytes, size_t count);
int attack_watched(int i);
int parity(int i);
int expect(int i);
int clz(int i);
int popcount(int i);
int ctzl(int i);
double absf(double v);
double inf(int i);
double huge_val(int i);
int isinf_sign(int i);
int parityl(int i);
double expectf(double v);

/** Returns a table of the calling thread, like the C library's __ctype_b_loc. */
const int *attack_table(void) __attribute__((const));
/** Returns the calling thread's number (0 at first) plus i. */
int attack_thread_value(int i) __attribute__((pure));
/** Returns the calling thread's number. */
int attack_thread_number(void) __attribute__((const));
/** Sets the calling thread's number, and fills its table accordingly. */
void attack_set_thread(int value);
/** Sets the calling thread's character classes to those of the locale that the environment variable
 * ATTACK_LOCALE names, if that locale exists. attack_reset_locale sets those of the process. */
void attack_set_locale(void);
void attack_reset_locale(void);
/** Returns its argument, which the compiler cannot know. */
void *attack_same(const void *p) __attribute__((const));
/** Maps 1024 zeros at each of the addresses both[0] and both[1]. If both[0] is NULL, first sets the
 * two addresses. kind 0: two objects. 1: one object, mapped twice. 2: one object, mapped twice at
 * adjacent addresses. 3: one object, of which the second mapping is private (copy-on-write). */
void attack_map(unsigned long *both[2], int kind);
/** For objects in pages of their own, which can only be read once attack_hold has been called. */
#define ATTACK_PAGE __attribute__((section("attack_pages"), aligned(4096)))
void attack_hold(void);
void attack_mark(const void **entries, int count, const void *mark);

#endif
