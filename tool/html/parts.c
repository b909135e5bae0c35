/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What the index and the pages of the sources share: file names, the beginning and the end of a
 * page, a loop's verdict, its share of the time, and its gain. */
#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "html/pages.h"
#include "html/text.h"

const char *page_name(const reports *r, const report_file *file) {
    char base[41];
    unsigned number = 0, length = 0;
    if (file->loops.count == 0)
        return NULL;
    while (r->files.items[number] != file)
        number++;
    const char *slash = strrchr(file->name, '/');
    for (const char *at = slash ? slash + 1 : file->name; *at && length + 1 < sizeof base; at++) {
        const bool is_plain = isalnum((unsigned char)*at) || (*at == '.' && length > 0);
        base[length++] = is_plain ? *at : '_';
    }
    base[length] = 0;
    return arena_format(r->memory, "%u-%s.html", number + 1, base);
}

void page_begin(buffer *out, const char *title) {
    buffer_text(out, "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n"
                     "<head>\n<meta charset=\"utf-8\"/>\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
                     "<meta name=\"generator\" content=\"redcc-cc " REDCC_VERSION "\"/>\n<title>");
    html_text(out, title);
    buffer_text(out, "</title>\n<link rel=\"stylesheet\" href=\"style.css\"/>\n</head>\n<body>\n");
}

void page_end(buffer *out) {
    buffer_text(out,
                "<p class=\"soft\">Made by redcc-cc " REDCC_VERSION ".</p>\n</body>\n</html>\n");
}

void page_verdict(buffer *out, const report_loop *loop) {
    const char *verdict = loop->verdict ? json_word(loop->verdict, "verdict") : "";
    if (loop_is_parallel(loop))
        buffer_text(out, "<span class=\"parallel\"><span class=\"mark\">parallel</span></span>");
    else if (strcmp(verdict, "refused") == 0)
        buffer_text(out, "<span class=\"refused\"><span class=\"mark\">sequential</span></span>");
    else
        buffer_format(out, "<span class=\"mark\">%s</span>",
                      loop->verdict ? "no irregular update" : "not in the build's report");
}

void page_share(buffer *out, const loop_time *time) {
    if (time->runs == 0 || time->process <= 0) {
        buffer_text(out, "<span class=\"soft\">-</span>");
        return;
    }
    const double share = time->seconds >= time->process ? 100 : 100 * time->seconds / time->process;
    buffer_format(out,
                  "<span class=\"share\" aria-hidden=\"true\"><i style=\"width:%.1f%%\"></i></span>"
                  "%.1f %%",
                  share, share);
}

void page_gain(buffer *out, const loop_time *time) {
    const json_t *gain = time->runs > 0 ? json_object_get(time->last, "speedup") : NULL;
    if (json_is_number(gain))
        buffer_format(out, "%.2f", json_number_value(gain));
    else
        buffer_text(out, "<span class=\"soft\">-</span>");
}
