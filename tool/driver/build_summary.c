/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The summary of a build's report, for redcc-cc --redcc-summary. */
#include <errno.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>

#include "driver/build_report.h"
#include "driver/installation.h"

/* A text, and how often it occurs. */
struct count {
    const char *text; /* owned by the JSON object of counts */
    json_int_t times;
};

struct totals {
    json_int_t files, translated_files, left_alone, parallel, refused_loops;
    json_int_t remade;  /* parallel loops that need a new plan for each execution */
    json_int_t never;   /* parallel loops that by default do not run in parallel */
    json_t *refused;    /* reason's id and slug -> number of loops */
    json_t *in_headers; /* keys of the loops in headers that have been counted */
    json_t *reasons;    /* reason why a file was compiled unchanged -> number of files */
};

static void count_one(json_t *counts, const char *text) {
    const json_int_t before = json_integer_value(json_object_get(counts, text));
    json_object_set_new(counts, text, json_integer(before + 1));
}

/* Has the loop of a header been counted before? Each source that includes the header reports it. */
static bool is_known(const struct totals *totals, const char *folder, const json_t *loop) {
    const char *name = json_string_value(json_object_get(loop, "file"));
    if (!name)
        return false;
    arena *a = arena_new();
    const char *path = *name == '/' || !folder ? name : arena_format(a, "%s/%s", folder, name);
    char *resolved = realpath(path, NULL);
    const char *key = arena_format(a, "%s:%lld:%lld:%s", resolved ? resolved : path,
                                   (long long)json_integer_value(json_object_get(loop, "line")),
                                   (long long)json_integer_value(json_object_get(loop, "column")),
                                   json_string_value(json_object_get(loop, "verdict")));
    const bool is_found = json_object_get(totals->in_headers, key) != NULL;
    json_object_set_new(totals->in_headers, key, json_true());
    free(resolved);
    arena_free(a);
    return is_found;
}

static void add_loop(struct totals *totals, const json_t *loop, bool *translated) {
    const char *verdict = json_string_value(json_object_get(loop, "verdict"));
    if (verdict && strcmp(verdict, "transformed") == 0) {
        const char *plan = json_string_value(json_object_get(loop, "plan"));
        totals->parallel++;
        totals->remade += plan && strcmp(plan, "remade") == 0;
        totals->never += plan && strcmp(plan, "never") == 0;
        *translated = true;
        return;
    }
    totals->refused_loops++;
    const json_t *reason = json_object_get(loop, "reason");
    const char *id = json_string_value(json_object_get(reason, "id"));
    const char *slug = json_string_value(json_object_get(reason, "slug"));
    char text[128];
    snprintf(text, sizeof text, "%s %s", id ? id : "?", slug ? slug : "");
    count_one(totals->refused, text);
}

/* Returns false if the object does not belong in a build's report. */
static bool add_file(struct totals *totals, const json_t *file) {
    const json_t *loops = json_object_get(file, "loops");
    if (!json_is_array(loops))
        return false;
    totals->files++;
    const char *why = json_string_value(json_object_get(file, "left_alone"));
    if (why) {
        totals->left_alone++;
        count_one(totals->reasons, why);
    }
    bool translated = false;
    size_t i;
    const json_t *loop;
    json_array_foreach(loops, i, loop) {
        if (!is_known(totals, json_string_value(json_object_get(file, "directory")), loop))
            add_loop(totals, loop, &translated);
    }
    totals->translated_files += translated;
    return true;
}

static int more_often_first(const void *left, const void *right) {
    const struct count *l = left, *r = right;
    if (l->times != r->times)
        return l->times < r->times ? 1 : -1;
    return strcmp(l->text, r->text);
}

static void print_counts(json_t *counts, const char *what, FILE *out) {
    const size_t size = json_object_size(counts);
    struct count *list = calloc(size + 1, sizeof *list);
    size_t n = 0;
    const char *text;
    json_t *times;
    if (!list)
        return;
    json_object_foreach(counts, text, times) {
        list[n++] = (struct count){text, json_integer_value(times)};
    }
    qsort(list, n, sizeof *list, more_often_first);
    for (size_t i = 0; i < n; i++)
        fprintf(out, "  %s: %s: %lld\n", what, list[i].text, (long long)list[i].times);
    free(list);
}

static void print_totals(const struct totals *totals, FILE *out) {
    fprintf(out,
            "redcc-cc: files: %lld, %lld with a loop made parallel, %lld left alone; irregular "
            "reductions: %lld parallel, %lld refused\n",
            (long long)totals->files, (long long)totals->translated_files,
            (long long)totals->left_alone, (long long)totals->parallel,
            (long long)totals->refused_loops);
    if (totals->remade > 0)
        fprintf(out, "  parallel by a plan for each execution: %lld\n", (long long)totals->remade);
    if (totals->never > 0)
        fprintf(out, "  translated, with too few iterations to run in parallel: %lld\n",
                (long long)totals->never);
    print_counts(totals->refused, "refused", out);
    print_counts(totals->reasons, "left alone", out);
    arena *a = arena_new();
    const char *pages = installation_documents(a);
    if (pages && totals->left_alone + totals->refused_loops > 0)
        fprintf(out, "  what can be done: %s/refused.md\n", pages);
    arena_free(a);
}

/* Reads every line of the stream; returns the number of the first invalid one, or 0. */
static long add_lines(struct totals *totals, FILE *in) {
    char *line = NULL;
    size_t size = 0;
    long number = 0, wrong = 0;
    while (!wrong && getline(&line, &size, in) >= 0) {
        number++;
        json_t *object = json_loads(line, 0, NULL);
        if (!object || !add_file(totals, object))
            wrong = number;
        json_decref(object);
    }
    free(line);
    return wrong;
}

int build_report_summarise(const char *report, FILE *out) {
    FILE *in = fopen(report, "r");
    if (!in) {
        fprintf(stderr, "redcc-cc: error: cannot read '%s': %s\n", report, strerror(errno));
        return 1;
    }
    struct totals totals = {
        .refused = json_object(), .reasons = json_object(), .in_headers = json_object()};
    const long wrong = add_lines(&totals, in);
    fclose(in);
    if (wrong)
        fprintf(stderr,
                "redcc-cc: error: %s:%ld: expected a JSON object with \"loops\", as redcc-cc "
                "appends it to REDCC_BUILD_REPORT\n",
                report, wrong);
    else
        print_totals(&totals, out);
    json_decref(totals.refused);
    json_decref(totals.reasons);
    json_decref(totals.in_headers);
    return wrong != 0;
}
