/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/options.h"

#include <assert.h>
#include <errno.h>
#include <string.h>

#include "analysis/base/stateful.h"
#include "driver/files.h"
#include "redcc/nearest.h"
#include "support/compiler_options.h"

const char options_help[] =
    "redcc: parallel irregular reductions, with the bits of the sequential program\n"
    "\n"
    "usage: redcc INPUT.c -o OUTPUT.c [options] [-- COMPILER-FLAGS]\n"
    "       redcc --analyze INPUT.c... [options] [-- COMPILER-FLAGS]\n"
    "       redcc --analyze -p DIR [options] [-- COMPILER-FLAGS]\n"
    "\n"
    "  -o FILE              output file; - is standard output. A file without a loop to\n"
    "                       transform is copied byte for byte\n"
    "  -I -isystem -iquote -include -D -U -std=\n"
    "                       compiler options; all others after --\n"
    "  -p DIR               read the flags from DIR/compile_commands.json\n"
    "  --analyze            write a report and no source; with -p and no INPUT for all C files\n"
    "                       of the build, using each other's functions\n"
    "  --report=FORM        text (default; remarks on standard error), json, sarif, yaml\n"
    "                       (to standard output with --analyze, otherwise to --report-file)\n"
    "  --report-file=FILE   file for the report\n"
    "  --order=ORDER        order of the updates: serial (default: the sequential bits), fixed\n"
    "                       (the same bits in every run and at every number of threads), any\n"
    "  --lanes=HOW          four iterations at once in vectors, where possible: auto (default:\n"
    "                       in heavy loops), off, 4 (everywhere)\n"
    "  --openmp=HOW         OpenMP loops that protect array updates: replace (default: the same\n"
    "                       bits in every run and at every number of threads; those of the\n"
    "                       sequential program with --order=serial), keep\n"
    "  --pure=NAME[,NAME]   assert that these functions have no side effects and return the\n"
    "                       same value in every thread\n"
    "  --assume-noalias     assert that distinct pointers do not overlap\n"
    "  --files=WHICH        alone (default); project: find called functions in the project's\n"
    "                       sources, and check at run time that the program is linked with\n"
    "                       them (redcc-cc does so)\n"
    "  --compiler=WHICH     compiler of the result: any (default; code that differs for gcc and\n"
    "                       clang is left unchanged), known or clang (you have checked\n"
    "                       that, and translate anew when a header changes)\n"
    "  --predefined=FILE    macros of that compiler, as printed by 'cc -dM -E -x c /dev/null'\n"
    "  --require            exit with 3 if a file has no transformed loop\n"
    "  --verify             build and run the sequential and the parallel program (INPUT must\n"
    "                       be the whole program) and compare their output\n"
    "  --all                report loops without an irregular update too\n"
    "  --dump=ir            print the intermediate representation, for debugging\n"
    "  --in-process         parse in this process: a crash of the parser ends it\n"
    "  --inputs-file=FILE   list the dependences of the result: libraries, folders, files\n"
    "  --explain REASON     explain a reason for a refusal: R204, or its slug; list: all\n"
    "  --help, --version\n"
    "\n"
    "To compile the result:\n"
    "  cc OUTPUT.c $(pkg-config --cflags --libs redcc)\n"
    "Use the flags of INPUT.c; from another folder add -iquote FOLDER-OF-INPUT for its headers.\n"
    "Without redcc's headers, or with -DREDCC_OFF, it is the sequential program. redcc-cc, used\n"
    "as the compiler, does all this.\n"
    "\n"
    "Exit status: 0 success; 1 the input cannot be read or parsed, or the output cannot be\n"
    "written (an old one is unchanged); 2 wrong usage; 3 --require not met.\n";

/* ---- options by name ----------------------------------------------------------------------- */

typedef enum option_name {
    OPTION_ALL,
    OPTION_ANALYZE,
    OPTION_ASSUME_NOALIAS,
    OPTION_COMPILER,
    OPTION_DUMP,
    OPTION_EXPLAIN,
    OPTION_FILES,
    OPTION_HELP,
    OPTION_IN_PROCESS,
    OPTION_INPUTS_FILE,
    OPTION_LANES,
    OPTION_OPENMP_LOOPS,
    OPTION_ORDER,
    OPTION_PREDEFINED,
    OPTION_PURE,
    OPTION_REPORT,
    OPTION_REPORT_FILE,
    OPTION_REQUIRE,
    OPTION_VERIFY,
    OPTION_VERSION
} option_name;

/** The long options. A text that ends in = takes a value, which is attached to it. The value of
 * --explain may also be the next word. */
