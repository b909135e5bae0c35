/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan.h"

#include "compensate.h"
#include "graph/divide.h"
#include "length.h"
#include "memory.h"
#include "settings.h"

#include <string.h>

int redcc_team_of(int threads, int teams, int thread) {
    int team = (int)((long)thread * teams / threads);
    while (thread >= redcc_team_first(threads, teams, team + 1))
        team++;
    return team;
}

static bool take_tables(struct plan *plan, const redcc_loop *loop) {
    const size_t arrays = plan->array_count;
    plan->key = redcc_memory_take(loop->key_count * sizeof *plan->key);
    plan->group_of = redcc_memory_take(arrays * sizeof *plan->group_of);
    plan->shift = redcc_memory_take(arrays * sizeof *plan->shift);
    plan->touched = redcc_memory_take_zeroed(arrays, sizeof *plan->touched);
    plan->bound = redcc_memory_take_zeroed(arrays * (plan->owners + 1), sizeof *plan->bound);
    plan->source = redcc_memory_take_zeroed(plan->source_count, sizeof *plan->source);
    plan->schedule = redcc_memory_take_zeroed(plan->schedules, sizeof *plan->schedule);
    plan->stages = redcc_memory_take_zeroed((size_t)plan->teams, sizeof *plan->stages);
    plan->team_barrier = redcc_memory_take_zeroed((size_t)plan->teams, sizeof *plan->team_barrier);
    const bool flagged = plan->method->flags != NULL;
    if (flagged)
        plan->flags = redcc_flags_new(plan->method->flags(plan->owners));
    return plan->key && (plan->flags || !flagged) && plan->group_of && plan->shift &&
           plan->touched && plan->bound && plan->source && plan->schedule && plan->stages &&
           plan->team_barrier && redcc_copies_begin(plan, loop->arrays);
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
        const uintptr_t *cut = redcc_cuts(partition, group);
        for (uint32_t owner = 0; owner <= plan->owners; owner++)
            plan->bound[(size_t)group * (plan->owners + 1) + owner] =
                (ptrdiff_t)(within(cut[owner], touched[group]) - base);
    }
}

static void record_sources(struct plan *plan, const struct request *request,
                           const struct range *sources) {
    for (uint32_t s = 0; s < plan->source_count; s++) {
        struct source_record *record = &plan->source[s];
        const uintptr_t anchor = (uintptr_t)request->known[s].first;
        record->known = request->known[s].end != NULL;
        record->anchored = anchor != 0;
        if (!redcc_range_empty(sources[s]))
            record->extent = (struct offsets){(ptrdiff_t)(sources[s].first - anchor),
                                              (ptrdiff_t)(sources[s].end - anchor)};
    }
}

struct plan *redcc_plan_new(const struct method *method, int parameter, int threads,
                            const struct request *request, const struct partition *partition,
                            const struct range *touched, const struct range *sources) {
    struct plan *plan = redcc_memory_take_zeroed(1, sizeof *plan);
    if (!plan)
        return NULL;
    const redcc_loop *loop = request->loop;
    plan->method = method;
    plan->parameter = parameter;
    plan->threads = threads;
    plan->teams = method->teams ? method->teams(threads, parameter) : 1;
    plan->trip = request->trip;
    plan->float_control = request->float_control;
    plan->array_count = loop->array_count;
    plan->source_count = loop->source_count;
    plan->owners = partition->owners;
    plan->schedules = method->spares ? plan->owners : (uint32_t)threads;
    plan->round = 1;
    if (!take_tables(plan, loop)) {
        redcc_plan_free(plan);
        return NULL;
    }
    if (loop->key_count)
        memcpy(plan->key, request->key, loop->key_count * sizeof *plan->key);
    record_groups(plan, partition, touched);
    record_sources(plan, request, sources);
    if (redcc_settings()->compensated && !redcc_lost_new(plan, loop->arrays)) {
        redcc_plan_free(plan);
        return NULL;
    }
    return plan;
}

bool redcc_plan_take_map(struct plan *plan, const struct partition *partition,
                         struct divide *divide) {
    plan->mapped = redcc_memory_take_zeroed(plan->array_count, sizeof *plan->mapped);
    if (!plan->mapped)
        return false;
    for (uint32_t group = 0; group < plan->array_count; group++) {
        const struct group_units *units = &divide->units.of[group];
        if (units->count > 0)
            plan->mapped[group] =
                (struct group_map){(ptrdiff_t)(units->first - partition->base[group]), units->begin,
                                   units->count, units->bytes};
    }
    plan->map = divide->owner;
    divide->owner = NULL;
    return true;
}

void redcc_plan_free(struct plan *plan) {
    if (!plan)
        return;
    for (uint32_t s = 0; plan->schedule && s < plan->schedules; s++)
        redcc_schedule_end(&plan->schedule[s]);
    redcc_copies_end(&plan->copies);
    redcc_lost_free(plan);
    redcc_memory_give(plan->key);
    redcc_memory_give(plan->group_of);
    redcc_memory_give(plan->shift);
    redcc_memory_give(plan->touched);
    redcc_memory_give(plan->bound);
    redcc_memory_give(plan->map);
    redcc_memory_give(plan->mapped);
    redcc_memory_give(plan->source);
    redcc_memory_give(plan->schedule);
    redcc_memory_give(plan->stages);
    redcc_memory_give(plan->team_barrier);
    redcc_memory_give(plan->flags);
    redcc_memory_give(plan);
}

