/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/copies.h"

#include "base/memory.h"
#include "plan/elements.h"
#include "plan/plan.h"

#include <assert.h>

static const struct element_rule *rule_of(const redcc_array *array) {
    const struct element_rule *rule = redcc_element_rule(array->operation, array->type);
    return rule && rule->size == array->element ? rule : NULL;
}

static int copies_needed(const struct plan *plan) {
    switch (plan->method->copies) {
    case COPY_WHOLE:
    case COPY_TOUCHED:
        return plan->threads;
    case COPY_TEAM:
        return plan->teams.count - 1;
    case COPY_SHARE:
        return plan->parameter;
    case COPY_LATER:
        return plan->threads == 1 ? 1 : plan->parameter - 1;
    case COPY_NONE:
        break;
    }
    return 0;
}

bool redcc_copies_begin(struct plan *plan, const redcc_array *arrays) {
    struct copies *copies = &plan->copies;
    const int count = copies_needed(plan);
    assert(count >= 0);
    *copies = (struct copies){.count = count, .array_count = plan->array_count, .arrays = arrays};
    if (count == 0)
        return true;
    copies->copy = redcc_memory_alloc_zeroed((size_t)count, sizeof *copies->copy);
    bool enough = copies->copy != NULL;
    for (int c = 0; enough && c < count; c++) {
        struct copy *copy = &copies->copy[c];
        copy->memory = redcc_memory_alloc_zeroed(plan->array_count, sizeof *copy->memory);
        copy->held = redcc_memory_alloc_zeroed(plan->array_count, sizeof *copy->held);
        enough = copy->memory && copy->held;
    }
    return enough;
}

void redcc_copies_end(struct copies *copies) {
    for (int c = 0; copies->copy && c < copies->count; c++) {
        struct copy *copy = &copies->copy[c];
        for (uint32_t group = 0; copy->memory && group < copies->array_count; group++)
            redcc_memory_free(copy->memory[group]);
        redcc_memory_free(copy->memory);
        redcc_memory_free(copy->held);
    }
    redcc_memory_free(copies->copy);
    *copies = (struct copies){0};
}

bool redcc_copies_possible(const struct partition *partition, const struct range *touched) {
    if (partition->mixed)
        return false;
    for (uint32_t array = 0; array < partition->array_count; array++) {
        const redcc_array *it = &partition->arrays[array];
        const struct element_rule *rule = rule_of(it);
        if (!rule || it->unit % rule->size != 0)
            return false;
        const struct range range = touched[array];
        if (!redcc_leads_group(partition, array) || redcc_range_empty(range))
            continue;
        if ((range.end - range.first) % rule->size != 0 ||
            (range.first - partition->base[array]) % rule->size != 0)
            return false;
    }
    return true;
}

size_t redcc_copy_bytes(const struct partition *partition, const struct range *touched) {
    size_t bytes = 0;
    for (uint32_t group = 0; group < partition->array_count; group++)
        if (redcc_leads_group(partition, group) && !redcc_range_empty(touched[group]))
            bytes += touched[group].end - touched[group].first;
    return bytes;
}

int redcc_copy_of(const struct plan *plan, int thread) {
    assert(0 <= thread && thread < plan->threads);
    switch (plan->method->copies) {
    case COPY_WHOLE:
    case COPY_TOUCHED:
        return thread;
    case COPY_TEAM:
        return redcc_team_of(plan->threads, plan->teams.count, thread) - 1;
    case COPY_SHARE:
    case COPY_LATER:
    case COPY_NONE:
        break;
    }
    return -1;
}

int redcc_copy_of_share(const struct plan *plan, uint32_t share) {
    if (plan->method->copies == COPY_SHARE || share == 0)
        return plan->method->copies == COPY_SHARE ? (int)share : -1;
    return plan->threads == 1 ? 0 : (int)share - 1;
}

/* The copies of which `thread` is the first user are those from *first to before *end. */
static void copies_begun_by(const struct plan *plan, int thread, int *first, int *end) {
    if (plan->method->copies == COPY_SHARE) {
        const uint32_t count = (uint32_t)plan->copies.count;
        *first = (int)redcc_part_first(count, plan->threads, thread);
        *end = (int)redcc_part_first(count, plan->threads, thread + 1);
        return;
    }
    if (plan->method->copies == COPY_LATER) {
        /* The first share of the loop has no copy, so share s has copy s - 1. A single thread uses
         * copy 0 for all later shares. */
        const uint32_t shares = (uint32_t)plan->parameter;
        const uint32_t begin = redcc_part_first(shares, plan->threads, thread);
        *first = plan->threads == 1 || begin == 0 ? 0 : (int)begin - 1;
        *end =
            plan->threads == 1 ? 1 : (int)redcc_part_first(shares, plan->threads, thread + 1) - 1;
        return;
    }
    *first = redcc_copy_of(plan, thread);
    *end = *first + 1;
    const int team = redcc_team_of(plan->threads, plan->teams.count, thread);
    const bool leads = plan->teams.count == 1 ||
                       thread == redcc_team_first(plan->threads, plan->teams.count, team);
    if (*first < 0 || !leads)
        *first = *end = 0;
}

static bool take_copy(struct plan *plan, struct copy *copy, const struct range *seen,
                      const uintptr_t *base) {
    for (uint32_t group = 0; group < plan->array_count; group++) {
        if (plan->group_of[group] != group)
            continue;
        struct offsets held = plan->touched[group];
        if (plan->method->copies == COPY_TOUCHED) {
            held.first = (ptrdiff_t)(seen[group].first - base[group]);
            held.end = (ptrdiff_t)(seen[group].end - base[group]);
            if (redcc_range_empty(seen[group]))
                held = (struct offsets){0, 0};
        }
        if (held.first >= held.end)
            continue;
        assert(plan->touched[group].first <= held.first && held.end <= plan->touched[group].end);
        copy->held[group] = held;
        copy->memory[group] = redcc_memory_alloc((size_t)(held.end - held.first));
        if (!copy->memory[group])
            return false;
    }
    return true;
}

