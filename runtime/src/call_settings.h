/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The settings of one call of a loop: those of the loop, and which order the call keeps. */
#ifndef REDCC_CALL_SETTINGS_H
#define REDCC_CALL_SETTINGS_H

#include "base/call.h"
#include "base/reason.h"
#include "settings.h"

struct call_settings {
    const struct settings *common; /* the settings of all calls of the loop */
    enum kept_order keeps;
    const struct method *method; /* the named method, or the one that keeps the order; NULL: auto */
    int parameter;               /* the method's parameter */
    /* [array_count] with KEEPS_ORDER_OF_SECTIONS: the sections; otherwise NULL */
    const redcc_extent *sections;
};

/** As redcc_settings_of_call, if a method is named or the loop's order need not be its own. Stops
 * the program if an order named explicitly contradicts the named method. */
struct call_settings redcc_settled_order(const struct settings *common, redcc_loop *loop,
                                         redcc_int trip, void *const *bases,
                                         const redcc_extent *sections);

/** The settings of a call that updates the given sections of its arrays (NULL: none are known).
 * Inline, as is redcc_one_will_do, because calls of short loops need only these. */
static inline struct call_settings redcc_settings_of_call(redcc_loop *loop, redcc_int trip,
                                                          void *const *bases,
                                                          const redcc_extent *sections) {
    const struct settings *common = redcc_settings_for(loop);
    if (common->method || redcc_order_of(loop, common) != REDCC_ORDER_SERIAL)
        return redcc_settled_order(common, loop, trip, bases, sections);
    return (struct call_settings){.common = common, .parameter = common->parameter};
}

/** May a single thread execute the loop by a plan or in bins? It may if binning is named, or if the
 * loop has a vector form (lanes), which may be faster than the sequential loop. */
static inline bool redcc_one_will_do(const redcc_loop *loop, const struct call_settings *settings) {
    enum lanes_reason unused;
    const bool in_bins = settings->method && settings->method->in_bins;
    return in_bins || redcc_lanes_width(loop->flags, settings->common->lanes, &unused) > 0;
}

/** A reason to run sequentially that does not depend on the loop's data, or REASON_NONE. */
enum reason redcc_reason_not_to(const redcc_loop *loop, const struct call_settings *settings,
                                int threads, int nested, bool forked);

/** Sets the fields of the call that the settings determine. */
void redcc_take_settings(struct call *call, const struct call_settings *settings);

/** Do the settings require other bits than those of the sequential loop (another order of the
 * contributions, or compensated sums)? Then the bits must be the same in every execution. So even a
 * single thread executes by a plan, also within a parallel region and while other threads execute
 * the loop. `method` is that of a call or of its settings. */
static inline bool redcc_is_always_planned(const struct method *method, bool compensated) {
    return compensated || (method && method->keeps == REDCC_ORDER_FIXED);
}

#endif
