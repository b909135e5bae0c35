/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/verify.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "driver/files.h"
#include "driver/installation.h"
#include "driver/process.h"
#include "driver/temporary.h"
#include "redcc/output.h"
#include "support/compiler_options.h"

/** The files of one verification, in one temporary folder. */
typedef struct workplace {
    arena *arena;
    const char *folder;
    const char *input_folder; /* the folder of the input's own headers */
    const string_list *flags;
    installation redcc;
} workplace;

typedef struct program {
    const char *name; /* "sequential", "parallel" */
    const char *source, *binary, *output;
    int status;
} program;

static const char *in_folder(const workplace *w, const char *name, const char *suffix) {
    return arena_format(w->arena, "%s/%s%s", w->folder, name, suffix);
}

static program program_named(const workplace *w, const char *name) {
    return (program){.name = name,
                     .source = in_folder(w, name, ".c"),
                     .binary = in_folder(w, name, ""),
                     .output = in_folder(w, name, ".out")};
}

static const char *real_compiler(void) {
    const char *name = getenv("REDCC_CC");
    return name && *name ? name : "cc";
}

static const char *build(const workplace *w, const program *p, bool is_parallel) {
    arena *a = w->arena;
    word_list words = {0};
    words_add(a, &words, real_compiler());
    words_add(a, &words, "-O2"); /* the user's flags, which follow, may override it */
    for (unsigned i = 0; i < w->flags->count; i++)
        words_add(a, &words, w->flags->items[i]);
    words_add(a, &words, "-w");
    words_add(a, &words, "-ffp-contract=off");
    words_add(a, &words, "-iquote");
    words_add(a, &words, w->input_folder);
    if (is_parallel) {
        words_add(a, &words, "-Wl,-u,redcc_run");
        words_add(a, &words, "-idirafter");
        words_add(a, &words, w->redcc.include);
    }
    words_add(a, &words, p->source);
    words_add(a, &words, "-o");
    words_add(a, &words, p->binary);
    if (is_parallel) {
        words_add(a, &words, w->redcc.library);
        words_add(a, &words, "-lpthread");
    }
    words_add(a, &words, "-lm");
    const process_streams streams = {"/dev/null", NULL, NULL};
    if (process_run(a, &words, streams) == 0)
        return NULL;
    return arena_format(a, "--verify: the %s program cannot be built", p->name);
}

/* The number of threads: at least 2, since with one thread nothing would be verified. */
static long threads_to_use(void) {
    const char *wanted = getenv("OMP_NUM_THREADS");
    const long threads = wanted ? strtol(wanted, NULL, 10) : sysconf(_SC_NPROCESSORS_ONLN);
    return threads < 2 ? 2 : threads;
}

/* Runs the program. With REDCC_VALIDATE (docs/report.md), the parallel program executes each loop
 * in parallel from the first call on, and reports that. By default it would begin with the original
 * loop. */
static void execute(const workplace *w, program *p, bool is_parallel) {
    word_list words = {0};
    if (is_parallel) {
        words_add(w->arena, &words, "env");
        words_add(w->arena, &words, "REDCC_VALIDATE=1");
        words_add(w->arena, &words, "OMP_DYNAMIC=false");
        words_add(w->arena, &words,
                  arena_format(w->arena, "OMP_NUM_THREADS=%ld", threads_to_use()));
    }
    words_add(w->arena, &words, p->binary);
    p->status = process_run(w->arena, &words, (process_streams){"/dev/null", p->output, NULL});
}

static bool uses_openmp(const string_list *flags) {
    for (unsigned i = 0; i < flags->count; i++) {
        const option *known = option_find(flags->items[i]);
        if (known && known->meaning & OPTION_OPENMP)
            return true;
    }
    return false;
}

/** The line number of the first difference between two texts. */
static unsigned first_difference(const char *left, const char *right) {
    unsigned line = 1;
    for (; *left && *left == *right; left++, right++)
        line += *left == '\n';
    return line;
}

static const char *compare(const workplace *w, const program *left, const program *right) {
    if (left->status != right->status)
        return arena_format(w->arena,
                            "--verify: exit status %d of the %s program, %d of the %s one",
                            left->status, left->name, right->status, right->name);
    const char *left_text = file_read(w->arena, left->output, NULL);
    const char *right_text = file_read(w->arena, right->output, NULL);
    if (!left_text || !right_text)
        return "--verify: what the programs printed cannot be read";
    if (file_equal(w->arena, left->output, right->output))
        return NULL;
    return arena_format(w->arena, "--verify: the programs print different text, first in line %u%s",
                        first_difference(left_text, right_text),
                        uses_openmp(w->flags)
                            ? "; with -fopenmp the original program's own threads may add in "
                              "another order: to compare with a sequential one, omit -fopenmp"
                            : "");
}

static const char *verify_in(workplace *w, const source *input, const char *text, size_t length) {
    program sequential = program_named(w, "sequential");
    program parallel = program_named(w, "parallel");
    const char *wrong = output_write(w->arena, sequential.source, input->text, input->length);
    if (!wrong)
        wrong = output_write(w->arena, parallel.source, text, length);
    if (!wrong)
        wrong = build(w, &sequential, false);
    if (!wrong)
        wrong = build(w, &parallel, true);
    if (!wrong) {
        execute(w, &sequential, false);
        execute(w, &parallel, true);
        wrong = compare(w, &sequential, &parallel);
    }
    return wrong;
}

const char *verify_output(arena *a, const source *input, const string_list *flags, const char *text,
                          size_t length) {
    const char *input_folder = path_folder(a, input->path);
    workplace w = {.arena = a,
                   .input_folder = *input_folder ? input_folder : ".",
                   .flags = flags,
                   .redcc = installation_find(a)};
    if (!w.redcc.include || !w.redcc.library)
        return "--verify: redcc's runtime library is not found next to the program";
    w.folder = temporary_create(a);
    if (!w.folder)
        return "--verify: no temporary folder can be made";
    const char *wrong = verify_in(&w, input, text, length);
    temporary_remove(w.folder);
    return wrong;
}
