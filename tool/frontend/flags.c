/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "frontend/flags.h"

#include <glob.h>
#include <string.h>
#include <sys/stat.h>

#include "frontend/predefined.h"
#include "support/source.h"

/* How a flag that is passed on looks; all others are left out. */
typedef enum flag_form {
    EXACT,   /* -ansi */
    PREFIX,  /* -std=c99 */
    ARGUMENT /* -Idir, -I dir */
} flag_form;

static const struct {
    const char *name;
    flag_form form;
} passed_on[] = {
    {"--sysroot", ARGUMENT},
    {"-D", ARGUMENT},
    {"-I", ARGUMENT},
    {"-O", PREFIX},
    {"-U", ARGUMENT},
    {"-ansi", EXACT},
    {"-fgnuc-version=", PREFIX},
    {"-fms-extensions", EXACT},
    {"-fno-builtin", PREFIX},
    {"-fno-short-enums", EXACT},
    {"-fno-signed-char", EXACT},
    {"-fno-unsigned-char", EXACT},
    {"-fshort-enums", EXACT},
    {"-fsigned-char", EXACT},
    {"-funsigned-char", EXACT},
    {"-idirafter", ARGUMENT},
    {"-imacros", ARGUMENT},
    {"-include", ARGUMENT},
    {"-iquote", ARGUMENT},
    {"-isysroot", ARGUMENT},
    {"-isystem", ARGUMENT},
    {"-m", PREFIX},
    {"-nostdinc", EXACT},
    {"-pthread", EXACT},
    {"-std=", PREFIX},
    {"-trigraphs", EXACT},
};

/* What these are followed by is no flag. */
static const char *const dropped_with_argument[] = {
    "-A",        "-L", "-MF", "-MQ", "-MT", "-T", "-Xassembler", "-Xlinker", "-Xpreprocessor",
    "-aux-info", "-l", "-o",  "-u",  "-x",  "-z",
};

static bool has_form(const char *flag, unsigned row) {
    const char *name = passed_on[row].name;
    switch (passed_on[row].form) {
    case EXACT:
        return strcmp(flag, name) == 0;
    default:
        return source_starts_with(flag, name);
    }
}

/* Adds flags[i], and its argument where that stands apart. Returns the index of the last taken. */
static unsigned take(arena *a, parse_flags *chosen, unsigned i, unsigned count,
                     const char *const *flags) {
    for (unsigned row = 0; row < sizeof passed_on / sizeof passed_on[0]; row++) {
        if (!has_form(flags[i], row))
            continue;
        bool is_alone = strcmp(flags[i], passed_on[row].name) == 0;
        bool needs_next = is_alone && passed_on[row].form == ARGUMENT;
        if (needs_next && i + 1 == count)
            return i;
        VECTOR_PUSH(a, &chosen->items, flags[i]);
        if (needs_next)
            VECTOR_PUSH(a, &chosen->items, flags[++i]);
        return i;
    }
    for (unsigned row = 0; row < sizeof dropped_with_argument / sizeof *dropped_with_argument;
         row++)
        if (strcmp(flags[i], dropped_with_argument[row]) == 0)
            return i + 1;
    return i;
}

