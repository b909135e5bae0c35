/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A spin lock for critical sections that take less time than putting a thread to sleep. If signals
 * are not blocked (signals.h), a handler may run while its own thread holds the lock. Locks for
 * which this can happen are acquired by redcc_spin_hope. */
#ifndef REDCC_SPIN_H
#define REDCC_SPIN_H

#include "base/system.h"

#include <stdatomic.h>

/** Zero: unlocked. */
struct spin {
    atomic_int held;
};

/** Acquires the lock if it is free; otherwise returns false. */
static inline bool redcc_spin_try(struct spin *lock) {
    return atomic_load_explicit(&lock->held, memory_order_relaxed) == 0 &&
           atomic_exchange_explicit(&lock->held, 1, memory_order_acquire) == 0;
}

/** Acquires the lock. After a long wait without success, returns false, because the lock's holder
 * may never release it. */
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
