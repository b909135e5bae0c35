/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Tests plans of loops without generating text. Usage: plan_test FILE... A comment `PLAN: clause;
 * clause` on a loop's line names clauses that the plan's description must contain. Each loop that
 * can run in parallel must have such a comment. */
#include <stdio.h>
#include <string.h>

#include "analysis/analysis.h"
#include "frontend/frontend.h"
#include "plan/bins.h"
#include "plan/inner_iterations.h"
#include "plan/plan.h"
#include "support/buffer.h"
#include "support/source.h"

static void describe_bins(buffer *out, const loop_plan *plan) {
    if (!plan->bins) {
        buffer_format(out, "no bins: %s; ", plan->no_bins ? plan->no_bins : "not asked");
        return;
    }
    unsigned values = 0, tags = 0;
    for (unsigned i = 0; i < plan->bins->stream_count; i++) {
        values += stream_value_count(&plan->bins->streams[i]);
        tags += plan->bins->streams[i].tag_count;
    }
    for (unsigned i = 0; i < plan->bins->record_count; i++)
        if (plan->bins->records[i].span)
            buffer_format(out, "span of %u variables; ",
                          plan->bins->records[i].span->variable_count);
        else if (plan->facts->arrays[plan->bins->records[i].updates[0]->array].is_scattered)
            buffer_format(out, "no span; ");
    buffer_format(out, "bins: %u records of %u values, %u tags in %u streams; %s; ",
                  plan->bins->record_count, values, tags, plan->bins->stream_count,
                  plan->bins->is_checked ? "compared before" : "compared after");
}

static const char *describe(arena *a, const loop_plan *plan) {
    static const char *const prechecks[] = {"none", "updates", "all"};
    buffer out = {0};
    if (plan->obstacle.message) {
        buffer_format(&out, "obstacle: %s; ", plan->obstacle.message);
    } else {
        describe_bins(&out, plan);
        if (plan->prefetch.declined)
            buffer_format(&out, "no prefetch: %s; ", plan->prefetch.declined);
        else
            buffer_format(&out, "prefetch: %u%s; gathers: %u; ", plan->prefetch.ahead,
                          plan->prefetch.is_light ? " if light" : "", plan->prefetch.gather_count);
        for (unsigned i = 0; i < plan->skip_count; i++)
            if (plan->skips[i].declined)
                buffer_format(&out, "no skip: %s; ", plan->skips[i].declined);
            else
                buffer_format(&out, "skip: %u rows; ", plan->skips[i].row_count);
        const char *slug = lane_reason_slug(plan->no_lanes);
        buffer_format(&out, "lanes: %s; keys: %u; precheck: %s; %s; ", slug ? slug : "yes",
                      plan->execution.key_count, prechecks[plan->precheck],
                      plan->execution.is_over_blocks ? "over blocks" : "no blocks");
    }
    const char *text = arena_copy(a, out.data, out.length);
    buffer_free(&out);
    return text;
}

/* Returns the clauses of the PLAN comment on the loop's line, or NULL if the line has none. */
static const char *expected_at(arena *a, const source *s, uint32_t offset) {
    static const char word[] = "PLAN: ";
    const char *const line_end = strchr(s->text + offset, '\n');
    const char *const at = strstr(s->text + offset, word);
    if (!at || !line_end || at > line_end)
        return NULL;
    return arena_copy(a, at + sizeof word - 1, (size_t)(line_end - at) - (sizeof word - 1));
}

static bool has_clauses(arena *a, const char *description, const char *clauses) {
    for (const char *at = clauses; *at;) {
        const size_t length = strcspn(at, ";");
        if (!strstr(description, arena_format(a, "%.*s; ", (int)length, at)))
            return false;
        at += length;
        at += strspn(at, "; ");
    }
    return true;
}

static unsigned check_loop(arena *a, const ir_unit *unit, const loop_verdict *verdict) {
    static const plan_options options = {.lanes = LANES_OF_ALL};
    const char *expected = expected_at(a, unit->source, verdict->loop->range.begin);
    const char *found = describe(a, plan_loop(a, unit, unit, verdict->facts, &options));
    if (expected && has_clauses(a, found, expected))
        return 0;
    fprintf(stderr, "line %u: expected '%s', found '%s'\n",
            source_position(unit->source, verdict->loop->range.begin).line,
            expected ? expected : "a comment PLAN:", found);
    return 1;
}

static unsigned check_file(const char *path) {
    static const char *const flags[] = {"-std=gnu11"};
    const char *message = NULL;
    arena *a = arena_new();
    unsigned bad = 1;
    source *s = source_read(a, path, &message);
    frontend_result parsed = {0};
    if (s)
        parsed = frontend_parse(a, s, 1, flags);
    if (!parsed.unit) {
        fprintf(stderr, "%s: %s\n", path, message ? message : "cannot be parsed");
    } else {
        const analysis_result result = analyse(a, parsed.unit, &(analysis_options){0});
        unsigned count = 0;
        bad = 0;
        for (unsigned i = 0; i < result.verdict_count; i++)
            if (result.verdicts[i].kind == VERDICT_TRANSFORM) {
                bad += check_loop(a, parsed.unit, &result.verdicts[i]);
                count++;
            }
        const char *at = s->text;
        for (; (at = strstr(at, "// PLAN: ")); at++)
            count--;
        if (count != 0)
            fprintf(stderr, "%s: a comment stands at no loop that can run in parallel\n", path);
        bad += count != 0;
    }
    arena_free(a);
    return bad;
}

int main(int argc, char **argv) {
    unsigned bad = argc < 2;
    for (int i = 1; i < argc; i++)
        bad += check_file(argv[i]);
    return bad != 0;
}
