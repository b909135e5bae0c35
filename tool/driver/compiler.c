/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/compiler.h"

#include <assert.h>
#include <ctype.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

#include "driver/command.h"
#include "driver/files.h"
#include "driver/process.h"

static bool is_self(const char *self, const char *path) {
    return self && path_same_file(self, path);
}

/* Returns the path that execvp would use for `name`, but skips entries of PATH that lead back to
 * this program. Adds the number of skipped entries to *skipped. Returns NULL if there is no such
 * path. */
static const char *find_program(arena *a, const char *self, const char *name, unsigned *skipped) {
    if (strchr(name, '/')) {
        *skipped += is_self(self, name);
        return path_is_executable(name) && !is_self(self, name) ? name : NULL;
    }
    const char *path = getenv("PATH");
    if (!path)
        path = "/usr/local/bin:/usr/bin:/bin";
    while (*path) {
        size_t length = strcspn(path, ":");
        const char *folder = length ? arena_copy(a, path, length) : ".";
        const char *candidate = arena_format(a, "%s/%s", folder, name);
        path += length + (path[length] == ':');
        if (!path_is_executable(candidate))
            continue;
        if (!is_self(self, candidate))
            return candidate;
        ++*skipped;
    }
    return NULL;
}

/* Adds a program's name, or its full path if the name alone would start this program. Returns false
 * if no other program has the name. */
static bool add_program(arena *a, word_list *list, const char *self, const char *name) {
    unsigned skipped = 0;
    const char *path = find_program(a, self, name, &skipped);
    if (path)
        words_add(a, list, skipped ? path : name);
    return path != NULL;
}

bool compiler_is_launcher(const char *word) {
    static const char *const names[] = {"ccache", "sccache", "distcc", "icecc", "colorgcc"};
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(path_base(word), names[i]) == 0)
            return true;
    return false;
}

static bool names_compiler(arena *a, const char *word) {
    unsigned skipped = 0;
    return word[0] != '-' && word[0] != '@' && word[0] && !name_is_input(word) &&
           find_program(a, NULL, word, &skipped);
}

/* If the words begin with a compiler's or launcher's name (launcher form), takes the names of
 * launchers and then the compiler's name from them. */
static void take_from_front(arena *a, const char *self, unsigned count, char *const *words,
                            compiler *c) {
    while (c->taken < count && names_compiler(a, words[c->taken])) {
        const char *word = words[c->taken++];
        if (add_program(a, &c->words, self, word) && !compiler_is_launcher(word))
            return;
    }
}

static void take_from_environment(arena *a, const char *self, compiler *c) {
    const char *value = getenv("REDCC_CC");
    if (!value || !*value)
        return;
    word_list words = {0};
    if (path_is_executable(value))
        words_add(a, &words, value);
    else
        words_split(a, value, &words);
    if (words.count == 0 || !add_program(a, &c->words, self, words.items[0])) {
        unsigned skipped = 0;
        if (words.count > 0 && !find_program(a, NULL, words.items[0], &skipped))
            words_add(a, &c->words, words.items[0]); /* running it reports that it does not exist */
        return;
    }
    for (unsigned i = 1; i < words.count; i++)
        words_add(a, &c->words, words.items[i]);
}

static void take_default(arena *a, const char *self, const char *called, compiler *c) {
    static const char *const names[] = {"cc", "gcc", "clang"};
    const char *base = path_base(called);
    if (strcmp(base, "redcc-cc") != 0 && add_program(a, &c->words, self, base))
        return;
    for (unsigned i = 0; i < sizeof names / sizeof names[0]; i++)
        if (add_program(a, &c->words, self, names[i]))
            return;
}

/* Does the compiler of this name compile for another machine? "x86_64-linux-gnu-gcc-12" compiles
 * for x86_64, "gcc-12" for this machine. */
static bool is_for_another_machine(const char *base) {
    struct utsname host;
    const char *dash = strchr(base, '-');
    if (!dash || (!strstr(dash, "-gcc") && !strstr(dash, "-clang") && !strstr(dash, "-cc")))
        return false;
    size_t length = (size_t)(dash - base);
    return uname(&host) != 0 || strncmp(host.machine, base, length) != 0 || host.machine[length];
}

static void describe(arena *a, compiler *c) {
    unsigned last = 0;
    while (last + 1 < c->words.count && compiler_is_launcher(c->words.items[last]))
        last++;
    for (unsigned i = last; i < c->words.count; i++)
        words_add(a, &c->bare, c->words.items[i]);
    const char *name = c->words.items[last];
    unsigned skipped = 0;
    const char *path = find_program(a, NULL, name, &skipped);
    char real[PATH_MAX];
    const char *base = path_base(name);
    c->is_clang = strstr(path && realpath(path, real) ? path_base(real) : base, "clang") != NULL;
    size_t stem = strlen(base);
    while (stem > 0 && (isdigit((unsigned char)base[stem - 1]) || strchr("-.", base[stem - 1])))
        stem--;
    c->is_cxx = stem >= 2 && base[stem - 1] == '+' && base[stem - 2] == '+';
    c->is_cross = is_for_another_machine(base);
    if (strcmp(base, "c89") == 0)
        c->standard = "-std=c89";
    else if (strcmp(base, "c99") == 0)
        c->standard = "-std=c99";
}

compiler compiler_choose(arena *a, const char *self, unsigned count, char *const *words) {
    assert(count > 0); /* the program's own name */
    compiler c;
    memset(&c, 0, sizeof c);
    take_from_front(a, self, count - 1, words + 1, &c);
    if (c.words.count == 0)
        take_from_environment(a, self, &c);
    if (c.words.count == 0)
        take_default(a, self, words[0], &c);
    c.found = c.words.count > 0;
    if (c.found)
        describe(a, &c);
    return c;
}

bool compiler_has_launcher(const compiler *c) {
    assert(c->bare.count <= c->words.count);
    return c->bare.count < c->words.count;
}
