/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decides how many iterations are executed at once, and gives a reason (docs/lanes.md). */
#ifndef REDCC_EXECUTE_LANES_H
#define REDCC_EXECUTE_LANES_H

/** Values of REDCC_LANES. */
enum lanes_setting {
    LANES_OFF,
    LANES_AUTO /* the vector form, if the loop has one and the processor
                  supports it */
};

/** Why an execution uses the vector form, or why not: identifier, slug, meaning. docs/report.md
 * lists the slugs, and a test compares the two lists. */
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

/** The slug of a reason; "" for any other value. */
const char *redcc_lanes_slug(enum lanes_reason reason);

/** The number of iterations executed at once, from the flags of a redcc_loop; 0: one by one. Sets
 * *reason. Thread-safe. */
int redcc_lanes_width(unsigned flags, enum lanes_setting setting, enum lanes_reason *reason);

#endif
