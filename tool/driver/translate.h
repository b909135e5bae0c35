/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** From a C source of the command to the text that is to be compiled in its place. */
#ifndef DRIVER_TRANSLATE_H
#define DRIVER_TRANSLATE_H

#include "driver/session.h"

typedef struct translation {
    const item *source; /**< of the command */
    const char *file; /**< where the source's bytes are: its path, or the copy of standard input */
    const char *folder;     /**< the source's own folder for temporaries */
    const char *text;       /**< the translated text; NULL: compile the source itself */
    const char *predefined; /**< lists the compiler's own macros; NULL: clang's were good enough */
    struct cached *cached;  /**< what is kept of the source (cache.h); NULL: nothing is */
    const char *report;     /**< the JSON report, to be kept; NULL: none */
    word_list read;         /**< all files that the source is made of, itself first */
    bool is_input;          /**< the source is standard input */
} translation;

/** Translates `source`, the command's C input number `number`. text is set only where something was
 *  transformed and what was transformed can be compiled: the runtime is there. */
translation translate(session *s, const item *source, unsigned number);

/** Adds the options that the translated text must be compiled with, to stand before and after the
 *  user's own. */
void translation_add_before(session *s, word_list *list, const translation *t);
void translation_add_after(session *s, word_list *list, const translation *t);

/** Whether the compiler read the same headers for the text, compiled with these options, as for the
 *  source. */
bool translation_read_same(session *s, const translation *t);

/** Keeps what the user wants kept of the translation: its report ($REDCC_REPORT), and its text
 *  ($REDCC_KEEP) where `used` or `messages`, a file of compiler messages, says why it was not. */
void translation_keep(session *s, const translation *t, bool used, const char *messages);

#endif
