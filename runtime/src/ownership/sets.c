/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/sets.h"

#include "base/memory.h"

#include <assert.h>
#include <string.h>

static uint64_t hash(const uint32_t *members, uint32_t count) {
    uint64_t value = count;
    for (uint32_t i = 0; i < count; i++) {
        value = (value ^ members[i]) * 0x9e3779b97f4a7c15u;
        value ^= value >> 29;
    }
    return value;
}

static bool room_for_set(struct sets *sets) {
    if (sets->count < sets->capacity)
        return true;
    const uint32_t more = sets->capacity * 2;
    size_t *start = redcc_memory_resize(sets->start, ((size_t)more + 1) * sizeof *start);
    if (!start)
        return false;
    sets->start = start;
    sets->capacity = more;
    return true;
}

static bool room_for_members(struct sets *sets, uint32_t count) {
    const size_t used = sets->start[sets->count];
    if (used + count <= sets->member_capacity)
        return true;
    const size_t more = (used + count) * 2;
    uint32_t *member = redcc_memory_resize(sets->member, more * sizeof *member);
    if (!member)
        return false;
    sets->member = member;
    sets->member_capacity = more;
    return true;
}

static void enter_slot(struct sets *sets, uint32_t set) {
    const uint32_t *members = sets->member + sets->start[set];
    uint64_t at = hash(members, redcc_set_size(sets, set)) & (sets->slots - 1);
    while (sets->slot[at])
        at = (at + 1) & (sets->slots - 1);
    sets->slot[at] = set;
}

/* Ensures that the hash table is at most half full after one more set is added. */
static bool room_for_slot(struct sets *sets) {
    const uint32_t kept = sets->count - (1 + sets->owners);
    if (kept < sets->slots / 2)
        return true;
    uint32_t *slot = redcc_memory_alloc_zeroed((size_t)sets->slots * 2, sizeof *slot);
    if (!slot)
        return false;
    redcc_memory_free(sets->slot);
    sets->slot = slot;
    sets->slots *= 2;
    for (uint32_t set = 1 + sets->owners; set < sets->count; set++)
        enter_slot(sets, set);
    return true;
}

bool redcc_sets_begin(struct sets *sets, uint32_t owners) {
    assert(owners >= 1);
    *sets = (struct sets){.owners = owners, .capacity = owners + 64, .slots = 128};
    sets->member_capacity = (size_t)owners + 256;
    sets->start = redcc_memory_alloc(((size_t)sets->capacity + 1) * sizeof *sets->start);
    sets->member = redcc_memory_alloc(sets->member_capacity * sizeof *sets->member);
    sets->slot = redcc_memory_alloc_zeroed(sets->slots, sizeof *sets->slot);
    if (!sets->start || !sets->member || !sets->slot)
        return false;
    sets->start[0] = sets->start[1] = 0;
    for (uint32_t owner = 0; owner < owners; owner++) {
        sets->member[owner] = owner;
        sets->start[owner + 2] = (size_t)owner + 1;
    }
    sets->count = 1 + owners;
    return true;
}

void redcc_sets_end(struct sets *sets) {
    redcc_memory_free(sets->start);
    redcc_memory_free(sets->member);
    redcc_memory_free(sets->slot);
    *sets = (struct sets){0};
}

bool redcc_sets_intern(struct sets *sets, const uint32_t *members, uint32_t count, uint32_t *set) {
    assert(count >= 2 && count <= sets->owners);
    for (uint32_t m = 0; m < count; m++)
        assert(members[m] < sets->owners && (m == 0 || members[m - 1] < members[m]));
    const size_t bytes = count * sizeof *members;
    assert(sets->count <= sets->capacity && (sets->slots & (sets->slots - 1)) == 0);
    uint64_t at = hash(members, count) & (sets->slots - 1);
    for (uint32_t known; (known = sets->slot[at]) != 0; at = (at + 1) & (sets->slots - 1))
        if (redcc_set_size(sets, known) == count &&
            memcmp(sets->member + sets->start[known], members, bytes) == 0) {
            *set = known;
            return true;
        }
    if (!room_for_set(sets) || !room_for_members(sets, count) || !room_for_slot(sets))
        return false;
    memcpy(sets->member + sets->start[sets->count], members, bytes);
    sets->start[sets->count + 1] = sets->start[sets->count] + count;
    *set = sets->count++;
    enter_slot(sets, *set);
    return true;
}
