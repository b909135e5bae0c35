/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The inner loop of fingerprints for processors with AVX2. It is twice as fast as the portable
 * loop in fingerprint.c. */
#ifndef REDCC_FINGERPRINT_WIDE_H
#define REDCC_FINGERPRINT_WIDE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { REDCC_WIDE_BLOCK = 1024, REDCC_WIDE_LANES = 16, REDCC_WIDE_KEYS = 24 };

/** Does the processor have AVX2? The answer never changes. */
bool redcc_has_wide(void);

/** Hashes `blocks` blocks of REDCC_WIDE_BLOCK bytes at `data` into `lane`. Requires
 * redcc_has_wide(). The key must stay secret: whoever knows it can construct collisions. */
void redcc_take_in_wide(uint64_t lane[REDCC_WIDE_LANES], const char *data, size_t blocks,
                        const uint64_t key[REDCC_WIDE_KEYS]);

#endif
