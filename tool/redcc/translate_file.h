/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What redcc does with one input file: parse, analyse, write, report. */
#ifndef TRANSLATE_FILE_H
#define TRANSLATE_FILE_H

#include "frontend/frontend.h"
#include "redcc/foreign.h"
#include "redcc/options.h"

typedef enum file_status { FILE_DONE, FILE_FAILED, FILE_WRONG_PRAGMA } file_status;

/** Plain numbers, which may be handed from one process to another. */
typedef struct file_outcome {
    file_status status;
    unsigned transformed;            /* loops */
    unsigned long long unknown_pure; /* names of --pure that the file does not declare: a bit each,
                                        for the first 64; 0 where this is not known */
    unsigned by_declarations;        /* of them, those that rest on what other files define */
} file_outcome;

/** Does all of it; messages and reports go where the options say. "-" is standard input. `foreign`:
 *  what is known of other files' functions, for a report only; NULL: nothing. */
file_outcome translate_file(arena *a, const options *o, const char *path,
                            const foreign_functions *foreign);

/** Warns of the names of --pure that no file declares: most likely they are misspelt. `unknown`:
 * what the outcomes have in common; `where`: the file, or what stands for several. */
void translate_file_warn_pure(const options *o, unsigned long long unknown, const char *where);

/** Parses as translate_file does. */
frontend_result translate_file_parse(arena *a, const source *file, const string_list *flags);

/** Appends what the file tells others of its functions (foreign_read); nothing, and no message,
 *  where it cannot be parsed. */
void translate_file_exports(arena *a, const options *o, const char *path, buffer *out);

#endif
