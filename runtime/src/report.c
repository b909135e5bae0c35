/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* struct statx */
#include "report.h"

#include "base/memory.h"
#include "base/system.h"
#include "settings.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static _Atomic(struct reported *) all;

void redcc_report_add(struct reported *reported) {
    reported->next = atomic_load(&all);
    while (!atomic_compare_exchange_weak(&all, &reported->next, reported))
        ;
}

void redcc_report_remove(struct reported *reported) {
    struct reported *at = atomic_load(&all);
    if (at == reported) {
        atomic_store(&all, reported->next);
        return;
    }
    for (; at; at = at->next)
        if (at->next == reported)
            at->next = reported->next;
}

void redcc_report_overlap(struct statistics *statistics, const char *source, const char *array) {
    char text[REDCC_TEXT];
    snprintf(text, sizeof text, "'%s' overlaps '%s'", source, array);
    for (int i = 0; i < REDCC_TEXTS; i++) {
        struct told_reason *told = &statistics->told[i];
        if (told->count == 0)
            memcpy(told->text, text, sizeof text);
        if (strcmp(told->text, text) == 0) {
            told->count++;
            return;
        }
    }
    atomic_fetch_add(&statistics->fallback[REASON_OVERLAP], 1); /* too many to tell apart */
}

static void write_string(FILE *out, const char *text) {
    putc('"', out);
    for (; *text; text++) {
        const unsigned char letter = (unsigned char)*text;
        if (letter == '"' || letter == '\\')
            fprintf(out, "\\%c", letter);
        else if (letter < 0x20)
            fprintf(out, "\\u%04x", letter);
        else
            putc(letter, out);
    }
    putc('"', out);
}

static void write_fallback(FILE *out, const char **separator, const char *reason, long count) {
    if (count == 0)
        return;
    fprintf(out, "%s{\"reason\": ", *separator);
    write_string(out, reason);
    fprintf(out, ", \"count\": %ld}", count);
    *separator = ", ";
}

static const char *const reason_texts[] = {
#define REDCC_REASON(id, text) text,
    REDCC_REASON_LIST(REDCC_REASON)
#undef REDCC_REASON
};

static void write_fallbacks(FILE *out, const struct statistics *statistics) {
    const char *separator = "";
    for (int reason = REASON_NONE + 1; reason < REASON_COUNT; reason++)
        write_fallback(out, &separator, reason_texts[reason],
                       atomic_load(&statistics->fallback[reason]));
    for (int i = 0; i < REDCC_TEXTS; i++)
        write_fallback(out, &separator, statistics->told[i].text, statistics->told[i].count);
}

enum { LONGEST_METHOD = 64 };

static void spell_method(char name[LONGEST_METHOD], const struct statistics *statistics) {
    const struct method *method = statistics->method ? statistics->method : &redcc_method_serial;
    if (method->parameter && method->parameter[0] == 'N')
        snprintf(name, LONGEST_METHOD, "%s:%d", method->name, statistics->parameter);
    else if (method->parameter && statistics->parameter != method->usual)
        snprintf(name, LONGEST_METHOD, "%s:%c", method->name, statistics->parameter);
    else
        snprintf(name, LONGEST_METHOD, "%s", method->name);
}

static void write_method(FILE *out, const struct statistics *statistics) {
    char name[LONGEST_METHOD];
    spell_method(name, statistics);
    write_string(out, name);
}

static void write_choice(FILE *out, const struct statistics *statistics) {
    static const char *const texts[] = {"named",
#define REDCC_RULE(id, slug, known, done) slug,
                                        REDCC_RULE_LIST(REDCC_RULE)
#undef REDCC_RULE
    };
    fputs(", \"choice\": ", out);
    write_string(out, texts[atomic_load(&statistics->rule)]);
}