static const struct long_option {
    const char *text;
    option_name name;
} long_options[] = {
    {"--all", OPTION_ALL},
    {"--analyze", OPTION_ANALYZE},
    {"--assume-noalias", OPTION_ASSUME_NOALIAS},
    {"--compiler=", OPTION_COMPILER},
    {"--dump=", OPTION_DUMP},
    {"--explain=", OPTION_EXPLAIN},
    {"--files=", OPTION_FILES},
    {"--help", OPTION_HELP},
    {"--in-process", OPTION_IN_PROCESS},
    {"--inputs-file=", OPTION_INPUTS_FILE},
    {"--lanes=", OPTION_LANES},
    {"--openmp=", OPTION_OPENMP_LOOPS},
    {"--order=", OPTION_ORDER},
    {"--predefined=", OPTION_PREDEFINED},
    {"--pure=", OPTION_PURE},
    {"--report-file=", OPTION_REPORT_FILE},
    {"--report=", OPTION_REPORT},
    {"--require", OPTION_REQUIRE},
    {"--verify", OPTION_VERIFY},
    {"--version", OPTION_VERSION},
};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ---- the nearest valid option -------------------------------------------------------------- */

static const char *nearest_option(const char *word) {
    const char *best = long_options[0].text;
    size_t least = (size_t)-1;
    for (size_t i = 0; i < COUNT(long_options); i++) {
        const size_t distance = edit_distance(word, long_options[i].text);
        if (distance < least) {
            least = distance;
            best = long_options[i].text;
        }
    }
    static const char *const others[] = {"-o", "-p", "-std=", "-isystem", "-iquote", "-include"};
    for (size_t i = 0; i < COUNT(others); i++) {
        const size_t distance = edit_distance(word, others[i]);
        if (distance < least) {
            least = distance;
            best = others[i];
        }
    }
    return best;
}

/** Does the word resemble a compiler's flag: -O2, -Wall, -fopenmp, -march=native, -g, -pthread? */
static bool is_compiler_flag(const char *word) {
    static const char *const beginnings[] = {"-O", "-W",       "-f",        "-m",
                                             "-g", "-pthread", "-pedantic", "-ansi"};
    for (size_t i = 0; i < COUNT(beginnings); i++)
        if (strncmp(word, beginnings[i], strlen(beginnings[i])) == 0)
            return true;
    return false;
}

static const char *unknown_option(arena *a, const char *word) {
    if (is_compiler_flag(word))
        return arena_format(a, "'%s' is a compiler flag: put compiler flags after --", word);
    return arena_format(a,
                        "unknown option '%s'; the nearest is '%s' (compiler flags may follow "
                        "after --)",
                        word, nearest_option(word));
}

/* ---- values -------------------------------------------------------------------------------- */

/** The number of `word` among `words`, or -1. */
static int find_word(const char *const *words, size_t count, const char *word) {
    for (size_t i = 0; i < count; i++)
        if (strcmp(words[i], word) == 0)
            return (int)i;
    return -1;
}

/** The words as "a, b or c". */
static const char *list_words(arena *a, const char *const *words, size_t count) {
    const char *list = words[0];
    for (size_t i = 1; i < count; i++)
        list = arena_format(a, "%s%s%s", list, i + 1 < count ? ", " : " or ", words[i]);
    return list;
}

/** Sets *number to the index of `value` in `words`. If `words` does not contain it, returns a
 *  message with the valid words. */
static const char *read_word(arena *a, const char *name, const char *const *words, size_t count,
                             const char *value, int *number) {
    *number = find_word(words, count, value);
    return *number >= 0
               ? NULL
               : arena_format(a, "%s takes %s, not '%s'", name, list_words(a, words, count), value);
}

static const char *const order_words[] = {"serial", "fixed", "any"};

const char *options_order_word(result_order order) {
    assert((unsigned)order <= ORDER_ANY);
    return order_words[order];
}

static const char *read_lanes(arena *a, options *o, const char *value) {
    static const char *const words[] = {"off", "auto", "4"};
    static const lanes_wish lanes[] = {LANES_OF_NONE, LANES_OF_HEAVY, LANES_OF_ALL};
    int number;
    const char *wrong = read_word(a, "--lanes", words, COUNT(words), value, &number);
    if (!wrong)
        o->lanes = lanes[number];
    return wrong;
}

static const char *read_openmp(arena *a, options *o, const char *value) {
    static const char *const words[] = {"replace", "keep"};
    int number;
    const char *wrong = read_word(a, "--openmp", words, COUNT(words), value, &number);
    if (!wrong)
        o->keeps_openmp = number == 1;
    return wrong;
}

static const char *read_order(arena *a, options *o, const char *value) {
    int number;
    const char *wrong = read_word(a, "--order", order_words, COUNT(order_words), value, &number);
    if (!wrong) {
        o->order.word = (result_order)number;
        o->order.is_given = true;
    }
    return wrong;
}

