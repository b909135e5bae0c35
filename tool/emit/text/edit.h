/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Byte edits: all unedited text is preserved byte for byte.
 *
 * An edit replaces bytes [begin, end) of a text; begin == end inserts. Edits may be added in any
 * order. They are applied in the order of their positions. Insertions at one position are applied
 * in the order in which they were added, and before a replacement that begins there.
 */
#ifndef EMIT_TEXT_EDIT_H
#define EMIT_TEXT_EDIT_H

#include <stdbool.h>
#include <stdint.h>

#include "support/arena.h"
#include "support/buffer.h"
#include "support/vector.h"

typedef struct edit {
    uint32_t begin;
    uint32_t end;
    const char *text; /* not copied: must outlive the list */
    unsigned serial;  /* number of edits added before it */
} edit;

typedef struct edit_list {
    VECTOR(edit) edits;
} edit_list; /* {0} is an empty one; the arena owns the storage */

void edit_replace(arena *a, edit_list *list, uint32_t begin, uint32_t end, const char *text);
void edit_insert(arena *a, edit_list *list, uint32_t place, const char *text);

/** Appends bytes [begin, end) of `text` with the edits made. Returns false, and appends nothing, if
 *  an edit reaches outside of these bytes, ends before it begins, or overlaps another edit. Sorts
 *  the list. */
bool edit_apply(buffer *out, const char *text, uint32_t begin, uint32_t end, edit_list *list);
/** Like edit_apply, but marks the unedited parts as copies of the user's bytes (origin.h). */
bool edit_apply_marked(buffer *out, const char *text, uint32_t begin, uint32_t end,
                       edit_list *list);

#endif
