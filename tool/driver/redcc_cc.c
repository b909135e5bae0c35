/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * redcc-cc: a compiler wrapper. redcc makes the reduction loops of each C source parallel; whenever
 * that is impossible, the compiler runs on the original command.
 */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "driver/build.h"
#include "driver/build_report.h"
#include "driver/cache.h"
#include "driver/files.h"
#include "driver/linked_loops.h"
#include "driver/temporary.h"
#include "html/html.h"

/* The environment variable with the nesting depth of redcc-cc. A depth of 1 is possible if the
 * compiler is a script that calls redcc-cc by another name. A depth of 2 is an endless
 * recursion. */
static const char depth_variable[] = "REDCC_CC_DEPTH";

static const char help_text[] =
    "Usage: redcc-cc [COMPILER] ARGUMENTS...\n"
    "Compiles C as COMPILER does ($REDCC_CC, else cc), and makes irregular reductions parallel.\n"
    "ARGUMENTS are the compiler's. Alone, --help and --version print the compiler's text first.\n"
    "  -Rredcc               print remarks on the loops of each C source\n"
    "  --redcc-show          print the commands without running them\n"
    "  --redcc-report        translate and write the build's report without compiling\n"
    "  --redcc-summary FILE  add up the build's report in FILE\n"
    "  --redcc-html DIR [FILE...]\n"
    "                        write the reports of a build and its runs as pages to DIR\n"
    "  --redcc-help          print this\n"
    "  --redcc-version       print the version of redcc-cc\n"
    "Environment: REDCC_CC, REDCC_OPTS, REDCC_DISABLE=1, REDCC_KEEP=DIR, REDCC_BUILD_REPORT=FILE,\n"
    "REDCC_STRICT=1, REDCC_ROOT=PREFIX, REDCC_CACHE=DIR|off, REDCC_CACHE_SIZE=SIZE. The manual "
    "page redcc-cc(1) explains them.\n";

static int enter(void) {
    const char *value = getenv(depth_variable);
    int depth = value ? atoi(value) : 0;
    char text[16];
    snprintf(text, sizeof text, "%d", depth + 1);
    setenv(depth_variable, text, 1);
    return depth;
}

static bool is_disabled(void) {
    const char *value = getenv("REDCC_DISABLE");
    return value && *value && strcmp(value, "0") != 0;
}

static bool is_option_of_ours(session *s, const char *word) {
    if (strcmp(word, "--redcc-help") == 0) {
        fputs(help_text, stdout);
        exit(0);
    }
    if (strcmp(word, "--redcc-version") == 0) {
        puts("redcc-cc " REDCC_VERSION);
        exit(0);
    }
    const bool shows = strcmp(word, "--redcc-show") == 0;
    const bool reports = strcmp(word, "--redcc-report") == 0;
    const bool remarks = strcmp(word, "-Rredcc") == 0;
    s->show |= shows;
    s->only_reports |= reports;
    s->remarks |= remarks;
    if (shows || reports || remarks)
        return true;
    const bool remarks_in_part = strncmp(word, "-Rredcc", 7) == 0;
    if (remarks_in_part || strncmp(word, "--redcc-", 8) == 0) {
        fprintf(stderr, "redcc-cc: error: unknown option '%s'; %s\n", word,
                remarks_in_part ? "-Rredcc prints all remarks" : "--redcc-help lists the options");
        exit(2);
    }
    return false;
}

static void read_arguments(session *s, unsigned count, char **words) {
    word_list expanded = {0};
    for (unsigned i = 0; i < count; i++) {
        if (is_option_of_ours(s, words[i]))
            continue;
        words_add(s->memory, &s->given, words[i]);
        s->verbose |= strcmp(words[i], "-v") == 0;
    }
    words_expand(s->memory, s->given.count, words_argv(s->memory, &s->given), &expanded);
    s->command = command_parse(s->memory, &expanded, s->real.is_cxx);
}

/* Saves a source from standard input to a file, since both translator and compiler read it. */
static bool store_input(session *s) {
    const char *path = arena_format(s->memory, "%s/input", s->folder);
    FILE *file = fopen(path, "wb");
    char part[65536];
    size_t count;
    if (!file)
        return false;
    while ((count = fread(part, 1, sizeof part, stdin)) > 0)
        fwrite(part, 1, count, file);
    s->input = path;
    bool good = !ferror(file) && !ferror(stdin);
    return fclose(file) == 0 && good;
}

