/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Answers of the translator and of the compiler about a source, kept from one call of redcc-cc to
 * the next. An answer is kept under all that it depends on: the program that gives it, its
 * arguments, the environment, and everything that a preprocessor could read (closure.h), by
 * contents. It is not used for a source where that cannot be said, and it is kept only if all files
 * that were read are known to it and nothing has changed in the meantime. Not thread-safe.
 */
#ifndef DRIVER_CACHE_H
#define DRIVER_CACHE_H

#include "driver/session.h"

/** Who answers. */
typedef enum cache_program { CACHE_TRANSLATOR, CACHE_COMPILER } cache_program;

/** One source of the command. */
typedef struct cached cached;

/** A program's run, and the files that it writes. */
typedef struct cached_run {
    cache_program program;
    const word_list *words;
    process_streams streams; /**< files of standard output and error are among the outputs */
    const char *outputs[3];  /**< in the session's folder; NULL for none */
    const char *read;        /**< where the translator lists what it has read (--inputs-file) */
} cached_run;

/** Looks where answers are kept, and who is there to answer. NULL where nothing is to be kept. */
struct cache *cache_open(session *s);

/** Begins with a source whose bytes are in `file`. NULL where answers on it are not kept; the
 *  functions below then ask at every time. */
cached *cached_begin(session *s, const item *source, const char *file);

/** Runs a program (session_run), or writes what it would write. Returns its exit status. */
int cached_run_program(session *s, cached *c, const cached_run *run);

/** An answer that is a text: fetched under what it is about and the words that it depends on. NULL:
 *  it is not kept. */
const char *cached_text(session *s, cached *c, const char *about, const word_list *words);

/** Keeps such an answer. */
void cached_keep_text(session *s, cached *c, const char *about, const word_list *words,
                      const char *text);

/** The compiler has read these files. */
void cached_compiler_read(cached *c, const word_list *files);

/** Keeps the answers, if all is as it was in the beginning. */
void cached_end(session *s, cached *c);

#endif
