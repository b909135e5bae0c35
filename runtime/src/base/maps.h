/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Reads the memory mappings of the process one by one from /proc/self/maps, see proc_pid_maps(5).
 * Linux 6.11 and later versions support queries for single mappings (PROCMAP_QUERY). A query takes
 * some microseconds for any number of mappings. On other systems the text is read, which takes 1 to
 * 2 microseconds per mapping.
 */
#ifndef REDCC_MAPS_H
#define REDCC_MAPS_H

#include "base/lines.h"
#include "base/range.h"

/** The object that a mapping makes visible: a file, a System V segment, or anonymous shared
 * memory. */
struct object {
    uint64_t device;
    uint64_t inode; /* 0: there is no object, and the memory is the mapping's own */
};

/** A mapping. */
struct mapping {
    struct range place;
    uint64_t offset; /* the offset of its first byte in the object */
    struct object object;
    bool is_shared;
    bool is_writable;
    const char *name; /* the name in the text; valid until the next mapping is read */
};

/** The state of reading the list of mappings. It is on the stack of its reader and used by one
 * thread. */
struct maps {
    struct lines lines;
    bool by_text;      /* the kernel does not support queries */
    uintptr_t reached; /* if by_text: the end of the mapping read last */
};

/** Which mappings to read. */
enum which_maps {
    MAPS_ALL,
    MAPS_SHARED, /* those that are writable and whose writes go to the object */
    MAPS_OF_OBJECTS
};

enum maps_answer {
    MAPS_FOUND,
    MAPS_END,    /* there is no further mapping */
    MAPS_UNKNOWN /* the mappings cannot be read */
};

/** For tests: reads the text even if the kernel supports queries. */
extern bool redcc_maps_by_text;

/** Opens the list. False: it cannot be opened. */
bool redcc_maps_open(struct maps *maps);

/** Stores the first mapping that `which` selects and that ends after `from` in *found. */
enum maps_answer redcc_maps_next(struct maps *maps, uintptr_t from, enum which_maps which,
                                 struct mapping *found);

/** Closes a list opened by redcc_maps_open. */
void redcc_maps_close(struct maps *maps);

/** Parses a line of the text. False if it is invalid. */
bool redcc_maps_parse(const char *line, struct mapping *mapping);

#endif
