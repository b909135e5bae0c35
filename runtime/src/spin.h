/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A lock for what takes less time than to sleep. Signals are held back while it is held
 *  (signals.h), so that no handler finds it held by its own thread. */
#ifndef REDCC_SPIN_H
#define REDCC_SPIN_H

#include "system.h"

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

static inline void redcc_spin_lock(struct spin *lock) {
    while (!redcc_spin_try(lock))
        redcc_system_yield();
}

static inline void redcc_spin_unlock(struct spin *lock) {
    atomic_store_explicit(&lock->held, 0, memory_order_release);
}

#endif