bool redcc_copies_take(struct plan *plan, int thread, const struct range *seen,
                       const uintptr_t *base) {
    assert(0 <= thread && thread < plan->threads);
    int first, end;
    copies_begun_by(plan, thread, &first, &end);
    assert(0 <= first && end <= plan->copies.count);
    for (int c = first; c < end; c++)
        if (!take_copy(plan, &plan->copies.copy[c], seen, base))
            return false;
    return true;
}

/* Divides `count` elements into `parts` parts. Part number `part` has the elements from number
 * *first to before number *end. */
static void share(size_t count, int part, int parts, size_t *first, size_t *end) {
    *first = (size_t)redcc_share((redcc_int)count, parts, part);
    *end = (size_t)redcc_share((redcc_int)count, parts, part + 1);
}

/* Sets part number `part` of `parts` of the copy to the neutral element. */
static void fill_copy(const struct plan *plan, const struct copy *copy, int part, int parts) {
    for (uint32_t group = 0; group < plan->array_count; group++) {
        if (!copy->memory[group])
            continue;
        const struct element_rule *rule = rule_of(&plan->copies.arrays[group]);
        const size_t bytes = (size_t)(copy->held[group].end - copy->held[group].first);
        size_t first, end;
        share(bytes / rule->size, part, parts, &first, &end);
        rule->fill(copy->memory[group] + first * rule->size, end - first);
    }
}

void redcc_copies_fill(const struct plan *plan, int thread) {
    if (plan->copies.is_neutral)
        return;
    if (plan->method->copies == COPY_TEAM) { /* all threads of the team fill it together */
        const int team = redcc_team_of(plan->threads, plan->teams.count, thread);
        const int first = redcc_team_first(plan->threads, plan->teams.count, team);
        if (team > 0)
            fill_copy(plan, &plan->copies.copy[team - 1], thread - first,
                      redcc_team_first(plan->threads, plan->teams.count, team + 1) - first);
        return;
    }
    int first, end;
    copies_begun_by(plan, thread, &first, &end);
    for (int c = first; c < end; c++)
        fill_copy(plan, &plan->copies.copy[c], 0, 1);
}

/* Merges one copy after the other into this thread's block of the group, as in figure 9 (b) of the
 * paper (docs/methods.md). */
static void merge_copy_by_copy(const struct plan *plan, uint32_t group,
                               const struct element_rule *rule, char *base, struct offsets block) {
    for (int c = 0; c < plan->copies.count; c++) {
        const struct copy *copy = &plan->copies.copy[c];
        if (!copy->memory[group])
            continue;
        const struct offsets held = copy->held[group];
        const ptrdiff_t first = block.first > held.first ? block.first : held.first;
        const ptrdiff_t end = block.end < held.end ? block.end : held.end;
        if (first < end)
            rule->merge(base + first, copy->memory[group] + (first - held.first),
                        (size_t)(end - first) / rule->size, plan->copies.arrays[group].limit);
    }
}

/* Merges element by element: combines each element with its values in all copies, in the order of
 * the copies (figure 9 (a) of the paper, docs/paper.md). Each copy must contain the whole block.
 * With COPY_LATER, also makes the block neutral again in all copies. */
static void merge_element_by_element(const struct plan *plan, uint32_t group,
                                     const struct element_rule *rule, char *base,
                                     struct offsets block) {
    enum { AT_ONCE = 64 };
    void *from[AT_ONCE];
    for (int begin = 0; begin < plan->copies.count; begin += AT_ONCE) {
        int count = 0;
        for (; count < AT_ONCE && begin + count < plan->copies.count; count++) {
            const struct copy *copy = &plan->copies.copy[begin + count];
            assert(copy->held[group].first <= block.first && block.end <= copy->held[group].end);
            from[count] = copy->memory[group] + (block.first - copy->held[group].first);
        }
        const size_t elements = (size_t)(block.end - block.first) / rule->size;
        const redcc_word limit = plan->copies.arrays[group].limit;
        if (plan->method->copies == COPY_LATER)
            rule->drain(base + block.first, from, (size_t)count, elements, limit);
        else
            rule->merge_all(base + block.first, (const void *const *)from, (size_t)count, elements,
                            limit);
    }
}

void redcc_copies_merge(const struct plan *plan, int thread, void *const *bases) {
    assert(0 <= thread && thread < plan->threads);
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct offsets touched = plan->touched[group];
        if (plan->group_of[group] != group || touched.first >= touched.end)
            continue;
        const struct element_rule *rule = rule_of(&plan->copies.arrays[group]);
        assert(rule); /* redcc_copies_possible ensures this */
        size_t first, end;
        share((size_t)(touched.end - touched.first) / rule->size, thread, plan->threads, &first,
              &end);
        const struct offsets block = {touched.first + (ptrdiff_t)(first * rule->size),
                                      touched.first + (ptrdiff_t)(end * rule->size)};
        if (first == end)
            continue;
        if (plan->method->copies == COPY_LATER ||
            (plan->method->copies == COPY_WHOLE && plan->parameter == 'a'))
            merge_element_by_element(plan, group, rule, bases[group], block);
        else
            merge_copy_by_copy(plan, group, rule, bases[group], block);
    }
}
