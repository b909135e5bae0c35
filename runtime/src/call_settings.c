/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "call_settings.h"

#include "base/escapes.h"
#include "bins/shares.h"
#include "loop.h"
#include "plan/share_count.h"

/* Stops the program if an order named explicitly contradicts the named method. */
static void stop_at_contradiction(const redcc_loop *loop, const struct settings *settings) {
    const redcc_order order = redcc_order_of(loop, settings);
    if (!settings->method || settings->method->keeps <= order ||
        !(settings->order_given || loop->flags & REDCC_ORDER_EXPLICIT))
        return;
    redcc_stop("REDCC_METHOD=%s cannot keep order %s, which %s asks for (%s:%d); it gives order %s",
               settings->method->name, redcc_order_name(order),
               settings->order_given ? "REDCC_ORDER" : "the translated loop", loop->file,
               loop->line, redcc_order_name(settings->method->keeps));
}

/* May the loop be executed in an order that is fixed, but is not its own? */
static bool may_be_fixed(const redcc_loop *loop, const struct settings *settings) {
    return redcc_order_of(loop, settings) != REDCC_ORDER_SERIAL && !settings->method &&
           !settings->compensated;
}

/* Is the loop executed in shares with private copies? What earlier executions have found may be
 * read before the state is acquired: no other thread executes such a loop (redcc_is_alone). */
static bool goes_in_shares(redcc_loop *loop, const struct settings *settings, redcc_int trip) {
    const redcc_binned *binned = redcc_binned_of(loop);
    if (!binned || !binned->is_unordered)
        return false;
    const struct loop_state *state = redcc_made_state_of(loop);
    return (state ? redcc_bins_shares(&state->binning, trip, settings->memory_limit)
                  : redcc_share_count(loop, trip, redcc_updates(loop, trip), 1,
                                      settings->memory_limit)) > 1;
}

struct call_settings redcc_settled_order(const struct settings *common, redcc_loop *loop,
                                         redcc_int trip, void *const *bases,
                                         const redcc_extent *sections) {
    struct call_settings it = {
        .common = common, .method = common->method, .parameter = common->parameter};
    stop_at_contradiction(loop, common);
    if (!may_be_fixed(loop, common))
        return it;
    const int shares =
        sections ? redcc_sections_shares(loop, trip, bases, sections, common->memory_limit) : 0;
    if (shares > 1) {
        it.keeps = KEEPS_ORDER_OF_SECTIONS;
        it.method = &redcc_method_sections;
        it.parameter = shares;
        it.sections = sections;
    } else if (goes_in_shares(loop, common, trip)) {
        it.keeps = KEEPS_ORDER_OF_SHARES;
        it.method = &redcc_method_shares;
    }
    return it;
}

enum reason redcc_reason_not_to(const redcc_loop *loop, const struct call_settings *settings,
                                int threads, int nested, bool forked) {
    const struct method *method = settings->method;
    const bool in_bins = method && method->in_bins, compensated = settings->common->compensated;
    if (redcc_is_serial(method))
        return REASON_NAMED;
    if (method && loop->flags & REDCC_ORDER_NEEDED && method->keeps != REDCC_ORDER_SERIAL &&
        settings->keeps == KEEPS_ORDER_OF_METHOD)
        return REASON_ORDER_NEEDED;
    if (loop->flags & REDCC_MAY_ABORT && !redcc_assertions_abort())
        return REASON_ASSERTION;
    if (loop->flags & REDCC_NO_INSPECTOR && !in_bins && (method || compensated))
        return REASON_NO_INSPECTOR;
    if (redcc_is_always_planned(method, compensated))
        return REASON_NONE;
    if (in_bins && !redcc_binned_of(loop))
        return REASON_NO_BINS;
    if (method && method->selects && !(loop->flags & REDCC_SELECTS))
        return REASON_NO_SELECTION;
    if (method && method->tiles && (!(loop->flags & REDCC_TILES) || compensated))
        return REASON_NO_TILES;
    if (forked)
        return REASON_FORKED;
    if (nested)
        return REASON_NESTED;
    return threads < 2 && !redcc_one_will_do(loop, settings) ? REASON_ONE_THREAD : REASON_NONE;
}

/* The method that is used in place of auto; NULL: auto. Compensated sums use LOCALWRITE by default:
 * one thread adds to each element, in the order of the loop. */
static const struct method *method_of(const struct call_settings *settings) {
    if (!settings->method && settings->common->compensated)
        return &redcc_method_localwrite;
    return settings->method;
}

void redcc_take_settings(struct call *call, const struct call_settings *settings) {
    const redcc_loop *loop = call->request.loop;
    const struct settings *common = settings->common;
    call->keeps = settings->keeps;
    call->request.sections = settings->sections;
    call->method = method_of(settings);
    call->parameter = settings->parameter;
    call->in_bins = call->method && call->method->in_bins;
    call->order = redcc_order_of(loop, common);
    if (call->method && call->method->keeps > call->order)
        call->order = call->method->keeps;
    call->compensated = common->compensated;
    call->validate = common->validate;
    call->prefetch = (int)common->prefetch;
    call->lanes = (int)common->lanes;
    call->tracks = common->watch;
    call->memory_limit = common->memory_limit;
    call->one_will_do = redcc_is_always_planned(call->method, call->compensated) ||
                        redcc_one_will_do(loop, settings);
}
