/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/aliases.h"

#include "base/escapes.h"
#include "base/maps.h"

#include <string.h>

/* The written bytes of one mapping, and where they are in the mapped object. */
struct part {
    struct range place;
    struct object object;
    uint64_t offset; /* offset of the first byte in the object */
};

enum { PARTS = 32 };

struct parts {
    struct part part[PARTS];
    int count;
};

static bool begins(const char *text, const char *with) {
    return strncmp(text, with, strlen(with)) == 0;
}

/* Does an offset in the mapped object identify memory uniquely? Not for devices: a driver may map
 * any memory at an offset. */
static bool is_plain(const struct mapping *mapping) {
    const char *const name = mapping->name;
    if (mapping->object.inode == 0)
        return false;
    if (begins(name, "/dev/"))
        return begins(name, "/dev/shm/") || begins(name, "/dev/hugepages/") ||
               begins(name, "/dev/zero");
    return (name[0] == '/' && !begins(name, "/dmabuf")) || begins(name, "[anon_shmem:");
}

static uintptr_t higher(uintptr_t a, uintptr_t b) {
    return a > b ? a : b;
}

static uintptr_t lower(uintptr_t a, uintptr_t b) {
    return a < b ? a : b;
}

/* Adds the part of `written` that is in this mapping. Returns false if the mapped object is
 * unknown, or if there is no room for another part. */
static bool add_part(struct parts *parts, const struct mapping *mapping, struct range written) {
    if (!is_plain(mapping) || parts->count == PARTS)
        return false;
    const struct range place = {higher(mapping->place.first, written.first),
                                lower(mapping->place.end, written.end)};
    const uint64_t offset = mapping->offset + (place.first - mapping->place.first);
    parts->part[parts->count++] = (struct part){place, mapping->object, offset};
    return true;
}

/* Adds the parts of `written` that lie in writable shared mappings. Most arrays lie in one mapping,
 * so a single query suffices. Returns false if the mappings or a mapped object are unknown, or if
 * there are too many parts. */
static bool find_parts(struct maps *maps, struct range written, struct parts *parts) {
    enum which_maps which = MAPS_ALL;
    struct mapping mapping;
    for (uintptr_t from = written.first; from < written.end; from = mapping.place.end) {
        const enum maps_answer answer = redcc_maps_next(maps, from, which, &mapping);
        if (answer != MAPS_FOUND)
            return answer == MAPS_END;
        if (mapping.place.first >= written.end)
            return true;
        if (mapping.is_shared && mapping.is_writable && !add_part(parts, &mapping, written))
            return false;
        which = MAPS_SHARED;
    }
    return true;
}

static bool is_touched(const struct touches *touches, struct range range) {
    for (uint32_t w = 0; w < touches->written_count; w++)
        if (redcc_ranges_overlap(touches->written[w], range))
            return true;
    for (uint32_t r = 0; r < touches->read_count; r++)
        if (redcc_ranges_overlap(touches->read[r], range))
            return true;
    return false;
}

/* The addresses at which this mapping shows bytes of the part. The range is empty if the mapping
 * shows none of them, or shows them at the part's own addresses. */
static struct range image_of(const struct part *part, const struct mapping *mapping) {
    const uint64_t part_end = part->offset + redcc_range_size(part->place);
    const uint64_t mapping_end = mapping->offset + redcc_range_size(mapping->place);
    const uint64_t first = part->offset > mapping->offset ? part->offset : mapping->offset;
    const uint64_t end = part_end < mapping_end ? part_end : mapping_end;
    if (part->object.device != mapping->object.device ||
        part->object.inode != mapping->object.inode || first >= end)
        return redcc_nowhere;
    const uintptr_t at = mapping->place.first + (uintptr_t)(first - mapping->offset);
    if (at == part->place.first + (uintptr_t)(first - part->offset))
        return redcc_nowhere;
    return (struct range){at, at + (uintptr_t)(end - first)};
}

static bool have_images(struct maps *maps, const struct touches *touches,
                        const struct parts *parts) {
    enum maps_answer answer = MAPS_END;
    struct mapping mapping;
    for (uintptr_t from = 0;
         (answer = redcc_maps_next(maps, from, MAPS_OF_OBJECTS, &mapping)) == MAPS_FOUND;
         from = mapping.place.end)
        for (int p = 0; p < parts->count; p++)
            if (is_touched(touches, image_of(&parts->part[p], &mapping)))
                return true;
    return answer != MAPS_END;
}

/* Is one of the highest 8 bits of an address set? Processors may ignore these bits: 64-bit ARM
 * always does, some x86 processors do in a special mode. Then one byte has several addresses. */
static bool are_tagged(const struct range *ranges, uint32_t count) {
#if UINTPTR_MAX > UINT32_MAX
    for (uint32_t r = 0; r < count; r++)
        if (!redcc_range_empty(ranges[r]) && (ranges[r].first | (ranges[r].end - 1)) >> 56 != 0)
            return true;
#else
    (void)ranges;
    (void)count;
#endif
    return false;
}

static bool look(const struct touches *touches) {
    struct maps maps;
    struct parts parts = {.count = 0};
    if (!redcc_maps_open(&maps))
        return true;
    bool known = true;
    for (uint32_t w = 0; known && w < touches->written_count; w++)
        known = find_parts(&maps, touches->written[w], &parts);
    for (uint32_t r = 0; known && touches->loop && r < touches->read_count; r++)
        if (touches->loop->sources[r].flags & REDCC_IS_SCALAR)
            known = find_parts(&maps, touches->read[r], &parts);
    const bool aliased = !known || (parts.count > 0 && have_images(&maps, touches, &parts));
    redcc_maps_close(&maps);
    return aliased;
}

bool redcc_may_be_aliased(struct touches touches) {
    return are_tagged(touches.written, touches.written_count) ||
           are_tagged(touches.read, touches.read_count) || (redcc_may_map() && look(&touches));
}

bool redcc_may_have_aliases(void) {
    const struct range everything = {0, UINTPTR_MAX};
    const struct touches touches = {.written = &everything, .written_count = 1};
    return redcc_may_map() && look(&touches);
}
