/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/lanes.h"

#include "base/processor.h"
#include "redcc/runtime.h"

#include <assert.h>
#include <stdbool.h>

const char *redcc_lanes_slug(enum lanes_reason reason) {
    static const char *const slugs[] = {
#define REDCC_LANES_REASON(id, slug, text) slug,
        REDCC_LANES_LIST(REDCC_LANES_REASON)
#undef REDCC_LANES_REASON
    };
    return reason < LANES_REASON_COUNT ? slugs[reason] : "";
}

int redcc_lanes_width(unsigned flags, enum lanes_setting setting, enum lanes_reason *reason) {
    assert(setting == LANES_OFF || setting == LANES_AUTO);
    const int width = (int)(flags / REDCC_LANES_UNIT) & 7;
    const bool can = flags & REDCC_LANES_ANYWHERE || redcc_has_avx2();
    *reason = width == 0             ? LANES_NOT_WRITTEN
              : setting == LANES_OFF ? LANES_SAID_OFF
              : can                  ? LANES_USED
                                     : LANES_NO_PROCESSOR;
    return *reason == LANES_USED ? width : 0;
}
