/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The executor, which is the same for all methods: redcc_next hands out chunks, waits between
 * stages, and merges copies. The steps of a thread are:
 *
 *     STEP_BEGIN: the first call; continues with
 *     STEP_EXECUTE: the thread's chunks, and stealable ones; then the merge   -> STEP_END
 *                   with validation, the first thread:          -> STEP_CHECK -> STEP_END
 *                   if an iteration left a fence, the first thread: -> STEP_REST -> STEP_END
 *     STEP_REST: iterations of a binned loop in order, by the first thread    -> STEP_END
 *                with validation, after the binned part:      STEP_CHECK -> STEP_REST
 */
#include "execute/run.h"

#include "base/clock.h"
#include "execute/compensate.h"

#include <assert.h>
#include <errno.h>
#include <string.h>

static struct barrier *team_barrier(const struct plan *plan, int team) {
    return &plan->teams.barrier[team];
}

static int team_size(const struct plan *plan, int team) {
    return redcc_team_first(plan->threads, plan->teams.count, team + 1) -
           redcc_team_first(plan->threads, plan->teams.count, team);
}

/* Sets the bases to which the thread writes: those of the arrays (number < 0), or those of copy
 * number `number`. A copy need not contain an array's first element; its base is the address that
 * this element would have in the copy. */
static void place_bases(struct runner *runner, int number) {
    const struct plan *plan = runner->plan;
    void *const *bases = runner->run->call->request.bases;
    const struct copy *copy = number < 0 ? NULL : &plan->copies.copy[number];
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = plan->group_of[array];
        runner->base[array] = bases[array];
        if (copy && copy->memory[group])
            runner->base[array] =
                (void *)((uintptr_t)copy->memory[group] +
                         (uintptr_t)(plan->shift[array] - copy->held[group].first));
    }
}

/* The elements that a thread owns in an array if a map gives the owners of its units. */
static redcc_owner mapped_owner(const struct plan *plan, uint32_t group, const char *base,
                                uint32_t owner) {
    const struct group_map *it = &plan->map.of[group];
    if (it->count == 0)
        return (redcc_owner){.first = base};
    const redcc_size size = (redcc_size)it->count * it->bytes;
    const bool is_exact = it->bytes > 1 && size <= UINT64_MAX / it->bytes;
    return (redcc_owner){.first = base + it->first,
                         .size = size,
                         .map = plan->map.owner + it->begin,
                         .reciprocal = is_exact ? UINT64_MAX / it->bytes + 1 : 0,
                         .self = owner,
                         .unit = it->bytes};
}

static void place_owners(struct runner *runner) {
    const struct plan *plan = runner->plan;
    assert(runner->schedule < plan->schedules);
    const uint32_t owner = plan->owners == 1 ? 0 : runner->schedule;
    for (uint32_t array = 0; array < plan->array_count; array++) {
        const uint32_t group = plan->group_of[array];
        const uintptr_t base = (uintptr_t)runner->run->call->request.bases[group];
        runner->owner[array] = (redcc_owner){.first = (const char *)base};
        if (owner >= plan->owners)
            continue; /* a method with fewer owners than threads has no owner checks */
        if (plan->map.owner) {
            runner->owner[array] = mapped_owner(plan, group, (const char *)base, owner);
            continue;
        }
        const ptrdiff_t *bound = plan->bound + (size_t)group * (plan->owners + 1) + owner;
        runner->owner[array].first = (const char *)(base + (uintptr_t)bound[0]);
        runner->owner[array].size = (redcc_size)(bound[1] - bound[0]);
    }
}

void redcc_run_begin(struct run *run) {
    run->plan = NULL;
    run->validation = (struct validation){0};
    redcc_fences_open(&run->fences, run->call->request.loop);
    run->survey.stands = false;
    run->executed = 0;
    atomic_store_explicit(&run->error, 0, memory_order_relaxed);
    atomic_store_explicit(&run->last_claimed, 0, memory_order_relaxed);
    atomic_store_explicit(&run->blocks_claimed, 0, memory_order_relaxed);
}

