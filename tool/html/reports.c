/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "html/reports.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/buffer.h"

const char *json_word(const json_t *object, const char *name) {
    const char *text = json_string_value(json_object_get(object, name));
    return text ? text : "";
}

bool loop_is_parallel(const report_loop *loop) {
    return loop->verdict && strcmp(json_word(loop->verdict, "verdict"), "transformed") == 0;
}

static double number_of(const json_t *object, const char *name) {
    return json_number_value(json_object_get(object, name));
}

/* ---- the build ------------------------------------------------------------------------------- */

static report_file *file_of(reports *r, const char *name, const char *folder) {
    const char *path =
        *name == '/' || !*folder ? name : arena_format(r->memory, "%s/%s", folder, name);
    for (unsigned i = 0; i < r->files.count; i++)
        if (strcmp(r->files.items[i]->path, path) == 0)
            return r->files.items[i];
    report_file *file = ARENA_NEW(r->memory, report_file);
    file->name = name;
    file->path = path;
    VECTOR_PUSH(r->memory, &r->files, file);
    return file;
}

static void add_loop(reports *r, report_file *file, const json_t *object) {
    for (unsigned i = 0; i < file->loops.count; i++)
        if (json_equal(file->loops.items[i]->verdict, object)) {
            file->loops.items[i]->compilations++;
            return;
        }
    report_loop *loop = ARENA_NEW(r->memory, report_loop);
    loop->file = file;
    loop->name = file->name;
    loop->verdict = object;
    loop->function = json_word(object, "function");
    loop->line = json_integer_value(json_object_get(object, "line"));
    loop->compilations = 1;
    file->parallel += loop_is_parallel(loop);
    file->refused += strcmp(json_word(object, "verdict"), "refused") == 0;
    VECTOR_PUSH(r->memory, &file->loops, loop);
    VECTOR_PUSH(r->memory, &r->loops, loop);
}

/* Returns false if the object is not part of a build's report. */
static bool add_build(reports *r, const json_t *object) {
    const json_t *loops = json_object_get(object, "loops"), *loop;
    const char *name = json_word(object, "file"), *folder = json_word(object, "directory");
    size_t i;
    if (!json_is_array(loops) || !*name)
        return false;
    report_file *file = file_of(r, name, folder);
    if (json_is_string(json_object_get(object, "left_alone")))
        file->left_alone = json_word(object, "left_alone");
    json_array_foreach(loops, i, loop) {
        if (!json_is_object(loop) || !json_is_integer(json_object_get(loop, "line")))
            return false;
        const char *other = json_word(loop, "file"); /* a header */
        add_loop(r, *other ? file_of(r, other, folder) : file, loop);
    }
    return true;
}

/* ---- runs ------------------------------------------------------------------------------------ */

/* Does the run's report on the loop say that there was only one thread? */
static bool had_one_thread(const json_t *loop) {
    size_t i;
    const json_t *fallback;
    json_array_foreach(json_object_get(loop, "fallbacks"), i, fallback) {
        if (strcmp(json_word(fallback, "slug"), "one-thread") == 0)
            return true;
    }
    return false;
}

/* The number of threads of the run: the greatest that a loop reports. A loop whose last execution
 * was sequential reports one thread; then its expected speed-up, rounded up, is a lower bound.
 * Without either, two are assumed, unless a loop reports that there was only one thread. */
static json_int_t most_threads(const json_t *loops) {
    json_int_t most = 1;
    bool one = false;
    size_t i;
    const json_t *loop;
    json_array_foreach(loops, i, loop) {
        const json_int_t threads = json_integer_value(json_object_get(loop, "threads"));
        const double promised = number_of(loop, "modelled_speedup");
        one |= had_one_thread(loop);
        most = threads > most ? threads : most;
        while ((double)most < promised)
            most++;
    }
    return most == 1 && !one ? 2 : most;
}

/* Returns the time of a loop beyond its sequential time divided by the number of threads. If no
 * gain was measured, only the time of inspections counts for the parallel calls. */
static double seconds_lost(const json_t *run, json_int_t threads) {
    assert(threads >= 1);
    const double sequential = number_of(run, "sequential_seconds");
    const double inspecting = number_of(run, "inspect_seconds");
    const double parallel = inspecting + number_of(run, "execute_seconds");
    const double gain = number_of(run, "speedup");
    const double share = 1.0 / (double)threads;
    const double over = gain > 0 ? parallel * (1 - gain * share) : inspecting;
    return sequential * (1 - share) + (over > 0 ? over : 0);
}

static void add_time(report_loop *loop, const json_t *run, double process, json_int_t threads) {
    loop_time *time = &loop->time;
    time->runs++;
    time->last = run;
    time->process += process;
    time->seconds += number_of(run, "inspect_seconds") + number_of(run, "execute_seconds") +
                     number_of(run, "sequential_seconds");
    time->lost += seconds_lost(run, threads);
    time->calls += json_integer_value(json_object_get(run, "calls"));
    time->built += json_integer_value(json_object_get(run, "plans_built"));
    time->reused += json_integer_value(json_object_get(run, "plans_reused"));
    time->plans_lost += json_integer_value(json_object_get(run, "plans_lost"));
}

static bool is_same_loop(const report_loop *loop, const json_t *run) {
    return loop->line == json_integer_value(json_object_get(run, "line")) &&
           strcmp(loop->function, json_word(run, "function")) == 0 &&
           strcmp(loop->name, json_word(run, "file")) == 0;
}

static report_loop *stranger(reports *r, const json_t *run) {
    report_loop *loop = ARENA_NEW(r->memory, report_loop);
    loop->name = json_word(run, "file");
    loop->function = json_word(run, "function");
    loop->line = json_integer_value(json_object_get(run, "line"));
    VECTOR_PUSH(r->memory, &r->loops, loop);
    return loop;
}

