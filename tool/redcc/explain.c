/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* strcasestr */
#include "redcc/explain.h"

#include <string.h>
#include <strings.h>

#include "driver/installation.h"
#include "redcc/nearest.h"
#include "support/buffer.h"

/* The text of docs/reasons.md: it has a section "## ID slug" for each reason, and "# ..." between
 * groups of them. */
extern const char reasons_text[];

static const struct {
    const char *id;
    const char *slug;
} reasons[] = {
#define X(identifier, id, slug, message) {id, slug},
#include "analysis/base/reasons.def"
#undef X
};

enum { REASON_COUNT = sizeof reasons / sizeof *reasons };

/* The beginning of the next heading of either kind, or the end of the text. */
static const char *next_heading(const char *text) {
    for (const char *at = text; (at = strchr(at, '\n')); at++)
        if (strncmp(at, "\n# ", 3) == 0 || strncmp(at, "\n## ", 4) == 0)
            return at + 1;
    return text + strlen(text);
}

const char *explain_section(arena *a, const char *reason) {
    for (unsigned i = 0; i < REASON_COUNT; i++) {
        if (strcasecmp(reason, reasons[i].id) != 0 && strcasecmp(reason, reasons[i].slug) != 0)
            continue;
        const char *heading = arena_format(a, "\n## %s %s\n", reasons[i].id, reasons[i].slug);
        const char *at = strstr(reasons_text, heading);
        if (at)
            return arena_copy(a, at + 4, (size_t)(next_heading(at + 1) - (at + 4)));
    }
    return NULL;
}

const char *explain_link(arena *a, const char *reason) {
    const char *folder = installation_documents(a);
    for (unsigned i = 0; folder && i < REASON_COUNT; i++)
        if (strcasecmp(reason, reasons[i].id) == 0) /* anchors of headings are in lower case */
            return arena_format(a, "%s/reasons.md#r%s-%s", folder, reasons[i].id + 1,
                                reasons[i].slug);
    return NULL;
}

/* At most one line of reasons whose slugs contain the word, or "" if there are none. */
static const char *reasons_with(arena *a, const char *word) {
    enum { SHORTEST = 3, MOST = 6 };
    const char *list = "";
    unsigned count = 0;
    for (unsigned i = 0; i < REASON_COUNT && strlen(word) >= SHORTEST && count < MOST; i++)
        if (strcasestr(reasons[i].slug, word))
            list = arena_format(a, "%s%s%s %s", list, count++ ? ", " : "", reasons[i].id,
                                reasons[i].slug);
    return list;
}

const char *explain_nearest(arena *a, const char *word) {
    const char *with = reasons_with(a, word);
    if (*with)
        return arena_format(a, "%s %s", strchr(with, ',') ? "those near are" : "the nearest is",
                            with);
    unsigned best = 0;
    size_t least = (size_t)-1;
    for (unsigned i = 0; i < REASON_COUNT; i++) {
        const size_t by_id = edit_distance(word, reasons[i].id);
        const size_t by_slug = edit_distance(word, reasons[i].slug);
        const size_t distance = by_id < by_slug ? by_id : by_slug;
        if (distance < least) {
            least = distance;
            best = i;
        }
    }
    return arena_format(a, "the nearest is %s %s", reasons[best].id, reasons[best].slug);
}

const char *explain_list(arena *a) {
    buffer list = {0};
    for (unsigned i = 0; i < REASON_COUNT; i++)
        buffer_format(&list, "%s %s\n", reasons[i].id, reasons[i].slug);
    const char *text = arena_string(a, list.data ? list.data : "");
    buffer_free(&list);
    return text;
}

const char *explain_page(arena *a) {
    const char *folder = installation_documents(a);
    return folder ? arena_format(a, "%s/refused.md", folder) : NULL;
}
