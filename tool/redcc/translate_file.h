/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Processes one input file: parse, analyse, write, report. */
#ifndef TRANSLATE_FILE_H
#define TRANSLATE_FILE_H

#include "frontend/frontend.h"
#include "redcc/external_functions.h"
#include "redcc/options.h"

typedef enum file_status { FILE_DONE, FILE_FAILED, FILE_WRONG_PRAGMA } file_status;

/** The result for one file: plain numbers, so that one process can pass them to another. */
typedef struct file_outcome {
    file_status status;
    unsigned transformed;            /* the number of transformed loops */
    unsigned long long unknown_pure; /* names of --pure that the file does not declare: one bit
                                      * each, for the first 64; 0 if unknown */
    unsigned by_declarations; /* the number of transformed loops that depend on definitions in
                               * other files */
} file_outcome;

/** Parses, analyses, writes and reports, as the options say; messages go to standard error. Path
 * "-" is standard input. `external`: facts about other files' functions, only for a report, or
 * NULL. */
file_outcome translate_file(arena *a, const options *o, const char *path,
                            const external_functions *external);

/** Warns of the names of --pure that no file declares, which are probably misspelt. `unknown`: the
 *  intersection of the outcomes; `where`: the file, or a word for several. */
void translate_file_warn_pure(const options *o, unsigned long long unknown, const char *where);

/** Parses as translate_file does. */
frontend_result translate_file_parse(arena *a, const source *file, const string_list *flags);

/** Appends the facts about the file's functions, for external_read. Appends nothing, and gives no
 * message, if the file cannot be parsed. */
void translate_file_exports(arena *a, const options *o, const char *path, buffer *out);

#endif
