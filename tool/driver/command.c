/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/command.h"

#include <assert.h>
#include <string.h>

#include "driver/files.h"

static const char *ending(const char *word) {
    const char *dot = strrchr(path_base(word), '.');
    return dot ? dot : "";
}

static bool is_one_of(const char *word, const char *const *names) {
    for (; *names; names++)
        if (strcmp(word, *names) == 0)
            return true;
    return false;
}

static const char *const compiled_endings[] = {
    ".C",   ".CPP", ".F",   ".F03", ".F08", ".F90", ".F95", ".FOR", ".FPP", ".FTN", ".M",  ".S",
    ".ada", ".adb", ".ads", ".bc",  ".c++", ".cc",  ".cp",  ".cpp", ".cu",  ".cxx", ".d",  ".f",
    ".f03", ".f08", ".f90", ".f95", ".for", ".fpp", ".ftn", ".go",  ".h",   ".h++", ".hh", ".hp",
    ".hpp", ".hxx", ".i",   ".ii",  ".ll",  ".m",   ".mi",  ".mii", ".mm",  ".s",   ".sx", NULL};

static const char *const linked_endings[] = {".a",  ".dll", ".dylib", ".ld", ".lib",
                                             ".lo", ".o",   ".obj",   ".so", NULL};

bool name_is_input(const char *word) {
    const char *end = ending(word);
    return strcmp(end, ".c") == 0 || is_one_of(end, compiled_endings) ||
           is_one_of(end, linked_endings) || strstr(path_base(word), ".so.") != NULL;
}

static input_kind kind_of(const char *word, const char *language, bool c_is_cxx) {
    if (language)
        return strcmp(language, "c") == 0 && !c_is_cxx ? INPUT_C : INPUT_COMPILE;
    if (strcmp(ending(word), ".c") == 0)
        return c_is_cxx ? INPUT_COMPILE : INPUT_C;
    return is_one_of(ending(word), compiled_endings) ? INPUT_COMPILE : INPUT_LINK;
}

/* Is the item the option that has this name in the table of options? */
static bool is_named(const item *i, const char *name) {
    const option *found = i->kind == INPUT_NOT ? option_find(i->text) : NULL;
    return found && strcmp(found->name, name) == 0;
}

const char *item_argument(const item *i) {
    if (i->value)
        return i->value;
    const option *found = option_find(i->text);
    return found ? i->text + strlen(found->name) : "";
}

/* The meaning of an option of the form -Wp,LIST. The translator accepts -Wp,-DA,-UB, but no list
 * with other elements. */
static unsigned meaning_of_preprocessor_list(const char *word, unsigned meaning) {
    if (!(meaning & OPTION_PARSE))
        return meaning;
    for (const char *piece = strchr(word, ','); piece; piece = strchr(piece + 1, ','))
        if (strncmp(piece, ",-D", 3) != 0 && strncmp(piece, ",-U", 3) != 0)
            return OPTION_GIVE_UP;
    return meaning;
}

/* The option's meaning, which may depend on its argument. */
static unsigned meaning_with_argument(const option *found, const item *i) {
    const char *argument = i->value ? i->value : i->text + strlen(found->name);
    if (strcmp(found->name, "-fopt-info") == 0 && !strchr(argument, '='))
        return found->meaning & ~(unsigned)OPTION_AUXILIARY; /* it writes messages, and no file */
    if (strcmp(found->name, "-ftree-parallelize-loops=") == 0 && strcmp(argument, "1") == 0)
        return found->meaning & ~(unsigned)OPTION_THREADS;
    if (strcmp(found->name, "-fsanitize=") == 0 && strstr(argument, "thread"))
        return found->meaning | OPTION_GIVE_UP; /* ThreadSanitizer does not see how OpenMP's threads
                                                 * are synchronised */
    if (strcmp(found->name, "-MF") == 0 &&
        (strcmp(argument, "-") == 0 || strncmp(argument, "/dev/", 5) == 0) &&
        strcmp(argument, "/dev/null") != 0)
        return found->meaning | OPTION_GIVE_UP; /* dependencies are mixed with other output */
    return found->meaning;
}

static item read_option(const word_list *words, unsigned *next) {
    assert(*next < words->count);
    item i = {words->items[*next], NULL, 0, INPUT_NOT, NULL};
    ++*next;
    const option *found = option_find(i.text);
    if (!found)
        return i;
    bool takes_next = (found->meaning & OPTION_ARGUMENT) && strcmp(i.text, found->name) == 0;
    if (takes_next && *next >= words->count) {
        /* the argument is missing: a word that redcc-cc adds would take its place */
        i.meaning = found->meaning | OPTION_GIVE_UP | OPTION_NO_RUNTIME;
        return i;
    }
    if (takes_next)
        i.value = words->items[(*next)++];
    i.meaning = meaning_with_argument(found, &i);
    if (strncmp(i.text, "-Wp,", 4) == 0)
        i.meaning = meaning_of_preprocessor_list(i.text, i.meaning);
    return i;
}