/* The last thread to arrive saves the arrays for validation, before any thread writes. */
static void take_snapshot(struct runner *runner) {
    struct run *run = runner->run;
    if (!redcc_barrier_arrive(run->barrier, runner->threads))
        return;
    redcc_validation_begin(&run->validation, runner->plan, run->call->request.bases,
                           run->validated);
    redcc_barrier_release(run->barrier);
}

static bool is_hooked(const struct plan *plan) {
    return plan->rounding || plan->method->locks;
}

static void install_hooks(struct runner *runner) {
    struct run *run = runner->run;
    redcc_hooks_install(&runner->hooks, runner->plan, run->call->request.loop->arrays,
                        run->call->request.bases, runner->owner);
}

static void begin_hooks(struct runner *runner) {
    struct run *run = runner->run;
    const struct plan *plan = runner->plan;
    if (plan->rounding) {
        redcc_rounding_clear(plan, runner->thread, run->call->request.bases);
        redcc_barrier_wait(run->barrier, runner->threads);
    }
    install_hooks(runner);
}

/* The expected number of iterations of the thread. With work stealing, it is the average over the
 * threads. */
static redcc_int iterations_of(const struct runner *runner) {
    const struct plan *plan = runner->plan;
    return plan->method->steals ? plan->executed / plan->threads
                                : plan->schedule[runner->schedule].iterations;
}

/* Begins a selection: the thread finds its own iterations. If iterations that touch nothing must be
 * executed, each thread gets a share of them. Otherwise one thread executes the last iteration even
 * if it touches nothing, because variables that are used after the loop get their values there. */
static void begin_selecting(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct selection *selection = &runner->selection;
    const struct plan *plan = runner->plan;
    const int thread = runner->thread, threads = runner->threads;
    memcpy(selection->window, runner->owner, plan->array_count * sizeof *selection->window);
    redcc_selection_begin(selection, worker, plan->trip);
    worker->sources = runner->run->fences.reads;
    const bool idle = runner->run->call->request.loop->flags & REDCC_EVERY_ITERATION;
    if (idle)
        redcc_selection_set_idle(selection, redcc_share(plan->trip, threads, thread),
                                 redcc_share(plan->trip, threads, thread + 1));
    else if (thread == threads - 1 && plan->trip > 0)
        redcc_selection_set_idle(selection, plan->trip - 1, plan->trip);
    if (runner->run->survey.stands)
        redcc_selection_survey(selection, worker, &runner->run->survey, thread, idle);
}

static void begin_running(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const struct plan *plan = runner->plan;
    struct run *run = runner->run;
    if (runner->thread == 0)
        run->ready = redcc_seconds();
    errno = 0; /* discards the errno of the inspector, which is not that of the loop */
    runner->stage = 0;
    runner->runs = (struct run_reader){0};
    worker->position = 0;
    worker->base = runner->base;
    worker->owner = runner->owner;
    assert(plan && plan->threads == runner->threads && plan->trip == run->call->request.trip);
    runner->step = STEP_EXECUTE;
    runner->schedule = redcc_own_schedule(plan, runner->thread);
    place_owners(runner);
    place_bases(runner, redcc_copy_of(plan, runner->thread));
    if (run->validated)
        take_snapshot(runner);
    if (plan->method->selects)
        begin_selecting(worker);
    if (plan->method->tiles)
        redcc_tiles_begin(&runner->tiles,
                          redcc_tile_grid(plan->trip, plan->threads,
                                          run->call->request.loop->flags & REDCC_TILES_BELOW));
    if (is_hooked(plan))
        begin_hooks(runner);
    redcc_copies_fill(plan, runner->thread);
    /* other threads have filled a part of the memory to which this thread writes */
    if (plan->method->copies == COPY_TEAM) {
        const int team = redcc_team_of(plan->threads, plan->teams.count, runner->thread);
        redcc_barrier_wait(team_barrier(plan, team), team_size(plan, team));
    }
    redcc_parts_begin(&runner->parts, redcc_run_parts(run, plan), iterations_of(runner));
    worker->variant = redcc_run_variant(run, plan, 0);
}

