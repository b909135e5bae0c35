/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Inspection, in the threads of the region: a sample of the iterations, from which the arrays are
 * cut; then all of them, which gives the access summary, the exact extents and the guard; where the
 * owners are to be cut from the access graph, all of them once more (gather.c); then each thread
 * prepares its part of the plan. All threads walk through the same phases.
 */
#include "inspect.h"

#include "cuts.h"
#include "guard.h"
#include "memory.h"

#include <string.h>

enum {
    LEAST_WITH_SPARES = 4096,   /* iterations */
    SAMPLED_FOR_AN_OWNER = 512, /* iterations, by all threads together */
    SAMPLED_MOST = 8192,
    SAMPLED_TOUCHES = 32768,                    /* kept of them, by few owners; by many */
    SAMPLED_TOUCHES_AN_OWNER = 2048,            /* so many each, */
    SAMPLED_TOUCHES_MOST = 4 * SAMPLED_TOUCHES, /* up to this */
    ROWS_OF_A_TOUCH = 64,
    TAKEN_AT_ONCE = 512 * 1024 /* bytes of subscripts, that the caches hold */
};

void redcc_refuse(struct execution *execution, enum reason reason) {
    execution->reason = reason;
    execution->next = PHASE_OVER;
}

static bool some_failed(const struct execution *execution) {
    for (int thread = 0; thread < execution->threads; thread++)
        if (execution->state->member[thread]->failed)
            return true;
    return false;
}

static void recount(struct execution *execution) {
    redcc_find_candidate(execution, execution->threads);
    execution->next = PHASE_BEGIN;
}

/* With how many spare owners for each thread? auto sees by the sample what they cost. */
static uint32_t spares_to_cut_for(const struct execution *execution) {
    const struct method *method = execution->method;
    const bool spares = method ? method->spares
                               : execution->course == COURSE_PARALLEL && !execution->by_graph &&
                                     execution->request.trip >= LEAST_WITH_SPARES;
    return spares ? REDCC_SPARES : 0;
}

static uint32_t owners_to_cut_for(const struct execution *execution) {
    const struct method *method = execution->method;
    if (method && method->owners)
        return method->owners(execution->threads, execution->parameter);
    return (uint32_t)execution->threads * (1 + spares_to_cut_for(execution));
}

/* auto may come to spare owners later. */
static uint32_t most_owners(const struct execution *execution) {
    return execution->method ? owners_to_cut_for(execution)
                             : (uint32_t)execution->threads * (1 + REDCC_SPARES);
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
    if (!redcc_partition_begin(&execution->partition, execution->request.loop,
                               execution->request.bases, most_owners(execution)) ||
        !execution->samples || !execution->summaries || !execution->seen)
        redcc_refuse(execution, REASON_NO_MEMORY);
    execution->partition.owners = owners_to_cut_for(execution);
    execution->partition.spares = spares_to_cut_for(execution);
}

redcc_int redcc_own_begin(const struct member *member) {
    return redcc_share(member->execution->request.trip, member->threads, member->thread);
}

redcc_int redcc_own_end(const struct member *member) {
    return redcc_share(member->execution->request.trip, member->threads, member->thread + 1);
}

/* Iterations 0, stride, 2 stride, ... are sampled, however many threads share them. The stride is
 * odd, or it might meet the same corner of each element again and again. Sorting more touches than
 * few owners need would cost more than the sweep of all iterations. */
static redcc_int sample_stride(const struct execution *execution) {
    const struct partition *partition = &execution->partition;
    const redcc_int shares = partition->owners / (1 + partition->spares);
    const redcc_int wanted = shares * SAMPLED_FOR_AN_OWNER;
    return execution->request.trip / (wanted < SAMPLED_MOST ? wanted : SAMPLED_MOST) | 1;
}

/* How many of them lie before this thread's share. */
static redcc_int sampled_before(const struct member *member) {
    const redcc_int stride = sample_stride(member->execution);
    return (redcc_own_begin(member) + stride - 1) / stride;
}

/* A part's cuts can be no more even than the touches from which they are chosen. (Where results
 * must not depend on the number of threads each of them has room for all, so these are few.) */
static size_t touches_to_keep(const struct execution *execution) {
    if (execution->method && execution->method->keeps == REDCC_ORDER_FIXED)
        return SAMPLED_TOUCHES;
    const size_t wanted = (size_t)execution->partition.owners * SAMPLED_TOUCHES_AN_OWNER;
    const size_t most = wanted < SAMPLED_TOUCHES_MOST ? wanted : SAMPLED_TOUCHES_MOST;
    return most < SAMPLED_TOUCHES ? SAMPLED_TOUCHES : most;
}

