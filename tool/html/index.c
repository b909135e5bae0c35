/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The first page: a summary of the build, and its loops sorted by the time lost in them. */
#include <stdlib.h>
#include <string.h>

#include "html/pages.h"
#include "html/text.h"

static void add_fact(buffer *out, unsigned count, const char *what) {
    buffer_format(out, "<li><b>%u</b> %s</li>\n", count, what);
}

static void add_facts(const reports *r, buffer *out) {
    unsigned parallel = 0, refused = 0, left_alone = 0;
    for (unsigned i = 0; i < r->files.count; i++) {
        parallel += r->files.items[i]->parallel;
        refused += r->files.items[i]->refused;
        left_alone += r->files.items[i]->left_alone != NULL;
    }
    buffer_text(out, "<ul class=\"facts\">\n");
    add_fact(out, parallel, parallel == 1 ? "parallel loop" : "parallel loops");
    add_fact(out, refused, refused == 1 ? "sequential loop" : "sequential loops");
    add_fact(out, r->files.count, r->files.count == 1 ? "C file" : "C files");
    add_fact(out, left_alone, left_alone == 1 ? "file left alone" : "files left alone");
    add_fact(out, r->runs, r->runs == 1 ? "run" : "runs");
    buffer_text(out, "</ul>\n");
}

static void add_place(const reports *r, buffer *out, const report_loop *loop) {
    const char *page = loop->file ? page_name(r, loop->file) : NULL;
    buffer_text(out, "<span class=\"place\">");
    if (page)
        buffer_format(out, "<a href=\"%s#L%lld\">", page, (long long)loop->line);
    html_text(out, loop->name);
    buffer_format(out, ":%lld%s</span>", (long long)loop->line, page ? "</a>" : "");
}

static void add_seconds_or_dash(buffer *out, const loop_time *time, double seconds,
                                const char *kind) {
    buffer_format(out, "<td class=\"%s\">", kind);
    if (time->runs > 0)
        html_seconds(out, seconds);
    else
        buffer_text(out, "<span class=\"soft\">-</span>");
    buffer_text(out, "</td>");
}

static void add_plan(buffer *out, const loop_time *time) {
    const json_int_t all = time->built + time->reused;
    if (all == 0)
        buffer_text(out, "<span class=\"soft\">-</span>");
    else
        buffer_format(out, "kept %lld of %lld", (long long)time->reused, (long long)all);
}

static void add_loop(const reports *r, buffer *out, const report_loop *loop) {
    const json_t *reason = loop->verdict ? json_object_get(loop->verdict, "reason") : NULL;
    buffer_text(out, "<tr><td>");
    add_place(r, out, loop);
    buffer_text(out, "<br/><span class=\"soft\">");
    html_text(out, loop->function);
    buffer_text(out, "</span></td><td>");
    page_verdict(out, loop);
    if (json_is_object(reason)) {
        buffer_text(out, "<br/><span class=\"soft\">");
        html_text(out, json_word(reason, "id"));
        buffer_text(out, " ");
        html_text(out, json_word(reason, "slug"));
        buffer_text(out, "</span>");
    }
    buffer_text(out, "</td>");
    add_seconds_or_dash(out, &loop->time, loop->time.lost, "number");
    add_seconds_or_dash(out, &loop->time, loop->time.seconds, "number wide");
    buffer_text(out, "<td class=\"wide\">");
    page_share(out, &loop->time);
    buffer_text(out, "</td><td class=\"number\">");
    page_gain(out, &loop->time);
    buffer_text(out, "</td><td class=\"wide\">");
    if (loop->time.runs > 0)
        html_text(out, json_word(loop->time.last, "method"));
    else
        buffer_text(out, "<span class=\"soft\">-</span>");
    buffer_text(out, "</td><td class=\"wide\">");
    add_plan(out, &loop->time);
    buffer_text(out, "</td></tr>\n");
}

