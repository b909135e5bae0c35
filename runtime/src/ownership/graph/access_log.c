/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/graph/access_log.h"

#include <assert.h>

#include "base/memory.h"

/* How many of an iteration's latest units are searched for a duplicate of the next. */
enum { LOOK_BACK = 16 };

static bool list_begin(struct unit_list *list, size_t capacity) {
    *list = (struct unit_list){.capacity = capacity};
    list->item = redcc_memory_alloc(capacity * sizeof *list->item);
    return list->item != NULL;
}

bool redcc_unit_list_add(struct unit_list *list, const uint32_t *item, size_t count) {
    assert(list->count <= list->capacity);
    if (list->capacity - list->count < count) {
        const size_t more = 2 * list->capacity + count + 256;
        uint32_t *longer = redcc_memory_resize(list->item, more * sizeof *item);
        if (!longer)
            return false;
        list->item = longer;
        list->capacity = more;
    }
    for (size_t i = 0; i < count; i++)
        list->item[list->count++] = item[i];
    return true;
}

void redcc_unit_list_end(struct unit_list *list) {
    redcc_memory_free(list->item);
    *list = (struct unit_list){0};
}

bool redcc_access_log_begin(struct access_log *logged, const struct units *units,
                            const struct partition *partition, struct range *seen, redcc_int begin,
                            const size_t expected[2], size_t most) {
    assert(units->array_count == partition->array_count && begin >= 0);
    *logged = (struct access_log){.units = units->count, .begin = begin, .most = most};
    logged->of = redcc_memory_alloc(partition->array_count * sizeof *logged->of);
    for (uint32_t array = 0; logged->of && array < partition->array_count; array++) {
        const uint32_t group = partition->group_of[array];
        const bool leads = units->of[group].begin < units->leading;
        logged->of[array] = (struct logged_array){
            units->of[group], leads ? &logged->leading : &logged->further, &seen[group]};
    }
    const bool several = units->count > units->leading;
    return logged->of && list_begin(&logged->leading, expected[0] + 64) &&
           (!several || list_begin(&logged->further, expected[1] + 64));
}

void redcc_access_log_end(struct access_log *logged) {
    redcc_memory_free(logged->of);
    redcc_unit_list_end(&logged->leading);
    redcc_unit_list_end(&logged->further);
    *logged = (struct access_log){0};
}

/* Ensures space for one unit. False: the log has failed, or has become too long. */
static bool room_for_unit(struct access_log *logged, struct unit_list *list) {
    if (logged->failed || logged->too_much)
        return false;
    if (list->count >= logged->most) {
        logged->too_much = true;
        return false;
    }
    uint32_t *item = redcc_memory_resize(list->item, list->capacity * 2 * sizeof *item);
    if (!item) {
        logged->failed = true;
        return false;
    }
    list->item = item;
    list->capacity *= 2;
    return true;
}

static inline void enter(struct access_log *logged, struct unit_list *list, uint32_t unit) {
    const size_t count = list->count;
    const uint32_t *const open = list->item + list->open;
    const uint32_t *item = list->item + count;
    const uint32_t *const far = item - open < LOOK_BACK ? open : item - LOOK_BACK;
    while (item > far)
        if (*--item == unit)
            return;
    if (count == list->capacity && !room_for_unit(logged, list))
        return;
    list->item[count] = unit;
    list->count = count + 1;
}

static inline void close_iteration(struct access_log *logged, struct unit_list *list) {
    if (list->count == list->open)
        enter(logged, list, REDCC_NO_UNIT);
    if (list->count > list->open)
        list->item[list->count - 1] |= REDCC_LAST;
    list->open = list->count;
}

/* Adds a touch of several units, or of memory that is in none of them. */
static void take_wide(struct access_log *logged, const struct logged_array *array, uint64_t into,
                      uint32_t bytes) {
    const struct group_units *units = &array->units;
    const uint64_t last = redcc_units_in(units, into + bytes - 1);
    if (into > UINT64_MAX / 2 || last >= units->count) {
        logged->beyond = true;
        return;
    }
    for (uint64_t unit = redcc_units_in(units, into); unit <= last; unit++)
        enter(logged, array->list, units->begin + (uint32_t)unit);
}

static inline void take_touch(struct access_log *logged, const redcc_entry *entry) {
    const struct logged_array *array = &logged->of[entry->array];
    const uintptr_t address = (uintptr_t)entry->address, end = address + entry->bytes;
    if (address < array->seen->first)
        array->seen->first = address;
    if (end > array->seen->end)
        array->seen->end = end;
    const uint64_t into = address - array->units.first;
    const uint64_t unit = redcc_units_in(&array->units, into);
    const bool is_one = into - unit * array->units.bytes + entry->bytes <= array->units.bytes;
    if (is_one && unit < array->units.count)
        enter(logged, array->list, array->units.begin + (uint32_t)unit);
    else
        take_wide(logged, array, into, entry->bytes);
}

void redcc_access_log_take(struct access_log *logged, const redcc_entry *first,
                           const redcc_entry *end) {
    assert(first <= end);
    for (const redcc_entry *entry = first; entry != end; entry++) {
        if (entry->array != REDCC_END_OF_ITERATION) {
            if (entry->bytes)
                take_touch(logged, entry);
            continue;
        }
        close_iteration(logged, &logged->leading);
        if (logged->further.item)
            close_iteration(logged, &logged->further);
        logged->iterations++;
    }
}
