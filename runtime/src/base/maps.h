/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The mappings of the process, one by one: /proc/self/maps, proc_pid_maps(5). Linux 6.11 and later
 * answers questions about single mappings (PROCMAP_QUERY), which takes some microseconds however
 * many mappings there are; elsewhere the text is read, 1 to 2 microseconds a mapping.
 */
#ifndef REDCC_MAPS_H
#define REDCC_MAPS_H

#include "base/lines.h"
#include "base/range.h"

/** A memory object that mappings show: a file, a segment, anonymous memory that is shared. */
struct object {
    uint64_t device;
    uint64_t inode; /* 0: none, the mapping's memory is its own */
};

/** A mapping. */
struct mapping {
    struct range place;
    uint64_t offset; /* of its first byte in the object */
    struct object object;
    bool is_shared;
    bool is_writable;
    const char *name; /* as the text has it; valid until the next one is read */
};

/** A list of mappings that is read; on the stack of whoever reads it, used by one thread. */
struct maps {
    struct lines lines;
    bool by_text;      /* the kernel does not answer questions */
    uintptr_t reached; /* by text: where the mapping read last ends */
};

/** Which mappings are asked for. */
enum which_maps {
    MAPS_ALL,
    MAPS_SHARED, /* writable, and every write is one to the object */
    MAPS_OF_OBJECTS
};

enum maps_answer {
    MAPS_FOUND,
    MAPS_END,    /* there is none */
    MAPS_UNKNOWN /* that cannot be told */
};

/** For tests: reads the text also where the kernel answers questions. */
extern bool redcc_maps_by_text;

/** Opens the list. False: there is no /proc. */
bool redcc_maps_open(struct maps *maps);

/** The first mapping that ends behind `from`, of those asked for, into *found. */
enum maps_answer redcc_maps_next(struct maps *maps, uintptr_t from, enum which_maps which,
                                 struct mapping *found);

/** Closes what redcc_maps_open has opened. */
void redcc_maps_close(struct maps *maps);

/** Reads a line of the text. False: it is none. */
bool redcc_maps_parse(const char *line, struct mapping *mapping);

#endif
