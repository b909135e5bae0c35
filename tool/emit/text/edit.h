/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Byte edits: what is not edited stays as it is, byte for byte.
 *
 * An edit replaces bytes [begin, end) of a text by others; begin == end inserts. Edits may be added
 * in any order; they are applied in the order of their places, insertions at one place in the order
 * in which they were added and before what is replaced there.
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
    const char *text; /* not copied: must live as long as the list */
    unsigned serial;  /* when it was added */
} edit;

typedef struct edit_list {
    VECTOR(edit) edits;
} edit_list; /* {0} is an empty one; storage is the arena's */

void edit_replace(arena *a, edit_list *list, uint32_t begin, uint32_t end, const char *text);
void edit_insert(arena *a, edit_list *list, uint32_t place, const char *text);

/** Appends bytes [begin, end) of `text` with the edits made. Returns false, with nothing appended,
 *  where an edit leaves that range, ends before it begins, or overlaps another. Sorts the list. */
bool edit_apply(buffer *out, const char *text, uint32_t begin, uint32_t end, edit_list *list);
/** The same, what is kept of the text marked as a copy of it (origin.h). */
bool edit_apply_marked(buffer *out, const char *text, uint32_t begin, uint32_t end,
                       edit_list *list);

#endif
