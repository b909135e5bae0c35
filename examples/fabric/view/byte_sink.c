/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "view/byte_sink.h"

#include <string.h>

static void put_base64(byte_sink *to) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const uint32_t three =
        (uint32_t)to->pending[0] << 16 | (uint32_t)to->pending[1] << 8 | (uint32_t)to->pending[2];
    for (int k = 0; k < 4; k++)
        fputc(k <= to->count ? digits[three >> (18 - 6 * k) & 63] : '=', to->file);
    memset(to->pending, 0, sizeof to->pending);
    to->count = 0;
}

static void put_byte(byte_sink *to, unsigned char byte) {
    if (!to->is_base64) {
        fputc(byte, to->file);
        return;
    }
    to->pending[to->count++] = byte;
    if (to->count == 3)
        put_base64(to);
}

void byte_sink_word(byte_sink *to, uint32_t word) {
    for (int k = 0; k < 4; k++)
        put_byte(to, (unsigned char)(word >> 8 * k));
}

void byte_sink_float(byte_sink *to, double number) {
    const float single = (float)number;
    uint32_t word;
    memcpy(&word, &single, sizeof word);
    byte_sink_word(to, word);
}

void byte_sink_end(byte_sink *to) {
    if (to->count > 0)
        put_base64(to);
}
