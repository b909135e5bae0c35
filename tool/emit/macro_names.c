/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/macro_names.h"

#include "emit/text/origin.h"
#include "plan/macros.h"

static void check_piece(loop_text *loop, buffer *piece) {
    const char *name = piece->length > 0
                           ? macro_name_in(loop->arena, loop->unit, piece->data, piece->length)
                           : NULL;
    if (name)
        loop_obstacle(loop, loop->facts->loop->range,
                      "the macro '%s' would change the text that is written", name);
    piece->length = 0;
}

/** Words that the macros of redcc/loop.h contain in every form. */
static const char words_of_all_forms[] = "void int const char for (0) sizeof(0) ";

void check_macro_names(loop_text *loop, const buffer *written) {
    buffer piece = {0};
    buffer_text(&piece, words_of_all_forms);
    check_piece(loop, &piece);
    const char *at = written->data, *const end = at + written->length;
    while (at < end) {
        const char *const after = origin_skip(at, end);
        if (origin_is_copy(at, end))
            check_piece(loop, &piece);
        if (after == at)
            buffer_byte(&piece, *at++);
        else
            at = after;
    }
    check_piece(loop, &piece);
    buffer_free(&piece);
}
