/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* mkstemp, setenv */
#include "redcc/build_counts.h"

#include <jansson.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "driver/files.h"
#include "driver/installation.h"
#include "driver/process.h"
#include "redcc/compile_commands.h"
#include "redcc/workers.h"

enum { IN_HEADERS_KEPT = 128 };

/* A loop of a header. Every command whose source includes the header reports it. */
typedef struct loop_in_header {
    uint64_t place; /* a hash of its file, line and column */
    reason_id why;  /* REASON_NONE: it is transformed */
} loop_in_header;

/* The result of one command. If several files were compiled unchanged, `why` is the reason for the
 * last one. */
typedef struct command_outcome {
    unsigned files, left, transformed, refused[REASON_COUNT];
    char why[256];
    unsigned in_header_count;
    loop_in_header in_headers[IN_HEADERS_KEPT]; /* further ones are counted once for each command */
} command_outcome;

typedef struct counting {
    arena *memory;
    const options *options;
    const char *wrapper;
    compile_command_list commands;
    build_counts *counts;
    map *in_headers; /* loops of headers that were counted, by their place */
} counting;

/* The path of redcc-cc in an installed tree or a build tree, or NULL if it is missing. */
static const char *find_wrapper(arena *a) {
    const installation found = installation_find(a);
    if (!found.self)
        return NULL;
    const char *folder = path_folder(a, found.self);
    const char *installed = arena_format(a, "%s/redcc-cc", folder);
    const char *built = arena_format(a, "%s/driver/redcc-cc", folder);
    return access(installed, X_OK) == 0 ? installed : access(built, X_OK) == 0 ? built : NULL;
}

/* ---- a command ------------------------------------------------------------------------------ */

/* Passes the options of this redcc to redcc-cc, by its environment variable. */
static void set_options(arena *a, const options *o) {
    static const char *const lanes[] = {
        [LANES_OF_NONE] = " --lanes=off", [LANES_OF_HEAVY] = "", [LANES_OF_ALL] = " --lanes=4"};
    buffer text = {0};
    for (unsigned i = 0; i < o->pure.count; i++)
        buffer_format(&text, " --pure=%s", o->pure.items[i]);
    if (o->assume_noalias)
        buffer_text(&text, " --assume-noalias");
    if (o->order.is_given)
        buffer_format(&text, " --order=%s", options_order_word(o->order.word));
    buffer_text(&text, lanes[o->lanes]);
    buffer_text(&text, o->keeps_openmp ? " --openmp=keep" : "");
    if (text.data && text.length > 0)
        setenv("REDCC_OPTS", arena_string(a, text.data), 1);
    buffer_free(&text);
}

static word_list words_for(const counting *c, const compile_command *command) {
    arena *a = c->memory;
    word_list words = {0};
    words_add(a, &words, c->wrapper);
    for (unsigned i = 0; i < command->words.count; i++) /* if the command names a redcc-cc, this one
                                                         * is called */
        if (i > 0 || strcmp(path_base(command->words.items[0]), "redcc-cc") != 0)
            words_add(a, &words, command->words.items[i]);
    for (unsigned i = 0; i < c->options->flags.count; i++)
        words_add(a, &words, c->options->flags.items[i]);
    words_add(a, &words, "--redcc-report");
    return words;
}

static reason_id reason_of_slug(const char *slug) {
    for (unsigned r = REASON_NONE + 1; slug && r < REASON_COUNT; r++)
        if (strcmp(slug, reason_slug((reason_id)r)) == 0)
            return (reason_id)r;
    return REASON_NONE;
}

/* FNV-1a. */
static uint64_t hash(uint64_t before, const void *bytes, size_t count) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < count; i++)
        before = (before ^ at[i]) * 0x100000001b3;
    return before;
}

/* A hash of the loop's file, line and column. The current folder is the command's. */
static uint64_t place_of(const char *file, const json_t *loop) {
    const json_int_t at[2] = {json_integer_value(json_object_get(loop, "line")),
                              json_integer_value(json_object_get(loop, "column"))};
    char *resolved = realpath(file, NULL);
    const char *path = resolved ? resolved : file;
    const uint64_t place = hash(hash(0xcbf29ce484222325, path, strlen(path)), at, sizeof at);
    free(resolved);
    return place;
}

static void count_loop(const json_t *loop, reason_id why, command_outcome *outcome) {
    const char *file = json_string_value(json_object_get(loop, "file"));
    if (!file || outcome->in_header_count == IN_HEADERS_KEPT)
        ++*(why == REASON_NONE ? &outcome->transformed : &outcome->refused[why]);
    else
        outcome->in_headers[outcome->in_header_count++] =
            (loop_in_header){place_of(file, loop), why};
}

