/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files that redcc has written. */
#ifndef REDCC_TRANSLATED_H
#define REDCC_TRANSLATED_H

#include "support/source.h"

/** Are the lines with which each written file begins in the text, and not in a comment or string?
 * Other tools may have put text before them. */
bool is_translated(const source *file);

#endif
