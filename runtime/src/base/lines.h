/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Text files of /proc, line by line. */
#ifndef REDCC_LINES_H
#define REDCC_LINES_H

#include <stdbool.h>
#include <stddef.h>

enum { REDCC_LONGEST_LINE = 512 };

/** A file that is read; on the stack of whoever reads it, used by one thread. */
struct lines {
    int descriptor;
    bool failed; /* reading did, and not at the end */
    char buffer[4096];
    size_t at;
    size_t held;
    char line[REDCC_LONGEST_LINE]; /* the one read last; what does not fit is left out */
};

/** Opens the file. False: it cannot be opened. */
bool redcc_lines_open(struct lines *lines, const char *name);

/** Reads a line into lines->line, without its end. False: there are no more, or it has failed. */
bool redcc_lines_next(struct lines *lines);

/** Closes what redcc_lines_open has opened. */
void redcc_lines_close(struct lines *lines);

#endif
