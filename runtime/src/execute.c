/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Execution, the same for all methods: chunks, stages between barriers, copies and their merge. */
#include "loop.h"

#include "clock.h"
#include "compensate.h"
#include "settings.h"

#include <errno.h>

static struct barrier *team_barrier(const struct plan *plan, int team) {
    return &plan->team_barrier[team];
}

static int team_size(const struct plan *plan, int team) {
    return redcc_team_first(plan->threads, plan->teams, team + 1) -
           redcc_team_first(plan->threads, plan->teams, team);
}

/* Where this thread writes: in place (number < 0), or where its copy would begin if it were the
 * whole array. */
static void place_bases(struct member *member, int number) {
    const struct plan *plan = member->plan;
    void *const *bases = member->execution->request.bases;
    const struct copy *copy = number < 0 ? NULL : &plan->copies.copy[number];
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = plan->group_of[array];
        member->base[array] = bases[array];
        if (copy && copy->memory[group])
            member->base[array] =
                (void *)((uintptr_t)copy->memory[group] +
                         (uintptr_t)(plan->shift[array] - copy->held[group].first));
    }
}

/* What a thread owns of an array whose units have a map. */
static redcc_owner mapped_owner(const struct plan *plan, uint32_t group, const char *base,
                                uint32_t owner) {
    const struct group_map *it = &plan->mapped[group];
    if (it->count == 0)
        return (redcc_owner){.first = base};
    return (redcc_owner){.first = base + it->first,
                         .size = (redcc_size)it->count * it->bytes,
                         .map = plan->map + it->begin,
                         .unit = it->bytes,
                         .self = owner};
}

static void place_owners(struct member *member) {
    const struct plan *plan = member->plan;
    const uint32_t owner = plan->owners == 1 ? 0 : member->schedule;
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = plan->group_of[array];
        const uintptr_t base = (uintptr_t)member->execution->request.bases[group];
        member->owner[array] = (redcc_owner){.first = (const char *)base};
        if (owner >= plan->owners)
            continue; /* a method with fewer owners than threads: nothing is guarded */
        if (plan->map) {
            member->owner[array] = mapped_owner(plan, group, (const char *)base, owner);
            continue;
        }
        const ptrdiff_t *bound = plan->bound + (size_t)group * (plan->owners + 1) + owner;
        member->owner[array].first = (const char *)(base + (uintptr_t)bound[0]);
        member->owner[array].size = (redcc_size)(bound[1] - bound[0]);
    }
}

/* All threads are there, and none has written yet. */
static void take_snapshot(struct member *member) {
    struct execution *execution = member->execution;
    if (!redcc_barrier_arrive(&execution->barrier, member->threads))
        return;
    redcc_validation_begin(&execution->validation, member->plan, execution->request.bases,
                           &execution->state->reported.statistics.validated);
    redcc_barrier_release(&execution->barrier);
}

static bool is_hooked(const struct plan *plan) {
    return plan->lost || plan->method->locks;
}

static void install_hooks(struct member *member) {
    struct execution *execution = member->execution;
    redcc_hooks_install(&member->hooks, member->plan, execution->request.loop->arrays,
                        execution->request.bases, member->owner);
}

static void begin_hooks(struct member *member) {
    struct execution *execution = member->execution;
    const struct plan *plan = member->plan;
    if (plan->lost) {
        redcc_lost_clear(plan, member->thread, execution->request.bases);
        redcc_barrier_wait(&execution->barrier, member->threads);
    }
    install_hooks(member);
}

/* The first thread has its first spare part before it; the others wait until that is done, or do
 * not. */
static void begin_paced(struct member *member) {
    struct execution *execution = member->execution;
    if (member->thread > 0 && execution->pace == PACE_ALONE)
        redcc_barrier_wait(&execution->barrier, member->threads);
    member->began = redcc_seconds();
}

/* Paced, nobody else claims that part. */
static bool is_in_first_part(const struct member *member) {
    return member->thread == 0 && redcc_is_paced(member->execution, member->plan) &&
           member->schedule == redcc_spare_schedule(member->plan, 0);
}

/* The first thread is done with it, and turns to what is its own. */
static void end_first_part(struct member *member) {
    struct execution *execution = member->execution;
    execution->part_seconds = redcc_seconds() - member->began;
    if (execution->pace == PACE_ALONE)
        redcc_barrier_wait(&execution->barrier, member->threads);
    member->schedule = redcc_own_schedule(member->plan, 0);
}

