/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Chooses a path for a translated text that depends only on the text and its source's name, because
 * a compiler cache (ccache) uses a file's content and path as its key.
 */
#ifndef DRIVER_SHARED_TEXT_H
#define DRIVER_SHARED_TEXT_H

#include "driver/session.h"

/** Moves the text at `path`, the translation of `source`, to a path that depends only on text and
 *  source, in one of the session's shared folders. Returns the new path, in the session's arena.
 *  Returns `path` if moving is impossible or would change the meaning of the text; then the
 *  compiler cache misses. */
const char *shared_text(session *s, const char *path, const char *source);

#endif
