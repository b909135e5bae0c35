/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The part of a thread's state that affects its results:
 *
 * - Floating point: the rounding direction, flushing of subnormal numbers, exceptions that trap.
 *   fenv.h has no names for most of these, and its functions need libm.
 * - Locale: it affects how characters are classified and how numbers are read. uselocale sets a
 *   thread's locale. Without it, a thread keeps the tables of the locale (setlocale) that it used
 *   first.
 * - Memory: access rights by protection keys.
 *
 * OpenMP's threads must compute the same results as the thread that entered the loop, but the
 * program may have changed this state since they were created. On processors other than x86-64 and
 * 64-bit ARM each thread keeps its own floating-point state.
 */
#ifndef REDCC_FLOAT_CONTROL_H
#define REDCC_FLOAT_CONTROL_H

#include "base/rights.h"

#include <locale.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __GLIBC__
/* glibc's reserved name, because the program may define the POSIX name. */
extern locale_t __uselocale(locale_t wanted);
#define redcc_use_locale __uselocale
#else
#define redcc_use_locale uselocale
#endif

struct float_control {
    locale_t locale;
    uint64_t vector; /* MXCSR on x86-64; FPCR on 64-bit ARM */
    uint32_t rights; /* memory access rights */
    uint16_t x87;    /* the control word of the x87 unit, which computes long double */
};

/** The calling thread's state. */
static inline struct float_control redcc_float_control(void) {
    struct float_control own = {.locale = redcc_use_locale((locale_t)0), .rights = redcc_rights()};
#if defined(__x86_64__)
    uint32_t mxcsr;
    __asm__ volatile("stmxcsr %0" : "=m"(mxcsr));
    __asm__ volatile("fnstcw %0" : "=m"(own.x87));
    own.vector = mxcsr & ~0x3fu; /* the sticky exception flags are left out */
#elif defined(__aarch64__)
    __asm__ volatile("mrs %0, fpcr" : "=r"(own.vector));
#endif
    return own;
}

/** Are the floating-point parts of both states equal? */
static inline bool redcc_float_control_equal(struct float_control a, struct float_control b) {
    return a.vector == b.vector && a.x87 == b.x87;
}

/** Do floating-point exceptions trap? If so, a handler could observe that they occur in another
 * order than in the sequential loop. */
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

/** Sets the calling thread's state, except its sticky exception flags. */
static inline void redcc_float_control_take(struct float_control wanted) {
    redcc_rights_set(wanted.rights);
    redcc_use_locale(wanted.locale); /* even if it is the same, its tables may differ */
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
