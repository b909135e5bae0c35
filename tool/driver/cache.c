/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "driver/cache.h"

#include <assert.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "driver/answerers.h"
#include "driver/closure.h"
#include "driver/files.h"
#include "driver/program_identity.h"
#include "driver/project_text.h"

enum { OUTPUTS = sizeof((cached_run *)NULL)->outputs / sizeof(char *), PARTS = OUTPUTS + 1 };

typedef struct kept_answer {
    digest key;
    unsigned count;
    store_part parts[PARTS];
} kept_answer;

struct cached {
    closure_request request;
    closure found;
    digest project;       /* digest of what is read about functions of other files */
    const char *stranger; /* a file that was read but is not in the closure, or NULL */
    digest asked;         /* key of the last run for which cached_restore was called */
    VECTOR(kept_answer) fresh;
};

struct cache *cache_open(session *s) {
    const char *wrong = NULL;
    const store kept = store_open(s->memory, &wrong);
    if (wrong)
        session_warn(s, "%s", wrong);
    if (!kept.folder || s->show || !answerers_options_are_plain(&s->options))
        return NULL;
    return answerers_find(s, &kept);
}

/* ---- a source -------------------------------------------------------------------------------- */

/* Reads the project's files. They are stored once for all of the project's sources. `key`: the key
 * of all files in the store, or NULL if a file has just changed; then nothing is stored. */
static const project *project_of(session *s, const char *file, const word_list *list,
                                 const digest *key) {
    arena *a = s->memory;
    store_part part;
    if (key && store_get(a, answerers_store(s), key, 1, &part)) {
        const project_scan known = project_read(a, &part);
        return project_from(a, file, &known);
    }
    const project_scan files = project_scan_files(a, list);
    part = project_write(a, &files);
    if (key)
        store_put(a, answerers_store(s), key, 1, &part);
    return project_from(a, file, &files);
}

/* Returns the project's digest for the source (project_digest). The digest is cached for each
 * source, because reading the functions of hundreds of files would take longer than all other
 * work. */
static digest digest_around(session *s, const char *file) {
    arena *a = s->memory;
    const word_list list = project_list(a, file);
    const digest *translator = answerers_identity(s, CACHE_TRANSLATOR);
    digester d = digest_begin();
    digest_text(&d, "functions of a project's files");
    digest_add(&d, translator->bytes, sizeof translator->bytes);
    const bool is_settled = identity_add_times(&d, &list);
    digester of_source = d;
    const digest all = digest_end(&d);
    char real[PATH_MAX];
    digest_text(&of_source, realpath(file, real) ? real : file);
    const digest key = digest_end(&of_source);
    store_part part;
    digest found;
    if (is_settled && store_get(a, answerers_store(s), &key, 1, &part) &&
        part.length == sizeof found) {
        memcpy(&found, part.bytes, sizeof found);
        return found;
    }
    found = project_digest(project_of(s, file, &list, is_settled ? &all : NULL));
    if (is_settled)
        store_put(a, answerers_store(s), &key, 1,
                  &(store_part){(const char *)found.bytes, sizeof found});
    return found;
}

cached *cached_begin(session *s, const item *source, const char *file) {
    const bool is_input = strcmp(source->text, "-") == 0;
    if (!s->cache)
        return NULL;
    cached *c = ARENA_NEW(s->memory, cached);
    c->request = (closure_request){.file = file, .name = is_input ? "stdin" : source->text};
    const char *why = answerers_add_folders(s, &c->request);
    if (!why) {
        c->found = closure_find(s->memory, answerers_store(s), &c->request);
        why = c->found.unknown;
        c->project = digest_around(s, file);
    }
    if (why)
        session_explain(s, "%s: not cached: %s", source->text, why);
    return why ? NULL : c;
}

/* ---- keys ------------------------------------------------------------------------------------ */

static bool is_output(const cached_run *run, const char *path) {
    for (unsigned i = 0; i < OUTPUTS; i++)
        if (run->outputs[i] && strcmp(run->outputs[i], path) == 0)
            return true;
    return false;
}

/* Adds a word without the name of the temporary folder, which differs in each call. If the word
 * names a file in that folder that is not an output, adds the file's contents. */
