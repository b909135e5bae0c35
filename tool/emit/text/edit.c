/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/text/edit.h"

#include <assert.h>
#include <stdlib.h>

#include "emit/text/origin.h"

void edit_replace(arena *a, edit_list *list, uint32_t begin, uint32_t end, const char *text) {
    assert(text);
    const edit item = {begin, end, text, list->edits.count};
    VECTOR_PUSH(a, &list->edits, item);
}

void edit_insert(arena *a, edit_list *list, uint32_t place, const char *text) {
    edit_replace(a, list, place, place, text);
}

static int compare_edits(const void *left, const void *right) {
    const edit *a = left;
    const edit *b = right;
    if (a->begin != b->begin)
        return a->begin < b->begin ? -1 : 1;
    const bool a_inserts = a->begin == a->end;
    const bool b_inserts = b->begin == b->end;
    if (a_inserts != b_inserts)
        return a_inserts ? -1 : 1;
    return a->serial < b->serial ? -1 : a->serial > b->serial;
}

static bool are_disjoint_and_inside(const edit_list *list, uint32_t begin, uint32_t end) {
    uint32_t free_from = begin;
    for (unsigned i = 0; i < list->edits.count; i++) {
        const edit *item = &list->edits.items[i];
        if (item->begin < free_from || item->end < item->begin || item->end > end)
            return false;
        free_from = item->end;
    }
    return begin <= end;
}

static void append_plainly(buffer *out, const char *text, uint32_t begin, uint32_t end) {
    buffer_append(out, text + begin, end - begin);
}

static bool apply(buffer *out, const char *text, uint32_t begin, uint32_t end, edit_list *list,
                  void (*keep)(buffer *, const char *, uint32_t, uint32_t)) {
    if (list->edits.count > 0)
        qsort(list->edits.items, list->edits.count, sizeof *list->edits.items, compare_edits);
    if (!are_disjoint_and_inside(list, begin, end))
        return false;
    uint32_t copied = begin;
    for (unsigned i = 0; i < list->edits.count; i++) {
        const edit *item = &list->edits.items[i];
        keep(out, text, copied, item->begin);
        buffer_text(out, item->text);
        copied = item->end;
    }
    assert(copied <= end);
    keep(out, text, copied, end);
    return true;
}

bool edit_apply(buffer *out, const char *text, uint32_t begin, uint32_t end, edit_list *list) {
    return apply(out, text, begin, end, list, append_plainly);
}

bool edit_apply_marked(buffer *out, const char *text, uint32_t begin, uint32_t end,
                       edit_list *list) {
    return apply(out, text, begin, end, list, origin_copy);
}
