/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/plan.h"

#include "base/memory.h"
#include "ownership/graph/divide.h"
#include "ownership/owner_map.h"
#include "plan/length.h"
#include "plan/rounding.h"

#include <assert.h>

int redcc_team_of(int threads, int teams, int thread) {
    assert(1 <= teams && teams <= threads && 0 <= thread && thread < threads);
    int team = (int)((long)thread * teams / threads);
    while (thread >= redcc_team_first(threads, teams, team + 1))
        team++;
    return team;
}

static bool alloc_tables(struct plan *plan, const redcc_array *arrays_of_loop) {
    const size_t arrays = plan->array_count;
    plan->group_of = redcc_memory_alloc(arrays * sizeof *plan->group_of);
    plan->shift = redcc_memory_alloc(arrays * sizeof *plan->shift);
    plan->touched = redcc_memory_alloc_zeroed(arrays, sizeof *plan->touched);
    plan->bound = redcc_memory_alloc_zeroed(arrays * (plan->owners + 1), sizeof *plan->bound);
    plan->schedule = redcc_memory_alloc_zeroed(plan->schedules, sizeof *plan->schedule);
    plan->teams.stages =
        redcc_memory_alloc_zeroed((size_t)plan->teams.count, sizeof *plan->teams.stages);
    plan->teams.barrier =
        redcc_memory_alloc_zeroed((size_t)plan->teams.count, sizeof *plan->teams.barrier);
    const bool flagged = plan->method->flags != NULL;
    if (flagged)
        plan->flags = redcc_flags_new(plan->method->flags(plan->owners));
    return (plan->flags || !flagged) && plan->group_of && plan->shift && plan->touched &&
           plan->bound && plan->schedule && plan->teams.stages && plan->teams.barrier &&
           redcc_copies_begin(plan, arrays_of_loop);
}

static uintptr_t within(uintptr_t address, struct range range) {
    if (address < range.first)
        return range.first;
    return address > range.end ? range.end : address;
}

static void record_groups(struct plan *plan, const struct partition *partition,
                          const struct range *touched) {
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = partition->group_of[array];
        const uintptr_t base = partition->base[group];
        plan->group_of[array] = group;
        plan->shift[array] = (ptrdiff_t)(partition->base[array] - base);
        if (group != array || redcc_range_empty(touched[group]))
            continue;
        plan->touched[group].first = (ptrdiff_t)(touched[group].first - base);
        plan->touched[group].end = (ptrdiff_t)(touched[group].end - base);
        assert(partition->group_of[group] == group);
        const uintptr_t *cut = redcc_cuts(partition, group);
        for (uint32_t owner = 0; owner <= plan->owners; owner++)
            plan->bound[(size_t)group * (plan->owners + 1) + owner] =
                (ptrdiff_t)(within(cut[owner], touched[group]) - base);
    }
}

struct plan *redcc_plan_new(const struct method *method, int parameter, int threads, redcc_int trip,
                            const struct partition *partition, const struct range *touched,
                            bool compensated) {
    assert(threads >= 1 && trip >= 0 && partition->owners >= 1 && method->prepare);
    struct plan *plan = redcc_memory_alloc_zeroed(1, sizeof *plan);
    if (!plan)
        return NULL;
    plan->method = method;
    plan->parameter = parameter;
    plan->threads = threads;
    plan->teams.count = method->teams ? method->teams(threads, parameter) : 1;
    plan->trip = trip;
    plan->array_count = partition->array_count;
    plan->owners = partition->owners;
    plan->schedules = method->steals ? plan->owners : (uint32_t)threads;
    plan->round = 1;
    if (!alloc_tables(plan, partition->arrays)) {
        redcc_plan_free(plan);
        return NULL;
    }
    record_groups(plan, partition, touched);
    if (compensated && !redcc_rounding_new(plan, partition->arrays)) {
        redcc_plan_free(plan);
        return NULL;
    }
    return plan;
}

bool redcc_plan_take_map(struct plan *plan, const struct partition *partition,
                         struct divide *divide) {
    plan->map.of = redcc_memory_alloc_zeroed(plan->array_count, sizeof *plan->map.of);
    if (!plan->map.of)
        return false;
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct group_units *units = &divide->units.of[group];
        if (units->count > 0)
            plan->map.of[group] =
                (struct group_map){(ptrdiff_t)(units->first - partition->base[group]), units->begin,
                                   units->count, units->bytes};
    }
    assert(divide->owner && !plan->map.owner);
    plan->map.owner = divide->owner;
    divide->owner = NULL;
    return true;
}

void redcc_plan_take_votes(struct plan *plan, struct partition *partition,
                           const struct range *touched) {
    assert(!plan->map.owner);
    if (!partition->map.owner)
        return;
    redcc_owner_map_extend(partition, touched);
    plan->map = partition->map;
    partition->map = (struct owner_map){0};
}

void redcc_plan_keep_owners(struct plan *plan, struct partition *partition) {
    assert(plan->trip > 0 && plan->array_count == partition->array_count);
    const double share = (double)plan->length / (double)plan->trip;
    bool stands = partition->share == 0 || share <= partition->share + partition->share / 16;
    for (uint32_t array = 0; array < partition->array_count; array++)
        stands = stands && redcc_leads_group(partition, array);
    partition->map = plan->map;
    plan->map = (struct owner_map){0};
    if (partition->share == 0 || !stands)
        partition->share = stands ? share : 0;
}

