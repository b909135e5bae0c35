/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "execute/lanes.h"

#include "base/processor.h"
#include "redcc/runtime.h"

const char *redcc_lanes_slug(enum lanes_reason reason) {
    static const char *const slugs[] = {
#define REDCC_LANES_REASON(id, slug, text) slug,
        REDCC_LANES_LIST(REDCC_LANES_REASON)
#undef REDCC_LANES_REASON
    };
    return reason < LANES_REASON_COUNT ? slugs[reason] : "";
}

/* What lanes.h has functions compiled for. */
static int widest_of_processor(void) {
    return redcc_has_avx512() ? 8 : redcc_has_avx2() ? 4 : 2;
}

int redcc_lanes_width(unsigned flags, enum lanes_setting setting, enum lanes_reason *reason) {
    static const int most[] = {0, 8, 2, 4, 8};
    const int widths = (int)(flags / REDCC_LANES_UNIT) & (2 | 4 | 8);
    *reason = widths == 0             ? LANES_NOT_WRITTEN
              : setting == LANES_OFF  ? LANES_SAID_OFF
              : setting == LANES_AUTO ? LANES_TRYING
                                      : LANES_SAID;
    const int known = flags & REDCC_LANES_ANYWHERE ? 8 : widest_of_processor();
    for (int width = most[setting] < known ? most[setting] : known; width >= 2; width /= 2)
        if (widths & width)
            return width;
    if (widths && setting != LANES_OFF)
        *reason = LANES_NO_WIDTH;
    return 0;
}

bool redcc_lanes_half(unsigned flags, int width) {
    const int widths = (int)(flags / REDCC_LANES_UNIT);
    return width == 8 && widths & width / 2;
}