/* Where results must not depend on the number of threads, each has room for whatever of its share
 * may stay in the end. */
static size_t sample_room(const struct member *member) {
    const struct method *method = member->execution->method;
    const size_t all = touches_to_keep(member->execution);
    const size_t least = 1024, even = all / (size_t)member->threads;
    if (method && method->keeps == REDCC_ORDER_FIXED)
        return all;
    return even > least ? even : least;
}

static bool begin_member(struct member *member) {
    const struct partition *partition = &member->execution->partition;
    member->entries = redcc_memory_take(REDCC_ENTRIES * sizeof *member->entries);
    member->seen = redcc_memory_take(partition->array_count * sizeof *member->seen);
    member->executed = redcc_memory_take_zeroed(partition->room, sizeof *member->executed);
    if (!redcc_sample_begin(&member->sample, sample_room(member),
                            (uint64_t)sampled_before(member)) ||
        !member->entries || !member->seen || !member->executed)
        return false;
    for (uint32_t array = 0; array < partition->array_count; array++) {
        member->seen[array] = redcc_nowhere;
        member->owner[array] = (redcc_owner){.first = 0}; /* of a sample, all touches are entered */
    }
    for (uint32_t s = 0; s < member->execution->request.loop->source_count; s++)
        member->sources[s] = (redcc_extent){0, 0};
    return true;
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

static int hand_out_sample(redcc_worker *worker) {
    struct member *member = worker->execution;
    const redcc_int stride = sample_stride(member->execution);
    const redcc_int first = stride * sampled_before(member);
    member->failed = !begin_member(member);
    member->phase = PHASE_SAMPLED;
    if (member->failed || first >= redcc_own_end(member))
        return 0;
    return redcc_hand_out(worker, first, redcc_own_end(member), stride, member->owner);
}

/* A touch of several rows weighs as much as they do, up to some: cuts lie between rows. */
static void sample_rows(struct member *member, const redcc_entry *entry) {
    const uint32_t unit = member->execution->partition.arrays[entry->array].unit;
    const uint32_t rows = entry->bytes / unit > 0 ? entry->bytes / unit : 1;
    const uint32_t step = (rows + ROWS_OF_A_TOUCH - 1) / ROWS_OF_A_TOUCH;
    for (uint32_t row = 0; row < rows; row += step)
        redcc_sample_add(&member->sample, (uintptr_t)entry->address + (uintptr_t)row * unit,
                         entry->array);
}

static void take_sample(struct member *member, const redcc_entry *end) {
    for (const redcc_entry *entry = member->entries; entry != end; entry++) {
        if (entry->array == REDCC_END_OF_ITERATION) {
            redcc_sample_next_iteration(&member->sample);
            continue;
        }
        const uintptr_t first = (uintptr_t)entry->address;
        if (entry->bytes == 0)
            continue;
        member->seen[entry->array] = redcc_range_union(member->seen[entry->array],
                                                       (struct range){first, first + entry->bytes});
        sample_rows(member, entry);
    }
}

/* What the threads touched, by group. */
static void gather_touched(struct execution *execution) {
    for (uint32_t group = 0; group < execution->partition.array_count; group++) {
        execution->touched[group] = redcc_nowhere;
        for (int thread = 0; thread < execution->threads; thread++)
            execution->touched[group] = redcc_range_union(
                execution->touched[group], execution->state->member[thread]->seen[group]);
    }
}

/* Groups were put together: so is what each thread has seen of them. */
static void regroup_seen(struct execution *execution) {
    const struct partition *partition = &execution->partition;
    for (int thread = 0; thread < execution->threads; thread++) {
        struct range *seen = execution->state->member[thread]->seen;
        for (uint32_t array = 0; array < partition->array_count; array++) {
            const uint32_t group = partition->group_of[array];
            if (group == array)
                continue;
            seen[group] = redcc_range_union(seen[group], seen[array]);
            seen[array] = redcc_nowhere;
        }
    }
}

/* Nothing but the original loop is left, or nothing is known of it: one thread executes it, so that
 * it is known how long that takes. Even that wants the guard: what the body reads once, as where an
 * array lies, must not be among what it updates. */
static void go_alone(struct execution *execution) {
    execution->course = COURSE_SOLO;
    execution->planless = true;
    execution->next = PHASE_RUN;
}

/* auto, by the sample: is it worth going on, and by copies, or to be timed first? Then it need not
 * be told apart who touches what: only where and how far, for the guard and the copies. */
static void look_ahead(struct execution *execution, const struct estimate *estimate) {
    switch (redcc_find_way(execution, estimate)) {
    case RULE_DEFERRED:
        redcc_refuse(execution, REASON_REPLICATION);
        break;
    case RULE_COSTLY:
        redcc_refuse(execution, REASON_COSTLY);
        break;
    case RULE_TIMED:
        execution->only_timed = true;
        redcc_partition_in_one(&execution->partition);
        break;
    case RULE_COPIES:
    case RULE_CHEAP_COPIES:
        execution->for_copies = true;
        redcc_partition_in_one(&execution->partition);
        break;
    default:
        break;
    }
}

/* Where the others lie the sweep tells. */
static void place_known_sources(struct execution *execution) {
    const struct request *request = &execution->request;
    for (uint32_t s = 0; s < request->loop->source_count; s++) {
        const redcc_extent known = request->known[s];
        execution->sources[s] = known.end
                                    ? (struct range){(uintptr_t)known.first, (uintptr_t)known.end}
                                    : redcc_nowhere;
    }
}

/* Sends all to a sweep with groups that do not overlap, as far as is known, newly cut. */
static void cut_and_sweep(struct execution *execution) {
    regroup_seen(execution);
    execution->partition.owners = owners_to_cut_for(execution);
    execution->partition.spares = spares_to_cut_for(execution);
    execution->for_copies = execution->only_timed = false;
    for (int thread = 0; thread < execution->threads; thread++)
        execution->samples[thread] = &execution->state->member[thread]->sample;
    execution->next = PHASE_SWEEP;
    place_known_sources(execution);
    struct estimate estimate = {0};
    if (!redcc_choose_cuts(&execution->partition, execution->samples, execution->threads) ||
        (!execution->method && !redcc_estimate(&execution->partition, execution->samples,
                                               execution->threads, &estimate))) {
        redcc_refuse(execution, REASON_NO_MEMORY);
        return;
    }
    execution->touches = estimate.touches;
    if (!execution->method && execution->partition.spares > 0 &&
        !redcc_choose_spares(&execution->state->chooser, execution->request.trip,
                             execution->threads, &estimate))
        redcc_partition_join_spares(&execution->partition);
    if (!execution->method && execution->course == COURSE_PARALLEL)
        look_ahead(execution, &estimate);
}

/* One item stands for as many touches in all samples, and all have touches_to_keep at most. */
static void thin_samples(struct execution *execution) {
    struct member *const *member = execution->state->member;
    uint64_t keep_each = 1;
    size_t count = SIZE_MAX;
    for (int thread = 0; thread < execution->threads; thread++)
        if (member[thread]->sample.keep_each > keep_each)
            keep_each = member[thread]->sample.keep_each;
    for (; count > touches_to_keep(execution); keep_each *= 2) {
        count = 0;
        for (int thread = 0; thread < execution->threads; thread++)
            count += redcc_sample_count(&member[thread]->sample, keep_each);
    }
    for (int thread = 0; thread < execution->threads; thread++)
        redcc_sample_thin(&member[thread]->sample, keep_each / 2);
}

static void after_sample(struct execution *execution) {
    if (some_failed(execution)) {
        redcc_refuse(execution, REASON_NO_MEMORY);
        return;
    }
    thin_samples(execution);
    gather_touched(execution);
    if (redcc_partition_merge(&execution->partition, execution->touched) == MERGE_REFUSED)
        redcc_refuse(execution, REASON_OUT_OF_STEP);
    else
        cut_and_sweep(execution);
}

/* As many iterations as read so much of the subscripts, whose fingerprints are then taken. */
static redcc_int iterations_at_once(struct member *member) {
    const size_t bytes = member->execution->only_timed ? 0 : redcc_begin_taking(member);
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
        cut_and_sweep(execution);
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
    if (some_failed(execution) || !told_all) {
        redcc_refuse(execution, some_failed(execution) ? REASON_NO_MEMORY : REASON_INSPECTOR);
        return;
    }
    gather_touched(execution);
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
        cut_and_sweep(execution);
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
    if (some_failed(execution)) {
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
            if (hand_out_sample(worker))
                return 1;
            break;
        case PHASE_SAMPLED:
            if (!member->failed && worker->entry)
                redcc_flush(worker);
            redcc_meet(member, after_sample);
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
        take_sample(member, worker->entry);
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
