/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inspection, in the threads of the region: a sample of the iterations, from which the arrays are
 * cut (sampling.c); then all of them, which gives the access summary, the exact extents and the
 * guard; where the owners are to be cut from the access graph, all of them once more (gather.c);
 * then each thread prepares its part of the plan. All threads walk through the same phases.
 */
#include "inspect/inspect.h"

#include "base/memory.h"
#include "ownership/overlap.h"

#include <string.h>

enum { TAKEN_AT_ONCE = 512 * 1024 /* bytes of subscripts, that the caches hold */ };

void redcc_refuse(struct execution *execution, enum reason reason) {
    execution->reason = reason;
    execution->next = PHASE_OVER;
}

bool redcc_some_failed(const struct execution *execution) {
    for (int thread = 0; thread < execution->threads; thread++)
        if (execution->state->member[thread]->failed)
            return true;
    return false;
}

static void recount(struct execution *execution) {
    redcc_find_candidate(execution, execution->threads);
    execution->next = PHASE_BEGIN;
}

static void begin_inspection(struct execution *execution) {
    redcc_drop_candidate(execution);
    execution->inspected = true;
    const size_t threads = (size_t)execution->threads;
    execution->for_copies = execution->no_copies = execution->only_timed = false;
    execution->samples = redcc_memory_take(threads * sizeof *execution->samples);
    execution->summaries = redcc_memory_take(threads * sizeof *execution->summaries);
    execution->seen = redcc_memory_take(threads * sizeof *execution->seen);
    execution->next = PHASE_SAMPLE;
    if (!redcc_begin_partition(execution) || !execution->samples || !execution->summaries ||
        !execution->seen)
        redcc_refuse(execution, REASON_NO_MEMORY);
}

redcc_int redcc_own_begin(const struct member *member) {
    return redcc_share(member->execution->request.trip, member->threads, member->thread);
}

redcc_int redcc_own_end(const struct member *member) {
    return redcc_share(member->execution->request.trip, member->threads, member->thread + 1);
}

int redcc_hand_out(redcc_worker *worker, redcc_int first, redcc_int last, redcc_int stride,
                   const redcc_owner *window) {
    struct member *member = worker->execution;
    worker->first = first;
    worker->last = last;
    worker->stride = stride;
    worker->sources = member->sources;
    worker->window = window;
    worker->inside = worker->outside = 0;
    worker->alike = 0;
    worker->entry = member->entries;
    worker->entry_end = member->entries + REDCC_ENTRIES;
    return 1;
}

/* Nothing but the original loop is left, or nothing is known of it: one thread executes it, so that
 * it is known how long that takes. Even that wants the guard: what the body reads once, as where an
 * array lies, must not be among what it updates. */
static void go_alone(struct execution *execution) {
    execution->course = COURSE_SOLO;
    execution->planless = true;
    execution->next = PHASE_RUN;
}

/* As many iterations as read so much of the subscripts, whose fingerprints are then taken. */
static redcc_int iterations_at_once(struct member *member) {
    const size_t bytes = redcc_begin_taking(member);
    const redcc_int own = redcc_own_end(member) - redcc_own_begin(member);
    const redcc_int blocks = (redcc_int)(bytes / TAKEN_AT_ONCE) + 1;
    const redcc_int each = own / blocks + 1;
    return each < REDCC_BLOCK ? each : REDCC_BLOCK;
}

static void begin_sweep(struct member *member) {
    redcc_sweep_end(&member->sweep); /* of the sweep before, where groups had to be put together */
    memset(member->executed, 0, member->execution->partition.owners * sizeof *member->executed);
    member->failed =
        !redcc_sweep_begin(&member->sweep, &member->execution->partition, member->seen);
    member->next = redcc_own_begin(member);
    member->handed = 0;
    member->block = iterations_at_once(member);
    member->told_all = true;
    member->phase = PHASE_SWEEPING;
}

static int hand_out_block(redcc_worker *worker) {
    struct member *member = worker->execution;
    const redcc_int end = redcc_own_end(member), first = member->next;
    if (member->failed || !member->told_all || first == end)
        return 0;
    member->handed = end - first < member->block ? end - first : member->block;
    member->next = first + member->handed;
    redcc_sweep_open_block(&member->sweep, first);
    return redcc_hand_out(worker, first, member->next, 1, member->sweep.window);
}

