/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/lane_reason.h"

#include <assert.h>
#include <stddef.h>

static const struct {
    const char *slug, *message;
} reasons[LANE_REASON_COUNT] = {
    {NULL, NULL},
    {NULL, NULL},
#define X(NAME, slug, message) {slug, message},
#include "plan/lane_reasons.def"
#undef X
};

const char *lane_reason_slug(lane_reason why) {
    assert(why < LANE_REASON_COUNT);
    return reasons[why].slug;
}

const char *lane_reason_message(lane_reason why) {
    assert(why < LANE_REASON_COUNT);
    return reasons[why].message;
}