static void count_loops(const json_t *loops, command_outcome *outcome) {
    size_t i;
    const json_t *loop;
    json_array_foreach(loops, i, loop) {
        const char *verdict = json_string_value(json_object_get(loop, "verdict"));
        const reason_id why = reason_of_slug(
            json_string_value(json_object_get(json_object_get(loop, "reason"), "slug")));
        if (why != REASON_NONE || (verdict && strcmp(verdict, "transformed") == 0))
            count_loop(loop, why, outcome);
    }
}

static void read_report(FILE *report, command_outcome *outcome) {
    json_t *file;
    while ((file = json_loadf(report, JSON_DISABLE_EOF_CHECK, NULL))) {
        const char *why = json_string_value(json_object_get(file, "left_alone"));
        outcome->files++;
        outcome->left += why != NULL;
        if (why)
            snprintf(outcome->why, sizeof outcome->why, "%s", why);
        count_loops(json_object_get(file, "loops"), outcome);
        json_decref(file);
    }
}

static void report_command(unsigned number, void *result, void *context) {
    const counting *c = context;
    const compile_command *command = &c->commands.items[number];
    const char *temporary = getenv("TMPDIR");
    char *path = arena_format(c->memory, "%s/redcc-counts-XXXXXX",
                              temporary && *temporary ? temporary : "/tmp");
    const word_list words = words_for(c, command);
    const int file = mkstemp(path);
    if (file < 0)
        return;
    setenv("REDCC_BUILD_REPORT", path, 1);
    unsetenv("REDCC_STRICT"); /* with it, the first file that is compiled unchanged would end the
                               * command */
    unsetenv("REDCC_DISABLE");
    unsetenv("REDCC_KEEP");
    set_options(c->memory, c->options);
    if (chdir(command->directory) == 0)
        process_run(c->memory, &words, (process_streams){"/dev/null", "/dev/null", "/dev/null"});
    FILE *report = fdopen(file, "r");
    if (report)
        read_report(report, result);
    unlink(path);
}

/* ---- all of them ---------------------------------------------------------------------------- */

static void add_left(counting *c, const command_outcome *outcome) {
    /* the message of an error in a source differs from file to file, so these errors are counted
     * together */
    const char *why =
        strncmp(outcome->why, "redcc: ", 7) == 0 ? "redcc cannot read it" : outcome->why;
    build_counts *counts = c->counts;
    for (unsigned i = 0; i < counts->left.count; i++)
        if (strcmp(counts->left.items[i].why, why) == 0) {
            counts->left.items[i].files += outcome->left;
            return;
        }
    VECTOR_PUSH(c->memory, &counts->left,
                ((left_alone){arena_string(c->memory, why), outcome->left}));
}

/* Counts the loops of headers, each once for the whole build. */
static void add_in_headers(counting *c, const command_outcome *outcome) {
    for (unsigned i = 0; i < outcome->in_header_count; i++) {
        const loop_in_header *loop = &outcome->in_headers[i];
        void **known = map_at(c->in_headers, &loop->place, sizeof loop->place);
        if (*known == NULL)
            ++*(loop->why == REASON_NONE ? &c->counts->transformed
                                         : &c->counts->refused[loop->why]);
        *known = c;
    }
}

static void count_command(unsigned number, const void *result, int ended_by, void *context) {
    counting *c = context;
    const command_outcome *outcome = result;
    if (ended_by != 0) {
        workers_explain(c->commands.items[number].file, ended_by);
        return;
    }
    c->counts->files += outcome->files;
    c->counts->transformed += outcome->transformed;
    for (unsigned i = 0; i < REASON_COUNT; i++)
        c->counts->refused[i] += outcome->refused[i];
    add_in_headers(c, outcome);
    if (outcome->left > 0)
        add_left(c, outcome);
}

bool build_counts_take(arena *a, const options *o, build_counts *counts) {
    counting c = {.memory = a,
                  .options = o,
                  .wrapper = find_wrapper(a),
                  .counts = counts,
                  .in_headers = map_new(a)};
    if (!c.wrapper || compile_commands_of_c(a, o->database_folder, &c.commands))
        return false;
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    const workers how = {.count = c.commands.count,
                         .at_once = processors > 0 ? (unsigned)processors : 1,
                         .result_size = sizeof(command_outcome),
                         .keeps_output = true,
                         .work = report_command,
                         .done = count_command,
                         .context = &c};
    return workers_run(&how);
}
