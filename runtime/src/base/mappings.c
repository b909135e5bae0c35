/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for O_DIRECTORY */
#include "base/mappings.h"

#include "base/system.h"

#if defined(__linux__)

#include "base/maps.h"

#include <fcntl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

/* The number after `key` in /proc/thread-self/status, or `otherwise`. */
static long status_of(const char *key, long otherwise) {
    struct lines lines;
    long value = otherwise;
    if (!redcc_lines_open(&lines, "/proc/thread-self/status"))
        return value;
    while (redcc_lines_next(&lines))
        if (begins(lines.line, key)) {
            value = strtol(lines.line + strlen(key), NULL, 10);
            break;
        }
    redcc_lines_close(&lines);
    return value;
}

bool redcc_is_confined(void) {
    return status_of("Seccomp:", -1) != 0;
}

int redcc_descriptor_room(void) {
    const long room = status_of("FDSize:", 0);
    return room > 0 && room <= INT_MAX ? (int)room : 0;
}

bool redcc_has_accelerator(void) {
    static const char *const places[] = {"/dev/dri", "/dev/kfd", "/dev/nvidia-uvm",
                                         "/dev/nvidiactl", "/dev/accel"};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        if (redcc_system(SYS_faccessat, AT_FDCWD, places[i], 0) == 0)
            return true;
    return false;
}

static bool is_listed(const char *name, const char *const *list) {
    for (; *list; list++)
        if (begins(name, *list))
            return true;
    return false;
}

/* Devices whose memory is written only by the processor. */
static bool is_plain_device(const char *name) {
    static const char *const plain[] = {"/dev/null",       "/dev/zero", "/dev/full", "/dev/random",
                                        "/dev/urandom",    "/dev/tty",  "/dev/pts/", "/dev/ptmx",
                                        "/dev/console",    "/dev/shm/", "/dev/fuse", "/dev/kmsg",
                                        "/dev/hugepages/", "/dev/log",  NULL};
    return is_listed(name, plain);
}

/* May writes be tracked if the process has a mapping with this name? True for anonymous mappings,
 * for the system's own names, and for most files. False for devices, except plain ones, and for
 * libseccomp, by which the process may be confined later. */
static bool is_harmless(const char *name) {
    if (name[0] == '\0' || name[0] == '[')
        return true;
    if (name[0] != '/' || begins(name, "/dmabuf") || strstr(name, "/libseccomp"))
        return false;
    return !begins(name, "/dev/") || is_plain_device(name);
}

/* Is the memory private, with no file behind it? */
static bool is_own(const struct mapping *mapping) {
    const bool unnamed = mapping->name[0] == '\0' || strcmp(mapping->name, "[heap]") == 0 ||
                         begins(mapping->name, "[anon:");
    return !mapping->is_shared && mapping->object.inode == 0 && unnamed;
}

struct range redcc_mapping_of(uintptr_t address) {
    struct lines lines;
    struct mapping mapping = {.place = redcc_nowhere};
    bool found = false;
    if (!redcc_lines_open(&lines, "/proc/self/maps"))
        return redcc_nowhere;
    while (!found && redcc_lines_next(&lines) && redcc_maps_parse(lines.line, &mapping))
        found = mapping.place.first <= address && address < mapping.place.end;
    redcc_lines_close(&lines);
    return found ? mapping.place : redcc_nowhere;
}

/* Checks one mapping, and adds it to *found if it contains some of `pages`. Returns false if the
 * mapping forbids tracking. *covered is the address up to which `pages` are covered so far. */
static bool consider(const struct mapping *mapping, struct range pages, struct mappings *found,
                     uintptr_t *covered) {
    if (!is_harmless(mapping->name))
        return false;
    if (!redcc_ranges_overlap(mapping->place, pages))
        return true;
    if (!is_own(mapping) || mapping->place.first > *covered || found->count == REDCC_MAPPINGS)
        return false;
    found->whole[found->count++] = mapping->place;
    *covered = mapping->place.end;
    return true;
}

static bool mappings_allow(struct mappings *found, struct range pages) {
    struct lines lines;
    struct mapping mapping;
    uintptr_t covered = pages.first;
    bool allowed = true;
    found->count = 0;
    if (!redcc_lines_open(&lines, "/proc/self/maps"))
        return false;
    while (allowed && redcc_lines_next(&lines))
        allowed =
            redcc_maps_parse(lines.line, &mapping) && consider(&mapping, pages, found, &covered);
    redcc_lines_close(&lines);
    return allowed && covered >= pages.end;
}

/* Is it certain that no memory is written, and no tracking is disturbed, through this
 * descriptor? */
static bool is_harmless_descriptor(int folder, const char *number, int own) {
    char name[REDCC_LONGEST_LINE];
    const long length = redcc_system(SYS_readlinkat, folder, number, name, sizeof name - 1);
    if (length < 0 || atoi(number) == own)
        return true; /* the descriptor is closed by now, or `own` */
    name[length] = '\0';
    if (begins(name, "anon_inode:"))
        return !strstr(name, "userfault") && !strstr(name, "io_uring");
    return !begins(name, "/dev/") || is_plain_device(name);
}

/* An entry of a directory as getdents64(2) returns it. */
struct entry {
    uint64_t inode;
    int64_t next;
    unsigned short bytes;
    unsigned char type;
    char name[];
};

static bool entries_allow(int folder, const char *entries, long bytes, int own) {
    bool allowed = true;
    for (long at = 0; allowed && at < bytes;) {
        const struct entry *entry = (const void *)(entries + at);
        allowed = entry->name[0] == '.' || is_harmless_descriptor(folder, entry->name, own);
        at += entry->bytes;
    }
    return allowed;
}

static bool descriptors_allow(int own) {
    _Alignas(struct entry) char entries[4096];
    const int folder = redcc_system_open("/proc/self/fd");
    if (folder < 0)
        return false;
    bool allowed = true;
    long bytes = 0;
    while (allowed && (bytes = redcc_system(SYS_getdents64, folder, entries, sizeof entries)) > 0)
        allowed = entries_allow(folder, entries, bytes, own);
    redcc_system_close(folder);
    return allowed && bytes == 0;
}

bool redcc_may_watch(struct mappings *found, struct range pages, int own) {
    return status_of("VmPin:", -1) == 0 && mappings_allow(found, pages) && descriptors_allow(own);
}

#else

struct range redcc_mapping_of(uintptr_t address) {
    (void)address;
    return redcc_nowhere;
}

bool redcc_is_confined(void) {
    return true;
}

bool redcc_has_accelerator(void) {
    return false;
}

bool redcc_may_watch(struct mappings *found, struct range pages, int own) {
    (void)pages;
    (void)own;
    found->count = 0;
    return false;
}

#endif
