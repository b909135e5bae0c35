/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What is asked of a generator: FIRST COUNT [--only=S,S...] [--without=N,N...] [--statements], and
 *  options of its own. */
#ifndef FUZZ_REQUEST_H
#define FUZZ_REQUEST_H

#include <stdbool.h>
#include <stdint.h>

enum { MOST_STATEMENTS = 1000, MOST_PROGRAMS = 1000 };

typedef struct request {
    uint64_t first;            /* seed */
    int count;                 /* of seeds; 1 ... MOST_PROGRAMS */
    bool taken[MOST_PROGRAMS]; /* seed first + i; all, or those that --only names */
    bool has_without;
    bool without[MOST_STATEMENTS]; /* by number of statement: to be left out */
    bool only_statements;          /* how many statements there are is asked for */
} request;

/** An option that the one generator has: its text, and whether it was given. */
typedef struct own_option {
    const char *name;
    bool is_given;
} own_option;

/** Reads the arguments; false: they are none of these. */
bool request_read(request *r, own_option *own, int argc, char **argv);

#endif
