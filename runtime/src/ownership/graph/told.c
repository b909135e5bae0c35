/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/told.h"

#include "base/memory.h"

/* How far back a unit is looked for, so that it is not entered twice in an iteration. */
enum { LOOK_BACK = 16 };

static bool list_begin(struct unit_list *list, size_t capacity) {
    *list = (struct unit_list){.capacity = capacity};
    list->item = redcc_memory_take(capacity * sizeof *list->item);
    return list->item != NULL;
}

bool redcc_told_begin(struct told *told, const struct units *units,
                      const struct partition *partition, redcc_int begin, size_t leading,
                      size_t further, size_t most) {
    *told = (struct told){.units = units, .partition = partition, .begin = begin, .most = most};
    const bool several = units->count > units->leading;
    return list_begin(&told->leading, leading + 64) &&
           (!several || list_begin(&told->further, further + 64));
}

void redcc_told_end(struct told *told) {
    redcc_memory_give(told->leading.item);
    redcc_memory_give(told->further.item);
    *told = (struct told){0};
}

static bool room_for_unit(struct told *told, struct unit_list *list) {
    if (list->count < list->capacity)
        return true;
    if (list->count >= told->most) {
        told->too_much = true;
        return false;
    }
    uint32_t *item = redcc_memory_resize(list->item, list->capacity * 2 * sizeof *item);
    if (!item) {
        told->failed = true;
        return false;
    }
    list->item = item;
    list->capacity *= 2;
    return true;
}

static void enter(struct told *told, struct unit_list *list, uint32_t unit) {
    const size_t far = list->count - list->open < LOOK_BACK ? list->open : list->count - LOOK_BACK;
    for (size_t i = list->count; i > far; i--)
        if (list->item[i - 1] == unit)
            return;
    if (room_for_unit(told, list))
        list->item[list->count++] = unit;
}

static void close_iteration(struct told *told, struct unit_list *list) {
    if (list->count == list->open)
        enter(told, list, REDCC_NO_UNIT);
    if (list->count > list->open)
        list->item[list->count - 1] |= REDCC_LAST;
    list->open = list->count;
}

static void take_touch(struct told *told, const redcc_entry *entry) {
    const struct group_units *group = &told->units->of[told->partition->group_of[entry->array]];
    const uint64_t into = (uintptr_t)entry->address - group->first;
    const uint64_t last = redcc_units_in(group, into + entry->bytes - 1);
    uint64_t unit = redcc_units_in(group, into);
    if (into > UINT64_MAX / 2 || last >= group->count) {
        told->too_much = true; /* the inspector does not tell the same again */
        return;
    }
    struct unit_list *list = group->begin < told->units->leading ? &told->leading : &told->further;
    for (; unit <= last && !told->too_much && !told->failed; unit++)
        enter(told, list, group->begin + (uint32_t)unit);
}

void redcc_told_take(struct told *told, const redcc_entry *first, const redcc_entry *end) {
    for (const redcc_entry *entry = first; entry != end; entry++) {
        if (told->failed || told->too_much)
            return;
        if (entry->array != REDCC_END_OF_ITERATION) {
            if (entry->bytes)
                take_touch(told, entry);
            continue;
        }
        close_iteration(told, &told->leading);
        if (told->further.item)
            close_iteration(told, &told->further);
        told->iterations++;
    }
}