static void add_word(session *s, digester *d, const cached_run *run, const char *word) {
    const char *at = s->folder ? strstr(word, s->folder) : NULL;
    if (!at) {
        digest_text(d, word);
        return;
    }
    const char *rest = at + strlen(s->folder);
    digest_text(d, arena_format(s->memory, "%.*s\1%s", (int)(at - word), word, rest));
    if (!run || !is_output(run, at))
        digest_text(d, file_read(s->memory, at, NULL));
}

static digest key_of(session *s, const cached *c, cache_program program, const char *about,
                     const word_list *words, const cached_run *run) {
    digester d = digest_begin();
    digest_text(&d, REDCC_VERSION);
    digest_text(&d, about);
    const digest *of_program = answerers_identity(s, program);
    digest_add(&d, of_program->bytes, sizeof of_program->bytes);
    digest_add(&d, c->found.state.bytes, sizeof c->found.state.bytes);
    if (program == CACHE_TRANSLATOR)
        digest_add(&d, c->project.bytes, sizeof c->project.bytes);
    if (run && run->beside)
        digest_add(&d, run->beside->bytes, sizeof run->beside->bytes);
    for (unsigned i = 0; i < words->count; i++)
        add_word(s, &d, run, words->items[i]);
    return digest_end(&d);
}

/* ---- outputs: 'a' absent, 's' the source's bytes, 'b' and bytes ------------------------------ */

static store_part part_of_file(session *s, const cached *c, const char *path) {
    size_t length, source_length;
    const char *bytes = path ? file_read(s->memory, path, &length) : NULL;
    if (!bytes)
        return (store_part){"a", 1};
    const char *source = file_read(s->memory, c->request.file, &source_length);
    if (source && source_length == length && memcmp(source, bytes, length) == 0)
        return (store_part){"s", 1};
    char *part = arena_allocate(s->memory, length + 1);
    part[0] = 'b';
    memcpy(part + 1, bytes, length);
    return (store_part){part, length + 1};
}

/* Writes a new file in place of an old one, as compilers do. Hard links to the old file keep its
 * bytes. */
static bool write_file(const char *path, const char *bytes, size_t length) {
    unlink(path);
    FILE *file = fopen(path, "wb");
    if (!file)
        return false;
    const bool good = fwrite(bytes, 1, length, file) == length;
    return fclose(file) == 0 && good;
}

static bool write_part(session *s, const cached *c, const store_part *part, const char *path) {
    size_t length;
    if (!path || part->length == 0 || part->bytes[0] == 'a')
        return part->length > 0;
    if (part->bytes[0] == 'b')
        return write_file(path, part->bytes + 1, part->length - 1);
    const char *source = file_read(s->memory, c->request.file, &length);
    return source && write_file(path, source, length);
}

static bool write_outputs(session *s, const cached *c, const cached_run *run,
                          const store_part *parts) {
    bool good = true;
    for (unsigned i = 0; i < OUTPUTS; i++)
        good = good && write_part(s, c, &parts[i + 1], run->outputs[i]);
    for (unsigned i = 0; !good && i < OUTPUTS; i++)
        if (run->outputs[i])
            unlink(run->outputs[i]);
    return good;
}

/* ---- runs ------------------------------------------------------------------------------------ */

static void keep(session *s, cached *c, const kept_answer *answer) {
    VECTOR_PUSH(s->memory, &c->fresh, *answer);
}

/* Does the answer name this call's folder? Then it is invalid in the next call. The search looks
 * only for the last part of the name, because the rest may be written with backslashes. */
static bool names_folder(const session *s, const store_part *part) {
    const char *own = path_base(s->folder);
    return memmem(part->bytes, part->length, own, strlen(own)) != NULL;
}

/* Does the run's answer depend only on its inputs? If a translator fails, the cause may be
 * temporary (a full disk), unless the translator cannot parse the source. */
static bool is_lasting(session *s, const cached_run *run, int status) {
    if (status != 1 || run->program != CACHE_TRANSLATOR)
        return status == 0;
    const char *said = run->streams.error ? file_read(s->memory, run->streams.error, NULL) : NULL;
    return said && strstr(said, ": cannot be parsed; nothing was written\n");
}

