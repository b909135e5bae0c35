/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Flags by which threads wait for each other, one to one. In each round (an execution) they begin
 * down; nothing has to be reset in between.
 */
#ifndef REDCC_FLAGS_H
#define REDCC_FLAGS_H

#include <stdatomic.h>
#include <stdint.h>

struct flags {
    atomic_int asleep;
    atomic_uint flag[]; /* the round in which it went up */
};

/** `count` flags, down in all rounds but round 0; redcc_memory_give gives them back. NULL: no
 *  memory. */
struct flags *redcc_flags_new(uint32_t count);

/** Flag number `flag` goes up, for good in this round. */
void redcc_flag_raise(struct flags *flags, uint32_t flag, unsigned round);

/** Returns when it is up; the caller sees what the thread that raised it did before. threads: of
 *  the region. */
void redcc_flag_await(struct flags *flags, uint32_t flag, unsigned round, int threads);

#endif