static const char *read_form(arena *a, options *o, const char *value) {
    static const char *const words[] = {"text", "json", "sarif", "yaml"};
    int number;
    const char *wrong = read_word(a, "--report", words, COUNT(words), value, &number);
    if (!wrong) {
        o->report.form = (report_form)number;
        o->report.form_is_given = true;
    }
    return wrong;
}

static const char *read_pure(arena *a, options *o, const char *value) {
    while (*value) {
        const size_t length = strcspn(value, ",");
        if (length == 0)
            return "--pure takes names of functions, separated by commas";
        const char *name = arena_copy(a, value, length);
        if (stateful_effect(name))
            return arena_format(a, "--pure=%s: '%s' %s, so that it has side effects", name, name,
                                stateful_effect(name));
        VECTOR_PUSH(a, &o->pure, name);
        value += length + (value[length] == ',');
    }
    return NULL;
}

static const char *read_compiler(arena *a, options *o, const char *value) {
    static const char *const words[] = {"any", "known", "clang"};
    int number;
    const char *wrong = read_word(a, "--compiler", words, COUNT(words), value, &number);
    if (!wrong)
        o->compiler = (compiler_option)number;
    return wrong;
}

static const char *read_files(arena *a, options *o, const char *value) {
    static const char *const words[] = {"alone", "project"};
    int number;
    const char *wrong = read_word(a, "--files", words, COUNT(words), value, &number);
    if (!wrong)
        o->sees_project = number == 1;
    return wrong;
}

static const char *read_predefined(arena *a, options *o, const char *value) {
    const char *text = file_read(a, value, NULL);
    if (!text)
        return arena_format(a, "--predefined: cannot read '%s': %s", value, strerror(errno));
    if (!strstr(text, "#define __STDC__ "))
        return arena_format(
            a,
            "--predefined: '%s' does not list a compiler's macros, as 'cc -dM -E -x c "
            "/dev/null' prints them",
            value);
    if (o->compiler == COMPILER_ANY)
        o->compiler = COMPILER_KNOWN;
    VECTOR_PUSH(a, &o->flags, arena_format(a, "--predefined=%s", value));
    return NULL;
}

static const char *read_dump(arena *a, options *o, const char *value) {
    o->dump_ir = strcmp(value, "ir") == 0;
    return o->dump_ir ? NULL : arena_format(a, "--dump takes ir, not '%s'", value);
}

static const char *set_option(arena *a, options *o, option_name name, const char *value) {
    switch (name) {
    case OPTION_ALL:
        o->report.all = true;
        return NULL;
    case OPTION_ANALYZE:
        o->analyze = true;
        return NULL;
    case OPTION_ASSUME_NOALIAS:
        o->assume_noalias = true;
        return NULL;
    case OPTION_COMPILER:
        return read_compiler(a, o, value);
    case OPTION_DUMP:
        return read_dump(a, o, value);
    case OPTION_EXPLAIN:
        o->explain = value;
        return *value ? NULL : "--explain takes the id or slug of a reason, such as R204";
    case OPTION_FILES:
        return read_files(a, o, value);
    case OPTION_HELP:
        o->help = true;
        return NULL;
    case OPTION_IN_PROCESS:
        o->in_process = true;
        return NULL;
    case OPTION_INPUTS_FILE:
        o->report.inputs_file = value;
        return *value ? NULL : "--inputs-file takes the name of a file";
    case OPTION_LANES:
        return read_lanes(a, o, value);
    case OPTION_OPENMP_LOOPS:
        return read_openmp(a, o, value);
    case OPTION_ORDER:
        return read_order(a, o, value);
    case OPTION_PREDEFINED:
        return read_predefined(a, o, value);
    case OPTION_PURE:
        return *value ? read_pure(a, o, value) : "--pure takes names of functions";
    case OPTION_REPORT:
        return read_form(a, o, value);
    case OPTION_REPORT_FILE:
        o->report.file = value;
        return *value ? NULL : "--report-file takes the name of a file";
    case OPTION_REQUIRE:
        o->require = true;
        return NULL;
    case OPTION_VERIFY:
        o->verify = true;
        return NULL;
    case OPTION_VERSION:
        o->version = true;
        return NULL;
    }
    return NULL;
}

/* ---- words --------------------------------------------------------------------------------- */

typedef struct words {
    int count;
    char **items;
    int next;
} words;

static const char *read_long_option(arena *a, options *o, words *w, const char *word) {
    if (strcmp(word, "--explain") == 0) /* its value may be the next word */
        return set_option(a, o, OPTION_EXPLAIN, w->next < w->count ? w->items[w->next++] : "");
    for (size_t i = 0; i < COUNT(long_options); i++) {
        const char *text = long_options[i].text;
        const size_t length = strlen(text);
        const bool takes_value = text[length - 1] == '=';
        if (takes_value ? strncmp(word, text, length) == 0 : strcmp(word, text) == 0)
            return set_option(a, o, long_options[i].name, word + length);
        if (takes_value && strlen(word) == length - 1 && strncmp(word, text, length - 1) == 0)
            return arena_format(a, "%s takes a value: %sVALUE", word, text);
    }
    return unknown_option(a, word);
}

