/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A source with headers in place of their #include directives, so that loops of headers can be
 *  rewritten. */
#ifndef HEADERS_IN_PLACE_H
#define HEADERS_IN_PLACE_H

#include "analysis/analysis.h"
#include "redcc/options.h"

/** A header and the only directive that includes it. */
typedef struct header_use {
    const char *name; /* the header's path, without "./" before it */
    const source *file;
    ir_range directive; /* without the line's end */
} header_use;

typedef VECTOR(header_use) header_uses;

/** The headers with refused loops (R518) whose text may replace their directives, in the source's
 * order. Such a header is included only once, by the source itself, and its text means the same in
 * the source. */
header_uses headers_that_fit(arena *a, const ir_unit *unit, const analysis_result *analysed);

/** The source of `unit` with the text of these headers in place of their directives. #line
 * directives keep all places; with as_clang headers have clang's names, else gcc's. */
const source *headers_in_place(arena *a, const ir_unit *unit, const header_uses *headers,
                               bool as_clang);

/** Does a loop of the header run in parallel? `unit` is a source with headers in place. `obstacles`
 * has, for each verdict, the reason why its loop could not be written, or a reason without a
 * message. It may be NULL if all loops could be written. */
bool header_is_used(const ir_unit *unit, const analysis_result *analysed, const reason *obstacles,
                    const char *header);

/** Returns the verdicts `found` of `unit`, with other reasons for some loops of headers. A header's
 * loop was analysed in `in_place` if that source contains the header's text; it gets its reason
 * from `known`, the verdicts of `in_place`. */
analysis_result with_reasons_in_place(arena *a, const ir_unit *unit, const analysis_result *found,
                                      const ir_unit *in_place, const analysis_result *known);

#endif
