/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The mappings of the process, one by one: /proc/self/maps, proc_pid_maps(5). Linux 6.11 and later
 * supports queries for single mappings (PROCMAP_QUERY), which take some microseconds for any number
 * of mappings. Otherwise the text is read, at 1 to 2 microseconds per mapping.
 */
#ifndef REDCC_MAPS_H
#define REDCC_MAPS_H

#include "base/lines.h"
#include "base/range.h"

/** The object behind mappings: a file, a segment, anonymous shared memory. */
struct object {
    uint64_t device;
    uint64_t inode; /* 0: no object; the memory belongs to the mapping */
};

/** A mapping. */
struct mapping {
    struct range place;
    uint64_t offset; /* of its first byte in the object */
    struct object object;
    bool is_shared;
    bool is_writable;
    const char *name; /* as in the text; valid until the next one is read */
};

/** The state of reading the list of mappings; on the stack of its reader, used by one thread. */
struct maps {
    struct lines lines;
    bool by_text;      /* the kernel does not support queries */
    uintptr_t reached; /* by text: the end of the mapping read last */
};

/** A selection of mappings. */
enum which_maps {
    MAPS_ALL,
    MAPS_SHARED, /* writable, and writes go to the object */
    MAPS_OF_OBJECTS
};

enum maps_answer {
    MAPS_FOUND,
    MAPS_END,    /* there is no further one */
    MAPS_UNKNOWN /* the mappings cannot be read */
};

/** For tests: reads the text even if the kernel supports queries. */
extern bool redcc_maps_by_text;

/** Opens the list. False: there is no /proc. */
bool redcc_maps_open(struct maps *maps);

/** Stores the first selected mapping that ends after `from` in *found. */
enum maps_answer redcc_maps_next(struct maps *maps, uintptr_t from, enum which_maps which,
                                 struct mapping *found);

/** Closes a list opened by redcc_maps_open. */
void redcc_maps_close(struct maps *maps);

/** Parses a line of the text. False if it is invalid. */
bool redcc_maps_parse(const char *line, struct mapping *mapping);

#endif
