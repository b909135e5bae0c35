/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc-cc --redcc-html: pages that show the reports of a build and of its runs in the source. */
#ifndef HTML_HTML_H
#define HTML_HTML_H

/** Writes the pages to `folder`, which must be new, empty, or made by an earlier call. If `count`
 *  is 0, reads $REDCC_BUILD_REPORT and, if that file exists, $REDCC_REPORT. On an error the folder
 *  is left as it was. Returns the exit status: 0; 1 if a file cannot be read or the folder cannot
 *  be written; 2 for wrong usage. Every error has a message on standard error. */
int html_write(const char *folder, unsigned count, char *const *paths);

#endif