static bool reads_input(const command *c) {
    for (unsigned i = 0; i < c->count; i++)
        if (c->items[i].kind == INPUT_C && strcmp(c->items[i].text, "-") == 0)
            return true;
    return false;
}

/* Is the output also an input? The compiler would refuse to overwrite the input, but cannot
 * recognise it when it compiles the translated text instead. */
static bool would_write_over_input(const command *c) {
    for (unsigned i = 0; c->output && i < c->count; i++)
        if (c->items[i].kind != INPUT_NOT && path_same_file(c->items[i].text, c->output))
            return true;
    return false;
}

/* Does a word that was parsed as an input name no file? Either the input is missing, which clang
 * checks first, or the word is the argument of an option that is not in the table. */
static bool misses_input(const command *c) {
    for (unsigned i = 0; i < c->count; i++) {
        const char *word = c->items[i].text;
        struct stat about;
        if (c->items[i].kind != INPUT_NOT && strcmp(word, "-") != 0 &&
            (stat(word, &about) != 0 || S_ISDIR(about.st_mode)))
            return true;
    }
    return false;
}

/* The first option that the translator cannot follow, or NULL if there is none. */
static const char *obstructing_option(const command *c) {
    for (unsigned i = 0; i < c->count; i++)
        if (c->items[i].meaning & (OPTION_GIVE_UP | OPTION_REFUSE))
            return c->items[i].text;
    return NULL;
}

/* Is the option for coverage? Coverage counts executions of source lines; a translated text has
 * other lines. */
static bool is_for_coverage(const char *word) {
    return strstr(word, "coverage") || strcmp(word, "-fprofile-arcs") == 0;
}

/* The reason why no source of this command can be translated, or NULL. */
static const char *general_obstacle(const session *s) {
    if (s->command.c_count == 0)
        return "no C source";
    const char *obstacle = obstructing_option(&s->command);
    if (obstacle)
        return arena_format(s->memory, "%s: %s",
                            is_for_coverage(obstacle) ? "coverage counts the source's own lines"
                                                      : "an option that redcc cannot follow",
                            obstacle);
    if (s->real.is_cross)
        return "the compiler is for another machine";
    if (would_write_over_input(&s->command))
        return "the output is one of the inputs";
    if (getenv("DEPENDENCIES_OUTPUT") || getenv("SUNPRO_DEPENDENCIES"))
        return "DEPENDENCIES_OUTPUT would name temporaries";
    return NULL;
}

static bool is_complete(const session *s) {
    if (s->tools.translator && s->tools.library && s->tools.include)
        return true;
    session_warn(s, "%s not found next to %s; compiled as it is",
                 !s->tools.translator ? "redcc"
                 : !s->tools.library  ? "libredcc_rt"
                                      : "runtime.h",
                 s->tools.self ? s->tools.self : "redcc-cc");
    return false;
}

static _Noreturn void translate_and_build(session *s) {
    translation *translations = ARENA_ARRAY(s->memory, translation, s->command.c_count);
    unsigned count = 0;
    session_read_options(s);
    s->cache = cache_open(s);
    for (unsigned i = 0; i < s->command.count && !process_signal(); i++)
        if (s->command.items[i].kind == INPUT_C) {
            translations[count] = translate(s, &s->command.items[i], count);
            count++;
        }
    build(s, translations, count);
}

/* Returns the reason to report for an input that is compiled but is no C source; NULL if it is
 * neither preprocessed C nor C++. */
static const char *other_input(const session *s, const item *one) {
    static const char *const cxx[] = {".C", ".CPP", ".c++", ".cc", ".cp", ".cpp", ".cxx", ".ii"};
    const char *dot = strrchr(path_base(one->text), '.');
    const char *language = one->language ? one->language : "";
    if (strcmp(language, "cpp-output") == 0 || (!*language && dot && strcmp(dot, ".i") == 0))
        return "it is preprocessed text, in which redcc does not see what the program says";
    bool is_cxx = s->real.is_cxx || strncmp(language, "c++", 3) == 0;
    for (unsigned i = 0; !*language && dot && i < sizeof cxx / sizeof cxx[0]; i++)
        is_cxx |= strcmp(dot, cxx[i]) == 0;
    return is_cxx ? "it is C++, which redcc does not translate" : NULL;
}

/* Adds to the report the files that are not translated: C sources if the command forbids
 * translating them (`obstacle`), preprocessed C, and C++. */
