/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/signals.h"

#include "base/mappings.h"
#include "base/system.h"

#include <signal.h>

#if defined(__linux__)

#define BIT(number) (UINT64_C(1) << ((number)-1))

/* Signals that are never blocked: those that a thread's own instructions raise, and glibc's
 * internal signal 33. By signal 33 setuid reaches all threads, and its caller waits until each
 * thread has handled it. */
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

/* The kernel's struct sigaction, of which only these fields are read. */
struct action {
    uintptr_t handler;
    uintptr_t flags;
    uintptr_t restorer;
    uintptr_t rest[13];
};

static bool is_handled(int number, struct action *action) {
    return redcc_system(SYS_rt_sigaction, number, 0, action, sizeof(uint64_t)) == 0 &&
           action->handler != (uintptr_t)SIG_DFL && action->handler != (uintptr_t)SIG_IGN;
}

bool redcc_signal_is_default(int number) {
    struct action action;
    return redcc_system(SYS_rt_sigaction, number, 0, &action, sizeof(uint64_t)) == 0 &&
           action.handler == (uintptr_t)SIG_DFL;
}

static bool is_on_other_stack(void) {
    stack_t now;
    return redcc_system(SYS_sigaltstack, 0, &now) == 0 && (now.ss_flags & SS_ONSTACK) != 0;
}

#if defined(__x86_64__) && defined(__LP64__)

/* The scan of the stack also reads memory between variables, which sanitizers would report. */
#define NOT_SANITIZED __attribute__((__no_sanitize_address__, __no_sanitize_thread__))

/* Is the word at `at` a handler's return address, with the interrupted context above it
 * (sigreturn(2), struct rt_sigframe)? The return address alone proves nothing, since the stack may
 * hold old contents. The context has a null link and the interrupted stack pointer, which lies
 * above this frame. In its processor flags, bit 1 is always set, and bits 22 and above never
 * are. */
NOT_SANITIZED static bool is_frame(const uintptr_t *at, const uintptr_t *end, uintptr_t restorer) {
    enum { LINK = 2, STACK_POINTER = 1 + 5 + 15, FLAGS = STACK_POINTER + 2 };
    return *at == restorer && end - at > FLAGS && at[LINK] == 0 &&
           at[STACK_POINTER] > (uintptr_t)at && at[STACK_POINTER] <= (uintptr_t)end &&
           at[FLAGS] >> 22 == 0 && (at[FLAGS] & 2) != 0;
}

NOT_SANITIZED static bool has_frame(uintptr_t restorer) {
    const uintptr_t *at = __builtin_frame_address(0);
    const struct range stack = redcc_mapping_of((uintptr_t)at);
    const uintptr_t *const end = (const uintptr_t *)stack.end;
    for (; at < end; at++)
        if (is_frame(at, end, restorer))
            return true;
    return false;
}

#endif

bool redcc_signals_in_handler(uint64_t before) {
    uintptr_t restorer = 0;
    bool some = false, blocked = false;
    for (int number = 1; number <= 64; number++) {
        struct action action;
        if (!is_handled(number, &action))
            continue;
        some = true;
        restorer = action.restorer ? action.restorer : restorer;
        blocked = blocked || (before & BIT(number));
    }
    if (!some)
        return false;
#if defined(__x86_64__) && defined(__LP64__)
    return is_on_other_stack() || has_frame(restorer);
#else /* no scan of the stack: but while a handler runs, its signal is blocked */
    (void)restorer;
    return is_on_other_stack() || blocked;
#endif
}

void redcc_signals_take_over(void) {
    const uint64_t real_time = ~UINT64_C(0) << 33;
    uint64_t own = 0;
    set_mask(SIG_BLOCK, 0, &own);
    if ((own & real_time) == real_time)
        set_mask(SIG_BLOCK, ~NEVER_HELD, NULL);
}

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

bool redcc_signals_in_handler(uint64_t before) {
    (void)before;
    return false;
}

uint64_t redcc_signals_hold(void) {
    return 0;
}

void redcc_signals_release(uint64_t before) {
    (void)before;
}

void redcc_signals_take_over(void) {
}

void redcc_signals_let_default(uint64_t before) {
    (void)before;
}

#endif