/* Prepares the thread to hand out iterations [begin, end) in order; they write to the arrays. */
static void begin_in_order(redcc_worker *worker, enum step step, redcc_int begin, redcc_int end) {
    struct runner *runner = worker->execution;
    const struct call *call = runner->run->call;
    errno = 0;
    runner->step = begin < end ? step : STEP_END;
    runner->in_order_end = end;
    worker->position = begin;
    worker->variant = (redcc_variant){0};
    worker->base = runner->base;
    worker->owner = runner->owner; /* used only after redcc_run_own_nothing */
    worker->run_end = NULL;
    for (uint32_t array = 0; array < call->request.loop->array_count; array++)
        runner->base[array] = call->request.bases[array];
}

void redcc_run_stretch(redcc_worker *worker, redcc_int begin, redcc_int end) {
    assert(0 <= begin && begin <= end);
    begin_in_order(worker, STEP_REST, begin, end);
}

void redcc_run_rest(redcc_worker *worker, redcc_int from) {
    const struct runner *runner = worker->execution;
    assert(from <= runner->run->call->request.trip);
    redcc_run_stretch(worker, from, runner->run->call->request.trip);
}

void redcc_run_check(redcc_worker *worker, redcc_int end) {
    struct runner *runner = worker->execution;
    assert(0 <= end && end <= runner->run->call->request.trip);
    runner->run->executed = redcc_seconds();
    redcc_validation_swap(&runner->run->validation);
    begin_in_order(worker, STEP_CHECK, 0, end);
}

/* Hands out the next iterations in order. Returns false if none is left. */
static bool hand_out_in_order(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const redcc_int left = runner->in_order_end - worker->position;
    const redcc_int count = left < REDCC_RUN_MOST ? left : REDCC_RUN_MOST;
    runner->whole = (redcc_iterations){0, 2 * (redcc_u32)count};
    worker->origin = worker->position;
    worker->run = &runner->whole;
    worker->run_end = worker->run + 1;
    worker->position += count;
    return count > 0;
}

/* The end of the iterations executed so far. redcc_run_again repeats the iterations before it. */
static redcc_int end_of_executed(const struct runner *runner) {
    const struct plan *plan = runner->plan;
    return plan && plan->method->selects ? runner->selection.end : runner->run->call->request.trip;
}

bool redcc_run_has_rest(const redcc_worker *worker) {
    const struct runner *runner = worker->execution;
    return end_of_executed(runner) < runner->run->call->request.trip;
}

void redcc_run_own_nothing(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const struct call *call = runner->run->call;
    assert(runner->step == STEP_END);
    begin_in_order(worker, STEP_END, 0, end_of_executed(runner));
    for (uint32_t array = 0; array < call->request.loop->array_count; array++)
        runner->owner[array] = (redcc_owner){.first = call->request.bases[array]};
}

bool redcc_run_again(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const redcc_int end = end_of_executed(runner), trip = runner->run->call->request.trip;
    if (errno && worker->run_end)
        redcc_note_error(runner->run, worker->position);
    if (runner->in_order_end == end) {
        const bool is_left = hand_out_in_order(worker);
        runner->whole.count_and_check |= 1;
        if (is_left || end == trip)
            return is_left;
        begin_in_order(worker, STEP_END, end, trip);
    }
    return hand_out_in_order(worker);
}

/* Hands out iterations in order. When the iterations that were repeated for validation are done,
 * compares the results, and continues with the rest of a binned loop. Returns 0 if no iteration is
 * left. */
static int next_in_order(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct run *run = runner->run;
    if (hand_out_in_order(worker))
        return 1;
    if (runner->step != STEP_CHECK) {
        runner->step = STEP_END;
        return 0;
    }
    redcc_validation_end(&run->validation, run->call->request.loop, run->call->request.bases,
                         run->validated);
    redcc_run_rest(worker, runner->in_order_end);
    return runner->step == STEP_REST ? next_in_order(worker) : 0;
}