void redcc_plan_free(struct plan *plan) {
    if (!plan)
        return;
    for (uint32_t s = 0; plan->schedule && s < plan->schedules; s++)
        redcc_schedule_end(&plan->schedule[s]);
    redcc_copies_end(&plan->copies);
    redcc_rounding_free(plan);
    redcc_memory_free(plan->group_of);
    redcc_memory_free(plan->shift);
    redcc_memory_free(plan->touched);
    redcc_memory_free(plan->bound);
    redcc_owner_map_end(&plan->map);
    redcc_memory_free(plan->schedule);
    redcc_memory_free(plan->teams.stages);
    redcc_memory_free(plan->teams.barrier);
    redcc_memory_free(plan->flags);
    redcc_memory_free(plan);
}

/* The lowest stage among the chunks of threads `first` to `end` - 1 that are not renumbered yet;
 * UINT32_MAX if there are none. at[end - first] has the index of each thread's first such chunk. */
static uint32_t next_stage(const struct plan *plan, int first, int end, const size_t *at) {
    uint32_t lowest = UINT32_MAX;
    for (int thread = first; thread < end; thread++) {
        const struct schedule *schedule = &plan->schedule[thread];
        if (at[thread - first] < schedule->chunk_count &&
            schedule->chunk[at[thread - first]].stage < lowest)
            lowest = schedule->chunk[at[thread - first]].stage;
    }
    return lowest;
}

static void number_stages(struct plan *plan, int team) {
    enum { AT_ONCE = 256 };
    const int first = redcc_team_first(plan->threads, plan->teams.count, team);
    const int end = redcc_team_first(plan->threads, plan->teams.count, team + 1);
    size_t few[AT_ONCE] = {0};
    size_t *at = few;
    if (end - first > AT_ONCE)
        at = redcc_memory_alloc_zeroed((size_t)(end - first), sizeof *at);
    plan->teams.stages[team] = 0;
    for (uint32_t stage; at && (stage = next_stage(plan, first, end, at)) != UINT32_MAX;) {
        for (int thread = first; thread < end; thread++) {
            const struct schedule *schedule = &plan->schedule[thread];
            size_t *c = &at[thread - first];
            for (; *c < schedule->chunk_count && schedule->chunk[*c].stage == stage; ++*c)
                schedule->chunk[*c].stage = plan->teams.stages[team];
        }
        plan->teams.stages[team]++;
    }
    if (!at) /* out of memory: the numbers stay as they are, including those of empty stages */
        for (int thread = first; thread < end; thread++) {
            const struct schedule *schedule = &plan->schedule[thread];
            const size_t count = schedule->chunk_count;
            if (count && schedule->chunk[count - 1].stage + 1 > plan->teams.stages[team])
                plan->teams.stages[team] = schedule->chunk[count - 1].stage + 1;
        }
    if (at != few)
        redcc_memory_free(at);
}

#ifndef NDEBUG
/* Are all copies, flags and waits of the schedule in range? */
static bool names_what_is_there(const struct plan *plan, const struct schedule *schedule) {
    const uint32_t flags = plan->flags ? plan->method->flags(plan->owners) : 0;
    const uint32_t copies = plan->method->copies == COPY_SHARE   ? (uint32_t)plan->copies.count
                            : plan->method->copies == COPY_LATER ? (uint32_t)plan->parameter
                                                                 : 1;
    for (size_t c = 0; c < schedule->chunk_count; c++) {
        const struct chunk *chunk = &schedule->chunk[c];
        if (chunk->run_begin > chunk->run_end || chunk->flag > flags || chunk->copy >= copies ||
            chunk->wait_begin > chunk->wait_end || chunk->wait_end > schedule->wait_count)
            return false;
    }
    for (uint32_t w = 0; w < schedule->wait_count; w++)
        if (schedule->wait[w] >= flags)
            return false;
    return true;
}
#endif

void redcc_plan_finish(struct plan *plan) {
    for (uint32_t s = 0; s < plan->schedules; s++)
        assert(names_what_is_there(plan, &plan->schedule[s]));
    for (int team = 0; team < plan->teams.count && !plan->method->steals; team++)
        number_stages(plan, team);
    if (plan->method->steals)
        plan->teams.stages[0] = 1; /* stealable schedules have no order */
    plan->executed = 0;
    for (uint32_t s = 0; s < plan->schedules; s++)
        plan->executed += plan->schedule[s].iterations;
    plan->length = redcc_plan_length(plan);
    assert(plan->length <= plan->executed);
}

size_t redcc_plan_bytes(const struct plan *plan) {
    size_t bytes = redcc_memory_size(plan) + redcc_memory_size(plan->bound) +
                   redcc_memory_size(plan->schedule) + redcc_memory_size(plan->teams.barrier) +
                   redcc_memory_size(plan->flags) + redcc_memory_size(plan->map.owner) +
                   redcc_memory_size(plan->map.of) + redcc_rounding_bytes(plan);
    for (uint32_t s = 0; s < plan->schedules; s++)
        bytes +=
            redcc_memory_size(plan->schedule[s].run) + redcc_memory_size(plan->schedule[s].packed) +
            redcc_memory_size(plan->schedule[s].chunk) + redcc_memory_size(plan->schedule[s].wait);
    for (int c = 0; c < plan->copies.count; c++)
        for (uint32_t group = 0; group < plan->array_count; group++)
            bytes += redcc_memory_size(plan->copies.copy[c].memory[group]);
    return bytes;
}

uint32_t redcc_plan_stages(const struct plan *plan) {
    assert(plan->teams.count >= 1);
    uint32_t most = 0;
    for (int team = 0; team < plan->teams.count; team++)
        most = plan->teams.stages[team] > most ? plan->teams.stages[team] : most;
    return most;
}
