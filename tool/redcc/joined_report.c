/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/joined_report.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "redcc/output.h"
#include "support/json_text.h"

bool joined_report_is_needed(const options *o) {
    return o->analyze && o->inputs.count != 1 && (o->report.form == REPORT_SARIF || o->report.file);
}

options joined_report_of_one(const options *o) {
    options of_one = *o;
    assert(joined_report_is_needed(o));
    of_one.report.file = "-";
    return of_one;
}

joined_report joined_report_begin(const options *o) {
    return (joined_report){.form = o->report.form, .path = o->report.file ? o->report.file : "-"};
}

/* ---- SARIF: one run, with each rule once ----------------------------------------------------- */

static json_t *run_of(json_t *log) {
    return json_array_get(json_object_get(log, "runs"), 0);
}

static json_t *rules_of(json_t *log) {
    return json_object_get(json_object_get(json_object_get(run_of(log), "tool"), "driver"),
                           "rules");
}

static bool has_rule(const json_t *rules, const json_t *rule) {
    for (size_t i = 0; i < json_array_size(rules); i++)
        if (json_equal(json_object_get(json_array_get(rules, i), "id"),
                       json_object_get(rule, "id")))
            return true;
    return false;
}

/* Adds those results that the log does not contain yet. A loop of a header is a result of each file
 * that includes the header. */
static void add_results(joined_report *joined, json_t *results) {
    json_t *all = json_object_get(run_of(joined->log), "results");
    for (size_t i = 0; i < json_array_size(results); i++) {
        json_t *result = json_array_get(results, i);
        char *text = json_dumps(result, JSON_COMPACT);
        if (!json_object_get(joined->known, text) && all != results)
            json_array_append(all, result);
        json_object_set_new(joined->known, text, json_true());
        free(text);
    }
}

static void add_log(joined_report *joined, FILE *printed) {
    json_t *log = json_loadf(printed, 0, NULL);
    if (!log) /* the process has failed */
        return;
    if (!joined->log) {
        joined->log = log;
        joined->known = json_object();
        add_results(joined, json_object_get(run_of(log), "results"));
        return;
    }
    json_t *rules = rules_of(joined->log), *more = rules_of(log);
    for (size_t i = 0; i < json_array_size(more); i++)
        if (!has_rule(rules, json_array_get(more, i)))
            json_array_append(rules, json_array_get(more, i));
    add_results(joined, json_object_get(run_of(log), "results"));
    json_decref(log);
}

/* ---- all ------------------------------------------------------------------------------------- */

void joined_report_add(joined_report *joined, FILE *printed) {
    char bytes[1 << 12];
    size_t count;
    if (joined->form == REPORT_SARIF)
        add_log(joined, printed);
    else
        while ((count = fread(bytes, 1, sizeof bytes, printed)) > 0)
            buffer_append(&joined->text, bytes, count);
}

const char *joined_report_end(arena *a, joined_report *joined) {
    const report_input nothing = {.analysis = &(analysis_result){0}, .version = REDCC_VERSION};
    if (joined->log)
        json_print(&joined->text, joined->log);
    else if (joined->form == REPORT_SARIF) /* an empty log: no file could be read */
        report_write(a, &joined->text, REPORT_SARIF, &nothing);
    const char *wrong = output_write(a, joined->path, joined->text.data ? joined->text.data : "",
                                     joined->text.length);
    buffer_free(&joined->text);
    json_decref(joined->known);
    return wrong;
}