static bool is_folder(const char *path) {
    struct stat status;
    return path[0] != 0 && stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* gcc's own headers: where they were when this was built, or where Debian has them. */
static const char *gcc_include_folder(arena *a) {
    if (is_folder(REDCC_GCC_INCLUDE))
        return REDCC_GCC_INCLUDE;
    glob_t found;
    const char *folder = NULL;
    if (glob("/usr/lib/gcc/*/*/include", 0, NULL, &found) == 0) {
        folder = arena_string(a, found.gl_pathv[found.gl_pathc - 1]);
        globfree(&found);
    }
    return folder;
}

static void add(arena *a, parse_flags *chosen, const char *flag) {
    VECTOR_PUSH(a, &chosen->items, flag);
}

/* Old C that gcc takes with a warning, and limits meant for people, must not stop the parser. */
static void add_leniency(arena *a, parse_flags *chosen) {
    static const char *const flags[] = {
        "-xc",
        "-ferror-limit=0",
        "-fbracket-depth=10000",
        "-w",
        "-Wno-error=implicit-function-declaration",
        "-Wno-error=implicit-int",
        "-Wno-error=int-conversion",
        "-Wno-error=incompatible-function-pointer-types",
        "-Wno-error=incompatible-pointer-types",
        "-Wno-error=return-mismatch",
        "-D__malloc__(...)=__malloc__", /* gcc's omp.h gives the attribute arguments */
    };
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        add(a, chosen, flags[i]);
}

static void add_headers(arena *a, parse_flags *chosen) {
    if (is_folder(REDCC_CLANG_RESOURCES)) {
        add(a, chosen, "-resource-dir");
        add(a, chosen, REDCC_CLANG_RESOURCES);
    }
}

bool add_gcc_headers(arena *a, parse_flags *flags) {
    const char *folder = flags->has_headers ? gcc_include_folder(a) : NULL;
    if (folder == NULL)
        return false;
    add(a, flags, "-idirafter");
    add(a, flags, folder);
    return true;
}

static bool sets_word_size(const char *flag) {
    return strcmp(flag, "-m32") == 0 || strcmp(flag, "-m64") == 0 || strcmp(flag, "-mx32") == 0;
}

void remove_machine_flags(parse_flags *flags) {
    unsigned kept = 0;
    for (unsigned i = 0; i < flags->items.count; i++) {
        const char *flag = flags->items.items[i];
        if (!source_starts_with(flag, "-m") || sets_word_size(flag))
            flags->items.items[kept++] = flag;
    }
    flags->items.count = kept;
}

/* The runtime's own structures and numbers would be others than the library's. */
static bool changes_layout(const char *flag) {
    return source_starts_with(flag, "-fpack-struct") || strcmp(flag, "-mlong-double-128") == 0;
}

/* The user's own flags come after the compiler's macros, which they may change. */
static void choose_predefined(arena *a, parse_flags *chosen, unsigned count,
                              const char *const *flags) {
    static const char name[] = "--predefined=";
    for (unsigned i = 0; i < count; i++)
        if (source_starts_with(flags[i], name))
            add_predefined(a, chosen, flags[i] + sizeof name - 1);
    for (unsigned i = 0; i < count; i++)
        if (source_starts_with(flags[i], "-D") || source_starts_with(flags[i], "-U"))
            forget_predefined(chosen, flags[i][2] || i + 1 == count ? flags[i] : flags[i + 1]);
}

static bool is_predefined(const parse_flags *flags, const char *name) {
    return flags->predefined && map_get(flags->predefined, name, strlen(name));
}

parse_flags choose_flags(arena *a, unsigned count, const char *const *flags) {
    parse_flags chosen = {.strict_aliasing = true, .has_headers = true};
    bool has_openmp = false;
    choose_predefined(a, &chosen, count, flags);
    for (unsigned i = 0; i < count; i++) {
        const char *flag = flags[i];
        if (source_starts_with(flag, "-fopenmp") && strcmp(flag, "-fopenmp-simd") != 0)
            has_openmp = true;
        else if (strcmp(flag, "-fno-openmp") == 0)
            has_openmp = false;
        else if (strcmp(flag, "-fno-strict-aliasing") == 0)
            chosen.strict_aliasing = false;
        else if (strcmp(flag, "-fstrict-aliasing") == 0)
            chosen.strict_aliasing = true;
        if (changes_layout(flag))
            chosen.unseen = flag;
        chosen.has_headers = chosen.has_headers && strcmp(flag, "-nostdinc") != 0;
        i = take(a, &chosen, i, count, flags);
    }
    /* Parsed with -fopenmp itself, a loop below a directive would be hidden in the directive. */
    if (has_openmp && !is_predefined(&chosen, "_OPENMP"))
        add(a, &chosen, "-D_OPENMP=201511");
    add_leniency(a, &chosen);
    if (chosen.has_headers)
        add_headers(a, &chosen);
    return chosen;
}
