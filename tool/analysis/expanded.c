/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* An updating call in a loop that stays sequential is expanded for whatever reason the loop was
 * refused, because only the analysis of the expanded loop shows whether the expansion helps. Calls
 * in expanded bodies are expanded in the next round. If the loop still stays sequential, its calls
 * are put back, so that the report describes the text that the user wrote. */
#include "analysis/expanded.h"

#include "analysis/base/dead_branches.h"
#include "analysis/base/expandable_call.h"
#include "analysis/base/expanded_call.h"
#include "analysis/base/loop_loads.h"

enum { MOST_ROUNDS = 3, MOST_CALLS = 400 };

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
        if (expandable_call_of(unit, call->function, call->statement))
            VECTOR_PUSH(a, calls, expanded_call_take_in(unit, call->function, call->statement));
    }
    return calls->count > before;
}

/* Puts back the calls of loops without generated code, the last expansion first, because a block
 * may contain calls that were expanded after it. Returns whether there were any. */
static bool put_back(const analysis_result *analysed, const expanded_list *calls) {
    bool has_changed = false;
    for (unsigned i = calls->count; i-- > 0;)
        if (!is_written(analysed, calls->items[i].block)) {
            expanded_call_put_back(&calls->items[i]);
            has_changed = true;
        }
    return has_changed;
}

static bool is_about_call(reason_id why) {
    return why == REASON_CALLEE_UPDATES || why == REASON_IMPURE_CALL || why == REASON_NO_RETURN;
}

/* Adds to the message about a call the reason why the loop is refused with the body in its place.
 */
static void explain(arena *a, const analysis_result *expanded, analysis_result *analysed) {
    loop_verdict *verdicts = ARENA_ARRAY(a, loop_verdict, analysed->verdict_count + 1);
    for (unsigned i = 0; i < analysed->verdict_count; i++) {
        verdicts[i] = analysed->verdicts[i];
        for (unsigned k = 0; k < expanded->verdict_count; k++)
            if (is_about_call(verdicts[i].why.id) &&
                expanded->verdicts[k].loop == verdicts[i].loop &&
                expanded->verdicts[k].kind == VERDICT_REFUSE &&
                !is_about_call(expanded->verdicts[k].why.id))
                verdicts[i].why.message =
                    arena_format(a, "%s (in its body: %s)", verdicts[i].why.message,
                                 expanded->verdicts[k].why.message);
    }
    analysed->verdicts = verdicts;
}

analysis_result analyse_expanding(arena *a, ir_unit *unit, const analysis_options *options) {
    updating_calls updating = {0};
    expanded_list calls = {0};
    analysis_result analysed = analyse_listing(a, unit, options, &updating);
    for (unsigned round = 0; round < MOST_ROUNDS && take_in(a, unit, &updating, &calls); round++) {
        dead_branches_take_out(unit); /* arguments decide conditions */
        loop_loads_name(unit);
        updating = (updating_calls){0};
        analysed = analyse_listing(a, unit, options, &updating);
    }
    if (!put_back(&analysed, &calls))
        return analysed;
    analysis_result result = analyse(a, unit, options);
    explain(a, &analysed, &result);
    return result;
}
