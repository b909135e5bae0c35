/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/nearest.h"

#include <string.h>

static size_t smallest(size_t a, size_t b, size_t c) {
    const size_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

size_t edit_distance(const char *from, const char *to) {
    enum { LONGEST = 64 };
    size_t row[LONGEST + 1];
    const size_t width = strlen(to) < LONGEST ? strlen(to) : LONGEST;
    for (size_t k = 0; k <= width; k++)
        row[k] = k;
    for (size_t i = 0; from[i]; i++) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t k = 0; k < width; k++) {
            const size_t above = row[k + 1];
            row[k + 1] = smallest(diagonal + (from[i] != to[k]), above + 1, row[k] + 1);
            diagonal = above;
        }
    }
    return row[width];
}
