/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "signals.h"

#include "system.h"

#include <signal.h>

#if defined(__linux__)

#define BIT(number) (UINT64_C(1) << ((number)-1))

/* Raised by the thread itself; and the one, of glibc's own two, by which setuid reaches all
 * threads and for whose effect another thread waits. */
#define NEVER_HELD                                                                                 \
    (BIT(SIGSEGV) | BIT(SIGBUS) | BIT(SIGFPE) | BIT(SIGILL) | BIT(SIGTRAP) | BIT(SIGSYS) | BIT(33))

static void set_mask(int how, uint64_t mask, uint64_t *before) {
    redcc_system(SYS_rt_sigprocmask, how, &mask, before, sizeof mask);
}

uint64_t redcc_signals_hold(void) {
    uint64_t before = 0;
    set_mask(SIG_BLOCK, ~NEVER_HELD, &before);
    return before;
}

void redcc_signals_release(uint64_t before) {
    set_mask(SIG_SETMASK, before, NULL);
}

/* As the kernel tells it; the rest is not looked at. */
struct action {
    uintptr_t handler;
    uintptr_t rest[15];
};

void redcc_signals_let_default(uint64_t before) {
    uint64_t unhandled = 0;
    for (int number = 1; number < 32; number++) {
        struct action action;
        if (redcc_system(SYS_rt_sigaction, number, 0, &action, sizeof unhandled) == 0 &&
            action.handler == (uintptr_t)SIG_DFL)
            unhandled |= BIT(number);
    }
    set_mask(SIG_UNBLOCK, unhandled & ~before, NULL);
}

#else

uint64_t redcc_signals_hold(void) {
    return 0;
}

void redcc_signals_release(uint64_t before) {
    (void)before;
}

void redcc_signals_let_default(uint64_t before) {
    (void)before;
}

#endif
