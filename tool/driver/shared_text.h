/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A path for a translated text that depends on nothing but the text and its source's name. A cache
 * of compilations (ccache) looks a text up by its content and its path.
 */
#ifndef DRIVER_SHARED_TEXT_H
#define DRIVER_SHARED_TEXT_H

#include "driver/session.h"

/** Moves the text at `path`, the translation of `source`, there and returns the new path, in the
 *  session's arena; its folder is one of the session's shared ones. Returns `path` where that
 * cannot be done or would change what the text means: the cache then misses. */
const char *shared_text(session *s, const char *path, const char *source);

#endif
