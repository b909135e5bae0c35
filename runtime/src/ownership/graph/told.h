/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What the inspector told, kept: the units that each iteration of a thread's share touches. Units
 * of the leading group and those of further groups are kept apart, each in a list in which the last
 * unit of an iteration is marked.
 */
#ifndef REDCC_TOLD_H
#define REDCC_TOLD_H

#include "ownership/graph/units.h"

/** In a list: this is the iteration's last; and what stands for an iteration without units. */
#define REDCC_LAST 0x80000000u
#define REDCC_NO_UNIT 0x7fffffffu

struct unit_list {
    uint32_t *item;
    size_t count;
    size_t capacity;
    size_t open; /* where the iteration at hand begins */
};

/** Appends units item[0 .. count), an iteration's. False: no memory. */
bool redcc_unit_list_add(struct unit_list *list, const uint32_t *item, size_t count);

/** Gives back its memory. */
void redcc_unit_list_end(struct unit_list *list);

/** How many units the iteration has that begins at item `at`. */
static inline size_t redcc_iteration_length(const struct unit_list *list, size_t at) {
    size_t last = at;
    while (!(list->item[last] & REDCC_LAST))
        last++;
    return last + 1 - at;
}

/** Of one array: all that a touch is looked up by. */
struct told_array {
    struct group_units units; /* its group's */
    struct unit_list *list;   /* that they are kept in */
    struct range *seen;       /* of its group, by this thread */
};

struct told {
    struct told_array *of; /* [array_count] */
    uint32_t units;        /* that there are */
    struct unit_list leading;
    struct unit_list further; /* without memory where there is but one group */
    redcc_int begin;          /* the first iteration */
    redcc_int iterations;     /* how many were told */
    size_t most;              /* items in either list */
    bool too_much;            /* more than that */
    bool beyond;              /* a touch of what is no unit: the lists are of no use */
    bool failed;              /* no memory */
};

/** Begins with iteration `begin`, for about leading + further touches and at most `most` of each;
 *  seen [array_count] is the caller's, and goes on being widened. False: no memory (end it all the
 *  same). */
bool redcc_told_begin(struct told *told, const struct units *units,
                      const struct partition *partition, struct range *seen, redcc_int begin,
                      const size_t expected[2], size_t most);

/** Gives back its memory. */
void redcc_told_end(struct told *told);

/** Takes entries [first, end) in; an iteration's may come in several calls. */
void redcc_told_take(struct told *told, const redcc_entry *first, const redcc_entry *end);

/** Where a reader of a list stands. */
struct told_reading {
    const struct unit_list *list;
    size_t at;
};

/** The next unit of the iteration at hand, or REDCC_NO_UNIT; sets *last where it is its last. */
static inline uint32_t redcc_told_read(struct told_reading *reading, bool *last) {
    const uint32_t item = reading->list->item[reading->at++];
    *last = item & REDCC_LAST;
    return item & ~REDCC_LAST;
}

#endif