/* Waits at `stage` for the other threads of the team. */
static void reach_stage(struct runner *runner, uint32_t stage) {
    const struct plan *plan = runner->plan;
    const int team = redcc_team_of(plan->threads, plan->teams.count, runner->thread);
    assert(runner->stage <= stage && stage < plan->teams.stages[team]);
    for (; runner->stage < stage; runner->stage++)
        redcc_barrier_wait(team_barrier(plan, team), team_size(plan, team));
}

/* Called by each thread when it has executed its iterations before the first one that leaves a
 * fence (ownership/fences.h). Once all threads have, the first thread executes the remaining
 * iterations in order. In a loop with series, redcc_run_again hands these out instead. */
static void execute_rest(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    assert(runner->run->fences.stand && !runner->run->validation.began);
    if (runner->run->call->request.loop->flags & REDCC_FENCED_SERIES)
        return;
    redcc_barrier_wait(runner->run->barrier, runner->threads);
    if (runner->thread == 0)
        redcc_run_rest(worker, runner->selection.end);
}

static void finish(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const struct plan *plan = runner->plan;
    struct run *run = runner->run;
    redcc_parts_end(&runner->parts);
    const int team = redcc_team_of(plan->threads, plan->teams.count, runner->thread);
    if (plan->teams.stages[team] > 0)
        reach_stage(runner, plan->teams.stages[team] - 1);
    if (plan->copies.count > 0) {
        redcc_barrier_wait(run->barrier, runner->threads);
        redcc_copies_merge(plan, runner->thread, run->call->request.bases);
    }
    if (plan->rounding) {
        redcc_barrier_wait(run->barrier, runner->threads);
        redcc_rounding_add(plan, runner->thread);
    }
    runner->step = STEP_END;
    if (plan->method->selects && runner->selection.end < plan->trip)
        execute_rest(worker);
    if (!run->validation.began)
        return;
    redcc_barrier_wait(run->barrier, runner->threads);
    if (runner->thread == 0)
        redcc_run_check(worker, plan->trip);
}

static void raise_flag(const struct plan *plan, const struct chunk *chunk) {
    if (chunk->flag)
        redcc_flag_raise(plan->flags, chunk->flag - 1, plan->round);
}

/* Switches to the copy of share number `share`. With COPY_LATER, a single thread has one copy for
 * all shares after the first. Before the next share begins, it merges that copy. */
static void begin_share(struct runner *runner, uint32_t share) {
    const struct plan *plan = runner->plan;
    if (plan->method->copies == COPY_LATER && plan->threads == 1 && share > 1)
        redcc_copies_merge(plan, runner->thread, runner->run->call->request.bases);
    place_bases(runner, redcc_copy_of_share(plan, share));
}

/* Waits for the stages and flags that `chunk` needs, and switches to the copy to which the chunk
 * writes. */
static void prepare_chunk(struct runner *runner, const struct chunk *chunk) {
    const struct plan *plan = runner->plan;
    const uint32_t *wait = plan->schedule[runner->schedule].wait;
    reach_stage(runner, chunk->stage);
    for (uint32_t w = chunk->wait_begin; w < chunk->wait_end; w++)
        redcc_flag_await(plan->flags, wait[w], plan->round, runner->threads);
    if (plan->method->copies == COPY_SHARE || plan->method->copies == COPY_LATER)
        begin_share(runner, chunk->copy);
}

/* If the current timing slice is complete, begins the next slice, and switches to its variant. */
static void advance_to_slice(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct parts *parts = &runner->parts;
    if (parts->count > 0 && redcc_parts_next(parts))
        worker->variant = redcc_run_variant(runner->run, runner->plan, parts->number);
}

/* Reads some runs of the current timing slice. Returns the number of runs. */
static size_t read_runs(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct parts *parts = &runner->parts;
    if (parts->count == 0)
        return redcc_runs_read(&runner->runs, runner->piece, REDCC_RUNS);
    advance_to_slice(worker);
    return redcc_runs_read_part(&runner->runs, runner->piece, REDCC_RUNS, &parts->left);
}

