/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reads text files of /proc line by line. */
#ifndef REDCC_LINES_H
#define REDCC_LINES_H

#include <stdbool.h>
#include <stddef.h>

enum { REDCC_LONGEST_LINE = 512 };

/** An open file. It is on the stack of its reader and used by one thread. */
struct lines {
    int descriptor;
    bool failed; /* reading failed before the end */
    char buffer[4096];
    size_t at;
    size_t held;
    char line[REDCC_LONGEST_LINE]; /* the line read last; the part that does not fit is dropped */
};

/** Opens the file. False on failure. */
bool redcc_lines_open(struct lines *lines, const char *name);

/** Reads a line into lines->line, without its end. False at the end of the file, or on failure. */
bool redcc_lines_next(struct lines *lines);

/** Closes a file opened by redcc_lines_open. */
void redcc_lines_close(struct lines *lines);

#endif
