/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for strverscmp */
#include "frontend/flags.h"

#include <assert.h>
#include <glob.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "frontend/frontend.h"
#include "frontend/predefined.h"
#include "support/compiler_options.h"
#include "support/source.h"

/* Adds flags[i] if the parser needs it, together with its argument if that is the next word.
 * Returns the index of the last word that belongs to the flag. */
static unsigned take(arena *a, parse_flags *chosen, unsigned i, unsigned count,
                     const char *const *flags) {
    assert(i < count);
    const option *known = option_find(flags[i]);
    const unsigned meaning = known ? known->meaning : 0;
    const bool needs_next = (meaning & OPTION_ARGUMENT) && strcmp(flags[i], known->name) == 0;
    if (needs_next && i + 1 == count)
        return i;
    if (meaning & OPTION_CLANG) {
        VECTOR_PUSH(a, &chosen->items, flags[i]);
        if (needs_next)
            VECTOR_PUSH(a, &chosen->items, flags[i + 1]);
    }
    if (meaning & OPTION_REFUSE && !chosen->refusing)
        chosen->refusing = flags[i];
    if (meaning & OPTION_INEXACT && !chosen->inexact)
        chosen->inexact = flags[i];
    return needs_next ? i + 1 : i;
}

static bool is_folder(const char *path) {
    struct stat status;
    return path[0] != 0 && stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

/* Folders in which common distributions install gcc's headers, for the machine that redcc was built
 * for. */
#if defined(__x86_64__)
#define GCC_FOLDERS "/usr/lib/gcc/x86_64-*linux*/*/include"
#elif defined(__aarch64__)
#define GCC_FOLDERS "/usr/lib/gcc/aarch64-*linux*/*/include"
#else
#define GCC_FOLDERS "/usr/lib/gcc/*linux*/*/include"
#endif

const char *newest_folder(size_t count, char *const *paths) {
    const char *newest = NULL;
    for (size_t i = 0; i < count; i++)
        if (!newest || strverscmp(paths[i], newest) > 0)
            newest = paths[i];
    return newest;
}

/* Returns the folder of gcc's own headers: the one found when redcc was built or, if that does not
 * exist, the folder of the newest version. NULL if there is none. */
static const char *gcc_include_folder(arena *a) {
    if (is_folder(REDCC_GCC_INCLUDE))
        return REDCC_GCC_INCLUDE;
    glob_t found;
    const char *folder = NULL;
    if (glob(GCC_FOLDERS, 0, NULL, &found) == 0) {
        folder = arena_string(a, newest_folder(found.gl_pathc, found.gl_pathv));
        globfree(&found);
    }
    return folder;
}

static void add(arena *a, parse_flags *chosen, const char *flag) {
    VECTOR_PUSH(a, &chosen->items, flag);
}

/* Adds flags that keep the parser from rejecting old C, of which gcc only warns, and from stopping
 * at clang's limits (bracket depth, number of errors). */
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
        "-D__malloc__(...)=__malloc__", /* gcc's omp.h gives this attribute arguments, which clang
                                         * does not accept */
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

frontend_folders frontend_header_folders(arena *a) {
    return (frontend_folders){
        .own = is_folder(REDCC_CLANG_RESOURCES) ? REDCC_CLANG_RESOURCES "/include" : NULL,
        .of_gcc = gcc_include_folder(a),
    };
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

/* Notes the compiler's predefined macros, then the user's -D and -U, which may override them. */
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

static bool is_one_of(const char *flag, const char *const *names) {
    while (*names && strcmp(flag, *names) != 0)
        names++;
    return *names != NULL;
}

static bool names_c89(const char *standard) {
    static const char *const names[] = {"c89",   "c90",          "gnu89",          "gnu90",
                                        "c1990", "iso9899:1990", "iso9899:199409", NULL};
    return is_one_of(standard, names);
}

/* Does the name mean C23 or later (c23, gnu23, c2x, gnu2x, ...)? */
static bool names_c23(const char *standard) {
    return source_starts_with(standard, "c2") || source_starts_with(standard, "gnu2") ||
           strstr(standard, ":202");
}

/* Does the list name a sanitizer that may check arithmetic? The sanitizers in of_memory[] check
 * only memory or threads; any other counts. */
static bool reports_arithmetic(const char *list) {
    static const char *const of_memory[] = {"address",          "leak",   "thread",
                                            "hwaddress",        "memory", "pointer-compare",
                                            "pointer-subtract", NULL};
    for (size_t length; *list; list += length + (list[length] == ',')) {
        length = strcspn(list, ",");
        unsigned i = 0;
        while (of_memory[i] &&
               (strlen(of_memory[i]) != length || strncmp(list, of_memory[i], length) != 0))
            i++;
        if (!of_memory[i])
            return true;
    }
    return false;
}

/* Notes options of the language. If options contradict each other, the last one counts. All
 * -fsanitize= options count. */
static void note_language(parse_flags *chosen, const char *flag) {
    if (strcmp(flag, "-fno-strict-aliasing") == 0)
        chosen->strict_aliasing = false;
    else if (strcmp(flag, "-fstrict-aliasing") == 0)
        chosen->strict_aliasing = true;
    else if (strcmp(flag, "-fwrapv") == 0)
        chosen->wraps = true;
    else if (strcmp(flag, "-fno-wrapv") == 0)
        chosen->wraps = false;
    else if (strcmp(flag, "-ansi") == 0)
        chosen->is_c89 = true, chosen->is_c23 = false;
    else if (source_starts_with(flag, "-std=")) {
        chosen->is_c89 = names_c89(flag + sizeof "-std=" - 1);
        chosen->is_c23 = names_c23(flag + sizeof "-std=" - 1);
    } else if (source_starts_with(flag, "-fsanitize="))
        chosen->is_sanitized |= reports_arithmetic(flag + sizeof "-fsanitize=" - 1);
    else if (strcmp(flag, "-nostdinc") == 0)
        chosen->has_headers = false;
}

static void note_code(parse_flags *chosen, const char *flag) {
    static const char *const interposable[] = {"-fPIC", "-fpic", NULL};
    static const char *const final[] = {"-fPIE",    "-fpie",    "-fno-PIC", "-fno-pic",
                                        "-fno-PIE", "-fno-pie", NULL};
    static const char *const without_errno[] = {"-fno-math-errno", "-ffast-math", "-Ofast", NULL};
    if (is_one_of(flag, interposable) || is_one_of(flag, final))
        chosen->may_be_interposed = is_one_of(flag, interposable);
    else if (strcmp(flag, "-fno-semantic-interposition") == 0)
        chosen->no_interposition = true;
    else if (strcmp(flag, "-fsemantic-interposition") == 0)
        chosen->no_interposition = false;
    else if (is_one_of(flag, without_errno))
        chosen->math_errno = false;
    else if (strcmp(flag, "-fmath-errno") == 0)
        chosen->math_errno = true;
}

/* Notes the folder of `-isystem FOLDER` or `-isystemFOLDER`, and that of -idirafter in the same
 * forms. `next` is the next word, or NULL. */
static void note_folder(arena *a, parse_flags *chosen, const char *flag, const char *next) {
    static const char *const names[] = {"-isystem", "-idirafter"};
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
        if (!source_starts_with(flag, names[i]))
            continue;
        const char *folder = flag[strlen(names[i])] ? flag + strlen(names[i]) : next;
        if (folder)
            VECTOR_PUSH(a, &chosen->system_folders, folder);
    }
}

/* Notes the folders in C_INCLUDE_PATH, which gcc and clang search like those of -isystem. */
static void note_folders_of_environment(arena *a, parse_flags *chosen) {
    const char *list = getenv("C_INCLUDE_PATH");
    for (size_t length; list && *list; list += length + (list[length] == ':')) {
        length = strcspn(list, ":");
        if (length > 0)
            VECTOR_PUSH(a, &chosen->system_folders, arena_copy(a, list, length));
    }
}

static bool turns_on_openmp(const char *flag) {
    const option *known = option_find(flag);
    return known && known->meaning & OPTION_OPENMP;
}

parse_flags choose_flags(arena *a, unsigned count, const char *const *flags) {
    parse_flags chosen = {.strict_aliasing = true, .has_headers = true, .math_errno = true};
    choose_predefined(a, &chosen, count, flags);
    for (unsigned i = 0; i < count; i++) {
        chosen.has_openmp = (chosen.has_openmp || turns_on_openmp(flags[i])) &&
                            strcmp(flags[i], "-fno-openmp") != 0;
        note_language(&chosen, flags[i]);
        note_code(&chosen, flags[i]);
        note_folder(a, &chosen, flags[i], i + 1 < count ? flags[i + 1] : NULL);
        i = take(a, &chosen, i, count, flags);
    }
    note_folders_of_environment(a, &chosen);
    /* -fopenmp itself is not passed on: libclang would show a loop only as part of the directive
     * above it */
    if (chosen.has_openmp && !is_predefined(&chosen, "_OPENMP"))
        add(a, &chosen, "-D_OPENMP=201511");
    chosen.has_openmp |= is_predefined(&chosen, "_OPENMP");
    add_leniency(a, &chosen);
    if (chosen.has_headers)
        add_headers(a, &chosen);
    return chosen;
}
