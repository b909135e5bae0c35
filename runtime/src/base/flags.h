/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Flags by which one thread waits for another. A flag stores the number of the round (execution) in
 * which it was raised. So all flags are lowered at the beginning of a round without being reset.
 */
#ifndef REDCC_FLAGS_H
#define REDCC_FLAGS_H

#include <stdatomic.h>
#include <stdint.h>

struct flags {
    atomic_int asleep;
    atomic_uint flag[]; /* for each flag, the round in which it was raised */
};

/** Allocates `count` flags, which are lowered in all rounds except round 0. They are freed by
 * redcc_memory_free. NULL: out of memory. */
struct flags *redcc_flags_new(uint32_t count);

/** Raises flag number `flag` for the rest of this round. */
void redcc_flag_raise(struct flags *flags, uint32_t flag, unsigned round);

/** Waits until the flag is raised. The caller then sees all writes that the thread which raised the
 * flag made before. `threads` is the number of threads of the region. */
void redcc_flag_await(struct flags *flags, uint32_t flag, unsigned round, int threads);

/** As redcc_flag_await, for a flag that is raised repeatedly, to ascending values (modulo 2^32).
 * Waits until the flag's value is at least `value`. */
void redcc_flag_await_past(struct flags *flags, uint32_t flag, unsigned value, int threads);

#endif
