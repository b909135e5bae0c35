/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* A source's page: its text, with a note under each loop. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "html/pages.h"
#include "html/text.h"

/* The text of docs/reasons.md: it has a section "## ID slug" for each reason, and "# ..." between
 * groups of them. */
extern const char reasons_text[];

/* The section on a reason, in the arena, or NULL if there is none. */
static const char *advice(arena *a, const json_t *reason) {
    const char *heading =
        arena_format(a, "\n## %s %s\n", json_word(reason, "id"), json_word(reason, "slug"));
    const char *at = strstr(reasons_text, heading);
    if (!at)
        return NULL;
    const char *begin = at + 1, *end = begin;
    while ((end = strstr(end, "\n#")) && strncmp(end, "\n# ", 3) != 0 &&
           strncmp(end, "\n## ", 4) != 0)
        end++;
    return end ? arena_copy(a, begin, (size_t)(end - begin)) : begin;
}

/* ---- the note on a loop ---------------------------------------------------------------------- */

static void add_row(buffer *out, const char *name) {
    buffer_format(out, "<tr><th scope=\"row\">%s</th><td>", name);
}

static void add_list(buffer *out, const json_t *list, const char *name) {
    size_t i;
    const json_t *one;
    if (json_array_size(list) == 0)
        return;
    add_row(out, name);
    json_array_foreach(list, i, one) {
        buffer_text(out, i > 0 ? ", <code>" : "<code>");
        html_text(out, json_is_string(one) ? json_string_value(one) : json_word(one, "name"));
        buffer_text(out, "</code>");
        if (!json_is_object(one))
            continue;
        buffer_text(out, " (");
        html_text(out, json_word(one, "operator"));
        buffer_text(out, *json_word(one, "operator") ? " " : "");
        html_text(out, json_word(one, "type"));
        buffer_text(out, ")");
    }
    buffer_text(out, "</td></tr>\n");
}

/* Appends how many calls of the last run were sequential and for which reasons, and the advice of
 * the run's report. */
static void add_fallbacks(buffer *out, const json_t *run) {
    const json_t *list = json_object_get(run, "fallbacks"), *one;
    const char *advice = json_word(run, "why_sequential");
    size_t i;
    if (json_array_size(list) == 0)
        return;
    add_row(out, "Ran sequentially");
    json_array_foreach(list, i, one) {
        buffer_format(out, "%s%lld &#215; ", i > 0 ? "<br/>" : "",
                      (long long)json_integer_value(json_object_get(one, "count")));
        html_text(out, json_word(one, "reason"));
    }
    buffer_text(out, "</td></tr>\n");
    if (!*advice)
        return;
    add_row(out, "Advice");
    html_text(out, advice);
    buffer_text(out, "</td></tr>\n");
}

static void add_lost_plans(buffer *out, const loop_time *time) {
    const json_t *changed = json_object_get(time->last, "changed"), *one;
    size_t i;
    if (time->plans_lost == 0)
        return;
    buffer_format(out, "; lost: %lld, as this had changed:", (long long)time->plans_lost);
    json_array_foreach(changed, i, one) {
        buffer_text(out, i > 0 ? ", <code>" : " <code>");
        html_text(out, json_word(one, "array"));
        buffer_text(out, "</code>");
    }
}

static void add_time(buffer *out, const loop_time *time) {
    if (time->runs == 0)
        return;
    add_row(out, "Time");
    html_seconds(out, time->seconds);
    buffer_format(out, " in %lld calls, ", (long long)time->calls);
    html_seconds(out, time->lost);
    buffer_text(out, " lost</td></tr>\n");
    add_row(out, "Share of the run");
    page_share(out, time);
    buffer_text(out, "</td></tr>\n");
    add_row(out, "Measured gain");
    page_gain(out, time);
    buffer_text(out, "</td></tr>\n");
    add_row(out, "Method");
    html_text(out, json_word(time->last, "method"));
    const long long threads = (long long)json_integer_value(json_object_get(time->last, "threads"));
    buffer_format(out, ", %lld %s, by rule ", threads, threads == 1 ? "thread" : "threads");
    html_text(out, json_word(time->last, "rule"));
    buffer_text(out, ", last call ");
    html_text(out, json_word(time->last, "mode"));
    buffer_text(out, "</td></tr>\n");
    add_row(out, "Plan");
    if (time->built + time->reused == 0)
        buffer_text(out, "none was needed");
    else
        buffer_format(out, "built: %lld, kept: %lld executions", (long long)time->built,
                      (long long)time->reused);
    add_lost_plans(out, time);
    buffer_text(out, "</td></tr>\n");
    add_fallbacks(out, time->last);
}

static const char *kind_of(const report_loop *loop) {
    if (loop_is_parallel(loop))
        return "parallel";
    return strcmp(json_word(loop->verdict, "verdict"), "refused") == 0 ? "refused" : "other";
}

static void add_reason(const reports *r, buffer *out, const report_loop *loop, long long lines) {
    const json_t *reason = json_object_get(loop->verdict, "reason");
    if (!json_is_object(reason))
        return;
    buffer_text(out, "<p>");
    html_text(out, json_word(reason, "message"));
    const long long line = (long long)json_integer_value(json_object_get(reason, "line"));
    if (line > 0 && line <= lines)
        buffer_format(out, " (<a href=\"#L%lld\">line %lld</a>)</p>\n", line, line);
    else
        buffer_format(out, " (line %lld)</p>\n", line);
    const char *section = advice(r->memory, reason);
    if (!section)
        return;
    buffer_text(out, "<details><summary>What this means, and what to change (");
    html_text(out, json_word(reason, "id"));
    buffer_text(out, " ");
    html_text(out, json_word(reason, "slug"));
    buffer_text(out, ")</summary>\n");
    html_section(out, section);
    buffer_text(out, "</details>\n");
}

