/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A loop over subscripts that lie where a test wants them to, large enough to be watched. */
#ifndef WATCHED_H
#define WATCHED_H

#include "loop.h"
#include "problem.h"

enum {
    THREADS = 2,
    TRIP = 80000, /* subscripts of 320 KB */
    ROWS = 3000,
    HUGE_PAGE = 2 << 20,
    AT = TRIP / 2,           /* in a page in the middle */
    CALLS_UNTIL_WATCHED = 40 /* one builds the plan, 38 find both sources unchanged, one begins */
};

struct fixture {
    struct problem problem;
    struct described described;
    double *expected;
    char *place; /* mapped; the subscripts begin some bytes into it */
    size_t place_bytes;
};

/** Private memory without a file. */
char *map_pages(size_t bytes);

/** Subscripts at random. */
void fill(int *row, unsigned long random);

/** With subscripts [TRIP] at `row`. */
void fixture_begin_at(struct fixture *fixture, int *row);

/** With subscripts in a mapping of their own. */
void fixture_begin(struct fixture *fixture);

/** Ends what fixture_begin_at began. */
void fixture_end_at(struct fixture *fixture);

/** Ends what fixture_begin began. */
void fixture_end(struct fixture *fixture);

const struct statistics *statistics_of(const struct fixture *fixture);

/** Runs the loop, compares with the oracle; were some subscripts watched and not read? */
bool run_right(struct fixture *fixture);

/** How many of the two sources, `start` and `row`, were not read in the last run. */
uint32_t sources_watched(const struct fixture *fixture);

/** Runs it until both are watched. */
void run_until_watched(struct fixture *fixture);

/** The whole pages of the subscripts. */
struct range rows_of(const struct fixture *fixture);

/** The same as run_until_watched, but without waiting: as if another loop had begun to watch. */
void run_and_share(struct fixture *fixture);

/** Another subscript than the one at AT. */
int other(const struct fixture *fixture);

/** Changes the one at AT. */
void by_a_store(struct fixture *fixture);

/** Changes all of them. */
void by_stores_all_over(struct fixture *fixture);

/** Skips the test, with a message, if the system cannot report written pages. */
void need_watching(void);

#endif
