/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/answerers.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "driver/files.h"
#include "driver/program_identity.h"

struct cache {
    store kept;
    digest compiler;
    digest program;       /* contents of the translator's program, without its libraries */
    digest libraries_key; /* the key under which the list of its libraries is cached */
    digest translator;
    word_list folders;
};

const store *answerers_store(const session *s) {
    return &s->cache->kept;
}

const digest *answerers_identity(const session *s, cache_program program) {
    assert(program <= CACHE_COMPILER);
    const struct cache *c = s->cache;
    return program == CACHE_COMPILER ? &c->compiler : &c->translator;
}

bool answerers_options_are_plain(const word_list *options) {
    static const char *const plain[] = {
        "--all", "--assume-noalias", "--lanes=", "--order=", "--pure=", "--report=text"};
    for (unsigned i = 0; i < options->count; i++) {
        bool is_plain = false;
        for (size_t k = 0; k < sizeof plain / sizeof *plain; k++)
            is_plain |= strncmp(options->items[i], plain[k], strlen(plain[k])) == 0;
        if (!is_plain)
            return false;
    }
    return true;
}

/* ---- the compiler ---------------------------------------------------------------------------- */

/* Adds to the digest the programs that run when the compiler is called: launchers (ccache), and the
 * compiler itself. */
static bool add_programs(session *s, const store *kept, digester *d) {
    const word_list *words = &s->real.words;
    unsigned i = 0;
    do
        if (!identity_add_program(s->memory, kept, d, words->items[i]))
            return false;
    while (compiler_is_launcher(words->items[i]) && ++i < words->count);
    for (i = 0; i < words->count; i++)
        digest_text(d, words->items[i]);
    return true;
}

/* Returns what the compiler prints when called with the options `question`. The answer is cached
 * under `of_whom`, the compiler's identity, because no source can affect it. Returns NULL if the
 * compiler fails. */
static const char *ask_compiler(session *s, const store *kept, const digest *of_whom,
                                const char *const *question) {
    arena *a = s->memory;
    word_list words = {0};
    words_add_all(a, &words, &s->real.words);
    digester d = digest_begin();
    digest_text(&d, "a question");
    digest_add(&d, of_whom->bytes, sizeof of_whom->bytes);
    for (; *question; question++) {
        words_add(a, &words, *question);
        digest_text(&d, *question);
    }
    const digest key = digest_end(&d);
    store_part part;
    if (store_get(a, kept, &key, 1, &part))
        return arena_copy(a, part.bytes, part.length);
    const char *to = arena_format(a, "%s/question", s->folder);
    unlink(to);
    if (process_run(a, &words, (process_streams){NULL, to, to}) != 0)
        return NULL;
    size_t length;
    const char *text = file_read(a, to, &length);
    if (text)
        store_put(a, kept, &key, 1, &(store_part){text, length});
    return text;
}

/* Adds to `folders` the folders that the compiler prints under -v, in any language, including
 * nonexistent folders. Other paths in the text may be added as well. */
static void add_printed_folders(arena *a, const char *text, word_list *folders) {
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        const size_t end = strcspn(line, "\n");
        const char *quote = memchr(line, '"', end);
        if (line[0] == ' ' && line[1] == '/')
            words_add(a, folders, arena_copy(a, line + 1, end - 1));
        else if (quote && quote[1] == '/')
            words_add(a, folders, arena_copy(a, quote + 1, strcspn(quote + 1, "\"\n")));
    }
}

/* Adds the dynamic loader's cache to the digest: if the cache changes, names of shared libraries
 * may lead to other files. */
static bool add_loader(session *s, const store *kept, digester *d) {
    static const char path[] = "/etc/ld.so.cache";
    word_list files = {0};
    if (access(path, F_OK) == 0)
        words_add(s->memory, &files, path);
    return identity_add_files(s->memory, kept, d, &files);
}

