/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What generated attacks share (tests/fuzz/attacks). No system header: translating takes less
 * time. */
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

/** Begins the values of one program. */
void attack_seed(unsigned long long seed);
int attack_below(int n);
void attack_fill(void *to, int count, size_t size, int is_floating);
void attack_fill_ints(int *to, int count, int below);
void attack_fill_doubles(double *to, int count);
/** Prints a hash of the bytes, all NaN being one. is_floating: the size of the values, or 0. */
void attack_print(unsigned seed, const void *bytes, size_t size, int is_floating);
/** Takes part in the hash that attack_print prints next. */
void attack_note(double value);

/* In another file: the translator sees no body. */

/** What the functions below read: `count` bytes, read one in `count` by the low bits of i. */
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

/** Belongs to the calling thread, as the C library's __ctype_b_loc does. */
const int *attack_table(void) __attribute__((const));
int attack_thread_value(int i) __attribute__((pure));
int attack_thread_number(void) __attribute__((const));
/** Sets what the two before give for the calling thread. */
void attack_set_thread(int value);
/** The calling thread's classes of characters are those of the locale that ATTACK_LOCALE names; or,
 * by the second, as before. */
void attack_set_locale(void);
void attack_reset_locale(void);
/** Returns its argument, for all that the compiler knows. */
void *attack_same(const void *p) __attribute__((const));
/** Maps 1024 zeros at both[0] and, the same or others, at both[1]: at the addresses
 * that they have from an earlier call. kind 0: two objects; 1: one, mapped twice; 2: one, twice,
 * side by side; 3: one, which the second shows until it is written to. */
void attack_map(unsigned long *both[2], int kind);
/** Objects of pages of their own, which can only be read after attack_hold. */
#define ATTACK_PAGE __attribute__((section("attack_pages"), aligned(4096)))
void attack_hold(void);
void attack_mark(const void **entries, int count, const void *mark);

#endif
