/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/compiled.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "driver/answerers.h"
#include "driver/cache.h"
#include "driver/files.h"

static bool begins_with_one(const char *word, const char *const *beginnings) {
    for (; *beginnings; beginnings++)
        if (strncmp(word, *beginnings, strlen(*beginnings)) == 0)
            return true;
    return false;
}

/* May an object be kept in the cache if the command has this item? Inputs, and options of the
 * linker and for dependency files, never prevent it. Any other option does if it may name a file
 * other than headers and the object, or depend on the machine (-march=native). Unknown options
 * prevent it, except for -f options without a value. */
static bool is_plain(const item *one) {
    static const char *const plain[] = {"--param", "-D", "-I", "-O",    "-U", "-W",
                                        "-ansi",   "-c", "-g", "-i",    "-m", "-o",
                                        "-p",      "-w", "-x", "-std=", NULL};
    static const char *const with_value[] = {"-falign-",
                                             "-fcf-protection=",
                                             "-fdebug-prefix-map=",
                                             "-fdiagnostics-color=",
                                             "-fexcess-",
                                             "-ffile-prefix-map=",
                                             "-ffp-contract=",
                                             "-flto",
                                             "-fmacro-prefix-map=",
                                             "-fmax-errors=",
                                             "-fopenmp=",
                                             "-fsanitize=",
                                             "-fstack-protector",
                                             "-ftls-model=",
                                             "-fvisibility=",
                                             NULL};
    static const char *const others[] = {"-Wa,",
                                         "-Wp,",
                                         "-fauto-profile",
                                         "-fbranch-probabilities",
                                         "-fcompare-debug",
                                         "-fmem-report",
                                         "-fno-integrated-as",
                                         "-fplugin",
                                         "-fprofile",
                                         "-ftime-report",
                                         "-mllvm",
                                         NULL};
    const char *word = one->text;
    if (one->kind != INPUT_NOT || one->meaning & (OPTION_LINKER | OPTION_DEPENDENCY))
        return true;
    if (begins_with_one(word, others) || strstr(word, "native"))
        return false;
    if (strncmp(word, "-f", 2) == 0)
        return !strchr(word, '=') || begins_with_one(word, with_value);
    return begins_with_one(word, plain);
}

static bool may_be_kept(const session *s, const translation *t) {
    if (!t->cached || t->is_input || s->verbose || compiler_has_launcher(&s->real) ||
        s->command.meaning & OPTION_AUXILIARY)
        return false;
    for (unsigned i = 0; i < s->command.count; i++)
        if (!is_plain(&s->command.items[i]))
            return false;
    return true;
}

/* May the driver write the file itself? It leaves devices and targets of links to the compiler. */
static bool is_plain_output(const char *path) {
    struct stat about;
    return path && (lstat(path, &about) != 0 || S_ISREG(about.st_mode));
}

static bool has_option(const command *c, const char *word) {
    for (unsigned i = 0; i < c->count; i++)
        if (c->items[i].kind == INPUT_NOT && strcmp(c->items[i].text, word) == 0)
            return true;
    return false;
}

/* The object that the command's -c writes, or NULL if the command has another output, or none. */
static const char *object_of_command(session *s, const translation *t) {
    if (!has_option(&s->command, "-c") || has_option(&s->command, "-S"))
        return NULL;
    if (s->command.output)
        return s->command.output;
    const char *base = path_base(t->source->text), *dot = strrchr(base, '.');
    return dot ? arena_format(s->memory, "%.*s.o", (int)(dot - base), base) : NULL;
}

static bool has_debugging_information(const command *c) {
    for (unsigned i = 0; i < c->count; i++)
        if (c->items[i].kind == INPUT_NOT && strncmp(c->items[i].text, "-g", 2) == 0)
            return true;
    return false;
}

/* Sets *found to a digest of other things on which an object depends: the assembler and, with
 * debugging information, the current folder and its name in $PWD. Returns false if they are
 * unknown. */
static bool find_surroundings(session *s, digest *found) {
    char here[PATH_MAX];
    digester d = digest_begin();
    if (!answerers_add_assembler(s, &d))
        return false;
    if (has_debugging_information(&s->command)) {
        if (!getcwd(here, sizeof here))
            return false;
        digest_text(&d, here);
        digest_text(&d, getenv("PWD"));
    }
    *found = digest_end(&d);
    return true;
}

int compiled_text(session *s, const translation *t, const word_list *words, const char *object,
                  process_streams streams, bool *same) {
    const char *output = object ? object : object_of_command(s, t);
    digest around;
    int status;
    const bool is_kept = may_be_kept(s, t) && is_plain_output(output) &&
                         !translation_assembles_file(s, t) && find_surroundings(s, &around);
    const cached_run run = {.program = CACHE_COMPILER,
                            .words = words,
                            .streams = streams,
                            .outputs = {output, streams.output, streams.error},
                            .beside = &around};
    *same = true; /* only runs that read the source's headers are kept */
    if (is_kept && cached_restore(s, t->cached, &run, &status))
        return status;
    status = session_run(s, words, streams);
    *same = status == 0 && translation_read_same(s, t);
    if (is_kept && *same)
        cached_keep(s, t->cached, &run, status);
    return status;
}

/* The file that -MF names. Returns NULL if there is no -MF or several, if an option goes through
 * -Wp,-M, or if -MG makes the file name headers that do not exist. */
static const char *dependency_file(const command *c) {
    const char *file = NULL;
    for (unsigned i = 0; i < c->count; i++) {
        const item *one = &c->items[i];
        if (!(one->meaning & OPTION_DEPENDENCY))
            continue;
        const bool is_name = strncmp(one->text, "-MF", 3) == 0;
        if (strcmp(one->text, "-MG") == 0 || one->text[1] != 'M' || (is_name && file))
            return NULL;
        if (is_name)
            file = item_argument(one);
    }
    return file;
}

int compiled_dependencies(session *s, const translation *t, const word_list *words) {
    const process_streams silent = {s->input, "/dev/null", "/dev/null"};
    const char *file = dependency_file(&s->command);
    if (s->command.compiled != 1 || !may_be_kept(s, t) || !is_plain_output(file))
        return session_run(s, words, silent);
    const cached_run run = {
        .program = CACHE_COMPILER, .words = words, .streams = silent, .outputs = {file}};
    return cached_run_program(s, t->cached, &run);
}