/* Adds the times of a run. The run's report names no folder. If two files of the build have the
 * same name, loops at the same position in them cannot be distinguished, so each of these loops
 * gets the times. */
static bool add_run(reports *r, const json_t *object) {
    const json_t *loops = json_object_get(object, "loops"), *run;
    const double process = number_of(object, "seconds");
    size_t i;
    if (!json_is_array(loops))
        return false;
    const json_int_t threads = most_threads(loops);
    r->runs++;
    json_array_foreach(loops, i, run) {
        bool is_known = false;
        for (unsigned k = 0; k < r->loops.count; k++)
            if (is_same_loop(r->loops.items[k], run) &&
                (loop_is_parallel(r->loops.items[k]) || !r->loops.items[k]->file)) {
                add_time(r->loops.items[k], run, process, threads);
                is_known = true;
            }
        if (!is_known)
            add_time(stranger(r, run), run, process, threads);
    }
    return true;
}

/* ---- files ----------------------------------------------------------------------------------- */

/* The objects that a pass over the files reads: those of builds (BUILDS), or those of runs (RUNS),
 * which name a process. */
typedef enum pass { BUILDS, RUNS } pass;

static const char *add_objects(reports *r, const char *path, const char *text, pass wanted) {
    static const char expected[] =
        "%s:%d: error: expected a JSON object of a build (REDCC_BUILD_REPORT) or of a run "
        "(REDCC_REPORT=FILE): %s";
    int line = 1;
    for (const char *at = text;;) {
        for (; *at == '\n' || *at == ' ' || *at == '\r' || *at == '\t'; at++)
            line += *at == '\n';
        if (!*at)
            return NULL;
        json_error_t wrong;
        json_t *object = json_loads(at, JSON_DISABLE_EOF_CHECK, &wrong);
        if (!object)
            return arena_format(r->memory, expected, path, line + wrong.line - 1, wrong.text);
        VECTOR_PUSH(r->memory, &r->owned, object);
        const bool is_run = json_object_get(object, "process") != NULL;
        if (is_run == (wanted == RUNS) && !(is_run ? add_run : add_build)(r, object))
            return arena_format(r->memory, expected, path, line,
                                "it has no \"loops\" and \"file\"");
        for (const char *end = at + wrong.position; at < end; at++)
            line += *at == '\n';
    }
}

static char *read_text(arena *a, const char *path) {
    FILE *file = fopen(path, "rb");
    buffer text = {0};
    char part[65536];
    size_t count;
    if (!file)
        return NULL;
    while ((count = fread(part, 1, sizeof part, file)) > 0)
        buffer_append(&text, part, count);
    char *copy = ferror(file) ? NULL : arena_string(a, text.data ? text.data : "");
    buffer_free(&text);
    fclose(file);
    return copy;
}

static int by_place(const report_loop *l, const report_loop *r) {
    const int names = strcmp(l->name, r->name);
    if (names != 0)
        return names;
    if (l->line != r->line)
        return l->line < r->line ? -1 : 1;
    const int functions = strcmp(l->function, r->function);
    if (functions != 0 || !l->verdict || !r->verdict)
        return functions;
    const json_int_t columns = json_integer_value(json_object_get(l->verdict, "column")) -
                               json_integer_value(json_object_get(r->verdict, "column"));
    if (columns != 0)
        return columns < 0 ? -1 : 1;
    return strcmp(json_word(json_object_get(l->verdict, "reason"), "slug"),
                  json_word(json_object_get(r->verdict, "reason"), "slug"));
}

static int worst_first(const void *left, const void *right) {
    const report_loop *l = *(report_loop *const *)left, *r = *(report_loop *const *)right;
    if (l->time.lost != r->time.lost)
        return l->time.lost > r->time.lost ? -1 : 1;
    if (l->time.seconds != r->time.seconds)
        return l->time.seconds > r->time.seconds ? -1 : 1;
    return by_place(l, r);
}

static int in_order(const void *left, const void *right) {
    return by_place(*(report_loop *const *)left, *(report_loop *const *)right);
}

static int by_name(const void *left, const void *right) {
    const report_file *l = *(report_file *const *)left, *r = *(report_file *const *)right;
    const int names = strcmp(l->name, r->name);
    return names != 0 ? names : strcmp(l->path, r->path);
}

static void sort(reports *r) {
    for (unsigned i = 0; i < r->files.count; i++) {
        report_file *file = r->files.items[i];
        if (file->loops.count > 0)
            qsort(file->loops.items, file->loops.count, sizeof *file->loops.items, in_order);
    }
    if (r->files.count > 0)
        qsort(r->files.items, r->files.count, sizeof *r->files.items, by_name);
    if (r->loops.count > 0)
        qsort(r->loops.items, r->loops.count, sizeof *r->loops.items, worst_first);
}

const char *reports_read(reports *r, unsigned count, char *const *paths) {
    for (int wanted = BUILDS; wanted <= RUNS; wanted++)
        for (unsigned i = 0; i < count; i++) {
            const char *text = read_text(r->memory, paths[i]);
            if (!text)
                return arena_format(r->memory, "error: cannot read '%s': %s", paths[i],
                                    strerror(errno));
            const char *why = add_objects(r, paths[i], text, (pass)wanted);
            if (why)
                return why;
        }
    if (r->files.count == 0)
        return "error: none of the files is a build's report (REDCC_BUILD_REPORT)";
    sort(r);
    return NULL;
}

void reports_free(reports *r) {
    for (unsigned i = 0; i < r->owned.count; i++)
        json_decref(r->owned.items[i]);
}
