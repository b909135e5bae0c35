/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "spelling.h"

#include <assert.h>
#include <string.h>

size_t redcc_spelling_distance(const char *a, const char *b) {
    enum { LONGEST = 64 };
    size_t row[LONGEST + 1];
    const size_t width = strnlen(b, LONGEST);
    for (size_t j = 0; j <= width; j++)
        row[j] = j;
    for (size_t i = 1; i <= LONGEST && a[i - 1]; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= width; j++) {
            const size_t changed = diagonal + (a[i - 1] != b[j - 1]);
            const size_t shorter = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            diagonal = row[j];
            row[j] = changed < shorter ? changed : shorter;
        }
    }
    return row[width];
}

size_t redcc_spelling_nearest(const char *word, const char *const *names, size_t count) {
    assert(count > 0);
    size_t nearest = 0;
    for (size_t i = 1; i < count; i++)
        if (redcc_spelling_distance(word, names[i]) < redcc_spelling_distance(word, names[nearest]))
            nearest = i;
    return nearest;
}
