/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The analysis has two rounds, each with one process for each file. The first round collects facts
 * about the files' functions; the second analyses the loops. The counts of the build come from
 * redcc-cc's reports on the build's commands (build_counts.h). */
#include "redcc/whole_program.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "redcc/build_counts.h"
#include "redcc/compile_commands.h"
#include "redcc/external_functions.h"
#include "redcc/joined_report.h"
#include "redcc/translate_file.h"
#include "redcc/workers.h"

/* Size limit of the text about a file's functions; a longer text is not used. */
enum { EXPORTS_SIZE = 1 << 20 };

typedef struct whole_program {
    arena *memory;
    options options;
    string_list files;  /* the build's C files, each once */
    unsigned *mentions; /* [files.count] how often the build compiles the file */
    external_functions functions;
    joined_report joined;
    const char *what; /* the name of the round, for the progress line */
    unsigned failed, by_declarations;
    unsigned long long unknown_pure; /* names that no file declares */
} whole_program;

/* ---- files ---------------------------------------------------------------------------------- */

static const char *list_files(whole_program *p) {
    compile_command_list all = {0};
    const char *wrong = compile_commands_of_c(p->memory, p->options.database_folder, &all);
    if (wrong)
        return wrong;
    map *known = map_new(p->memory);
    p->mentions = ARENA_ARRAY(p->memory, unsigned, all.count + 1);
    for (unsigned i = 0; i < all.count; i++) {
        char *resolved = realpath(all.items[i].file, NULL);
        const char *path = resolved ? resolved : all.items[i].file;
        void **number = map_at(known, path, strlen(path));
        free(resolved);
        if (!*number) {
            VECTOR_PUSH(p->memory, &p->files, all.items[i].file);
            *number = &p->mentions[p->files.count - 1];
        }
        ++*(unsigned *)*number;
    }
    return p->files.count ? NULL : "the build compiles no C files";
}

/* ---- the first round ------------------------------------------------------------------------ */

static void export_file(unsigned number, void *result, void *context) {
    const whole_program *p = context;
    arena *a = arena_new();
    buffer text = {0};
    translate_file_exports(a, &p->options, p->files.items[number], &text);
    if (text.data && text.length < EXPORTS_SIZE)
        memcpy(result, text.data, text.length);
    buffer_free(&text);
    arena_free(a);
}

static void take_exports(unsigned number, const void *result, int ended_by, void *context) {
    whole_program *p = context;
    const char *text = result;
    if (ended_by != 0) /* the process failed, which the second round reports */
        return;
    text = arena_string(p->memory, text);
    for (unsigned i = 0; i < p->mentions[number]; i++) /* a file compiled twice defines its
                                                        * functions twice */
        external_read(p->memory, &p->functions, p->files.items[number], text);
}

/* ---- the second round ----------------------------------------------------------------------- */

static void analyse_file(unsigned number, void *result, void *context) {
    const whole_program *p = context;
    arena *a = arena_new();
    *(file_outcome *)result = translate_file(a, &p->options, p->files.items[number], &p->functions);
    arena_free(a);
}

static void add_report(unsigned number, FILE *printed, void *context) {
    whole_program *p = context;
    (void)number;
    joined_report_add(&p->joined, printed);
}

static void count_file(unsigned number, const void *result, int ended_by, void *context) {
    whole_program *p = context;
    const file_outcome *outcome = result;
    if (ended_by != 0)
        workers_explain(p->files.items[number], ended_by);
    if (ended_by != 0 || outcome->status != FILE_DONE) {
        p->failed++;
        return;
    }
    p->by_declarations += outcome->by_declarations;
    p->unknown_pure &= outcome->unknown_pure;
}

/* ---- both rounds ------------------------------------------------------------------------------
 */

static void show_progress(unsigned finished, void *context) {
    const whole_program *p = context;
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%s: %u of %u files\033[K%s", p->what, finished, p->files.count,
                finished == p->files.count ? "\r\033[K" : "");
}

static bool run_round(whole_program *p, const char *what, size_t result_size,
                      void (*work)(unsigned, void *, void *),
                      void (*done)(unsigned, const void *, int, void *),
                      void (*take)(unsigned, FILE *, void *)) {
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    const workers how = {.count = p->files.count,
                         .at_once = processors > 0 ? (unsigned)processors : 1,
                         .result_size = result_size,
                         .keeps_output = true,
                         .take = take,
                         .work = work,
                         .done = done,
                         .progress = show_progress,
                         .context = p};
    p->what = what;
    return workers_run(&how);
}

/* Prints a line of the table. */
static void show_count(const char *what, unsigned count) {
    fprintf(stderr, "%-24s%7u\n", what, count);
}

static void show_loops(const build_counts *counts) {
    unsigned refused = 0;
    for (unsigned i = REASON_NONE + 1; i < REASON_COUNT; i++)
        refused += counts->refused[i];
    show_count("loops", counts->transformed + refused);
    show_count("  transformed", counts->transformed);
    show_count("  refused", refused);
    for (unsigned i = REASON_NONE + 1; i < REASON_COUNT; i++)
        if (counts->refused[i])
            fprintf(stderr, "    %-20s%7u\n", reason_slug((reason_id)i), counts->refused[i]);
}

static void show_summary(const whole_program *p) {
    build_counts counts = {0};
    const bool is_counted = build_counts_take(p->memory, &p->options, &counts);
    fprintf(stderr, "%-24s%7u", "files", is_counted ? counts.files : p->files.count);
    if (p->failed)
        fprintf(stderr, "   (%u could not be analysed)", p->failed);
    fputs("\n", stderr);
    if (!is_counted) {
        fputs("redcc: warning: redcc-cc is not next to redcc: the loops that it transforms are "
              "not counted\n",
              stderr);
        return;
    }
    for (unsigned i = 0; i < counts.left.count; i++)
        fprintf(stderr, "  left alone            %7u   (%s)\n", counts.left.items[i].files,
                counts.left.items[i].why);
    show_loops(&counts);
    if (p->by_declarations > 0)
        show_count("more by declarations", p->by_declarations);
}

bool whole_program_analyse(arena *a, const options *o) {
    const bool is_joined = joined_report_is_needed(o);
    whole_program p = {.memory = a,
                       .options = is_joined ? joined_report_of_one(o) : *o,
                       .joined = joined_report_begin(o),
                       .unknown_pure = ~0ULL};
    const char *wrong = list_files(&p);
    if (!wrong && (!run_round(&p, "functions", EXPORTS_SIZE, export_file, take_exports, NULL) ||
                   !run_round(&p, "loops", sizeof(file_outcome), analyse_file, count_file,
                              is_joined ? add_report : NULL)))
        wrong = "no process can be started";
    if (!wrong && is_joined)
        wrong = joined_report_end(a, &p.joined);
    if (wrong) {
        fprintf(stderr, "redcc: error: %s\n", wrong);
        return false;
    }
    translate_file_warn_pure(o, p.unknown_pure, "any of the files");
    show_summary(&p);
    return p.failed == 0;
}
