/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Hooks let the runtime act before and after each update. The owner-checked form of a body tests
 * the owner (redcc_owns, or an inlined equivalent) before each update of an element. If several
 * elements of a unit are updated together, it tests once. An owner with a hook has an empty range,
 * so every such test reaches redcc_hooked. What must follow an update is done at the next test, or
 * at the end of the chunk (redcc_hooks_settle).
 *
 * For compensated sums, before the update, the elements from the tested address to the end of its
 * unit are set to the neutral element. So after the update they hold the contribution, whether the
 * body adds to them or stores the sum. With locks, the unit's lock is held during the update.
 */
#ifndef REDCC_HOOK_H
#define REDCC_HOOK_H

#include "plan/plan.h"

struct redcc_hook {
    struct hooks *of;
    redcc_owner owner; /* the elements that the thread owns; unused with locks */
    /* rounding errors of the array's group; NULL: the array is not compensated */
    const struct rounding *rounding;
    uintptr_t base;   /* units begin at multiples of `unit` from this address */
    uint32_t unit;    /* size of a unit in bytes */
    uint32_t element; /* size of an element in bytes */
};

/** One thread's hooks. If all fields are zero, there are none. */
struct hooks {
    bool locks;
    atomic_uchar *held;              /* the lock that the thread holds; NULL: none */
    const struct rounding *updating; /* rounding errors of the group whose elements are being
                                        updated; NULL: no update has begun */
    void *address;
    size_t count;
    struct redcc_hook *hook; /* [array_count] */
};

/** Puts the thread's `hooks` into owner[array_count], for those arrays at `bases` that are
 * compensated or locked. The caller has allocated hooks->hook. */
void redcc_hooks_install(struct hooks *hooks, const struct plan *plan, const redcc_array *arrays,
                         void *const *bases, redcc_owner *owner);

/** Completes the last update: releases the lock, or adds the contributions to the saved values. */
void redcc_hooks_settle(struct hooks *hooks);

#endif
