/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The command line of redcc. */
#ifndef OPTIONS_H
#define OPTIONS_H

#include "emit/emit.h"
#include "report/report.h"
#include "support/vector.h"

typedef VECTOR(const char *) string_list;

/** Options for the report on the loops, and for the list of inputs. */
typedef struct report_options {
    report_form form;
    bool form_is_given;
    bool all;                /* --all */
    const char *file;        /* NULL: standard output, or standard error for text */
    const char *inputs_file; /* --inputs-file, or NULL */
} report_options;

/** --order */
typedef struct order_option {
    result_order word;
    bool is_given;
} order_option;

/** --compiler: with KNOWN and CLANG the caller, usually redcc-cc, checks for differences between
 *  compilers itself. */
typedef enum compiler_option { COMPILER_ANY, COMPILER_KNOWN, COMPILER_CLANG } compiler_option;

typedef struct options {
    string_list inputs;
    const char *output;          /* -o; "-": standard output; NULL: none */
    const char *database_folder; /* -p */
    string_list flags;           /* for the parser, in order */
    string_list pure;            /* --pure */
    report_options report;
    const char *explain; /* --explain: this reason, or NULL */
    order_option order;
    lanes_wish lanes;
    compiler_option compiler;
    bool sees_project; /* --files=project */
    bool keeps_openmp; /* --openmp=keep */
    bool in_process;   /* no child process protects this one against crashes of the parser */
    bool analyze, assume_noalias, require, verify, dump_ir, help, version;
} options;

/** Reads the command line. Returns NULL, or a message in the arena. */
const char *options_read(arena *a, int argc, char **argv, options *result);

/** The text of --help. */
extern const char options_help[];
/** The word for the order: "serial", "fixed" or "any". */
const char *options_order_word(result_order order);

#endif