/* Hands out runs of the current chunk: all remaining runs if they can be handed out as they are,
 * otherwise some of them, copied to runner->piece. Returns false if no run is left. */
static bool hand_out_runs(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct run_reader *runs = &runner->runs;
    const bool hooked = is_hooked(runner->plan);
    if (runs->run != runs->run_end && !hooked && runner->parts.count == 0) {
        worker->run = runs->run;
        worker->run_end = runs->run = runs->run_end;
        return true;
    }
    const size_t count = read_runs(worker);
    for (size_t r = 0; hooked && r < count; r++)
        runner->piece[r].count_and_check |= 1;
    worker->run = runner->piece;
    worker->run_end = runner->piece + count;
    return count > 0;
}

/* Work stealing: takes the next stealable block. False: no block is left. */
static bool steal(struct runner *runner) {
    struct run *run = runner->run;
    const unsigned claimed =
        atomic_fetch_add_explicit(&run->blocks_claimed, 1, memory_order_relaxed);
    const uint32_t next = redcc_stealable_schedule(runner->plan, claimed);
    runner->schedule = next == UINT32_MAX ? runner->schedule : next;
    return next != UINT32_MAX;
}

/* Advances to the next schedule of a plan with stealable blocks. False: no schedule is left. */
static bool advance_to_schedule(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const struct plan *plan = runner->plan;
    if (!plan->method->steals || !steal(runner))
        return false;
    worker->position = 0;
    place_owners(runner);
    if (is_hooked(plan))
        install_hooks(runner);
    return true;
}

/* Advances to the next chunk. False: no chunk is left. */
static bool advance_to_chunk(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const struct schedule *schedule = &runner->plan->schedule[runner->schedule];
    if (worker->position > 0)
        raise_flag(runner->plan, &schedule->chunk[worker->position - 1]);
    if ((size_t)worker->position == schedule->chunk_count)
        return advance_to_schedule(worker) && advance_to_chunk(worker);
    assert(worker->position >= 0 && (size_t)worker->position < schedule->chunk_count);
    const struct chunk *chunk = &schedule->chunk[worker->position++];
    prepare_chunk(runner, chunk);
    worker->origin = chunk->origin;
    runner->runs = redcc_runs_of(schedule, chunk);
    return true;
}

/* Requests the next classes of the survey. False: the survey has ended. */
static bool goes_on_surveying(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    worker->owner = runner->run->fences.updates;
    if (redcc_selection_ask_survey(&runner->selection, worker, runner->thread))
        return true;
    redcc_parts_begin(&runner->parts, redcc_run_parts(runner->run, runner->plan),
                      iterations_of(runner));
    return false;
}

/* Hands out runs of classified iterations. False: there are none. */
static bool hand_out_classified(redcc_worker *worker, bool hooked) {
    struct runner *runner = worker->execution;
    struct parts *parts = &runner->parts;
    redcc_int iterations;
    const size_t runs =
        redcc_selection_take(&runner->selection, worker, hooked, runner->piece, &iterations);
    worker->origin = worker->first;
    worker->owner = runner->owner;
    worker->run = runner->piece;
    worker->run_end = runner->piece + runs;
    advance_to_slice(worker);
    worker->variant.operands =
        runner->selection.follows ? REDCC_OPERANDS_BY_LEADER : REDCC_OPERANDS_ONE_BY_ONE;
    parts->left -= parts->count > 0 ? iterations : 0;
    return runs > 0;
}

/* Hands out runs of classified iterations or, if there are none, a request to classify the next
 * iterations. Returns 0 if no iteration is left. Clears errno after a request, because the
 * program's slices may have set it. */