/* Appends the note on a loop. `lines`: the number of lines of the source that the page shows; only
 * numbers of these lines become links. */
static void add_note(const reports *r, buffer *out, const report_loop *loop, long long lines) {
    buffer_format(out, "<section class=\"note %s\">\n<p>", kind_of(loop));
    page_verdict(out, loop);
    buffer_text(out, " loop in <code>");
    html_text(out, loop->function);
    buffer_format(out, "</code>, line %lld", (long long)loop->line);
    if (loop->compilations > 1)
        buffer_format(out, ", in %u compilations", loop->compilations);
    buffer_text(out, "</p>\n");
    add_reason(r, out, loop, lines);
    buffer rows = {0};
    add_list(&rows, json_object_get(loop->verdict, "arrays"), "Updates");
    add_list(&rows, json_object_get(loop->verdict, "guards"), "Checked at run time");
    add_list(&rows, json_object_get(loop->verdict, "pragmas"), "By your word");
    add_time(&rows, &loop->time);
    if (rows.length > 0)
        buffer_format(out, "<table>\n<tbody>\n%s</tbody>\n</table>\n", rows.data);
    buffer_free(&rows);
    buffer_text(out, "</section>\n");
}

/* ---- the text -------------------------------------------------------------------------------- */

static bool read_source(buffer *text, const char *path) {
    FILE *file = fopen(path, "rb");
    char part[65536];
    size_t count;
    if (!file)
        return false;
    while ((count = fread(part, 1, sizeof part, file)) > 0)
        buffer_append(text, part, count);
    const bool good = !ferror(file);
    fclose(file);
    return good;
}

/* Appends the notes on loops from number `next` on, whose lines are not shown. */
static void add_rest(const reports *r, const report_file *file, buffer *out, unsigned next) {
    for (long long before = 0; next < file->loops.count; next++) {
        const report_loop *loop = file->loops.items[next];
        if (loop->line != before)
            buffer_format(out, "<div id=\"L%lld\"></div>\n", (long long)loop->line);
        before = loop->line;
        add_note(r, out, loop, 0);
    }
}

static long long count_lines(const char *text) {
    long long count = 0;
    for (; *text; text += strcspn(text, "\n"), text += *text == '\n')
        count++;
    return count;
}

/* Appends the lines. The encoding is decided for the whole text, because a single line may be valid
 * in both UTF-8 and Latin-1. */
static void add_lines(const reports *r, const report_file *file, buffer *out, const buffer *text) {
    buffer escaped = {0};
    html_bytes(&escaped, text->data ? text->data : "", text->length);
    const char *at = escaped.data ? escaped.data : "";
    const long long lines = count_lines(at);
    unsigned next = 0;
    buffer_text(out, "<div class=\"source\">\n<pre>");
    for (long long line = 1; *at; line++) {
        const report_loop *first = next < file->loops.count ? file->loops.items[next] : NULL;
        const size_t length = strcspn(at, "\n");
        const bool has_loop = first && first->line == line;
        buffer_format(out, "<span id=\"L%lld\"", line);
        if (has_loop)
            buffer_format(out, " class=\"%s\"", kind_of(first));
        buffer_format(out, "><b>%lld</b>", line);
        buffer_append(out, at, length);
        buffer_text(out, "\n</span>");
        at += length + (at[length] == '\n');
        if (!has_loop)
            continue;
        buffer_text(out, "</pre>\n");
        for (; next < file->loops.count && file->loops.items[next]->line == line; next++)
            add_note(r, out, file->loops.items[next], lines);
        buffer_text(out, "<pre>");
    }
    buffer_text(out, "</pre>\n</div>\n");
    if (next < file->loops.count)
        buffer_text(out,
                    "<p>The text has changed since it was compiled: it has no such line.</p>\n");
    add_rest(r, file, out, next);
    buffer_free(&escaped);
}

/* Removes the CR of line ends CR LF. */
static void even_lines(buffer *text) {
    size_t kept = 0;
    for (size_t i = 0; i < text->length; i++)
        if (text->data[i] != '\r' || i + 1 == text->length || text->data[i + 1] != '\n')
            text->data[kept++] = text->data[i];
    buffer_shorten(text, text->length - kept);
}

static void add_text(const reports *r, const report_file *file, buffer *out) {
    buffer text = {0};
    if (read_source(&text, file->path)) {
        even_lines(&text);
        add_lines(r, file, out, &text);
    } else {
        buffer_text(out, "<p>The text cannot be read at <code>");
        html_text(out, file->path);
        buffer_text(out, "</code>; the loops by themselves:</p>\n");
        add_rest(r, file, out, 0);
    }
    buffer_free(&text);
}

void page_source(const reports *r, const report_file *file, buffer *out) {
    page_begin(out, arena_format(r->memory, "redcc: %s", file->name));
    buffer_text(out, "<nav><a href=\"index.html\">All loops</a></nav>\n<main>\n<h1>");
    html_text(out, file->name);
    buffer_text(out, "</h1>\n<ul class=\"jump\">\n");
    for (unsigned i = 0; i < file->loops.count; i++) {
        const report_loop *loop = file->loops.items[i];
        buffer_format(out, "<li><a href=\"#L%lld\">line %lld</a> ", (long long)loop->line,
                      (long long)loop->line);
        page_verdict(out, loop);
        buffer_text(out, " <span class=\"soft\">");
        html_text(out, loop->function);
        buffer_text(out, "</span></li>\n");
    }
    buffer_text(out, "</ul>\n");
    add_text(r, file, out);
    buffer_text(out, "</main>\n");
    page_end(out);
}
