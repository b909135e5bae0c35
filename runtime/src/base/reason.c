/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/reason.h"

#include <assert.h>

static const struct {
    const char *slug, *text;
} reasons[] = {
#define REDCC_REASON(id, slug, text) {slug, text},
    REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
};
_Static_assert(sizeof reasons / sizeof *reasons == REASON_COUNT, "a slug for each reason");

const char *redcc_reason_slug(enum reason reason) {
    assert(reason < REASON_COUNT);
    return reasons[reason].slug;
}

const char *redcc_reason_text(enum reason reason) {
    assert(reason < REASON_COUNT);
    return reasons[reason].text;
}
