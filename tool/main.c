/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** redcc: command line and exit status. */
#include <stdio.h>
#include <string.h>

#include "frontend/frontend.h"
#include "redcc/explain.h"
#include "redcc/joined_report.h"
#include "redcc/options.h"
#include "redcc/translate_file.h"
#include "redcc/whole_program.h"
#include "redcc/workers.h"

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_USAGE = 2, EXIT_REQUIREMENT = 3 };

/* ---- the files of the command line ---------------------------------------------------------- */

typedef struct inputs {
    const options *options;
    joined_report *joined;           /* combines the reports */
    unsigned unmet;                  /* files without a transformed loop */
    unsigned long long unknown_pure; /* names that no file declares */
    int status;
} inputs;

static void translate_input(unsigned number, void *result, void *context) {
    const inputs *all = context;
    arena *a = arena_new();
    *(file_outcome *)result =
        translate_file(a, all->options, all->options->inputs.items[number], NULL);
    arena_free(a);
}

static void add_report(unsigned number, FILE *printed, void *context) {
    const inputs *all = context;
    (void)number;
    joined_report_add(all->joined, printed);
}

static void count_input(unsigned number, const void *result, int ended_by, void *context) {
    inputs *all = context;
    const file_outcome *outcome = result;
    if (ended_by != 0) {
        workers_explain(all->options->inputs.items[number], ended_by);
        all->status = EXIT_FAILED;
        return;
    }
    if (outcome->status != FILE_FAILED && outcome->transformed == 0) {
        all->unmet++;
        if (all->options->require)
            fprintf(stderr, "redcc: error: %s: no loop was transformed (--require)\n",
                    all->options->inputs.items[number]);
    }
    all->unknown_pure &= outcome->unknown_pure;
    if (outcome->status == FILE_FAILED)
        all->status = EXIT_FAILED;
    else if (outcome->status == FILE_WRONG_PRAGMA && all->status == EXIT_DONE)
        all->status = EXIT_USAGE;
}

static int translate_inputs(arena *a, const options *o) {
    const bool is_joined = joined_report_is_needed(o);
    const options of_one = is_joined ? joined_report_of_one(o) : *o;
    joined_report joined = joined_report_begin(o);
    inputs all = {.options = &of_one, .joined = &joined, .unknown_pure = ~0ULL};
    const workers how = {.count = o->inputs.count,
                         .at_once = o->in_process ? 0 : 1,
                         .result_size = sizeof(file_outcome),
                         .take = is_joined ? add_report : NULL,
                         .work = translate_input,
                         .done = count_input,
                         .context = &all};
    const char *wrong = workers_run(&how) ? NULL : "no process can be started";
    if (!wrong && is_joined)
        wrong = joined_report_end(a, &joined);
    if (wrong) {
        fprintf(stderr, "redcc: error: %s\n", wrong);
        return EXIT_FAILED;
    }
    translate_file_warn_pure(o, all.unknown_pure,
                             o->inputs.count == 1 ? o->inputs.items[0] : "any of the files");
    return all.status == EXIT_DONE && o->require && all.unmet > 0 ? EXIT_REQUIREMENT : all.status;
}

static int explain(arena *a, const char *word) {
    const char *section = explain_section(a, word);
    if (section) {
        fputs(section, stdout);
        const char *page = explain_page(a);
        if (page)
            printf("What else can be done: %s\n", page);
        return EXIT_DONE;
    }
    if (strcmp(word, "list") == 0) {
        fputs(explain_list(a), stdout);
        return EXIT_DONE;
    }
    fprintf(stderr,
            "redcc: error: there is no reason '%s'; %s\n"
            "redcc: note: 'redcc --explain list' names all\n",
            word, explain_nearest(a, word));
    return EXIT_USAGE;
}

static int run(arena *a, int argc, char **argv) {
    options o;
    const char *wrong = options_read(a, argc, argv, &o);
    if (wrong) {
        fprintf(stderr, "redcc: error: %s\nredcc: note: 'redcc --help' lists the options\n", wrong);
        return EXIT_USAGE;
    }
    if (o.help) {
        fputs(options_help, stdout);
        return EXIT_DONE;
    }
    if (o.version) {
        printf("redcc %s (%s)\n", REDCC_VERSION, frontend_version(a));
        return EXIT_DONE;
    }
    if (o.explain)
        return explain(a, o.explain);
    if (o.inputs.count == 0)
        return whole_program_analyse(a, &o) ? EXIT_DONE : EXIT_FAILED;
    return translate_inputs(a, &o);
}

int main(int argc, char **argv) {
    arena *a = arena_new();
    int status = run(a, argc, argv);
    if (fflush(stdout) != 0 && status == EXIT_DONE) {
        perror("redcc: error: cannot write standard output");
        status = EXIT_FAILED;
    }
    arena_free(a);
    return status;
}