static void check_file(cached *c, const char *path) {
    if (!c->stranger && !closure_has(&c->found, path))
        c->stranger = path;
}

/* Checks that the closure contains each file in the translator's list of inputs. */
static void check_list(session *s, cached *c, const char *list) {
    size_t length;
    const char *text = file_read(s->memory, list, &length);
    if (!text) {
        c->stranger = "what the translator has read";
        return;
    }
    for (const char *at = text; at < text + length; at += strlen(at) + 1)
        if (*at == 'f' && strcmp(at + 1, "<stdin>") != 0)
            check_file(c, at + 1);
}

bool cached_restore(session *s, cached *c, const cached_run *run, int *status) {
    store_part parts[PARTS];
    c->asked = key_of(s, c, run->program, "a run", run->words, run);
    if (!store_get(s->memory, answerers_store(s), &c->asked, PARTS, parts) ||
        parts[0].length != 1 || !write_outputs(s, c, run, parts))
        return false;
    *status = parts[0].bytes[0] - '0';
    return true;
}

void cached_keep(session *s, cached *c, const cached_run *run, int status) {
    if (!is_lasting(s, run, status))
        return;
    assert(status == 0 || status == 1);
    kept_answer answer = {.key = c->asked, .count = PARTS};
    answer.parts[0] = (store_part){arena_format(s->memory, "%d", status), 1};
    for (unsigned i = 0; i < OUTPUTS; i++) {
        answer.parts[i + 1] = part_of_file(s, c, run->outputs[i]);
        const bool is_missing = run->outputs[i] && answer.parts[i + 1].bytes[0] == 'a';
        if (names_folder(s, &answer.parts[i + 1]) || (is_missing && run->program == CACHE_COMPILER))
            return;
    }
    keep(s, c, &answer);
}

int cached_run_program(session *s, cached *c, const cached_run *run) {
    assert(run->words->count > 0);
    int status;
    if (!c)
        return session_run(s, run->words, run->streams);
    if (run->read)
        unlink(run->read);
    if (cached_restore(s, c, run, &status)) {
        if (run->program == CACHE_TRANSLATOR)
            session_explain(s, "%s: translated before, from the cache", c->request.name);
        return status;
    }
    status = session_run(s, run->words, run->streams);
    if (run->read)
        check_list(s, c, run->read);
    cached_keep(s, c, run, status);
    return status;
}

const char *cached_text(session *s, cached *c, const char *about, const word_list *words) {
    store_part part;
    if (!c)
        return NULL;
    const digest key = key_of(s, c, CACHE_COMPILER, about, words, NULL);
    return store_get(s->memory, answerers_store(s), &key, 1, &part)
               ? arena_copy(s->memory, part.bytes, part.length)
               : NULL;
}

void cached_keep_text(session *s, cached *c, const char *about, const word_list *words,
                      const char *text) {
    if (!c)
        return;
    kept_answer answer = {.key = key_of(s, c, CACHE_COMPILER, about, words, NULL), .count = 1};
    answer.parts[0] = (store_part){text, strlen(text)};
    if (!names_folder(s, &answer.parts[0]))
        keep(s, c, &answer);
}

/* ---- files read, and the end ----------------------------------------------------------------- */

void cached_compiler_read(cached *c, const word_list *files) {
    for (unsigned i = 0; c && i < files->count; i++)
        if (strcmp(files->items[i], "-") != 0)
            check_file(c, files->items[i]);
}

void cached_end(session *s, cached *c) {
    if (!c || c->fresh.count == 0 || process_signal())
        return;
    if (c->stranger) {
        session_explain(s, "%s: not cached: %s was read, which no search for headers finds",
                        c->request.name, c->stranger);
        return;
    }
    const closure now = closure_find(s->memory, answerers_store(s), &c->request);
    if (now.unknown || memcmp(&now.state, &c->found.state, sizeof now.state) != 0)
        return;
    for (unsigned i = 0; i < c->fresh.count; i++)
        store_put(s->memory, answerers_store(s), &c->fresh.items[i].key, c->fresh.items[i].count,
                  c->fresh.items[i].parts);
    c->fresh.count = 0;
}
