/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/translated.h"

#include <string.h>

#include "emit/emit.h"
#include "frontend/directives.h"

/** Do the first lines of a written file begin at `at`, with either kind of line ends? */
static bool is_beginning(const char *at) {
    for (const char *expected = REDCC_BEGINNING REDCC_REQUIREMENT; *expected; expected++) {
        if (*expected == '\n' && *at == '\r')
            at++;
        if (*at++ != *expected)
            return false;
    }
    return true;
}

bool is_translated(const source *file) {
    static const char byte_order_mark[] = "\xef\xbb\xbf";
    const char *at = file->text, *const end = at + file->length;
    bool begins_line = true;
    if (!strstr(at, REDCC_REQUIREMENT))
        return false;
    if (source_starts_with(at, byte_order_mark))
        at += sizeof byte_order_mark - 1;
    while (at < end && !(begins_line && is_beginning(at))) {
        begins_line = *at == '\n';
        at = piece_end(at, end);
    }
    return at < end;
}