/* The lowest stage >= `from` that some thread of the team has chunks in; UINT32_MAX: none. `at`
 * [threads] is how far each thread's chunks are numbered already. */
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
    const int first = redcc_team_first(plan->threads, plan->teams, team);
    const int end = redcc_team_first(plan->threads, plan->teams, team + 1);
    size_t few[AT_ONCE] = {0};
    size_t *at = few;
    if (end - first > AT_ONCE)
        at = redcc_memory_take_zeroed((size_t)(end - first), sizeof *at);
    plan->stages[team] = 0;
    for (uint32_t stage; at && (stage = next_stage(plan, first, end, at)) != UINT32_MAX;) {
        for (int thread = first; thread < end; thread++) {
            const struct schedule *schedule = &plan->schedule[thread];
            size_t *c = &at[thread - first];
            for (; *c < schedule->chunk_count && schedule->chunk[*c].stage == stage; ++*c)
                schedule->chunk[*c].stage = plan->stages[team];
        }
        plan->stages[team]++;
    }
    if (!at) /* no memory: as they came, the empty ones too */
        for (int thread = first; thread < end; thread++) {
            const struct schedule *schedule = &plan->schedule[thread];
            const size_t count = schedule->chunk_count;
            if (count && schedule->chunk[count - 1].stage + 1 > plan->stages[team])
                plan->stages[team] = schedule->chunk[count - 1].stage + 1;
        }
    if (at != few)
        redcc_memory_give(at);
}

void redcc_plan_finish(struct plan *plan) {
    for (int team = 0; team < plan->teams && !plan->method->spares; team++)
        number_stages(plan, team);
    if (plan->method->spares)
        plan->stages[0] = 1; /* whatever is executed when */
    plan->executed = 0;
    for (uint32_t s = 0; s < plan->schedules; s++)
        plan->executed += plan->schedule[s].iterations;
    plan->length = redcc_plan_length(plan);
}

static bool sources_fit(const struct plan *plan, const struct request *request,
                        struct range *sources) {
    for (uint32_t s = 0; s < plan->source_count; s++) {
        const struct source_record *record = &plan->source[s];
        const redcc_extent known = request->known[s];
        const uintptr_t anchor = (uintptr_t)known.first;
        if (record->known != (known.end != NULL) || record->anchored != (anchor != 0))
            return false;
        if (record->known && known.end - known.first != record->extent.end)
            return false;
        sources[s] = redcc_nowhere;
        if (record->extent.first < record->extent.end)
            sources[s] = (struct range){anchor + (uintptr_t)record->extent.first,
                                        anchor + (uintptr_t)record->extent.end};
    }
    return true;
}

static struct range place_of(const struct plan *plan, const struct request *request,
                             uint32_t array) {
    const struct offsets touched = plan->touched[array];
    if (plan->group_of[array] != array || touched.first >= touched.end)
        return redcc_nowhere;
    const uintptr_t base = (uintptr_t)request->bases[array];
    return (struct range){base + (uintptr_t)touched.first, base + (uintptr_t)touched.end};
}

/* Do the arrays lie to each other as when the plan was made: groups in one piece, and apart? And is
 * nothing read where they now are? */
static bool places_fit(const struct plan *plan, const struct request *request,
                       const struct range *sources) {
    for (uint32_t a = 0; a < plan->array_count; a++) {
        const uintptr_t group = (uintptr_t)request->bases[plan->group_of[a]];
        if ((ptrdiff_t)((uintptr_t)request->bases[a] - group) != plan->shift[a])
            return false;
        const struct range place = place_of(plan, request, a);
        for (uint32_t b = 0; b < a; b++)
            if (redcc_ranges_overlap(place, place_of(plan, request, b)))
                return false;
        for (uint32_t s = 0; s < plan->source_count; s++)
            if (redcc_ranges_overlap(place, sources[s]))
                return false;
    }
    return true;
}

bool redcc_plan_fits(const struct plan *plan, const struct request *request, int threads,
                     struct range *sources) {
    const size_t key_bytes = request->loop->key_count * sizeof *plan->key;
    return plan->trip == request->trip && plan->threads == threads &&
           redcc_float_control_equal(plan->float_control, request->float_control) &&
           (key_bytes == 0 || memcmp(plan->key, request->key, key_bytes) == 0) &&
           sources_fit(plan, request, sources) && places_fit(plan, request, sources);
}

bool redcc_plan_reusable(const struct request *request, const struct range *sources) {
    if (!(request->loop->flags & REDCC_VERIFIABLE))
        return false;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        const redcc_extent known = request->known[s];
        if (!known.end && !known.first && !redcc_range_empty(sources[s]))
            return false; /* where it would lie another time, nobody can say */
    }
    return true;
}

size_t redcc_plan_bytes(const struct plan *plan) {
    size_t bytes = redcc_memory_size(plan) + redcc_memory_size(plan->bound) +
                   redcc_memory_size(plan->schedule) + redcc_memory_size(plan->team_barrier) +
                   redcc_memory_size(plan->flags) + redcc_memory_size(plan->map) +
                   redcc_memory_size(plan->mapped) + redcc_lost_bytes(plan);
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
    uint32_t most = 0;
    for (int team = 0; team < plan->teams; team++)
        most = plan->stages[team] > most ? plan->stages[team] : most;
    return most;
}
