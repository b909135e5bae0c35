/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How many iterations at once can a loop be executed, and why so many (docs/lanes.md)? */
#ifndef REDCC_EXECUTE_LANES_H
#define REDCC_EXECUTE_LANES_H

#include <stdbool.h>

/** What REDCC_LANES says. */
enum lanes_setting {
    LANES_OFF,
    LANES_AUTO, /* as many as the processor can, where that has been found to pay (manner.h) */
    LANES_TWO,  /* so many at most, */
    LANES_FOUR, /* wherever the loop */
    LANES_EIGHT /* can */
};

/** Why a loop was executed with so many lanes, or without: identifier, slug, what it means.
 *  docs/report.md has the slugs, and a test compares. */
#define REDCC_LANES_LIST(X)                                                                        \
    X(LANES_NOT_WRITTEN, "not-written", "the loop has no form for vectors")                        \
    X(LANES_SAID_OFF, "off", "`REDCC_LANES=off`")                                                  \
    X(LANES_NO_WIDTH, "no-width", "the processor, or `REDCC_LANES`, allows no width that it has")  \
    X(LANES_SAID, "named", "`REDCC_LANES` names a width")                                          \
    X(LANES_TRYING, "trying", "executions with and without are being timed")                       \
    X(LANES_FASTER, "faster", "it was the faster way")                                             \
    X(LANES_SLOWER, "slower", "one by one was faster")

enum lanes_reason {
#define REDCC_LANES_REASON(id, slug, text) id,
    REDCC_LANES_LIST(REDCC_LANES_REASON)
#undef REDCC_LANES_REASON
        LANES_REASON_COUNT
};

/** The slug of a reason; "" of none. */
const char *redcc_lanes_slug(enum lanes_reason reason);

/** Iterations at once, of those that the flags of a redcc_loop name; 0: one by one, and *reason
 * says why. With lanes it is LANES_SAID or LANES_TRYING. Thread-safe. */
int redcc_lanes_width(unsigned flags, enum lanes_setting setting, enum lanes_reason *reason);

/** Is half of that width worth a trial? Of eight lanes it is, where four are written: an assembly
 *  of matrices took a fifth less time by four on an Intel Xeon (docs/lanes.md). Thread-safe. */
bool redcc_lanes_half(unsigned flags, int width);

#endif