static void begin_running(redcc_worker *worker) {
    struct member *member = worker->execution;
    const struct plan *plan = member->plan;
    struct execution *execution = member->execution;
    if (member->thread == 0)
        execution->ready = redcc_seconds();
    member->phase = PHASE_RUNNING;
    errno = 0; /* what the inspector left there is not the loop's */
    member->stage = 0;
    member->runs = (struct run_reader){0};
    worker->position = 0;
    worker->base = member->base;
    worker->owner = member->owner;
    if (execution->course == COURSE_SOLO) {
        for (uint32_t array = 0; array < execution->request.loop->array_count; array++)
            member->base[array] = execution->request.bases[array];
        return;
    }
    const bool paced = redcc_is_paced(execution, plan);
    member->schedule = paced && member->thread == 0 ? redcc_spare_schedule(plan, 0)
                                                    : redcc_own_schedule(plan, member->thread);
    place_owners(member);
    place_bases(member, redcc_copy_of(plan, member->thread));
    if (redcc_settings()->validate && !execution->state->passing)
        take_snapshot(member);
    if (is_hooked(plan))
        begin_hooks(member);
    redcc_copies_fill(plan, member->thread);
    if (plan->method->copies == COPY_TEAM) { /* several threads filled what each will write to */
        const int team = redcc_team_of(plan->threads, plan->teams, member->thread);
        redcc_barrier_wait(team_barrier(plan, team), team_size(plan, team));
    }
    if (paced)
        begin_paced(member);
}

/* Hands out all iterations in order. False: there are none left. */
static bool hand_out_in_order(redcc_worker *worker) {
    struct member *member = worker->execution;
    const redcc_int left = member->execution->request.trip - worker->position;
    const redcc_int count = left < REDCC_RUN_MOST ? left : REDCC_RUN_MOST;
    member->solo_run = (redcc_run){0, 2 * (redcc_u32)count};
    worker->origin = worker->position;
    worker->run = &member->solo_run;
    worker->run_end = worker->run + 1;
    worker->position += count;
    return count > 0;
}

/* COURSE_SOLO: the first thread executes all iterations in order. */
static int next_solo(redcc_worker *worker) {
    struct member *member = worker->execution;
    struct execution *execution = member->execution;
    if (member->thread == 0 && hand_out_in_order(worker))
        return 1;
    if (member->thread == 0)
        execution->solo_seconds = redcc_seconds() - execution->ready;
    member->phase = PHASE_OVER;
    return 0;
}

/* The loop is executed; the first thread executes it once more, from what the arrays held
 * before. */
static int next_to_check(redcc_worker *worker) {
    struct member *member = worker->execution;
    if (hand_out_in_order(worker))
        return 1;
    member->phase = PHASE_OVER;
    return 0;
}

/* All threads are done. */
static void begin_checking(redcc_worker *worker) {
    struct member *member = worker->execution;
    struct execution *execution = member->execution;
    redcc_validation_swap(&execution->validation, member->plan, execution->request.bases);
    member->phase = PHASE_CHECKING;
    worker->position = 0;
    for (uint32_t array = 0; array < member->plan->array_count; array++)
        member->base[array] = execution->request.bases[array];
}

/* Goes on to `stage` together with the others of the team. */
static void reach_stage(struct member *member, uint32_t stage) {
    const struct plan *plan = member->plan;
    const int team = redcc_team_of(plan->threads, plan->teams, member->thread);
    for (; member->stage < stage; member->stage++)
        redcc_barrier_wait(team_barrier(plan, team), team_size(plan, team));
}

static void finish(redcc_worker *worker) {
    struct member *member = worker->execution;
    const struct plan *plan = member->plan;
    struct execution *execution = member->execution;
    if (redcc_is_paced(execution, plan))
        member->ended = redcc_seconds();
    const int team = redcc_team_of(plan->threads, plan->teams, member->thread);
    if (plan->stages[team] > 0)
        reach_stage(member, plan->stages[team] - 1);
    if (plan->copies.count > 0) {
        redcc_barrier_wait(&execution->barrier, member->threads);
        redcc_copies_merge(plan, member->thread, execution->request.bases);
    }
    if (plan->lost) {
        redcc_barrier_wait(&execution->barrier, member->threads);
        redcc_lost_bring(plan, member->thread);
    }
    member->phase = PHASE_OVER;
    if (!execution->validation.began)
        return;
    redcc_barrier_wait(&execution->barrier, member->threads);
    if (member->thread == 0) {
        execution->executed = redcc_seconds();
        begin_checking(worker);
    }
}

/* The flag of the chunk that was executed goes up. */
static void pass_on(const struct plan *plan, const struct chunk *chunk) {
    if (chunk->flag)
        redcc_flag_raise(plan->flags, chunk->flag - 1, plan->round);
}

/* Waits for what must be done before `chunk`, and turns to the copy that it writes to. */
static void get_ready(struct member *member, const struct chunk *chunk) {
    const struct plan *plan = member->plan;
    const uint32_t *wait = plan->schedule[member->schedule].wait;
    reach_stage(member, chunk->stage);
    for (uint32_t w = chunk->wait_begin; w < chunk->wait_end; w++)
        redcc_flag_await(plan->flags, wait[w], plan->round, member->threads);
    if (plan->method->copies == COPY_SHARE)
        place_bases(member, (int)chunk->copy);
}

/* Runs of the chunk at hand: all that are left where they can be executed as they stand, else some
 * of them. False: there are none left. */