static void name_left_alone(session *s, const char *obstacle) {
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        const char *why = one->kind == INPUT_C         ? obstacle
                          : one->kind == INPUT_COMPILE ? other_input(s, one)
                                                       : NULL;
        if (why && one->kind == INPUT_COMPILE && strstr(why, "C++"))
            session_pass_by(s, one->text, why);
        else if (why)
            session_leave_alone(s, one->text, why);
    }
}

/* Warns of a link without libraries (-nostdlib) of objects with translated loops. */
static void warn_of_missing_runtime(session *s) {
    if (!s->command.links || !(s->command.meaning & OPTION_NO_RUNTIME))
        return;
    for (unsigned i = 0; i < s->command.count; i++) {
        const item *one = &s->command.items[i];
        if (strcmp(one->text, "-r") == 0)
            return; /* the output of -r is linked once more, later */
        if (one->kind == INPUT_LINK && has_loops(s, one->text)) {
            session_warn(
                s,
                "%s: has translated loops, and the command takes no library: they run sequentially "
                "without the runtime, -Wl,-u,redcc_run %s",
                one->text, s->tools.library ? s->tools.library : "libredcc_rt.a");
            return;
        }
    }
}

/* Prints the compiler's own --help or --version, and then this program's. The compiler's comes
 * first, because tools that identify the compiler read only the first lines. In the launcher form
 * nothing is printed here, so only the compiler's text appears. */
static void introduce(session *s) {
    const bool is_version = s->given.count == 1 && strcmp(s->given.items[0], "--version") == 0;
    const bool is_help = s->given.count == 1 && strcmp(s->given.items[0], "--help") == 0;
    if (s->show || s->real.taken > 0 || !(is_version || is_help))
        return;
    word_list words = {0};
    session_add_original(s, &words);
    process_catch_signals();
    int status = session_run(s, &words, (process_streams){NULL, NULL, NULL});
    if (status == 0 && is_version)
        puts("redcc-cc " REDCC_VERSION
             " runs the compiler above, with irregular reduction loops made "
             "parallel (--redcc-help)");
    else if (status == 0)
        printf("\n%s", help_text);
    session_end(s, status);
}

static _Noreturn void run(session *s) {
    char here[PATH_MAX];
    bool probe = command_is_probe(&s->command, getcwd(here, sizeof here) ? here : "");
    if (is_disabled() || probe || !(s->command.compiles || s->command.links) ||
        (!s->show && misses_input(&s->command)))
        session_become_compiler(s);
    session_read_environment(s);
    const char *why = general_obstacle(s);
    name_left_alone(s, why);
    warn_of_missing_runtime(s);
    bool translates = !why && (s->only_reports || is_complete(s)); /* a report needs no runtime */
    if (!translates && (s->only_reports || !build_can_add_runtime(s)))
        session_become_compiler(s);
    process_catch_signals();
    s->folder = s->show ? "TEMPORARY" : temporary_create(s->memory);
    if (!s->folder) {
        session_explain(s, "compiled as it is: no temporary folder: %s", strerror(errno));
        session_become_compiler(s);
    }
    if (!translates)
        build(s, NULL, 0);
    if (reads_input(&s->command) && !store_input(s)) {
        session_warn(s, "standard input could not be kept in %s", s->folder);
        session_end(s, 1);
    }
    translate_and_build(s);
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "--redcc-summary") == 0) {
        if (argc == 3)
            return build_report_summarise(argv[2], stdout);
        fputs("redcc-cc: error: --redcc-summary needs one FILE, the build's report\n", stderr);
        return 2;
    }
    if (argc > 1 && strcmp(argv[1], "--redcc-html") == 0)
        return html_write(argc > 2 ? argv[2] : NULL, argc > 3 ? (unsigned)argc - 3 : 0, argv + 3);
    session s;
    memset(&s, 0, sizeof s);
    s.memory = arena_new();
    s.tools = installation_find(s.memory);
    s.real = compiler_choose(s.memory, s.tools.self, (unsigned)argc, argv);
    if (!s.real.found) {
        fputs("redcc-cc: error: no compiler but redcc-cc itself was found; REDCC_CC names it\n",
              stderr);
        return 1;
    }
    int depth = enter();
    read_arguments(&s, (unsigned)argc - 1 - s.real.taken, argv + 1 + s.real.taken);
    if (depth == 0)
        introduce(&s);
    if (depth == 0)
        run(&s);
    if (depth == 1)
        session_become_compiler(&s);
    fprintf(stderr,
            "redcc-cc: error: the compiler '%s' calls redcc-cc again; REDCC_CC must name the "
            "compiler itself\n",
            s.real.words.items[0]);
    return 1;
}
