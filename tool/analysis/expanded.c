/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * A call of a loop that stays sequential is expanded whatever the reason was: only the analysis of
 * the expanded loop can tell whether that helps. Calls in expanded bodies are expanded in the next
 * round. If the loop still stays sequential, its call is put back, so that the report is about the
 * text that the user wrote.
 */
#include "analysis/expanded.h"

#include "analysis/base/expanded_call.h"
#include "analysis/base/loop_loads.h"

enum { MOST_ROUNDS = 3, MOST_CALLS = 32 };

typedef VECTOR(expanded_call) expanded_list;

static bool is_written(const analysis_result *analysed, const ir_node *node) {
    for (unsigned i = 0; i < analysed->verdict_count; i++)
        if (verdict_is_written(&analysed->verdicts[i]) &&
            ir_contains(analysed->verdicts[i].loop, node))
            return true;
    return false;
}

/* Returns whether any of `updating` was expanded. */
static bool take_in(arena *a, ir_unit *unit, const updating_calls *updating, expanded_list *calls) {
    const unsigned before = calls->count;
    for (unsigned i = 0; i < updating->count && calls->count < MOST_CALLS; i++) {
        const updating_call *call = &updating->items[i];
        if (expanded_call_of(unit, call->statement))
            VECTOR_PUSH(a, calls, expanded_call_take_in(unit, call->function, call->statement));
    }
    return calls->count > before;
}

/* A block whose own calls were expanded, too, is exchanged with all of them. */
static bool put_back(const analysis_result *analysed, const expanded_list *calls) {
    bool has_changed = false;
    for (unsigned i = calls->count; i-- > 0;)
        if (!is_written(analysed, calls->items[i].block)) {
            expanded_call_put_back(&calls->items[i]);
            has_changed = true;
        }
    return has_changed;
}

analysis_result analyse_expanding(arena *a, ir_unit *unit, const analysis_options *options) {
    updating_calls updating = {0};
    expanded_list calls = {0};
    analysis_result analysed = analyse_listing(a, unit, options, &updating);
    for (unsigned round = 0; round < MOST_ROUNDS && take_in(a, unit, &updating, &calls); round++) {
        loop_loads_name(unit);
        updating = (updating_calls){0};
        analysed = analyse_listing(a, unit, options, &updating);
    }
    return put_back(&analysed, &calls) ? analyse(a, unit, options) : analysed;
}
