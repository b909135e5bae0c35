/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** BLAKE2b (RFC 7693) with 32 bytes of output: collisions are practically impossible. */
#ifndef DRIVER_DIGEST_H
#define DRIVER_DIGEST_H

#include <stddef.h>
#include <stdint.h>

typedef struct digest {
    unsigned char bytes[32];
} digest;

typedef struct digester {
    uint64_t state[8];
    uint64_t length; /* bytes of input compressed so far */
    unsigned char block[128];
    unsigned filled;
} digester;

digester digest_begin(void);
void digest_add(digester *d, const void *bytes, size_t count);
/** Adds a text and its end, so that adjacent texts remain distinct. NULL differs from "". */
void digest_text(digester *d, const char *text);
digest digest_end(digester *d);

#endif
