/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** How many iterations at once can a loop be executed, and why so many (docs/lanes.md)? */
#ifndef REDCC_EXECUTE_LANES_H
#define REDCC_EXECUTE_LANES_H

/** What REDCC_LANES says. */
enum lanes_setting { LANES_OFF, LANES_AUTO /* wherever loop and processor can */ };

/** Why a loop was executed with so many lanes, or without: identifier, slug, what it means.
 *  docs/report.md has the slugs, and a test compares. */
#define REDCC_LANES_LIST(X)                                                                        \
    X(LANES_NOT_WRITTEN, "not-written", "the loop has no form for vectors")                        \
    X(LANES_SAID_OFF, "off", "`REDCC_LANES=off`")                                                  \
    X(LANES_NO_PROCESSOR, "processor", "the processor lacks AVX2")                                 \
    X(LANES_USED, "written", "the loop has a form for vectors")

enum lanes_reason {
#define REDCC_LANES_REASON(id, slug, text) id,
    REDCC_LANES_LIST(REDCC_LANES_REASON)
#undef REDCC_LANES_REASON
        LANES_REASON_COUNT
};

/** The slug of a reason; "" of none. */
const char *redcc_lanes_slug(enum lanes_reason reason);

/** Iterations at once, by the flags of a redcc_loop; 0: one by one, and *reason says why.
 *  Thread-safe. */
int redcc_lanes_width(unsigned flags, enum lanes_setting setting, enum lanes_reason *reason);

#endif
