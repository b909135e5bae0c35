/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A lock for what takes less time than to sleep. Where a handler may find it held by its own
 * thread, since signals are not held back (signals.h), it must not be waited for without end. */
#ifndef REDCC_SPIN_H
#define REDCC_SPIN_H

#include "base/system.h"

#include <stdatomic.h>

/** All zero: free. */
struct spin {
    atomic_int held;
};

/** Takes the lock if it is free; false: it is not. */
static inline bool redcc_spin_try(struct spin *lock) {
    return atomic_load_explicit(&lock->held, memory_order_relaxed) == 0 &&
           atomic_exchange_explicit(&lock->held, 1, memory_order_acquire) == 0;
}

/** Takes the lock; false: it was not free for so long that it may never be. */
static inline bool redcc_spin_hope(struct spin *lock) {
    for (int tries = 0; tries < 10000; tries++) {
        if (redcc_spin_try(lock))
            return true;
        redcc_system_yield();
    }
    return false;
}

static inline void redcc_spin_lock(struct spin *lock) {
    while (!redcc_spin_try(lock))
        redcc_system_yield();
}

static inline void redcc_spin_unlock(struct spin *lock) {
    atomic_store_explicit(&lock->held, 0, memory_order_release);
}

#endif
