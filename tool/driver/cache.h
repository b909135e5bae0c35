/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A cache of the translator's and the compiler's answers about a source, from one call of redcc-cc
 * to the next. The key covers everything that an answer depends on: the program, its arguments, the
 * environment, and the contents of all files that a preprocessor could read for the source: its
 * closure (closure.h). The translator's answers also depend on functions of the project's other
 * files, and an object on the things that cached_run.beside covers; the key covers these as well.
 * If the closure is unknown, the source is not cached. An answer is stored only if all files that
 * were read are in the closure and nothing has changed in the meantime. Not thread-safe.
 */
#ifndef DRIVER_CACHE_H
#define DRIVER_CACHE_H

#include "driver/digest.h"
#include "driver/session.h"

/** The program whose answers are cached. */
typedef enum cache_program { CACHE_TRANSLATOR, CACHE_COMPILER } cache_program;

/** The cached answers about one source of the command. */
typedef struct cached cached;

/** A program's run, and the files that it writes. */
typedef struct cached_run {
    cache_program program;
    const word_list *words;
    process_streams streams; /**< files of standard output and error, except /dev/null, are among
                              * the outputs */
    const char *outputs[3];  /**< plain files; NULL for none */
    const char *read;        /**< a file in which the translator lists its inputs (--inputs-file) */
    const digest *beside;    /**< a digest of other things on which the outputs depend, or NULL */
} cached_run;

/** Opens the store and identifies the programs. Returns NULL if answers cannot be cached. */
struct cache *cache_open(session *s);

/** Opens the cached answers about a source whose bytes are in `file`. Returns NULL if answers about
 * it cannot be cached. Then cached_run_program runs the program every time, and cached_restore and
 * cached_keep must not be called. */
cached *cached_begin(session *s, const item *source, const char *file);

/** Restores the program's outputs; or runs it (session_run) and collects them for cached_end.
 * Returns the exit status. */
int cached_run_program(session *s, cached *c, const cached_run *run);

/** Restores the outputs and the exit status of an earlier run; false if there is none in the
 * cache. */
bool cached_restore(session *s, cached *c, const cached_run *run, int *status);

/** Collects, for cached_end, the outputs of the run for which cached_restore was last called,
 * unless they may depend on more than its inputs. `status`: the exit status with which the run
 * ended. */
void cached_keep(session *s, cached *c, const cached_run *run, int status);

/** Returns the cached text about the subject `about`, which depends on `words`. Returns NULL if it
 * is not in the cache. */
const char *cached_text(session *s, cached *c, const char *about, const word_list *words);

/** Collects a text for cached_end. Later calls of redcc-cc get it from cached_text, for the same
 * `about` and `words`. */
void cached_keep_text(session *s, cached *c, const char *about, const word_list *words,
                      const char *text);

/** Reports that the compiler has read these files. */
void cached_compiler_read(cached *c, const word_list *files);

/** Stores the collected answers about this source if all files that were read are in the closure,
 * and the closure has not changed since cached_begin. */
void cached_end(session *s, cached *c);

#endif
