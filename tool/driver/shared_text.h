/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A path for a translated text that depends only on the text and its source's name, because a
 * compiler cache (ccache) uses content and path as its key.
 */
#ifndef DRIVER_SHARED_TEXT_H
#define DRIVER_SHARED_TEXT_H

#include "driver/session.h"

/** Moves the text at `path`, the translation of `source`, to such a path, in one of the session's
 *  shared folders, and returns it, in the session's arena. Returns `path` if that is impossible or
 *  would change the meaning of the text: then the cache misses. */
const char *shared_text(session *s, const char *path, const char *source);

#endif
