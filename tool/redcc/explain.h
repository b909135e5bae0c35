/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc --explain: what docs/reasons.md says of a reason, without the file at hand. */
#ifndef EXPLAIN_H
#define EXPLAIN_H

#include "support/arena.h"

/** The section on the reason of that id ("R204") or slug ("private-not-proved"), in the arena, from
 *  its heading on; NULL: there is no such reason. */
const char *explain_section(arena *a, const char *reason);

/** Where that section can be read: a URI, in the arena, below the one that redcc was built with
 *  (REDCC_DOCUMENTS_URI), else the installed file's. NULL: there is no such reason, or no such
 * file.
 */
const char *explain_link(arena *a, const char *reason);

/** The id and slug of the reason that is spelled most like `word`: "R204 private-not-proved". */
const char *explain_nearest(arena *a, const char *word);

#endif