static bool find_compiler(session *s, struct cache *c) {
    static const char *const ask_folders[] = {"-v", "-E", "-x", "c", "/dev/null", NULL};
    static const char *const ask_proper[] = {"-print-prog-name=cc1", NULL};
    digester d = digest_begin();
    identity_add_environment(s->memory, &d);
    if ((s->real.is_clang && !add_loader(s, &c->kept, &d)) || !add_programs(s, &c->kept, &d))
        return false;
    digester all = d;
    const digest driver = digest_end(&d);
    const char *proper = ask_compiler(s, &c->kept, &driver, ask_proper);
    if (!proper)
        return false;
    word_list files = {0};
    if (!s->real.is_clang) /* clang has no separate program (cc1) that compiles */
        words_add(s->memory, &files, arena_copy(s->memory, proper, strcspn(proper, "\n")));
    if (!identity_add_files(s->memory, &c->kept, &all, &files))
        return false;
    c->compiler = digest_end(&all);
    const char *printed = ask_compiler(s, &c->kept, &c->compiler, ask_folders);
    if (printed)
        add_printed_folders(s->memory, printed, &c->folders);
    return printed != NULL;
}

bool answerers_add_assembler(session *s, digester *d) {
    static const char *const ask[] = {"-print-prog-name=as", NULL};
    const struct cache *c = s->cache;
    if (s->real.is_clang) /* its assembler is built in */
        return true;
    const char *name = ask_compiler(s, &c->kept, &c->compiler, ask);
    return name && identity_add_program(s->memory, &c->kept, d,
                                        arena_copy(s->memory, name, strcspn(name, "\n")));
}

/* ---- the translator -------------------------------------------------------------------------- */

/* Reads the translator's list: identifies its libraries by their contents, and adds its folders. */
static bool know_translator(session *s, struct cache *c, const char *list, size_t length) {
    digester d = digest_begin();
    digest_add(&d, c->program.bytes, sizeof c->program.bytes);
    word_list libraries = {0};
    for (const char *at = list; at < list + length; at += strlen(at) + 1) {
        if (*at == 'l')
            words_add(s->memory, &libraries, arena_string(s->memory, at + 1));
        else if (*at == 'd')
            words_add(s->memory, &c->folders, arena_string(s->memory, at + 1));
    }
    const bool is_known = identity_add_files(s->memory, &c->kept, &d, &libraries);
    c->translator = digest_end(&d);
    return is_known;
}

/* Makes the translator list its libraries and folders, by translating an empty source. The list is
 * cached, so this is done only once. */
static const char *ask_translator(session *s, const struct cache *c, size_t *length) {
    arena *a = s->memory;
    store_part kept;
    if (store_get(a, &c->kept, &c->libraries_key, 1, &kept)) {
        *length = kept.length;
        return kept.bytes;
    }
    const char *list = arena_format(a, "%s/inputs", s->folder);
    const char *empty = arena_format(a, "%s/empty.c", s->folder);
    FILE *file = fopen(empty, "wb");
    if (!file || fclose(file) != 0)
        return NULL;
    word_list words = {0};
    words_add(a, &words, s->tools.translator);
    words_add(a, &words, empty);
    words_add(a, &words, "-o");
    words_add(a, &words, arena_format(a, "%s/empty", s->folder));
    words_add(a, &words, "--in-process");
    words_add(a, &words, arena_format(a, "--inputs-file=%s", list));
    const char *silent = "/dev/null";
    if (process_run(a, &words, (process_streams){NULL, silent, silent}) != 0)
        return NULL;
    const char *text = file_read(a, list, length);
    if (!text || *length == 0 || text[*length - 1] != 0)
        return NULL;
    buffer own = {0};
    for (const char *at = text; at < text + *length; at += strlen(at) + 1)
        if (*at != 'f') /* 'f': a file that was read, here only the empty source */
            buffer_append(&own, at, strlen(at) + 1);
    const char *result = arena_copy(a, own.data ? own.data : "", own.length);
    *length = own.length;
    buffer_free(&own);
    if (*length > 0)
        store_put(a, &c->kept, &c->libraries_key, 1, &(store_part){result, *length});
    return *length > 0 ? result : NULL;
}

