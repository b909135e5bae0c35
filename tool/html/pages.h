/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The pages: an index, and one for each source with loops. */
#ifndef HTML_PAGES_H
#define HTML_PAGES_H

#include "html/reports.h"
#include "support/buffer.h"

/** The file name of a source's page, in the arena. NULL if the source has no loops: then it has no
 * page. */
const char *page_name(const reports *r, const report_file *file);

/** page_begin appends the beginning that all pages have, page_end their end. */
void page_begin(buffer *out, const char *title);
void page_end(buffer *out);

/** Appends the mark of a loop's verdict. */
void page_verdict(buffer *out, const report_loop *loop);

/** Appends the share of the runs' time that a loop took, as a bar and a number. */
void page_share(buffer *out, const loop_time *time);

/** Appends the gain measured in the last run that reports the loop, or a dash. */
void page_gain(buffer *out, const loop_time *time);

void page_index(const reports *r, buffer *out);
void page_source(const reports *r, const report_file *file, buffer *out);

/** The style sheet of all pages. */
extern const char page_style[];

#endif
