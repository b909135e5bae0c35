/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Flags for synchronisation between two threads. In each round (an execution) they begin lowered,
 * without a reset in between.
 */
#ifndef REDCC_FLAGS_H
#define REDCC_FLAGS_H

#include <stdatomic.h>
#include <stdint.h>

struct flags {
    atomic_int asleep;
    atomic_uint flag[]; /* the round in which it was raised */
};

/** `count` flags, lowered in all rounds but round 0; freed by redcc_memory_give. NULL: no
 *  memory. */
struct flags *redcc_flags_new(uint32_t count);

/** Raises flag number `flag` for the rest of this round. */
void redcc_flag_raise(struct flags *flags, uint32_t flag, unsigned round);

/** Waits until the flag is raised; the caller then sees all earlier writes of the thread that
 *  raised it. threads: of the region. */
void redcc_flag_await(struct flags *flags, uint32_t flag, unsigned round, int threads);

/** The same for a flag that is raised again and again, to higher values (modulo 2^32): waits until
 *  it is at `value` or past it. */
void redcc_flag_await_past(struct flags *flags, uint32_t flag, unsigned value, int threads);

#endif
