/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * How a thread does floating-point arithmetic: direction of rounding, subnormal numbers taken as
 * zeros, exceptions that trap. And its locale, by which characters are classified and numbers read:
 * uselocale's is the thread's, and of setlocale's a thread keeps the tables that it found first.
 * And what memory it may touch by protection keys.
 * The program may have changed all of it since OpenMP's threads were made; they must compute what
 * the thread that entered the loop would. fenv.h has no name for most of the first, and needs libm.
 * Processors that are not named here keep what each thread has.
 */
#ifndef REDCC_FLOAT_CONTROL_H
#define REDCC_FLOAT_CONTROL_H

#include "base/rights.h"

#include <locale.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __GLIBC__
/* The name of POSIX is the program's to define. */
extern locale_t __uselocale(locale_t wanted);
#define redcc_use_locale __uselocale
#else
#define redcc_use_locale uselocale
#endif

struct float_control {
    locale_t locale;
    uint64_t vector; /* MXCSR; FPCR of 64-bit ARM */
    uint32_t rights; /* to memory */
    uint16_t x87;    /* the control word, of long double */
};

/** The calling thread's. */
static inline struct float_control redcc_float_control(void) {
    struct float_control own = {.locale = redcc_use_locale((locale_t)0), .rights = redcc_rights()};
#if defined(__x86_64__)
    uint32_t mxcsr;
    __asm__ volatile("stmxcsr %0" : "=m"(mxcsr));
    __asm__ volatile("fnstcw %0" : "=m"(own.x87));
    own.vector = mxcsr & ~0x3fu; /* without the flags of exceptions that occurred */
#elif defined(__aarch64__)
    __asm__ volatile("mrs %0, fpcr" : "=r"(own.vector));
#endif
    return own;
}

/** Are numbers rounded alike under both? */
static inline bool redcc_float_control_equal(struct float_control a, struct float_control b) {
    return a.vector == b.vector && a.x87 == b.x87;
}

/** Does some exception trap? A handler runs where it occurs, and can tell that from where it would
 *  in the sequential loop. */
static inline bool redcc_float_traps(struct float_control own) {
#if defined(__x86_64__)
    return (own.vector & 0x1f80) != 0x1f80 || (own.x87 & 0x3f) != 0x3f;
#elif defined(__aarch64__)
    return (own.vector & 0x9f00) != 0;
#else
    (void)own;
    return false;
#endif
}

/** Makes it the calling thread's. Flags of exceptions that occurred stay. */
static inline void redcc_float_control_take(struct float_control wanted) {
    redcc_rights_take(wanted.rights);
    redcc_use_locale(wanted.locale); /* also where it is the same: the tables may not be */
#if defined(__x86_64__)
    uint32_t mxcsr;
    __asm__ volatile("stmxcsr %0" : "=m"(mxcsr));
    mxcsr = (mxcsr & 0x3fu) | (uint32_t)wanted.vector;
    __asm__ volatile("ldmxcsr %0" : : "m"(mxcsr));
    __asm__ volatile("fldcw %0" : : "m"(wanted.x87));
#elif defined(__aarch64__)
    __asm__ volatile("msr fpcr, %0" : : "r"(wanted.vector));
#endif
}

#endif
