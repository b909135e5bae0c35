/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes numbers to a file in little-endian order on any machine, either as bytes or as base64
 * (RFC 4648). Callers check errors by ferror. */
#ifndef FABRIC_VIEW_BYTE_SINK_H
#define FABRIC_VIEW_BYTE_SINK_H

#include <stdint.h>
#include <stdio.h>

/** Initialise it with {file, is_base64, {0}, 0}. */
typedef struct byte_sink {
    FILE *file;
    int is_base64;
    unsigned char pending[3]; /* bytes not yet written as base64, until there are three */
    int count;
} byte_sink;

void byte_sink_word(byte_sink *to, uint32_t word);

/** Writes a number as a float of 4 bytes. */
void byte_sink_float(byte_sink *to, double number);

/** Completes base64; must be called after the last byte. */
void byte_sink_end(byte_sink *to);

#endif
