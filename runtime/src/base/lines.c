/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/lines.h"

#include <assert.h>

#include "base/system.h"

#if defined(__linux__)

bool redcc_lines_open(struct lines *lines, const char *name) {
    lines->descriptor = redcc_system_open(name);
    lines->at = lines->held = 0;
    lines->failed = false;
    return lines->descriptor >= 0;
}

static bool refill(struct lines *lines) {
    const long got = redcc_system_read(lines->descriptor, lines->buffer, sizeof lines->buffer);
    lines->at = 0;
    lines->held = got > 0 ? (size_t)got : 0;
    lines->failed = got < 0;
    return got > 0;
}

bool redcc_lines_next(struct lines *lines) {
    assert(lines->at <= lines->held && lines->held <= sizeof lines->buffer);
    size_t length = 0;
    bool some = false;
    while (lines->at < lines->held || refill(lines)) {
        const char letter = lines->buffer[lines->at++];
        some = true;
        if (letter == '\n')
            break;
        if (length + 1 < REDCC_LONGEST_LINE)
            lines->line[length++] = letter;
    }
    lines->line[length] = '\0';
    return some && !lines->failed;
}

void redcc_lines_close(struct lines *lines) {
    redcc_system_close(lines->descriptor);
}

#else

bool redcc_lines_open(struct lines *lines, const char *name) {
    (void)name;
    lines->failed = true;
    return false;
}

bool redcc_lines_next(struct lines *lines) {
    (void)lines;
    return false;
}

void redcc_lines_close(struct lines *lines) {
    (void)lines;
}

#endif
