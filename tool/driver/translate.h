/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Translates a C source of the command to the text that is compiled in its place. */
#ifndef DRIVER_TRANSLATE_H
#define DRIVER_TRANSLATE_H

#include "driver/session.h"

typedef struct translation {
    const item *source;     /**< the command's input */
    const char *file;       /**< the source's bytes: its path, or the copy of standard input */
    const char *folder;     /**< the source's own folder for temporaries */
    const char *text;       /**< the translated text; NULL: compile the source itself */
    const char *predefined; /**< lists the compiler's own macros; NULL: clang's were sufficient */
    struct cached *cached;  /**< cached answers about the source (cache.h), or NULL */
    const char *report;     /**< the JSON report, to be kept, or NULL */
    word_list read;         /**< the files that the compiler reads for the source, itself first */
    bool is_input;          /**< the source is standard input */
} translation;

/** Translates `source`, the command's C input number `number`. Sets the result's `text` only if
 * redcc changed the source and the text may be compiled in the source's place. */
translation translate(session *s, const item *source, unsigned number);

/** Add the options that the translated text needs: translation_add_before those before the user's
 *  own options, translation_add_after those after them. */
void translation_add_before(session *s, word_list *list, const translation *t);
void translation_add_after(session *s, word_list *list, const translation *t);

/** Returns whether inline assembler in the source or a header may make the assembler read a
 * file. */
bool translation_assembles_file(session *s, const translation *t);

/** Returns whether the compiler, run with the options of translation_add_after, read the same
 * headers for the text as for the source. */
bool translation_read_same(session *s, const translation *t);

/** Appends the translation's report to the build's report, if the text was used or there is no
 * text. If $REDCC_KEEP is set, keeps a copy of the text. `used`: the text was used. `messages`: a
 * file with the compiler's messages about a text that was not used, which is kept beside the copy;
 * or NULL. */
void translation_keep(session *s, const translation *t, bool used, const char *messages);

#endif
