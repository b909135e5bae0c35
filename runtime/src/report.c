/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for struct statx */
#include "report.h"

#include "base/memory.h"
#include "base/system.h"
#include "settings.h"
#include "variables.h"

#include <assert.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static _Atomic(struct reported *) all;

void redcc_report_add(struct reported *reported) {
    assert(reported->file && reported->function);
    reported->next = atomic_load(&all);
    while (!atomic_compare_exchange_weak(&all, &reported->next, reported))
        ;
}

const struct reported *redcc_report_loops(void) {
    return atomic_load(&all);
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

/* Counts a text in a slot that is free (count 0) or already has this text. Returns false if the
 * slot has another text. The text must fit into the slot. */
static bool count_text(char *place, long *count, const char *text) {
    if (*count == 0)
        memcpy(place, text, strlen(text) + 1);
    if (strcmp(place, text) != 0)
        return false;
    ++*count;
    return true;
}

void redcc_report_overlap(struct statistics *statistics, const char *source, const char *array) {
    assert(source && array);
    char text[REDCC_TEXT];
    snprintf(text, sizeof text, "'%s' overlaps '%s'", source, array);
    for (int i = 0; i < REDCC_TEXTS; i++)
        if (count_text(statistics->why.overlap[i].text, &statistics->why.overlap[i].count, text))
            return;
    atomic_fetch_add(&statistics->fallback[REASON_OVERLAP], 1); /* no slot is left for this text */
}

void redcc_report_unlinked(struct statistics *statistics, const redcc_expectation *other) {
    if (atomic_load(&statistics->why.unlinked))
        return;
    char text[REDCC_TEXT];
    snprintf(text, sizeof text, "'%.64s' of %.64s is not linked as it was analysed", other->name,
             other->file);
    char *none = NULL, *mine = redcc_memory_copy_text(text);
    if (!atomic_compare_exchange_strong(&statistics->why.unlinked, &none, mine))
        redcc_memory_free(mine);
}

const char *redcc_report_reason(const struct statistics *statistics, enum reason reason) {
    const char *unlinked =
        reason == REASON_UNLINKED ? atomic_load(&statistics->why.unlinked) : NULL;
    return unlinked ? unlinked : redcc_reason_text(reason);
}

void redcc_report_lost(struct statistics *statistics, const char *array) {
    char name[REDCC_NAME];
    snprintf(name, sizeof name, "%s", array);
    statistics->lost.count++;
    for (int i = 0; i < REDCC_LOST; i++)
        if (count_text(statistics->lost.array[i].name, &statistics->lost.array[i].count, name))
            return;
}

/* Replaces %p by the process's id, so that each of several processes writes a separate report.
 * NULL: out of memory. */
static char *spell_name(const char *name) {
    const size_t room = 24 * strlen(name) + 1; /* %p has two letters; an id has fewer than 40 */
    char *spelled = redcc_memory_alloc(room);
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

/* ---- several runtimes in one process ---------------------------------------------------------
 *
 * If a library has its own runtime, both runtimes write to the same file from the same process. The
 * second one to write recognises the first one's report by its first line, keeps the loops in it,
 * and adds its own loops. */

static const char end_of_report[] = "]}\n";

/* Is this a regular file? Returns `otherwise` if that is unknown. */
static bool is_regular(const char *name, unsigned flags, bool otherwise) {
#if defined(__linux__)
    struct statx found;
    if (redcc_system(SYS_statx, AT_FDCWD, name, flags, STATX_TYPE, &found) == 0)
        return (found.stx_mode & S_IFMT) == S_IFREG;
#else
    (void)name;
    (void)flags;
#endif
    return otherwise;
}

/* The contents of the file as a text; NULL: the file cannot be read. */
static char *read_all(const char *name) {
#if defined(__linux__)
    const int file = is_regular(name, 0, false) ? redcc_system_open(name) : -1;
    size_t room = 4096, length = 0;
    char *text = file >= 0 ? redcc_memory_alloc(room) : NULL;
    while (text) {
        const long more = redcc_system_read(file, text + length, room - 1 - length);
        if (more <= 0)
            break;
        length += (size_t)more;
        if (length + 1 < room)
            continue;
        char *longer = redcc_memory_resize(text, room *= 2);
        if (!longer)
            redcc_memory_free(text);
        text = longer;
    }
    if (file >= 0)
        redcc_system_close(file);
    if (text)
        text[length] = '\0';
    return text;
#else
    (void)name;
    return NULL;
#endif
}

/* The report of another runtime of this process, without its end; NULL: there is none. */
static char *read_others(const char *name, const char *head) {
    const size_t end = sizeof end_of_report - 1;
    char *text = read_all(name);
    const size_t length = text ? strlen(text) : 0;
    if (text && strncmp(text, head, strlen(head)) == 0 && length > end &&
        strcmp(text + length - end, end_of_report) == 0) {
        text[length - end] = '\0';
        return text;
    }
    redcc_memory_free(text);
    return NULL;
}

static bool write_whole(FILE *out, const char *head, const char *others) {
    if (others) {
        fputs(others, out);
        if (redcc_report_loops() && others[strlen(others) - 1] == '}')
            putc(',', out);
        redcc_report_list(out);
        fputs(end_of_report, out);
    } else {
        fputs(head, out);
        redcc_report_body(out);
    }
    return !ferror(out);
}

static bool write_all(FILE *out, const char *head, const char *others) {
    const bool written = write_whole(out, head, others);
    return fclose(out) == 0 && written;
}

/* ---- the file -------------------------------------------------------------------------------- */

static bool write_through(const char *name, const char *head, const char *others) {
    FILE *out = fopen(name, "w");
    return out && write_all(out, head, others);
}

/* Writes the report under a temporary name in the same directory, then renames it, so that no
 * reader finds an incomplete report. If no temporary file can be created, writes directly to the
 * file. Returns false if writing failed. */
static bool replace(const char *name, const char *head, const char *others) {
    const size_t room = strlen(name) + 32;
    char *beside = redcc_memory_alloc(room);
    if (!beside)
        return write_through(name, head, others);
    snprintf(beside, room, "%s.%ld", name, redcc_system_process());
    FILE *out = fopen(beside, "w");
    const bool written = out ? write_all(out, head, others) && rename(beside, name) == 0
                             : write_through(name, head, others);
    if (out && !written)
        remove(beside);
    redcc_memory_free(beside);
    return written;
}

/* Writes the report. A file that is not regular (a pipe, a device, a link) is never replaced. */
static bool write_file(const char *name) {
    char head[REDCC_REPORT_HEAD];
    redcc_report_head(head);
    if (strcmp(name, "/dev/stdout") ==
        0) /* opening it as a file would overwrite the program's output */
        return write_whole(stdout, head, NULL);
    if (strcmp(name, "/dev/stderr") == 0)
        return write_whole(stderr, head, NULL);
    char *others = read_others(name, head);
    const bool written = is_regular(name, AT_SYMLINK_NOFOLLOW, true)
                             ? replace(name, head, others)
                             : write_through(name, head, others);
    redcc_memory_free(others);
    return written;
}

void redcc_report_write(void) {
    redcc_memory_limit(0); /* the limit is for loops only; the report may exceed it */
    char *name = redcc_settings()->report ? spell_name(redcc_settings()->report) : NULL;
    if (!name)
        return;
    if (strcmp(name, "-") == 0)
        redcc_report_table(stderr);
    else if (!write_file(name))
        fprintf(stderr, "redcc: cannot write the report %s\n", name);
    redcc_memory_free(name);
}

/* ---- the end of the program ---------------------------------------------------------------- */

static void end_program(void) {
    if (!redcc_report_validation())
        return;
    fflush(NULL);
    _exit(REDCC_BROKEN); /* not exit, because this is one of exit's handlers */
}

/* Registers the handler at program start, because the handler that is registered first runs last:
 * after the program's handlers, and after all reports were written. */
__attribute__((constructor)) static void register_end(void) {
    const char *value = redcc_environment("REDCC_VALIDATE");
    if (value && strcmp(value, "1") == 0)
        atexit(end_program);
}