static void count_item(command *c, const item *i) {
    c->meaning |= i->meaning;
    c->c_count += i->kind == INPUT_C;
    c->compiled += i->kind == INPUT_C || i->kind == INPUT_COMPILE;
    c->linked += i->kind == INPUT_LINK || is_named(i, "-l");
    if (is_named(i, "-o"))
        c->output = item_argument(i);
}

/* Is an input a header? It is compiled to its precompiled form, and nothing is linked. */
static bool has_header(const command *c) {
    static const char *const headers[] = {".h", ".h++", ".hh", ".hp", ".hpp", ".hxx", NULL};
    for (unsigned i = 0; i < c->count; i++) {
        const item *one = &c->items[i];
        if (one->kind == INPUT_COMPILE && (one->language ? strstr(one->language, "-header") != NULL
                                                         : is_one_of(ending(one->text), headers)))
            return true;
    }
    return false;
}

command command_parse(arena *a, const word_list *words, bool c_is_cxx) {
    command c;
    memset(&c, 0, sizeof c);
    VECTOR(item) items = {0};
    unsigned next = 0;
    while (next < words->count) {
        const char *word = words->items[next];
        item i = {word, NULL, 0, INPUT_NOT, NULL};
        if (word[0] == '-' && word[1]) {
            i = read_option(words, &next);
        } else {
            i.kind = kind_of(word, c.language, c_is_cxx);
            i.language = c.language;
            next++;
        }
        if (is_named(&i, "-x"))
            c.language = strcmp(item_argument(&i), "none") == 0 ? NULL : item_argument(&i);
        VECTOR_PUSH(a, &items, i);
    }
    for (unsigned i = 0; i < items.count; i++)
        count_item(&c, &items.items[i]);
    assert(c.compiled + c.linked <= items.count);
    c.items = items.items;
    c.count = items.count;
    c.compiles = c.compiled > 0 && !(c.meaning & OPTION_NO_OBJECT);
    c.links = c.compiled + c.linked > 0 && !(c.meaning & (OPTION_NO_OBJECT | OPTION_NO_LINK)) &&
              !has_header(&c);
    return c;
}

/* Does only a compiler test (configure, CMake, Meson) use a file or folder of this name? */
static bool is_probe_path(const char *path) {
    static const char *const folders[] = {"CMakeFiles/CMakeTmp",
                                          "CMakeFiles/CMakeScratch",
                                          "CMakeFiles/CompilerId",
                                          "TryCompile-",
                                          "meson-private/",
                                          ".conf_check_",
                                          "cmTC_",
                                          NULL};
    static const char *const names[] = {"CMakeCCompilerId.c",    "CMakeCCompilerABI.c",
                                        "testCCompiler.c",       "_configtest.c",
                                        "CheckFunctionExists.c", NULL};
    const char *base = path_base(path);
    for (unsigned i = 0; folders[i]; i++)
        if (strstr(path, folders[i]))
            return true;
    size_t stem = strcspn(base, ".");
    return is_one_of(base, names) || (stem == 8 && strncmp(base, "conftest", stem) == 0);
}

bool command_is_probe(const command *c, const char *folder) {
    if (is_probe_path(folder) || (c->output && is_probe_path(c->output)))
        return true;
    for (unsigned i = 0; i < c->count; i++)
        if (c->items[i].kind != INPUT_NOT && is_probe_path(c->items[i].text))
            return true;
    return false;
}

void item_add(arena *a, word_list *list, const item *i) {
    words_add(a, list, i->text);
    if (i->value)
        words_add(a, list, i->value);
}

void item_add_strict(arena *a, word_list *list, const item *i) {
    if (!(i->meaning & OPTION_LIBERTY)) {
        item_add(a, list, i);
        return;
    }
    for (const char *const *rest = option_without_liberty(i->text); *rest; rest++)
        words_add(a, list, *rest);
}

void command_add_options(arena *a, word_list *list, const command *c, unsigned without) {
    for (unsigned i = 0; i < c->count; i++) {
        const item *one = &c->items[i];
        if (one->kind != INPUT_NOT || one->meaning & without & ~(unsigned)OPTION_LIBERTY ||
            is_named(one, "-o") || is_named(one, "-x"))
            continue;
        if (without & OPTION_LIBERTY)
            item_add_strict(a, list, one);
        else
            item_add(a, list, one);
    }
}

static void add_preprocessor_list(arena *a, word_list *list, const char *word) {
    const char *piece = strchr(word, ',');
    while (piece) {
        const char *end = strchr(piece + 1, ',');
        size_t length = end ? (size_t)(end - piece) - 1 : strlen(piece + 1);
        words_add(a, list, arena_copy(a, piece + 1, length));
        piece = end;
    }
}

void command_add_parse_options(arena *a, word_list *list, const command *c, bool is_strict) {
    for (unsigned i = 0; i < c->count; i++) {
        const item *one = &c->items[i];
        if (!(one->meaning & OPTION_PARSE))
            continue;
        if (strncmp(one->text, "-Wp,", 4) == 0)
            add_preprocessor_list(a, list, one->text);
        else if (is_strict)
            item_add_strict(a, list, one);
        else
            item_add(a, list, one);
    }
}
