/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/maps.h"

#include "base/system.h"

#include <stdlib.h>

bool redcc_maps_by_text;

#if defined(__linux__)

#include <errno.h>
#include <sys/ioctl.h>

static const char maps_path[] = "/proc/self/maps";

/* struct procmap_query and PROCMAP_QUERY of <linux/fs.h> (Linux 6.11). They are repeated here
 * because older headers lack them. */
struct question {
    uint64_t size;
    uint64_t flags;
    uint64_t address;
    uint64_t first, end;
    uint64_t access;
    uint64_t page_bytes;
    uint64_t offset;
    uint64_t inode;
    uint32_t device_major, device_minor;
    uint32_t name_bytes;
    uint32_t build_id_bytes;
    uint64_t name;
    uint64_t build_id;
};
#define ASK _IOWR('f', 17, struct question)

enum {
    WRITABLE = 0x02,     /* PROCMAP_QUERY_VMA_WRITABLE */
    SHARED = 0x08,       /* PROCMAP_QUERY_VMA_SHARED */
    THIS_OR_NEXT = 0x10, /* PROCMAP_QUERY_COVERING_OR_NEXT_VMA */
    OF_A_FILE = 0x20     /* PROCMAP_QUERY_FILE_BACKED_VMA */
};

bool redcc_maps_open(struct maps *maps) {
    maps->by_text = redcc_maps_by_text;
    maps->reached = 0;
    return redcc_lines_open(&maps->lines, maps_path);
}

void redcc_maps_close(struct maps *maps) {
    redcc_lines_close(&maps->lines);
}

/* Queries the kernel; sets by_text if it does not support queries. The name is stored in the buffer
 * for lines, which queries do not use. */
static enum maps_answer ask(struct maps *maps, uintptr_t from, enum which_maps which,
                            struct mapping *found) {
    static const uint64_t flags[] = {[MAPS_ALL] = THIS_OR_NEXT,
                                     [MAPS_SHARED] = THIS_OR_NEXT | WRITABLE | SHARED,
                                     [MAPS_OF_OBJECTS] = THIS_OR_NEXT | OF_A_FILE};
    char *const name = maps->lines.buffer;
    struct question question = {.size = sizeof question,
                                .flags = flags[which],
                                .address = from,
                                .name = (uintptr_t)name,
                                .name_bytes = sizeof maps->lines.buffer};
    name[0] = '\0';
    const long result = redcc_system(SYS_ioctl, maps->lines.descriptor, ASK, &question);
    if (result == -ENOENT)
        return MAPS_END;
    maps->by_text = result != 0;
    if (question.name_bytes == 0)
        name[0] = '\0';
    *found = (struct mapping){
        .place = {(uintptr_t)question.first, (uintptr_t)question.end},
        .offset = question.offset,
        .object = {(uint64_t)question.device_major << 32 | question.device_minor, question.inode},
        .is_shared = (question.access & SHARED) != 0,
        .is_writable = (question.access & WRITABLE) != 0,
        .name = name};
    return MAPS_FOUND;
}

/* Parses a line such as "7f11bd400000-7f11bd428000 r--p 00000000 08:01 5505057
 * /usr/lib/libc.so.6". */
bool redcc_maps_parse(const char *line, struct mapping *mapping) {
    char *at = NULL;
    mapping->place.first = (uintptr_t)strtoull(line, &at, 16);
    if (*at != '-')
        return false;
    mapping->place.end = (uintptr_t)strtoull(at + 1, &at, 16);
    if (at[0] != ' ' || !at[1] || !at[2] || !at[3] || (at[4] != 's' && at[4] != 'p'))
        return false;
    mapping->is_writable = at[2] == 'w';
    mapping->is_shared = at[4] == 's';
    mapping->offset = strtoull(at + 5, &at, 16);
    const uint64_t device_major = strtoull(at, &at, 16);
    if (*at != ':')
        return false;
    mapping->object.device = device_major << 32 | strtoull(at + 1, &at, 16);
    if (*at != ' ')
        return false;
    mapping->object.inode = strtoull(at, &at, 10);
    while (*at == ' ')
        at++;
    mapping->name = at;
    return true;
}

static bool is_selected(const struct mapping *mapping, uintptr_t from, enum which_maps which) {
    if (mapping->place.end <= from)
        return false;
    switch (which) {
    case MAPS_SHARED:
        return mapping->is_shared && mapping->is_writable;
    case MAPS_OF_OBJECTS:
        return mapping->object.inode != 0;
    default:
        return true;
    }
}

static enum maps_answer read_on(struct maps *maps, uintptr_t from, enum which_maps which,
                                struct mapping *found) {
    if (from < maps->reached) { /* starts again from the beginning */
        redcc_lines_close(&maps->lines);
        if (!redcc_lines_open(&maps->lines, maps_path))
            return MAPS_UNKNOWN;
    }
    while (redcc_lines_next(&maps->lines)) {
        if (!redcc_maps_parse(maps->lines.line, found))
            return MAPS_UNKNOWN;
        maps->reached = found->place.end;
        if (is_selected(found, from, which))
            return MAPS_FOUND;
    }
    maps->reached = UINTPTR_MAX;
    return maps->lines.failed ? MAPS_UNKNOWN : MAPS_END;
}

enum maps_answer redcc_maps_next(struct maps *maps, uintptr_t from, enum which_maps which,
                                 struct mapping *found) {
    if (!maps->by_text) {
        const enum maps_answer answer = ask(maps, from, which, found);
        if (!maps->by_text)
            return answer;
    }
    return read_on(maps, from, which, found);
}

#else

bool redcc_maps_open(struct maps *maps) {
    (void)maps;
    return false;
}

void redcc_maps_close(struct maps *maps) {
    (void)maps;
}

bool redcc_maps_parse(const char *line, struct mapping *mapping) {
    (void)line;
    (void)mapping;
    return false;
}

enum maps_answer redcc_maps_next(struct maps *maps, uintptr_t from, enum which_maps which,
                                 struct mapping *found) {
    (void)maps;
    (void)from;
    (void)which;
    (void)found;
    return MAPS_UNKNOWN;
}

#endif
