/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Sets of owners. Each set is stored once and identified by a number. Number 0 is the empty set, 1
 * + o is the set {o}, and larger sets follow in the order of their first use.
 */
#ifndef REDCC_SETS_H
#define REDCC_SETS_H

#include <assert.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct sets {
    uint32_t owners;
    uint32_t count;    /* number of sets */
    uint32_t capacity; /* number of sets for which memory is allocated */
    size_t *start; /* [capacity + 1] the members of set s are member[start[s]] to member[start[s +
                      1] - 1] */
    uint32_t *member; /* ascending within a set */
    size_t member_capacity;
    uint32_t *slot; /* [slots] open-addressing hash table of set numbers; 0: free */
    uint32_t slots; /* a power of two */
};

/** Begins with the empty set and the sets of one owner. False: out of memory. Call redcc_sets_end
 * in either case. */
bool redcc_sets_begin(struct sets *sets, uint32_t owners);

/** Frees the memory. */
void redcc_sets_end(struct sets *sets);

/** Sets *set to the number of the set of `count` >= 2 owners, members[count], which must ascend;
 * adds the set if it is new. Returns false if out of memory. */
bool redcc_sets_intern(struct sets *sets, const uint32_t *members, uint32_t count, uint32_t *set);

static inline uint32_t redcc_set_size(const struct sets *sets, uint32_t set) {
    assert(set < sets->count);
    return (uint32_t)(sets->start[set + 1] - sets->start[set]);
}

static inline uint32_t redcc_set_minimum(const struct sets *sets, uint32_t set) {
    assert(redcc_set_size(sets, set) > 0);
    return sets->member[sets->start[set]];
}

static inline uint32_t redcc_set_maximum(const struct sets *sets, uint32_t set) {
    assert(redcc_set_size(sets, set) > 0);
    return sets->member[sets->start[set + 1] - 1];
}

#endif