static void write_loop(FILE *out, const struct reported *loop) {
    const struct statistics *it = &loop->statistics;
    fputs("{\"file\": ", out);
    write_string(out, loop->file ? loop->file : "");
    fprintf(out, ", \"line\": %d, \"function\": ", loop->line);
    write_string(out, loop->function ? loop->function : "");
    fputs(", \"method\": ", out);
    write_method(out, it);
    write_choice(out, it);
    fprintf(out, ", \"order\": \"%s\", \"threads\": %d, \"calls\": %ld",
            redcc_order_name(it->order), it->threads, atomic_load(&it->calls));
    fprintf(out, ", \"nodes\": %d, \"moves\": %ld", it->nodes, it->moves);
    fprintf(out, ", \"sum\": \"%s\"", it->last.compensated ? "compensated" : "plain");
    if (it->validated.executions > 0)
        fprintf(out, ", \"validated\": %ld, \"promises_broken\": %ld", it->validated.executions,
                it->validated.broken);
    fprintf(out, ", \"plans_built\": %ld, \"plans_reused\": %ld, \"watched\": %ld", it->plans_built,
            it->plans_reused, it->watched);
    fprintf(out, ", \"inspect_seconds\": %ld.%06ld, \"execute_seconds\": %ld.%06ld",
            (long)it->inspect_seconds, (long)(it->inspect_seconds * 1e6) % 1000000,
            (long)it->execute_seconds, (long)(it->execute_seconds * 1e6) % 1000000);
    const redcc_int tenths = /* of a per mille; the decimal point must not depend on the locale */
        it->in_loops ? (redcc_int)(1e4 * (double)it->executed / (double)it->in_loops + 0.5) : 10000;
    fprintf(out, ", \"extra_bytes\": %zu, \"iterations\": %lld, \"stages\": %lld", it->extra_bytes,
            it->executed, it->last.stages);
    fprintf(out, ", \"replication\": %lld.%04lld", tenths / 10000, tenths % 10000);
    const redcc_int modelled = it->last.length ? it->last.trip * 100 / it->last.length : 100;
    fprintf(out, ", \"modelled_speedup\": %lld.%02lld, \"fallbacks\": [", modelled / 100,
            modelled % 100);
    write_fallbacks(out, it);
    fputs("]}", out);
}

static bool tell_validation(const struct reported *loop) {
    const struct validated *it = &loop->statistics.validated;
    if (it->passed_over > 0)
        fprintf(
            stderr,
            "redcc: validated: %s:%d (%s): %ld executions not compared: no copy of the "
            "elements can be made before the loop (pointers in memory lead to them, or the loop "
            "is binned)\n",
            loop->file ? loop->file : "", loop->line, loop->function ? loop->function : "",
            it->passed_over);
    if (it->executions == 0)
        return false;
    fprintf(stderr, "redcc: validated: %s:%d (%s): %ld executions compared, ",
            loop->file ? loop->file : "", loop->line, loop->function ? loop->function : "",
            it->executions);
    if (it->largest > 0)
        fprintf(stderr, "largest difference %.4g ulps, in element %lld of %s", it->largest,
                it->element, it->name);
    else
        fputs("no difference in ulps", stderr);
    if (it->broken > 0)
        fprintf(stderr, "; the promise of order %s is BROKEN in %ld of them\n",
                redcc_order_name(loop->statistics.order), it->broken);
    else if (loop->statistics.last.compensated)
        fputs("; the sums are compensated, those of the sequential loop are not\n", stderr);
    else
        fprintf(stderr, "; order %s is kept\n", redcc_order_name(loop->statistics.order));
    return it->broken > 0;
}

bool redcc_report_validation(void) {
    bool broken = false;
    for (const struct reported *loop = atomic_load(&all); loop; loop = loop->next)
        broken = tell_validation(loop) || broken;
    return broken;
}

/* What binds the threads, as the environment says it: to bind them is OpenMP's. */
static void write_variable(FILE *out, const char *key, const char *variable) {
    const char *value = redcc_environment(variable);
    fprintf(out, "\"%s\": ", key);
    if (value)
        write_string(out, value);
    else
        fputs("null", out);
    fputs(", ", out);
}

static bool write_all(FILE *out) {
    putc('{', out);
    write_variable(out, "proc_bind", "OMP_PROC_BIND");
    write_variable(out, "places", "OMP_PLACES");
    fputs("\"loops\": [", out);
    const char *separator = "\n ";
    for (const struct reported *loop = atomic_load(&all); loop; loop = loop->next) {
        fputs(separator, out);
        write_loop(out, loop);
        separator = ",\n ";
    }
    fputs("]}\n", out);
    const bool written = !ferror(out);
    return fclose(out) == 0 && written;
}