static void add_loops(const reports *r, buffer *out) {
    buffer_text(out, "<h2 id=\"loops\">Loops, by time lost</h2>\n");
    if (r->loops.count == 0) {
        buffer_text(out, "<p>No loop of the build updates an array through an irregular "
                         "subscript.</p>\n");
        return;
    }
    buffer_text(
        out,
        r->runs > 0
            ? "<p class=\"soft\">Time lost: what a loop took beyond its sequential time "
              "divided by the threads. Only loops that redcc has made parallel are timed.</p>\n"
            : "<p class=\"soft\">No run's report was given: run the program with "
              "<code>REDCC_REPORT=FILE</code>, and name that file as well, to see times.</p>\n");
    buffer_text(out,
                "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-labelledby=\"loops\">\n"
                "<table>\n<thead><tr><th scope=\"col\">Loop</th><th scope=\"col\">Verdict</th>"
                "<th scope=\"col\" class=\"number\">Time lost</th><th scope=\"col\" "
                "class=\"number wide\">Time</th><th scope=\"col\" class=\"wide\">Share</th>"
                "<th scope=\"col\" class=\"number\">Gain</th><th scope=\"col\" class=\"wide\">"
                "Method</th><th scope=\"col\" class=\"wide\">Plan</th></tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < r->loops.count; i++)
        add_loop(r, out, r->loops.items[i]);
    buffer_text(out, "</tbody>\n</table>\n</div>\n");
}

/* ---- reasons, most frequent first ------------------------------------------------------------ */

typedef struct reason_count {
    const char *id, *slug;
    unsigned count;
} reason_count;

static int more_often_first(const void *left, const void *right) {
    const reason_count *l = left, *r = right;
    if (l->count != r->count)
        return l->count > r->count ? -1 : 1;
    return strcmp(l->id, r->id);
}

static void count_reason(reason_count *counts, unsigned *count, const json_t *reason) {
    unsigned i = 0;
    while (i < *count && strcmp(counts[i].id, json_word(reason, "id")) != 0)
        i++;
    if (i == *count)
        counts[(*count)++] = (reason_count){json_word(reason, "id"), json_word(reason, "slug"), 0};
    counts[i].count++;
}

static void add_reasons(const reports *r, buffer *out) {
    reason_count *counts = ARENA_ARRAY(r->memory, reason_count, r->loops.count + 1);
    unsigned count = 0;
    for (unsigned i = 0; i < r->loops.count; i++) {
        const json_t *reason = json_object_get(r->loops.items[i]->verdict, "reason");
        if (json_is_object(reason))
            count_reason(counts, &count, reason);
    }
    if (count == 0)
        return;
    qsort(counts, count, sizeof *counts, more_often_first);
    buffer_text(out,
                "<h2 id=\"reasons\">Why loops stay sequential</h2>\n"
                "<p class=\"soft\">What each means, and what to change, is under the loops.</p>\n"
                "<ul class=\"jump\">\n");
    for (unsigned i = 0; i < count; i++) {
        buffer_format(out, "<li><b>%u</b> ", counts[i].count);
        html_text(out, counts[i].id);
        buffer_text(out, " ");
        html_text(out, counts[i].slug);
        buffer_text(out, "</li>\n");
    }
    buffer_text(out, "</ul>\n");
}

/* ---- files ----------------------------------------------------------------------------------- */

static void add_file(const reports *r, buffer *out, const report_file *file) {
    const char *page = page_name(r, file);
    buffer_text(out, "<tr><td class=\"place\">");
    if (page)
        buffer_format(out, "<a href=\"%s\">", page);
    html_text(out, file->name);
    buffer_format(out, "%s</td><td class=\"number\">%u</td><td class=\"number\">%u</td><td>",
                  page ? "</a>" : "", file->parallel, file->refused);
    if (file->left_alone) {
        buffer_text(out, "left alone: ");
        html_text(out, file->left_alone);
    } else if (!page) {
        buffer_text(out, "<span class=\"soft\">no irregular loop</span>");
    }
    buffer_text(out, "</td></tr>\n");
}

static void add_files(const reports *r, buffer *out) {
    buffer_text(out, "<h2 id=\"files\">Files</h2>\n<div class=\"scroll\" tabindex=\"0\" "
                     "role=\"region\" aria-labelledby=\"files\">\n<table>\n<thead><tr>"
                     "<th scope=\"col\">File</th><th scope=\"col\" class=\"number\">Parallel</th>"
                     "<th scope=\"col\" class=\"number\">Sequential</th><th scope=\"col\">Note</th>"
                     "</tr></thead>\n<tbody>\n");
    for (unsigned i = 0; i < r->files.count; i++)
        add_file(r, out, r->files.items[i]);
    buffer_text(out, "</tbody>\n</table>\n</div>\n");
}

void page_index(const reports *r, buffer *out) {
    page_begin(out, "redcc: loops of the build");
    buffer_text(out, "<main>\n<h1>Loops of the build</h1>\n");
    add_facts(r, out);
    add_loops(r, out);
    add_reasons(r, out);
    add_files(r, out);
    buffer_text(out, "</main>\n");
    page_end(out);
}
