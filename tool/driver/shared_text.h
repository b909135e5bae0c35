/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A path for a translated text that depends only on the text and its source's name, because a
 * compiler cache (ccache) uses content and path as its key.
 */
#ifndef DRIVER_SHARED_TEXT_H
#define DRIVER_SHARED_TEXT_H

#include "driver/session.h"

/** Moves the text at `path`, the translation of `source`, to that path and returns it, in the
 *  session's arena; its folder is one of the session's shared ones. Returns `path` if that is
 *  impossible or would change the meaning of the text: the cache then misses. */
const char *shared_text(session *s, const char *path, const char *source);

#endif
