/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Reasons why a loop has no form for several iterations at once (docs/lanes.md). */
#ifndef PLAN_LANE_REASON_H
#define PLAN_LANE_REASON_H

#include "ir/ir.h"

typedef enum lane_reason {
    LANES_WRITTEN,   /* the loop has such a form */
    LANES_NOT_ASKED, /* none is requested */
#define X(NAME, slug, message) NO_LANES_##NAME,
#include "plan/lane_reasons.def"
#undef X
    LANE_REASON_COUNT
} lane_reason;

/** The result for one loop for which lanes were requested. */
typedef struct lanes_outcome {
    lane_reason why;
    ir_range range; /* the place of the reason, or the loop, in the main file */
} lanes_outcome;

/** The reason's short name, such as "used-below"; NULL for LANES_WRITTEN and LANES_NOT_ASKED. */
const char *lane_reason_slug(lane_reason why);
/** The reason as a sentence without a full stop; NULL for LANES_WRITTEN and LANES_NOT_ASKED. */
const char *lane_reason_message(lane_reason why);

#endif