static void close_block(redcc_worker *worker) {
    struct member *member = worker->execution;
    if (member->handed == 0)
        return;
    redcc_flush(worker);
    if (!redcc_sweep_close_block(&member->sweep, member->handed)) {
        member->failed = member->sweep.failed;
        member->told_all = false;
    }
    member->handed = 0;
    const redcc_int begin = redcc_own_begin(member), all = redcc_own_end(member) - begin;
    if (member->block < all)
        redcc_take_some(member, (double)(member->next - begin) / (double)all);
}

static void gather_sources(struct execution *execution) {
    const struct request *request = &execution->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        struct range *range = &execution->sources[s];
        if (request->known[s].end)
            continue;
        *range = redcc_nowhere;
        for (int thread = 0; thread < execution->threads; thread++) {
            const redcc_extent told = execution->state->member[thread]->sources[s];
            if (told.end)
                *range = redcc_range_union(
                    *range, (struct range){(uintptr_t)told.first, (uintptr_t)told.end});
        }
    }
}

/* The last question before a plan is made: may this method have this loop? */
static enum reason objection(const struct execution *execution, const struct method *method) {
    if (execution->partition.mixed && method->keeps != REDCC_ORDER_SERIAL)
        return REASON_MIXED;
    if (method->copies != COPY_NONE &&
        !redcc_copies_possible(&execution->partition, execution->touched))
        return REASON_NO_COPIES;
    return REASON_NONE;
}

void redcc_make_plan(struct execution *execution) {
    const struct method *method = execution->chosen;
    const int parameter = execution->method ? execution->parameter : method->usual;
    execution->plan = redcc_plan_new(method, parameter, execution->threads, &execution->request,
                                     &execution->partition, execution->touched, execution->sources);
    for (int thread = 0; thread < execution->threads; thread++) {
        const struct member *member = execution->state->member[thread];
        execution->summaries[thread] =
            execution->divided ? &execution->divide.sweep[thread].summary : &member->sweep.summary;
        execution->seen[thread] = member->seen;
    }
    execution->next = PHASE_PREPARE;
    if (execution->plan && execution->divided &&
        !redcc_plan_take_map(execution->plan, &execution->partition, &execution->divide)) {
        redcc_plan_free(execution->plan);
        execution->plan = NULL;
    }
    if (!execution->plan)
        redcc_refuse(execution, REASON_NO_MEMORY);
}

static const struct method *method_to_use(struct execution *execution) {
    if (execution->for_copies)
        return &redcc_method_expansion;
    return execution->method ? execution->method : redcc_find_method(execution);
}

void redcc_choose_and_go_on(struct execution *execution) {
    if (execution->for_copies && !redcc_copies_allowed(execution)) {
        execution->no_copies = true; /* the sample had not seen all that is touched */
        redcc_cut_and_sweep(execution);
        return;
    }
    const struct method *method = execution->only_timed ? NULL : method_to_use(execution);
    execution->chosen = method;
    execution->divided = false;
    if (!method) {
        go_alone(execution);
        return;
    }
    const enum reason reason = objection(execution, method);
    if (reason != REASON_NONE)
        redcc_refuse(execution, reason);
    else if (!method->by_graph || !redcc_begin_gathering(execution))
        redcc_make_plan(execution);
}

static void after_sweep(struct execution *execution) {
    bool told_all = true;
    for (int thread = 0; thread < execution->threads; thread++)
        told_all = told_all && execution->state->member[thread]->told_all;
    if (redcc_some_failed(execution) || !told_all) {
        redcc_refuse(execution, redcc_some_failed(execution) ? REASON_NO_MEMORY : REASON_INSPECTOR);
        return;
    }
    redcc_gather_touched(execution);
    gather_sources(execution);
    if (!redcc_guard(execution->sources, execution->request.loop->source_count, execution->touched,
                     execution->partition.array_count, &execution->clash_source,
                     &execution->clash_array)) {
        redcc_refuse(execution, REASON_OVERLAP);
        return;
    }
    switch (redcc_partition_merge(&execution->partition, execution->touched)) {
    case MERGE_REFUSED:
        redcc_refuse(execution, REASON_OUT_OF_STEP);
        break;
    case MERGE_DONE:
        redcc_cut_and_sweep(execution);
        break;
    case MERGE_NOTHING:
        redcc_choose_and_go_on(execution);
        break;
    }
}

