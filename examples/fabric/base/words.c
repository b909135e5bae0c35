/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "words.h"

#include <stddef.h>
#include <string.h>

enum { LONGEST = 63 };

static int least(int a, int b) {
    return a < b ? a : b;
}

/** Optimal string alignment distance (Damerau 1964, Levenshtein 1966) between two words of at most
 *  LONGEST letters. */
static int edit_distance(const char *a, const char *b) {
    int rows[3][LONGEST + 1], *before = rows[0], *last = rows[1], *row = rows[2];
    const int a_length = (int)strlen(a), b_length = (int)strlen(b);
    for (int j = 0; j <= b_length; j++)
        last[j] = j;
    for (int i = 1; i <= a_length; i++) {
        row[0] = i;
        for (int j = 1; j <= b_length; j++) {
            row[j] = least(least(last[j], row[j - 1]) + 1, last[j - 1] + (a[i - 1] != b[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = least(row[j], before[j - 2] + 1);
        }
        int *const oldest = before;
        before = last;
        last = row;
        row = oldest;
    }
    return last[b_length];
}

const char *words_nearest(const char *word, const char *const *words, int count) {
    const char *nearest = NULL;
    const size_t length = strlen(word);
    int best = 2 + (int)length / 4; /* at a larger distance the hint would be a guess */
    if (length > LONGEST)
        return NULL;
    for (int k = 0; k < count; k++) {
        if (strlen(words[k]) > LONGEST)
            continue;
        const int distance = edit_distance(word, words[k]);
        if (distance < best) {
            best = distance;
            nearest = words[k];
        }
    }
    return nearest;
}