static int hand_out_selected(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    struct selection *selection = &runner->selection;
    const bool hooked = is_hooked(runner->plan);
    if (hooked)
        redcc_hooks_settle(&runner->hooks);
    if (selection->asked)
        errno = 0;
    if (selection->surveys && goes_on_surveying(worker))
        return REDCC_SELECT;
    for (;;) {
        if (redcc_selection_has_classes(selection, worker) && hand_out_classified(worker, hooked))
            return 1;
        worker->owner = runner->run->fences.updates;
        if (!redcc_selection_ask(selection, worker))
            return 0;
        if (selection->asked)
            return REDCC_SELECT;
    }
}

/* Hands out the next tile. It also sets a run with the tile's rows; only recording errno needs this
 * run. */
static int hand_out_tile(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    const redcc_tile *tile =
        redcc_tiles_next(&runner->tiles, runner->plan, &runner->run->blocks_claimed);
    if (!tile)
        return 0;
    worker->variant.tile = tile;
    runner->whole = (redcc_iterations){0, 2 * (redcc_u32)(tile->row_end - tile->row)};
    worker->origin = tile->row;
    worker->run = &runner->whole;
    worker->run_end = worker->run + 1;
    return REDCC_TILE;
}

static bool hand_out(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    if (is_hooked(runner->plan))
        redcc_hooks_settle(&runner->hooks);
    return hand_out_runs(worker) || (advance_to_chunk(worker) && hand_out_runs(worker));
}

static int next_chunk(redcc_worker *worker) {
    struct runner *runner = worker->execution;
    if (runner->step == STEP_BEGIN)
        begin_running(worker);
    switch (runner->step) {
    case STEP_EXECUTE: {
        const struct method *method = runner->plan->method;
        const int handed = method->selects ? hand_out_selected(worker)
                           : method->tiles ? hand_out_tile(worker)
                                           : (int)hand_out(worker);
        if (handed)
            return handed;
        finish(worker);
        return runner->step == STEP_END ? 0 : next_in_order(worker);
    }
    case STEP_REST:
    case STEP_CHECK:
        return next_in_order(worker);
    case STEP_BEGIN:
    case STEP_END:
        break;
    }
    return 0;
}

/* Mathematical functions set errno of the calling thread to EDOM or ERANGE. run->error describes
 * the last chunk, in the order of the loop, in which this happened. Its value is 2 * (end + 1) +
 * (ERANGE ? 1 : 0), where `end` is one past the chunk's last iteration. If iterations in several
 * threads fail with different errors, the stored error may differ from that of the sequential
 * loop. */
void redcc_note_error(struct run *run, redcc_int end) {
    assert(end >= 0);
    const int error = errno;
    if (error != EDOM && error != ERANGE)
        return;
    const unsigned long long noted = 2 * ((unsigned long long)end + 1) + (error == ERANGE ? 1 : 0);
    atomic_ullong *latest = &run->error;
    unsigned long long before = atomic_load_explicit(latest, memory_order_relaxed);
    while (before < noted &&
           !atomic_compare_exchange_weak_explicit(latest, &before, noted, memory_order_relaxed,
                                                  memory_order_relaxed))
        ;
    errno = 0;
}

static void note_error(const redcc_worker *worker) {
    const struct runner *runner = worker->execution;
    if (runner->step != STEP_EXECUTE && runner->step != STEP_REST)
        return;
    const redcc_iterations *last = worker->run_end - 1;
    redcc_note_error(runner->run, worker->origin + last->begin + last->count_and_check / 2);
}

int redcc_error_of(struct run *run) {
    const unsigned long long noted = atomic_load_explicit(&run->error, memory_order_relaxed);
    return noted == 0 ? 0 : noted % 2 ? ERANGE : EDOM;
}

int redcc_next(redcc_worker *worker) {
    const struct runner *runner = worker->execution;
    if (!runner)
        return 0;
    if (errno && !runner->selection.asked)
        note_error(worker);
    const int handed = next_chunk(worker);
    if (handed)
        return handed;
    redcc_float_control_take(runner->float_control);
    return 0;
}

int redcc_claims_last(redcc_worker *worker) {
    const struct runner *runner = worker->execution;
    return atomic_exchange(&runner->run->last_claimed, 1) == 0;
}
