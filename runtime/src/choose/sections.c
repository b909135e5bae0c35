/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/sections.h"

#include "base/memory.h"
#include "plan/elements.h"
#include "plan/share_count.h"

#include <assert.h>

/* ---- how many shares ------------------------------------------------------------------------- */

static struct range range_of(redcc_extent section) {
    return (struct range){(uintptr_t)section.first, (uintptr_t)section.end};
}

static bool are_alike(const redcc_array *a, const redcc_array *b) {
    return a->type == b->type && a->operation == b->operation && a->element == b->element &&
           a->limit == b->limit;
}

/* Do two arrays have the same section, type and operation? Then they share one private copy. */
static bool are_one(const redcc_loop *loop, const redcc_extent *sections, uint32_t a, uint32_t b) {
    return sections[a].first == sections[b].first && sections[a].end == sections[b].end &&
           are_alike(&loop->arrays[a], &loop->arrays[b]);
}

/* The first array that uses the same private copy as this array; it may be this array itself. */
static uint32_t first_of(const redcc_loop *loop, const redcc_extent *sections, uint32_t array) {
    uint32_t first = 0;
    while (first < array && !are_one(loop, sections, first, array))
        first++;
    return first;
}

/* The size of a copy in bytes; 0: no copy is possible. */
static size_t copy_bytes(const redcc_loop *loop, void *const *bases, const redcc_extent *sections) {
    size_t bytes = 0;
    for (uint32_t a = 0; a < loop->array_count; a++) {
        const redcc_array *array = &loop->arrays[a];
        const struct element_rule *rule = redcc_element_rule(array->operation, array->type);
        const struct range range = range_of(sections[a]);
        if (!rule || rule->size != array->element || range.first >= range.end ||
            (range.first - (uintptr_t)bases[a]) % rule->size != 0)
            return 0;
        if (first_of(loop, sections, a) < a)
            continue;
        for (uint32_t b = 0; b < a; b++)
            if (redcc_ranges_overlap(range, range_of(sections[b])))
                return 0;
        bytes += redcc_range_size(range);
    }
    return bytes;
}

int redcc_sections_shares(const redcc_loop *loop, redcc_int trip, void *const *bases,
                          const redcc_extent *sections, size_t memory_limit) {
    const redcc_size bytes = copy_bytes(loop, bases, sections);
    return bytes > 0 ? redcc_share_count(loop, trip, redcc_updates(loop, trip), bytes, memory_limit)
                     : 0;
}

/* ---- how many threads ------------------------------------------------------------------------ */

/* Seconds. In an execution that takes longer, waking the threads is a small part. */
#define WORTH_WAKING 0.3e-3
enum { FEW_CALLS = 1024, FIRST_SIZE = 16384 };

static unsigned size_of(redcc_int trip) {
    unsigned size = 0;
    while (size < SECTION_SIZES - 1 && trip > FIRST_SIZE) {
        trip /= 2;
        size++;
    }
    return size;
}

int redcc_sections_threads(struct sections *it, redcc_int trip, int threads) {
    const unsigned size = size_of(trip);
    struct paired_timing *pace = &it->pace[size];
    if (threads < 2)
        return 1;
    const int winner = redcc_paired_winner(pace);
    if (pace->timed > 0 && pace->least[0] * (double)trip > WORTH_WAKING)
        return threads;
    if (winner < 0)
        return redcc_arm_of(pace->timed) == 0 ? threads : 1;
    if (++it->rest[size] >= FEW_CALLS) {
        it->rest[size] = 0;
        *pace = (struct paired_timing){0};
    }
    return winner == 0 ? threads : 1;
}

void redcc_sections_timed(struct sections *it, redcc_int trip, int threads, double seconds) {
    const unsigned size = size_of(trip);
    struct paired_timing *pace = &it->pace[size];
    const int arm = threads < 2;
    if (redcc_paired_winner(pace) >= 0)
        return;
    if (!it->met[size][arm]) {
        it->met[size][arm] = true;
        return;
    }
    if (arm != redcc_arm_of(pace->timed)) { /* `arm` is not the next one: one thread was not tried,
                                               because executions took long */
        if (arm == 1 || seconds / (double)trip > pace->least[0])
            return;
        *pace = (struct paired_timing){0};
    }
    redcc_paired_note(pace, seconds / (double)trip);
}

/* ---- the plan -------------------------------------------------------------------------------- */

static bool fits(const struct plan *plan, const struct call *call) {
    const redcc_loop *loop = call->request.loop;
    if (!plan || plan->trip != call->request.trip || plan->threads != call->threads ||
        plan->parameter != call->parameter)
        return false;
    for (uint32_t a = 0; a < loop->array_count; a++) {
        const uint32_t group = plan->group_of[a];
        const uintptr_t base = (uintptr_t)call->request.bases[group];
        const struct range section = range_of(call->request.sections[a]);
        if (group != first_of(loop, call->request.sections, a) ||
            plan->touched[group].first != (ptrdiff_t)(section.first - base) ||
            plan->touched[group].end != (ptrdiff_t)(section.end - base) ||
            plan->shift[a] != (ptrdiff_t)((uintptr_t)call->request.bases[a] - base))
            return false;
    }
    return true;
}

static bool prepare(struct plan *plan, const struct call *call, const uintptr_t *base) {
    const struct evidence evidence = {.threads = call->threads, .trip = call->request.trip};
    for (int thread = 0; thread < call->threads; thread++)
        if (!plan->method->prepare(plan, &evidence, thread) ||
            !redcc_copies_take(plan, thread, NULL, base))
            return false;
    redcc_plan_finish(plan);
    return true;
}

static struct plan *build(const struct call *call) {
    const redcc_loop *loop = call->request.loop;
    struct partition partition;
    struct plan *plan = NULL;
    struct range *touched = redcc_memory_alloc(loop->array_count * sizeof *touched);
    if (redcc_partition_begin(&partition, loop, call->request.bases, 1) && touched) {
        redcc_partition_in_one(&partition);
        for (uint32_t a = 0; a < loop->array_count; a++) {
            partition.group_of[a] = first_of(loop, call->request.sections, a);
            touched[a] = range_of(call->request.sections[a]);
        }
        plan = redcc_plan_new(call->method, call->parameter, call->threads, call->request.trip,
                              &partition, touched, false);
        if (plan && !prepare(plan, call, partition.base)) {
            redcc_plan_free(plan);
            plan = NULL;
        }
    }
    redcc_partition_end(&partition);
    redcc_memory_free(touched);
    return plan;
}

struct plan *redcc_sections_plan(struct sections *it, const struct call *call) {
    struct plan **plan = &it->plan[call->threads > 1];
    if (!fits(*plan, call)) {
        redcc_plan_free(*plan);
        *plan = build(call);
    }
    return *plan;
}

void redcc_sections_end(struct sections *it) {
    for (int p = 0; p < 2; p++) {
        redcc_plan_free(it->plan[p]);
        it->plan[p] = NULL;
    }
}
