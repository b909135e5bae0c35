/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/flags.h"

#include <assert.h>

#include "base/memory.h"
#include "base/wait.h"

struct flags *redcc_flags_new(uint32_t count) {
    return redcc_memory_alloc_zeroed(1, sizeof(struct flags) + count * sizeof(atomic_uint));
}

void redcc_flag_raise(struct flags *flags, uint32_t flag, unsigned round) {
    atomic_store(&flags->flag[flag], round);
    redcc_wake(&flags->flag[flag], &flags->asleep);
}

void redcc_flag_await(struct flags *flags, uint32_t flag, unsigned round, int threads) {
    assert(threads >= 1);
    atomic_uint *word = &flags->flag[flag];
    unsigned value;
    while ((value = atomic_load_explicit(word, memory_order_acquire)) != round)
        redcc_wait_while(word, value, &flags->asleep, threads);
}

void redcc_flag_await_past(struct flags *flags, uint32_t flag, unsigned value, int threads) {
    assert(threads >= 1);
    atomic_uint *word = &flags->flag[flag];
    unsigned now;
    while (now = atomic_load_explicit(word, memory_order_acquire), (int)(now - value) < 0)
        redcc_wait_while(word, now, &flags->asleep, threads);
}
