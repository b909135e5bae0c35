/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "hook.h"

#include "compensate.h"

#include <sched.h>

enum { LOCKS = 1 << 14, TRIES = 100 };

static atomic_uchar locks[LOCKS]; /* by a hash of the address */

static void lock_for(struct hooks *hooks, const void *address) {
    const uint64_t hash = (uintptr_t)address * 0x9e3779b97f4a7c15u;
    atomic_uchar *lock = &locks[hash >> 50 & (LOCKS - 1)];
    for (int try = 1; atomic_exchange_explicit(lock, 1, memory_order_acquire); try++)
        if (try % TRIES == 0)
            sched_yield();
    hooks->held = lock;
}

void redcc_hooks_settle(struct hooks *hooks) {
    if (hooks->held)
        atomic_store_explicit(hooks->held, 0, memory_order_release);
    hooks->held = NULL;
    if (hooks->updating)
        redcc_lost_end(hooks->updating->lost, hooks->address, hooks->before);
    hooks->updating = NULL;
}

int redcc_hooked(struct redcc_hook *hook, const void *address) {
    struct hooks *hooks = hook->of;
    redcc_hooks_settle(hooks);
    if (hooks->locks) {
        lock_for(hooks, address);
        return 1;
    }
    if (!redcc_owns(&hook->owner, address))
        return 0;
    hooks->updating = hook;
    hooks->address = (void *)(uintptr_t)address;
    hooks->before = redcc_lost_begin(hook->lost, hooks->address);
    return 1;
}

void redcc_hooks_install(struct hooks *hooks, const struct plan *plan, redcc_owner *owner) {
    hooks->locks = plan->method->locks;
    for (uint32_t array = 0; array < plan->array_count; array++) {
        struct redcc_hook *hook = &hooks->hook[array];
        const struct lost *lost = plan->lost ? &plan->lost[plan->group_of[array]] : NULL;
        if (!hooks->locks && (!lost || !lost->value))
            continue;
        *hook = (struct redcc_hook){hooks, owner[array], lost};
        owner[array] = (redcc_owner){.first = owner[array].first, .hook = hook};
    }
}
