/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The arguments of a generator: FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements], and
 * options that only one generator has. */
#ifndef FUZZ_REQUEST_H
#define FUZZ_REQUEST_H

#include <stdbool.h>
#include <stdint.h>

enum { MOST_STATEMENTS = 1000, MOST_PROGRAMS = 1000 };

typedef struct request {
    uint64_t first;            /* the first seed */
    int count;                 /* number of seeds, 1 ... MOST_PROGRAMS */
    bool taken[MOST_PROGRAMS]; /* whether seed first + i is taken: all, or those of --only */
    bool has_without;
    bool without[MOST_STATEMENTS]; /* statements to leave out, by number */
    bool only_statements;          /* only the number of statements is printed */
} request;

/** An option that only one generator has: its text, and whether it was given. */
typedef struct own_option {
    const char *name;
    bool is_given;
} own_option;

/** Reads the arguments. Returns false if they are invalid. */
bool request_read(request *r, own_option *own, int argc, char **argv);

#endif
