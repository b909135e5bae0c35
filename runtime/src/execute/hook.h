/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Updates that the runtime takes part in. The guarded form of a body asks redcc_owns before each
 * update of an element, or of several in one unit (a row, by a function that gets its address); an
 * owner with a hook owns nothing by itself, so that every question comes to redcc_hooked. What has
 * to be done after an update is done at the next question, or when the chunk is over
 * (redcc_hooks_settle).
 *
 * Compensated sums: from the address asked for to the end of its unit, elements are set to the
 * neutral element before the update, and so hold the contribution after it, whatever the update
 * looks like. Locks: that of the unit is held meanwhile.
 */
#ifndef REDCC_HOOK_H
#define REDCC_HOOK_H

#include "plan/plan.h"

struct redcc_hook {
    struct hooks *of;
    redcc_owner owner;       /* what the thread owns; of locks: not asked */
    const struct lost *lost; /* compensated; NULL: not this array */
    uintptr_t base;          /* units lie at multiples of `unit` from here */
    uint32_t unit;           /* bytes */
    uint32_t element;
};

/** Of one thread. All zero: none. */
struct hooks {
    bool locks;
    atomic_uchar *held;          /* the lock that is held */
    const struct lost *updating; /* compensated: the array whose elements are being updated */
    void *address;
    size_t count;
    struct redcc_hook *hook; /* [array_count] */
};

/** Puts hooks into `owner` [array_count], for the thread whose hooks these are (hooks->hook is
 *  there); arrays at `bases`. */
void redcc_hooks_install(struct hooks *hooks, const struct plan *plan, const redcc_array *arrays,
                         void *const *bases, redcc_owner *owner);

/** Ends what the last update left to do. */
void redcc_hooks_settle(struct hooks *hooks);

#endif