static bool hand_out_runs(redcc_worker *worker) {
    struct member *member = worker->execution;
    struct run_reader *runs = &member->runs;
    const bool hooked = is_hooked(member->plan);
    if (runs->run != runs->run_end && !hooked) {
        worker->run = runs->run;
        worker->run_end = runs->run = runs->run_end;
        return true;
    }
    const size_t count = redcc_runs_read(runs, member->run, REDCC_RUNS);
    for (size_t r = 0; hooked && r < count; r++)
        member->run[r].count_and_guard |= 1;
    worker->run = member->run;
    worker->run_end = member->run + count;
    return count > 0;
}

/* The next spare schedule, whichever it is. False: there is none left. */
static bool claim_spare(struct member *member) {
    struct execution *execution = member->execution;
    const unsigned claimed =
        atomic_fetch_add_explicit(&execution->spares_claimed, 1, memory_order_relaxed);
    const unsigned before = redcc_is_paced(execution, member->plan) ? 1 : 0;
    const uint32_t next = redcc_spare_schedule(member->plan, before + claimed);
    member->schedule = next == UINT32_MAX ? member->schedule : next;
    return next != UINT32_MAX;
}

/* On to the next schedule of a plan with spare ones. False: there is none left. */
static bool turn_to_schedule(redcc_worker *worker) {
    struct member *member = worker->execution;
    const struct plan *plan = member->plan;
    if (!plan->method->spares)
        return false;
    if (is_in_first_part(member)) {
        end_first_part(member);
    } else if (!claim_spare(member)) {
        return false;
    }
    worker->position = 0;
    place_owners(member);
    if (is_hooked(plan))
        install_hooks(member);
    return true;
}

/* On to the next chunk. False: there is none left. */
static bool turn_to_chunk(redcc_worker *worker) {
    struct member *member = worker->execution;
    const struct schedule *schedule = &member->plan->schedule[member->schedule];
    if (worker->position > 0)
        pass_on(member->plan, &schedule->chunk[worker->position - 1]);
    if ((size_t)worker->position == schedule->chunk_count)
        return turn_to_schedule(worker) && turn_to_chunk(worker);
    const struct chunk *chunk = &schedule->chunk[worker->position++];
    get_ready(member, chunk);
    worker->origin = chunk->origin;
    member->runs = redcc_runs_of(schedule, chunk);
    return true;
}

static bool hand_out(redcc_worker *worker) {
    struct member *member = worker->execution;
    if (is_hooked(member->plan))
        redcc_hooks_settle(&member->hooks);
    return hand_out_runs(worker) || (turn_to_chunk(worker) && hand_out_runs(worker));
}

static int next_chunk(redcc_worker *worker) {
    struct member *member = worker->execution;
    if (member->phase == PHASE_OVER)
        return 0;
    if (member->phase == PHASE_RUN)
        begin_running(worker);
    if (member->phase == PHASE_CHECKING)
        return next_to_check(worker);
    if (member->execution->course == COURSE_SOLO)
        return next_solo(worker);
    if (hand_out(worker))
        return 1;
    finish(worker);
    return member->phase == PHASE_CHECKING ? next_to_check(worker) : 0;
}

/* Mathematical functions set errno to EDOM or ERANGE; it is the calling thread's. That of the last
 * chunk in which one failed is kept, with its last iteration: 2 * (iteration + 1) + (ERANGE ? 1 :
 * 0). Of iterations that fail in both ways, and are executed by several threads, another may be the
 * last. */
static void note_error(const redcc_worker *worker) {
    const struct member *member = worker->execution;
    const int error = errno;
    if ((error != EDOM && error != ERANGE) || member->phase != PHASE_RUNNING)
        return;
    const redcc_run *last = worker->run_end - 1;
    const redcc_int end = worker->origin + last->begin + last->count_and_guard / 2;
    const unsigned long long noted = 2 * ((unsigned long long)end + 1) + (error == ERANGE ? 1 : 0);
    atomic_ullong *latest = &member->execution->error;
    unsigned long long before = atomic_load_explicit(latest, memory_order_relaxed);
    while (before < noted &&
           !atomic_compare_exchange_weak_explicit(latest, &before, noted, memory_order_relaxed,
                                                  memory_order_relaxed))
        ;
    errno = 0;
}

int redcc_error_of(struct execution *execution) {
    const unsigned long long noted = atomic_load_explicit(&execution->error, memory_order_relaxed);
    return noted == 0 ? 0 : noted % 2 ? ERANGE : EDOM;
}

int redcc_next(redcc_worker *worker) {
    const struct member *member = worker->execution;
    if (!member)
        return 0;
    if (errno)
        note_error(worker);
    if (next_chunk(worker))
        return 1;
    redcc_float_control_take(member->float_control);
    return 0;
}

int redcc_claims_last(redcc_worker *worker) {
    const struct member *member = worker->execution;
    return atomic_exchange(&member->execution->last_claimed, 1) == 0;
}
