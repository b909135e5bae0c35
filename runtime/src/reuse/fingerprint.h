/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * 128 bits that stand for the contents of a piece of memory, at memory speed. A plan is used again
 * where its subscripts' fingerprint is unchanged. It is made under a secret of the process, so that
 * no contents can be made beforehand that differ and have one fingerprint.
 */
#ifndef REDCC_FINGERPRINT_H
#define REDCC_FINGERPRINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct fingerprint {
    uint64_t word[2];
};

/** Of `bytes` bytes at `data`. */
struct fingerprint redcc_fingerprint(const char *data, size_t bytes);

/** Of a whole, from those of its parts in order (count >= 0). */
struct fingerprint redcc_fingerprint_join(const struct fingerprint *parts, int count);

static inline bool redcc_fingerprint_equal(struct fingerprint a, struct fingerprint b) {
    return a.word[0] == b.word[0] && a.word[1] == b.word[1];
}

#endif
