/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/hook.h"

#include "base/system.h"
#include "execute/compensate.h"

#include <assert.h>

enum { LOCKS = 1 << 14, TRIES = 100 };

static atomic_uchar locks[LOCKS]; /* indexed by a hash of the unit's address */

/* The offset of `address` in its unit. */
static size_t into_unit(const struct redcc_hook *hook, const void *address) {
    const ptrdiff_t offset = (ptrdiff_t)((uintptr_t)address - hook->base);
    const ptrdiff_t into = offset % (ptrdiff_t)hook->unit;
    return (size_t)(into < 0 ? into + (ptrdiff_t)hook->unit : into);
}

static void lock_unit(struct hooks *hooks, uintptr_t unit) {
    const uint64_t hash = unit * 0x9e3779b97f4a7c15u;
    atomic_uchar *lock = &locks[hash >> 50 & (LOCKS - 1)];
    for (int try = 1; atomic_exchange_explicit(lock, 1, memory_order_acquire); try++)
        if (try % TRIES == 0)
            redcc_system_yield();
    hooks->held = lock;
}

void redcc_hooks_settle(struct hooks *hooks) {
    if (hooks->held)
        atomic_store_explicit(hooks->held, 0, memory_order_release);
    hooks->held = NULL;
    if (hooks->updating)
        redcc_rounding_end(hooks->updating, hooks->address, hooks->count);
    hooks->updating = NULL;
}

int redcc_hooked(struct redcc_hook *hook, const void *address) {
    struct hooks *hooks = hook->of;
    const size_t into = into_unit(hook, address);
    redcc_hooks_settle(hooks);
    assert(!hooks->held && !hooks->updating);
    if (hooks->locks) {
        lock_unit(hooks, (uintptr_t)address - into);
        return 1;
    }
    if (!redcc_owns(&hook->owner, address))
        return 0;
    hooks->updating = hook->rounding;
    hooks->address = (void *)(uintptr_t)address;
    hooks->count = (hook->unit - into) / hook->element;
    redcc_rounding_begin(hook->rounding, hooks->address, hooks->count);
    return 1;
}

void redcc_hooks_install(struct hooks *hooks, const struct plan *plan, const redcc_array *arrays,
                         void *const *bases, redcc_owner *owner) {
    hooks->locks = plan->method->locks;
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = plan->group_of[array];
        const struct rounding *rounding = plan->rounding ? &plan->rounding[group] : NULL;
        if (!hooks->locks && (!rounding || !rounding->value))
            continue;
        /* Overlapping arrays form a group and must use the same locks: one per unit of the array
         * whose number identifies the group. */
        const uint32_t units = hooks->locks ? group : array;
        hooks->hook[array] = (struct redcc_hook){.of = hooks,
                                                 .owner = owner[array],
                                                 .rounding = rounding,
                                                 .base = (uintptr_t)bases[units],
                                                 .unit = arrays[units].unit,
                                                 .element = arrays[array].element};
        owner[array] = (redcc_owner){.first = owner[array].first, .hook = &hooks->hook[array]};
    }
}