/* For people: a line a loop, and why it ran sequentially where it did. */
static void write_table(FILE *out) {
    char method[LONGEST_METHOD];
    fputs("redcc: calls threads plans-built plans-reused inspecting executing method  loop\n", out);
    for (const struct reported *loop = atomic_load(&all); loop; loop = loop->next) {
        const struct statistics *it = &loop->statistics;
        spell_method(method, it);
        fprintf(out, "redcc: %5ld %7d %11ld %12ld %9.4fs %8.4fs %s  %s:%d (%s)\n",
                atomic_load(&it->calls), it->threads, it->plans_built, it->plans_reused,
                it->inspect_seconds, it->execute_seconds, method, loop->file ? loop->file : "",
                loop->line, loop->function ? loop->function : "");
        for (int reason = REASON_NONE + 1; reason < REASON_COUNT; reason++)
            if (atomic_load(&it->fallback[reason]) > 0)
                fprintf(out, "redcc:       sequential %ld times: %s\n",
                        atomic_load(&it->fallback[reason]), reason_texts[reason]);
        for (int i = 0; i < REDCC_TEXTS; i++)
            if (it->told[i].count > 0)
                fprintf(out, "redcc:       sequential %ld times: %s\n", it->told[i].count,
                        it->told[i].text);
    }
}

/* With the process's id for %p: of several processes each has a report of its own. NULL: no
 * memory. */
static char *spell_name(const char *name) {
    const size_t room = 24 * strlen(name) + 1; /* %p is two letters, an id fewer than 40 */
    char *spelled = redcc_memory_take(room);
    size_t length = 0;
    for (; spelled && *name; name++) {
        if (name[0] == '%' && name[1] == 'p') {
            length +=
                (size_t)snprintf(spelled + length, room - length, "%ld", redcc_system_process());
            name++;
        } else
            spelled[length++] = *name;
    }
    if (spelled)
        spelled[length] = '\0';
    return spelled;
}

/* What is no plain file (a pipe, a device, a link to a file) is written to, and never replaced. */
static bool is_replaceable(const char *name) {
#if defined(__linux__)
    struct statx found;
    return redcc_system(SYS_statx, AT_FDCWD, name, AT_SYMLINK_NOFOLLOW, STATX_TYPE, &found) != 0 ||
           (found.stx_mode & S_IFMT) == S_IFREG;
#else
    (void)name;
    return false;
#endif
}

static bool write_through(const char *name) {
    FILE *out = fopen(name, "w");
    return out && write_all(out);
}

/* Beside the file, then renamed: nobody reads half a report. */
static bool replace(const char *name) {
    const size_t room = strlen(name) + 32;
    char *beside = redcc_memory_take(room);
    if (!beside)
        return write_through(name);
    snprintf(beside, room, "%s.%ld", name, redcc_system_process());
    FILE *out = fopen(beside, "w");
    const bool written = out && write_all(out) && rename(beside, name) == 0;
    if (out && !written)
        remove(beside);
    redcc_memory_give(beside);
    return written;
}

void redcc_report_write(void) {
    redcc_memory_limit(
        0); /* it was for the loops, which are over; the report is owed all the same */
    char *name = redcc_settings()->report ? spell_name(redcc_settings()->report) : NULL;
    if (!name)
        return;
    if (strcmp(name, "-") == 0)
        write_table(stderr);
    else if (!(is_replaceable(name) ? replace(name) : write_through(name)))
        fprintf(stderr, "redcc: cannot write the report %s\n", name);
    redcc_memory_give(name);
}

/* ---- the end of the program ---------------------------------------------------------------- */

static void end_program(void) {
    if (!redcc_report_validation())
        return;
    fflush(NULL);
    _exit(REDCC_BROKEN); /* exit must not be called here: it is what called this */
}

/* What is registered first runs last: the program's own handlers, and all reports, come before. */
__attribute__((constructor)) static void register_end(void) {
    const char *value = redcc_environment("REDCC_VALIDATE");
    if (value && strcmp(value, "1") == 0)
        atexit(end_program);
}
