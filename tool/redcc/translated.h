/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Files that redcc has written. */
#ifndef REDCC_TRANSLATED_H
#define REDCC_TRANSLATED_H

#include "support/source.h"

/** Was the file written by redcc? It contains the lines with which each written file begins,
 * outside of comments and strings. Other tools may have put text before these lines. */
bool is_translated(const source *file);

#endif
