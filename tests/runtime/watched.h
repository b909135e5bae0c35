/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A loop with subscripts at a given address, which are large enough to be tracked (dirty-page
 * tracking). */
#ifndef WATCHED_H
#define WATCHED_H

#include "loop.h"
#include "problem.h"

enum {
    THREADS = 2,
    TRIP = 80000, /* subscripts of 320 KB */
    ROWS = 3000,
    HUGE_PAGE = 2 << 20,
    AT = TRIP / 2, /* index of a subscript in a page in the middle */
    /* One call builds the plan, 38 calls find both sources unchanged, and one begins tracking. */
    CALLS_UNTIL_WATCHED = 40
};

struct fixture {
    struct problem problem;
    struct described described;
    double *expected;
    char *place; /* mapped memory; the subscripts begin some bytes after its start */
    size_t place_bytes;
};

/** Returns private memory without a file. */
char *map_pages(size_t bytes);

/** Fills the subscripts at random. */
void fill(int *row, unsigned long random);

/** Makes a fixture with subscripts [TRIP] at `row`. */
void fixture_begin_at(struct fixture *fixture, int *row);

/** Makes a fixture whose subscripts are in a separate mapping. */
void fixture_begin(struct fixture *fixture);

/** Frees what fixture_begin_at made. */
void fixture_end_at(struct fixture *fixture);

/** Frees what fixture_begin made. */
void fixture_end(struct fixture *fixture);

const struct statistics *statistics_of(const struct fixture *fixture);

/** Runs the loop and compares with the expected result. Returns true if tracking made reading some
 * subscripts unnecessary. */
bool run_right(struct fixture *fixture);

/** Returns how many of the two sources, `start` and `row`, the last run did not read. */
uint32_t sources_watched(const struct fixture *fixture);

/** Runs the loop until both sources are tracked. */
void run_until_watched(struct fixture *fixture);

/** Returns the whole pages of the subscripts. */
struct range rows_of(const struct fixture *fixture);

/** Like run_until_watched, but at once, as if another loop had begun tracking. */
void run_and_share(struct fixture *fixture);

/** Returns a subscript that differs from the one at AT. */
int other(const struct fixture *fixture);

/** Changes the subscript at AT. */
void by_a_store(struct fixture *fixture);

/** Changes all subscripts. */
void by_stores_all_over(struct fixture *fixture);

/** Skips the test, with a message, if the system cannot report written pages. */
void need_watching(void);

#endif
