/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A 128-bit hash of a range of memory, computed as fast as memory is read. A plan is reused if the
 * fingerprints of its subscripts are unchanged. The hash is keyed with a secret of the process, so
 * that colliding contents cannot be prepared in advance.
 */
#ifndef REDCC_FINGERPRINT_H
#define REDCC_FINGERPRINT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct fingerprint {
    uint64_t word[2];
};

/** Computes the fingerprint of `bytes` bytes at `data`. */
struct fingerprint redcc_fingerprint(const char *data, size_t bytes);

/** Computes the fingerprint of a range of memory from the fingerprints of its `count` >= 0 parts,
 * in their order. */
struct fingerprint redcc_fingerprint_join(const struct fingerprint *parts, int count);

static inline bool redcc_fingerprint_equal(struct fingerprint a, struct fingerprint b) {
    return a.word[0] == b.word[0] && a.word[1] == b.word[1];
}

#endif