/** The value of a short option: the rest of the word, or the next one. */
static const char *short_value(words *w, const char *word, size_t length) {
    if (word[length])
        return word + length;
    return w->next < w->count ? w->items[w->next++] : NULL;
}

static const char *read_parser_flag(arena *a, options *o, words *w, const char *word,
                                    bool *is_flag) {
    *is_flag = true;
    if (strncmp(word, "-std=", 5) == 0) {
        VECTOR_PUSH(a, &o->flags, word);
        return NULL;
    }
    const option *known = option_find(word);
    *is_flag = known && known->meaning & OPTION_CLANG && known->meaning & OPTION_ARGUMENT;
    if (!*is_flag)
        return NULL;
    const char *flag = known->name;
    const char *value = short_value(w, word, strlen(flag));
    if (!value)
        return arena_format(a, "%s takes a value", flag);
    VECTOR_PUSH(a, &o->flags, flag);
    VECTOR_PUSH(a, &o->flags, value);
    return NULL;
}

static const char *read_short_option(arena *a, options *o, words *w, const char *word) {
    bool is_flag;
    const char *wrong = read_parser_flag(a, o, w, word, &is_flag);
    if (is_flag)
        return wrong;
    const bool is_output = word[1] == 'o';
    if ((!is_output && word[1] != 'p') || is_compiler_flag(word)) /* -pthread is not -p with a
                                                                   * value */
        return unknown_option(a, word);
    const char *value = short_value(w, word, 2);
    if (!value || !*value)
        return arena_format(a, "%.2s takes a value", word);
    *(is_output ? &o->output : &o->database_folder) = value;
    return NULL;
}

/** The first input with a C++ file name, or NULL if there is none. */
static const char *cxx_input(const options *o) {
    static const char *const endings[] = {".C", ".cc", ".cpp", ".cxx", ".c++"};
    for (unsigned i = 0; i < o->inputs.count; i++) {
        const char *dot = strrchr(path_base(o->inputs.items[i]), '.');
        if (dot && find_word(endings, COUNT(endings), dot) >= 0)
            return o->inputs.items[i];
    }
    return NULL;
}

static const char *check_together(arena *a, const options *o) {
    if (o->inputs.count == 0 && !(o->analyze && o->database_folder))
        return "no input file (all files of a build: --analyze -p FOLDER)";
    if (cxx_input(o))
        return arena_format(a, "'%s' is C++: redcc translates C", cxx_input(o));
    if (o->inputs.count > 1 && !o->analyze)
        return arena_format(a,
                            "one input file at a time, except with --analyze: '%s' is a second one",
                            o->inputs.items[1]);
    if (o->output && path_same_file(o->output, o->inputs.items[0]))
        return arena_format(a, "the output '%s' is the input: name another file", o->output);
    if (o->analyze && o->output)
        return "--analyze writes no source: it cannot be combined with -o";
    if (o->analyze && o->verify)
        return "--analyze writes no source: it cannot be combined with --verify";
    if (!o->analyze && !o->output && !o->dump_ir && !o->verify)
        return "no output: give -o FILE or --analyze";
    if (o->report.form != REPORT_TEXT && !o->analyze && !o->report.file)
        return "a report that is not text needs --report-file=FILE, or --analyze";
    if (o->in_process && o->analyze && o->inputs.count != 1)
        return "--in-process takes one input file";
    if (o->report.inputs_file && (o->analyze || o->database_folder))
        return "--inputs-file goes with -o, and with neither --analyze nor -p";
    if (o->inputs.count == 0 && o->require)
        return "--require takes an input file";
    return NULL;
}

const char *options_read(arena *a, int argc, char **argv, options *result) {
    *result =
        (options){.report.form = REPORT_TEXT, .order.word = ORDER_SERIAL, .lanes = LANES_OF_HEAVY};
    words w = {argc, argv, 1};
    bool only_flags = false;
    while (w.next < w.count) {
        const char *word = w.items[w.next++];
        const char *wrong = NULL;
        if (only_flags)
            VECTOR_PUSH(a, &result->flags, word);
        else if (strcmp(word, "--") == 0)
            only_flags = true;
        else if (strncmp(word, "--", 2) == 0)
            wrong = read_long_option(a, result, &w, word);
        else if (word[0] == '-' && word[1])
            wrong = read_short_option(a, result, &w, word);
        else
            VECTOR_PUSH(a, &result->inputs, word);
        if (wrong)
            return wrong;
    }
    const bool asks = result->help || result->version || result->explain;
    return asks ? NULL : check_together(a, result);
}
