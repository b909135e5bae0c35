/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/length.h"

#include <assert.h>

#include "base/memory.h"

/* A thread's position in its schedule. */
struct place {
    size_t chunk;
    redcc_int time;
};

static redcc_int iterations_of(const struct schedule *schedule, const struct chunk *chunk) {
    struct run_reader reader = redcc_runs_of(schedule, chunk);
    redcc_int sum = 0;
    for (redcc_iterations run; redcc_runs_read(&reader, &run, 1) > 0;)
        sum += run.count_and_check / 2;
    return sum;
}

/* The makespan with work stealing, if whichever thread finishes first takes the next stealable
 * schedule. */
static redcc_int length_with_stealing(const struct plan *plan, struct place *place) {
    redcc_int length = 0;
    for (int thread = 0; thread < plan->threads; thread++)
        place[thread].time = plan->schedule[redcc_own_schedule(plan, thread)].iterations;
    for (uint32_t claimed = 0; claimed < plan->schedules - (uint32_t)plan->threads; claimed++) {
        struct place *first = place;
        for (int thread = 1; thread < plan->threads; thread++)
            first = place[thread].time < first->time ? &place[thread] : first;
        first->time += plan->schedule[redcc_stealable_schedule(plan, claimed)].iterations;
    }
    for (int thread = 0; thread < plan->threads; thread++)
        length = place[thread].time > length ? place[thread].time : length;
    return length;
}

static redcc_int most_iterations(const struct plan *plan, int first, int end) {
    redcc_int most = 0;
    for (int thread = first; thread < end; thread++)
        if (plan->schedule[thread].iterations > most)
            most = plan->schedule[thread].iterations;
    return most;
}

/* The makespan of a team, whose threads synchronise after each stage. */
static redcc_int length_of_team(const struct plan *plan, int team, struct place *place) {
    const int first = redcc_team_first(plan->threads, plan->teams.count, team);
    const int end = redcc_team_first(plan->threads, plan->teams.count, team + 1);
    if (plan->teams.stages[team] <= 1)
        return most_iterations(plan, first, end);
    redcc_int length = 0;
    for (uint32_t stage = 0; stage < plan->teams.stages[team]; stage++) {
        redcc_int longest = 0;
        for (int thread = first; thread < end; thread++) {
            const struct schedule *schedule = &plan->schedule[thread];
            size_t *at = &place[thread].chunk;
            redcc_int own = 0;
            for (; *at < schedule->chunk_count && schedule->chunk[*at].stage == stage; ++*at)
                own += iterations_of(schedule, &schedule->chunk[*at]);
            longest = own > longest ? own : longest;
        }
        length += longest;
    }
    return length;
}

/* Simulates a thread's chunks, up to the first chunk that waits for a flag which is not raised yet.
 * up[flags] has 1 + the time at which each flag was raised; 0: it is not raised yet. Returns
 * whether the thread has advanced. */
static bool advance(const struct schedule *schedule, struct place *place, redcc_int *up) {
    const size_t before = place->chunk;
    for (; place->chunk < schedule->chunk_count; place->chunk++) {
        const struct chunk *chunk = &schedule->chunk[place->chunk];
        redcc_int begin = place->time;
        for (uint32_t w = chunk->wait_begin; w < chunk->wait_end; w++) {
            const redcc_int time = up[schedule->wait[w]];
            if (time == 0)
                return place->chunk > before;
            begin = time - 1 > begin ? time - 1 : begin;
        }
        place->time = begin + iterations_of(schedule, chunk);
        if (chunk->flag)
            up[chunk->flag - 1] = 1 + place->time;
    }
    return place->chunk > before;
}

static redcc_int length_by_flags(const struct plan *plan, struct place *place, redcc_int *up) {
    redcc_int length = 0;
    for (bool going = true; going;) {
        going = false;
        for (int thread = 0; thread < plan->threads; thread++)
            going = advance(&plan->schedule[thread], &place[thread], up) || going;
    }
    for (int thread = 0; thread < plan->threads; thread++)
        length = place[thread].time > length ? place[thread].time : length;
    return length;
}

redcc_int redcc_plan_length(const struct plan *plan) {
    assert(plan->threads >= 1);
    redcc_int length = 0;
    struct place *place = redcc_memory_alloc_zeroed((size_t)plan->threads, sizeof *place);
    redcc_int *up = NULL;
    if (plan->flags)
        up = redcc_memory_alloc_zeroed(plan->method->flags(plan->owners), sizeof *up);
    if (!place || (plan->flags && !up))
        length = most_iterations(plan, 0, plan->threads);
    else if (plan->flags)
        length = length_by_flags(plan, place, up);
    else if (plan->method->steals)
        length = length_with_stealing(plan, place);
    else
        for (int team = 0; team < plan->teams.count; team++) {
            const redcc_int own = length_of_team(plan, team, place);
            length = own > length ? own : length;
        }
    redcc_memory_free(place);
    redcc_memory_free(up);
    return length;
}