static void prepare(struct member *member) {
    struct execution *execution = member->execution;
    struct plan *plan = execution->plan;
    const struct evidence evidence = {
        .partition = &execution->partition,
        .summary = execution->summaries,
        .seen = execution->seen,
        .threads = execution->threads,
        .trip = execution->request.trip,
        .levels = &execution->levels,
        .every_iteration = (execution->request.loop->flags & REDCC_EVERY_ITERATION) != 0};
    member->failed =
        !plan->method->prepare(plan, &evidence, member->thread) ||
        !redcc_copies_take(plan, member->thread, member->seen, execution->partition.base);
    if (redcc_plan_reusable(&execution->request, execution->sources))
        redcc_take_fingerprints(member);
}

static void after_prepare(struct execution *execution) {
    if (redcc_some_failed(execution)) {
        redcc_plan_free(execution->plan);
        execution->plan = NULL;
        redcc_refuse(execution, REASON_NO_MEMORY);
        return;
    }
    redcc_plan_finish(execution->plan);
    redcc_record_fingerprints(execution);
    execution->next = PHASE_RUN;
}

static void begin_with_candidate(struct member *member) {
    struct execution *execution = member->execution;
    if (!execution->candidate || !redcc_verify(member)) {
        redcc_meet(member, begin_inspection);
        return;
    }
    member->plan = execution->candidate;
    member->phase = PHASE_RUN;
    if (member->thread == 0) {
        execution->plan = execution->candidate;
        execution->plan_is_kept = true;
    }
}

int redcc_inspect(redcc_worker *worker) {
    struct member *member = worker->execution;
    while (member)
        switch (member->phase) {
        case PHASE_RECOUNT:
            redcc_meet(member, recount);
            break;
        case PHASE_BEGIN:
            begin_with_candidate(member);
            break;
        case PHASE_SAMPLE:
            if (redcc_hand_out_sample(worker))
                return 1;
            break;
        case PHASE_SAMPLED:
            if (!member->failed && worker->entry)
                redcc_flush(worker);
            redcc_meet(member, redcc_after_sample);
            break;
        case PHASE_SWEEP:
            begin_sweep(member);
            break;
        case PHASE_SWEEPING:
            close_block(worker);
            if (hand_out_block(worker))
                return 1;
            if (!member->failed)
                redcc_sweep_count(&member->sweep, member->executed);
            redcc_meet(member, after_sweep);
            break;
        case PHASE_GATHER:
            redcc_gather(member);
            break;
        case PHASE_GATHERING:
            if (redcc_gathering(worker))
                return 1;
            break;
        case PHASE_DIVIDE:
            redcc_divide_share(member);
            break;
        case PHASE_JOIN:
            redcc_join_share(member);
            break;
        case PHASE_PREPARE:
            prepare(member);
            redcc_meet(member, after_prepare);
            member->plan = member->execution->plan;
            break;
        case PHASE_RUN:
        case PHASE_RUNNING:
        case PHASE_CHECKING:
        case PHASE_OVER:
            return 0;
        }
    return 0;
}

void redcc_flush(redcc_worker *worker) {
    struct member *member = worker->execution;
    if (member->phase == PHASE_SAMPLED)
        redcc_take_sample(member, worker->entry);
    else if (member->phase == PHASE_GATHERING)
        redcc_told_take(&member->execution->divide.told[member->thread], member->entries,
                        worker->entry);
    else {
        redcc_sweep_take_window(&member->sweep, worker->alike, worker->inside);
        redcc_sweep_take(&member->sweep, member->entries, worker->entry);
    }
    worker->alike = 0;
    worker->inside = 0;
    worker->entry = member->entries;
}
