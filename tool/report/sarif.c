/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** SARIF 2.1.0 (OASIS standard): one run, one rule for each reason, one result per loop. */
#include "analysis/base/reason.h"
#include "report/facts.h"
#include "report/plan.h"
#include "support/json_text.h"

#include <string.h>

/** The path as a URI. */
static json_t *uri(const char *path) {
    buffer out = {0};
    buffer_uri(&out, path);
    json_t *value = json_text(out.data ? out.data : "");
    buffer_free(&out);
    return value;
}

static json_t *message(const char *text) {
    json_t *object = json_object();
    json_object_set_new(object, "text", json_text(text));
    return object;
}

static json_t *location(ir_position at) {
    json_t *artifact = json_object();
    json_object_set_new(artifact, "uri", uri(at.file));
    json_t *physical = json_object();
    json_object_set_new(physical, "artifactLocation", artifact);
    if (at.line > 0) { /* regions begin at line 1 (section 3.30.5), but `#line 0` makes a line 0 */
        json_t *region = json_object();
        json_object_set_new(region, "startLine", json_integer(at.line));
        json_object_set_new(region, "startColumn", json_integer(at.column));
        json_object_set_new(physical, "region", region);
    }
    json_t *object = json_object();
    json_object_set_new(object, "physicalLocation", physical);
    return object;
}

static const char *rule_of(const loop_verdict *verdict) {
    return verdict->kind == VERDICT_REFUSE ? reason_code(verdict->why.id) : verdict_word(verdict);
}

/** Adds a property bag with the assertions of the user's pragmas, and the use of plans. */
static void add_properties(arena *a, json_t *result, const loop_verdict *verdict) {
    const plan_answer plan = verdict_plan(a, verdict);
    json_t *bag = json_object(), *pragmas = json_array();
    for (unsigned i = 0; i < verdict->pragma_count; i++)
        json_array_append_new(pragmas, json_text(verdict->pragmas[i].text));
    if (verdict->pragma_count > 0)
        json_object_set(bag, "pragmas", pragmas);
    if (plan.word)
        json_object_set_new(bag, "plan", json_text(plan.word));
    if (plan.cause)
        json_object_set_new(bag, "planCause", json_text(plan.cause));
    if (json_object_size(bag) > 0)
        json_object_set(result, "properties", bag);
    json_decref(pragmas);
    json_decref(bag);
}

/** Adds the place of a reason to the result, with a text. */
static void add_related(json_t *result, ir_position at, const char *text) {
    json_t *where = location(at);
    json_object_set_new(where, "message", message(text));
    json_t *related = json_array();
    json_array_append_new(related, where);
    json_object_set_new(result, "relatedLocations", related);
}

static json_t *result_of(arena *a, const report_input *input, const loop_verdict *verdict) {
    const bool is_refused = verdict->kind == VERDICT_REFUSE;
    json_t *result = json_object();
    json_object_set_new(result, "ruleId", json_text(rule_of(verdict)));
    json_object_set_new(result, "kind",
                        json_text(verdict_is_written(verdict) ? "pass"
                                  : is_refused                ? "review"
                                                              : "notApplicable"));
    json_object_set_new(result, "level", json_text("none"));
    json_object_set_new(result, "message", message(verdict_sentence(a, verdict)));
    json_t *locations = json_array();
    json_array_append_new(locations, location(verdict_position(input, verdict)));
    json_object_set_new(result, "locations", locations);
    add_properties(a, result, verdict);
    const lanes_remark *lanes = verdict_lanes(input, verdict);
    if (is_refused)
        add_related(result, reason_position(input, verdict), verdict->why.message);
    else if (lanes && lanes->slug)
        add_related(
            result, lanes_position(input, lanes),
            arena_format(a, "one iteration at a time: %s (%s)", lanes->message, lanes->slug));
    return result;
}

/* A text that is the same for all loops with the verdict's rule. For a refusal it is the message
 * with dots in place of the name. */
static const char *short_text(arena *a, const loop_verdict *verdict) {
    if (verdict->kind != VERDICT_REFUSE)
        return verdict_is_written(verdict)
                   ? "the loop runs in parallel"
                   : "the loop has no update by which iterations may conflict";
    return reason_make(a, verdict->why.id, "...", (ir_range){0}).message;
}

static json_t *rule_object(arena *a, const report_input *input, const loop_verdict *verdict) {
    const bool is_refused = verdict->kind == VERDICT_REFUSE;
    const char *section = is_refused && input->explain ? input->explain(a, rule_of(verdict)) : NULL;
    json_t *rule = json_object();
    json_object_set_new(rule, "id", json_text(rule_of(verdict)));
    json_object_set_new(
        rule, "name", json_text(is_refused ? reason_slug(verdict->why.id) : verdict_word(verdict)));
    json_object_set_new(rule, "shortDescription", message(short_text(a, verdict)));
    if (section) {
        json_t *help = message(section);
        json_object_set_new(help, "markdown", json_text(section));
        json_object_set_new(rule, "help", help);
    }
    const char *link = is_refused && input->link ? input->link(a, rule_of(verdict)) : NULL;
    if (link)
        json_object_set_new(rule, "helpUri", json_text(link));
    return rule;
}

/* Does the loop become a result in the SARIF file? By default, a loop that runs in parallel does
 * not, because it needs no review. */
static bool is_reported(const report_input *input, const loop_verdict *verdict) {
    return input->all || !verdict_is_written(verdict);
}

static bool has_rule(const json_t *rules, const char *id) {
    for (size_t i = 0; i < json_array_size(rules); i++)
        if (strcmp(json_string_value(json_object_get(json_array_get(rules, i), "id")), id) == 0)
            return true;
    return false;
}

static json_t *rules_of(arena *a, const report_input *input) {
    json_t *rules = json_array();
    for (unsigned i = 0; i < input->analysis->verdict_count; i++) {
        const loop_verdict *verdict = &input->analysis->verdicts[i];
        if (is_reported(input, verdict) && !has_rule(rules, rule_of(verdict)))
            json_array_append_new(rules, rule_object(a, input, verdict));
    }
    return rules;
}

void report_sarif(arena *a, buffer *out, const report_input *input) {
    json_t *driver = json_object();
    json_object_set_new(driver, "name", json_text("redcc"));
    json_object_set_new(driver, "version", json_text(input->version));
    json_object_set_new(driver, "rules", rules_of(a, input));
    json_t *tool = json_object();
    json_object_set_new(tool, "driver", driver);
    json_t *results = json_array();
    for (unsigned i = 0; i < input->analysis->verdict_count; i++)
        if (is_reported(input, &input->analysis->verdicts[i]))
            json_array_append_new(results, result_of(a, input, &input->analysis->verdicts[i]));
    json_t *run = json_object();
    json_object_set_new(run, "tool", tool);
    json_object_set_new(run, "results", results);
    json_t *runs = json_array();
    json_array_append_new(runs, run);
    json_t *root = json_object();
    json_object_set_new(root, "$schema",
                        json_text("https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/"
                                  "schemas/sarif-schema-2.1.0.json"));
    json_object_set_new(root, "version", json_text("2.1.0"));
    json_object_set_new(root, "runs", runs);
    json_print(out, root);
}
