/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ownership/sweep.h"

#include "base/memory.h"

#include <assert.h>

bool redcc_sweep_begin(struct sweep *sweep, const struct partition *partition, struct range *seen) {
    const uint32_t owners = partition->owners;
    assert(owners >= 1 && seen);
    *sweep = (struct sweep){.partition = partition, .seen = seen};
    sweep->window = redcc_memory_alloc_zeroed(partition->array_count, sizeof *sweep->window);
    sweep->stamp = redcc_memory_alloc_zeroed(owners, sizeof *sweep->stamp);
    sweep->list = redcc_memory_alloc(owners * sizeof *sweep->list);
    return redcc_summary_begin(&sweep->summary, owners) && sweep->window && sweep->stamp &&
           sweep->list;
}

void redcc_sweep_end(struct sweep *sweep) {
    redcc_summary_end(&sweep->summary);
    redcc_memory_free(sweep->window);
    redcc_memory_free(sweep->stamp);
    redcc_memory_free(sweep->list);
    *sweep = (struct sweep){0};
}

static void look_at_owner(struct sweep *sweep, uint32_t owner) {
    const struct partition *partition = sweep->partition;
    sweep->current = owner;
    for (uint32_t array = 0; array < partition->array_count; array++) {
        const uint32_t group = partition->group_of[array];
        const uintptr_t *cut = redcc_cuts(partition, group);
        const struct range seen = sweep->seen[group];
        const uintptr_t first = cut[owner] > seen.first ? cut[owner] : seen.first;
        const uintptr_t end = cut[owner + 1] < seen.end ? cut[owner + 1] : seen.end;
        sweep->window[array].first = (const char *)first;
        sweep->window[array].size = end > first ? end - first : 0;
    }
}

static void list_owner(struct sweep *sweep, uint32_t owner) {
    if (sweep->stamp[owner] == sweep->iteration)
        return;
    sweep->stamp[owner] = sweep->iteration;
    sweep->list[sweep->listed++] = owner;
}

void redcc_sweep_take_owner(struct sweep *sweep, uint32_t owner) {
    assert(owner < sweep->partition->owners);
    if (!sweep->touched || (!sweep->mixed && owner == sweep->current)) {
        sweep->touched = true;
        sweep->current = owner;
        return;
    }
    if (!sweep->mixed) {
        sweep->mixed = true;
        sweep->listed = 0;
        sweep->iteration++;
        list_owner(sweep, sweep->current);
    }
    list_owner(sweep, owner);
    sweep->current = owner;
}

/* Adds a touch that is not within the window. It touches another owner, several owners, or
 * addresses beyond the range touched so far. */
static void take_stray(struct sweep *sweep, uint32_t group, uintptr_t address, uint32_t bytes) {
    const struct range touch = {address, address + bytes};
    sweep->seen[group] = redcc_range_union(sweep->seen[group], touch);
    const uint32_t first = redcc_owner_of(sweep->partition, group, address);
    const uint32_t last = redcc_owner_of(sweep->partition, group, address + bytes - 1);
    for (uint32_t owner = first; owner <= last; owner++)
        redcc_sweep_take_owner(sweep, owner);
    look_at_owner(sweep, last);
}

static void sort_few(uint32_t *list, uint32_t count) {
    for (uint32_t i = 1; i < count; i++) {
        const uint32_t owner = list[i];
        uint32_t place = i;
        for (; place > 0 && list[place - 1] > owner; place--)
            list[place] = list[place - 1];
        list[place] = owner;
    }
}

static void sort_list(struct sweep *sweep) {
    if (sweep->listed <= 16) {
        sort_few(sweep->list, sweep->listed);
        return;
    }
    /* the list is long: it is replaced by all stamped owners, in ascending order */
    uint32_t count = 0;
    for (uint32_t owner = 0; owner < sweep->partition->owners; owner++)
        if (sweep->stamp[owner] == sweep->iteration)
            sweep->list[count++] = owner;
}

static void add_last_set(struct sweep *sweep) {
    if (sweep->in_last_set > 0 &&
        !redcc_summary_add(&sweep->summary, sweep->last_set, sweep->in_last_set))
        sweep->failed = true;
    sweep->in_last_set = 0;
}

