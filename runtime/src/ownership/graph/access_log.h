/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The access log records the units that each iteration of a thread's share touches. A unit is a row
 * of a reduction array. Units of the leading group and those of all other groups are in separate
 * lists, in which the last unit of each iteration is marked.
 */
#ifndef REDCC_ACCESS_LOG_H
#define REDCC_ACCESS_LOG_H

#include "ownership/graph/units.h"

#include <assert.h>

/** REDCC_LAST is a bit that marks the last unit of an iteration in a list. REDCC_NO_UNIT is the
 * only item of an iteration that touches no unit of the list. */
#define REDCC_LAST 0x80000000u
#define REDCC_NO_UNIT 0x7fffffffu

struct unit_list {
    uint32_t *item;
    size_t count;
    size_t capacity;
    size_t open; /* index of the current iteration's first item */
};

/** Appends the units item[0] to item[count - 1] of an iteration. False: out of memory. */
bool redcc_unit_list_add(struct unit_list *list, const uint32_t *item, size_t count);

/** Frees the list's memory. */
void redcc_unit_list_end(struct unit_list *list);

/** The number of items of the iteration that begins at item `at`; it is 1 for an iteration without
 * units, too. */
static inline size_t redcc_iteration_length(const struct unit_list *list, size_t at) {
    size_t last = at;
    assert(at < list->count);
    while (!(list->item[last] & REDCC_LAST))
        last++;
    return last + 1 - at;
}

/** What is needed to log the touches of one array. */
struct logged_array {
    struct group_units units; /* the units of the array's group */
    struct unit_list *list;   /* the list to which these units are appended */
    struct range *seen;       /* the range of the array's group that this thread has touched */
};

struct access_log {
    struct logged_array *of; /* [array_count] */
    uint32_t units;          /* total number of units */
    struct unit_list leading;
    /* the units of all other groups; not allocated if there is only one group */
    struct unit_list further;
    redcc_int begin;      /* the first iteration of the thread's share */
    redcc_int iterations; /* number of iterations recorded */
    size_t most;          /* a list with this many items is not enlarged */
    bool too_much;        /* a full list of at least `most` items would have had to be enlarged */
    bool beyond;          /* a touch was outside of all units, so the lists are unusable */
    bool failed;          /* out of memory */
};

/** Begins a log at iteration `begin`, with space for about expected[0] touches of the leading group
 * and expected[1] touches of the other groups. A list is not enlarged once it has `most` items.
 * seen[array_count] has the ranges of the groups that the thread has touched; it belongs to the
 * caller, and the log extends the ranges. Returns false if out of memory. Call redcc_access_log_end
 * in either case. */
bool redcc_access_log_begin(struct access_log *logged, const struct units *units,
                            const struct partition *partition, struct range *seen, redcc_int begin,
                            const size_t expected[2], size_t most);

/** Frees the log's memory. */
void redcc_access_log_end(struct access_log *logged);

/** Appends the entries from `first` to before `end`. The entries of one iteration may be split over
 * several calls. */
void redcc_access_log_take(struct access_log *logged, const redcc_entry *first,
                           const redcc_entry *end);

/** The position of a reader in a list. */
struct access_log_reader {
    const struct unit_list *list;
    size_t at;
};

/** Reads the next unit of the current iteration, or REDCC_NO_UNIT if the iteration has none. Sets
 * *last to whether it is the iteration's last item. */
static inline uint32_t redcc_access_log_read(struct access_log_reader *reading, bool *last) {
    const uint32_t item = reading->list->item[reading->at++];
    *last = item & REDCC_LAST;
    return item & ~REDCC_LAST;
}

#endif