static bool find_translator(session *s, struct cache *c) {
    size_t length;
    digester d = digest_begin();
    digest_text(&d, "the translator");
    identity_add_environment(s->memory, &d);
    if (!identity_add_program(s->memory, &c->kept, &d, s->tools.translator))
        return false;
    digester with_loader = d;
    c->program = digest_end(&d);
    if (!add_loader(s, &c->kept, &with_loader))
        return false;
    c->libraries_key = digest_end(&with_loader);
    const char *list = ask_translator(s, c, &length);
    return list && know_translator(s, c, list, length);
}

struct cache *answerers_find(session *s, const store *kept) {
    struct cache *c = ARENA_NEW(s->memory, struct cache);
    c->kept = *kept;
    return s->tools.translator && find_compiler(s, c) && find_translator(s, c) ? c : NULL;
}

/* ---- where headers are searched -------------------------------------------------------------- */

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

/* Adds to the request the headers and folders that one item of the command names. Returns NULL, or
 * the reason why the item cannot be followed. */
static const char *add_of_item(session *s, closure_request *request, const item *one) {
    static const char *const folders[] = {"-I", "-iquote", "-isystem", "-idirafter"};
    static const char *const files[] = {"-include", "-imacros"};
    static const char *const others[] = {"-i",       "-I",     "--sysroot", "-B",
                                         "-F",       "-specs", "--specs",   "-Wp,",
                                         "-fplugin", "-X",     "--include", "--imacros"};
    const option *known = one->kind == INPUT_NOT ? option_find(one->text) : NULL;
    const char *name = known ? known->name : one->text, *value = item_argument(one);
    if (one->kind != INPUT_NOT || begins(one->text, "-Wp,-D") || begins(one->text, "-Wp,-U"))
        return NULL;
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++)
        if (strcmp(name, folders[i]) == 0 && *value && *value != '=' && *value != '-' &&
            !begins(value, "$SYSROOT")) {
            words_add(s->memory, &request->folders, value);
            return NULL;
        }
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (strcmp(name, files[i]) == 0 && *value) {
            words_add(s->memory, &request->included, value);
            return NULL;
        }
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (begins(one->text, others[i]))
            return arena_format(s->memory, "'%s' is not followed", one->text);
    return NULL;
}

static void add_of_variable(arena *a, const char *name, word_list *folders) {
    const char *list = getenv(name);
    while (list && *list) {
        const size_t length = strcspn(list, ":");
        words_add(a, folders, length ? arena_copy(a, list, length) : ".");
        list += length + (list[length] == ':');
    }
}

const char *answerers_add_folders(session *s, closure_request *request) {
    static const char *const usual[] = {"/usr/local/include", "/include", "/usr/include"};
    static const char *const implied[] = {"stdc-predef.h", "redcc/runtime.h"};
    for (unsigned i = 0; i < s->command.count; i++) {
        item_add(s->memory, &request->words, &s->command.items[i]);
        const char *why = add_of_item(s, request, &s->command.items[i]);
        if (why)
            return why;
    }
    words_add_all(s->memory, &request->words, &s->real.words);
    add_of_variable(s->memory, "CPATH", &request->folders);
    add_of_variable(s->memory, "C_INCLUDE_PATH", &request->folders);
    words_add_all(s->memory, &request->folders, &s->cache->folders);
    for (size_t i = 0; i < sizeof usual / sizeof *usual; i++)
        words_add(s->memory, &request->folders, usual[i]);
    if (s->tools.include)
        words_add(s->memory, &request->folders, s->tools.include);
    for (size_t i = 0; i < sizeof implied / sizeof *implied; i++)
        words_add(s->memory, &request->included, implied[i]);
    return NULL;
}