static void add_iterations(struct sweep *sweep, uint32_t set, redcc_int count) {
    if (set != sweep->last_set) {
        add_last_set(sweep);
        sweep->last_set = set;
    }
    sweep->in_last_set += count;
    sweep->done += count;
}

void redcc_sweep_end_iteration(struct sweep *sweep) {
    assert(!sweep->mixed || sweep->listed >= 2);
    uint32_t set = sweep->touched ? 1 + sweep->current : 0;
    if (sweep->mixed) {
        sort_list(sweep);
        if (!redcc_sets_intern(&sweep->summary.sets, sweep->list, sweep->listed, &set))
            sweep->failed = true;
    }
    add_iterations(sweep, set, 1);
    sweep->touched = sweep->mixed = false;
}

void redcc_sweep_open_block(struct sweep *sweep, redcc_int origin) {
    assert(origin >= 0 && (sweep->failed || sweep->current < sweep->partition->owners));
    sweep->done = sweep->in_last_set = 0;
    sweep->touched = sweep->mixed = false;
    look_at_owner(sweep, sweep->current);
    if (!redcc_summary_open_block(&sweep->summary, origin))
        sweep->failed = true;
}

void redcc_sweep_take_window(struct sweep *sweep, redcc_int alike, bool inside) {
    assert(alike >= 0);
    if (sweep->failed)
        return;
    if (alike > 0)
        add_iterations(sweep, 1 + sweep->current, alike);
    if (inside)
        sweep->touched = true;
}

void redcc_sweep_take(struct sweep *sweep, const redcc_entry *first, const redcc_entry *end) {
    for (const redcc_entry *entry = first; entry != end && !sweep->failed; entry++) {
        assert(entry->array < sweep->partition->array_count ||
               entry->array == REDCC_END_OF_ITERATION);
        if (entry->array == REDCC_END_OF_ITERATION) {
            redcc_sweep_end_iteration(sweep);
            continue;
        }
        const redcc_owner window = sweep->window[entry->array];
        const redcc_size into = (uintptr_t)entry->address - (uintptr_t)window.first;
        if (into < window.size && entry->bytes <= window.size - into && entry->bytes)
            sweep->touched = true;
        else if (entry->bytes)
            take_stray(sweep, sweep->partition->group_of[entry->array], (uintptr_t)entry->address,
                       entry->bytes);
    }
}

bool redcc_sweep_close_block(struct sweep *sweep, redcc_int expected) {
    if (!sweep->failed)
        add_last_set(sweep);
    const bool all = !sweep->failed && sweep->done == expected && !sweep->touched;
    assert(!all || sweep->summary.block[sweep->summary.block_count - 1].count == expected);
    return all;
}

void redcc_sweep_count(const struct sweep *sweep, redcc_int *executed) {
    const struct summary *summary = &sweep->summary;
    const struct sets *sets = &summary->sets;
    for (size_t b = 0; b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; s < block->span_end; s++) {
            const uint32_t set = summary->span[s].set;
            const redcc_int count = redcc_span_count(summary, block, s);
            for (size_t m = sets->start[set]; m < sets->start[set + 1]; m++)
                executed[sets->member[m]] += count;
        }
    }
}

/* The number of owners in the set if every `each` consecutive owners are merged. */
static uint32_t count_joined(const struct sets *sets, uint32_t set, uint32_t each) {
    uint32_t count = 0;
    for (size_t m = sets->start[set]; m < sets->start[set + 1]; m++)
        count += m == sets->start[set] || sets->member[m] / each != sets->member[m - 1] / each;
    return count;
}

redcc_int redcc_sweep_executed(const struct sweep *sweep, uint32_t each) {
    assert(each >= 1 && sweep->partition->owners % each == 0);
    const struct summary *summary = &sweep->summary;
    redcc_int executed = 0;
    for (size_t b = 0; b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; s < block->span_end; s++)
            executed += redcc_span_count(summary, block, s) *
                        count_joined(&summary->sets, summary->span[s].set, each);
    }
    return executed;
}
