/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inspection, its first phase: a sample of the iterations, by which the arrays are cut among the
 *  owners, and by which auto looks ahead. */
#include "inspect/inspect.h"

#include "base/memory.h"
#include "ownership/cuts.h"

enum {
    LEAST_TRIP_WITH_SPARES = 4096,
    SAMPLED_FOR_AN_OWNER = 512, /* iterations, by all threads together */
    SAMPLED_MOST = 8192,
    SAMPLED_TOUCHES = 32768,                    /* kept of them, by few owners; by many */
    SAMPLED_TOUCHES_AN_OWNER = 2048,            /* so many each, */
    SAMPLED_TOUCHES_MOST = 4 * SAMPLED_TOUCHES, /* up to this */
    ROWS_OF_A_TOUCH = 64
};

/* With how many spare owners for each thread? auto sees by the sample what they cost. */
static uint32_t spares_to_cut_for(const struct execution *execution) {
    const struct method *method = execution->method;
    const bool spares = method ? method->spares
                               : execution->course == COURSE_PARALLEL && !execution->by_graph &&
                                     execution->request.trip >= LEAST_TRIP_WITH_SPARES;
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

static void set_owners(struct execution *execution) {
    execution->partition.owners = owners_to_cut_for(execution);
    execution->partition.spares = spares_to_cut_for(execution);
}

bool redcc_begin_partition(struct execution *execution) {
    if (!redcc_partition_begin(&execution->partition, execution->request.loop,
                               execution->request.bases, most_owners(execution)))
        return false;
    set_owners(execution);
    return true;
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

int redcc_hand_out_sample(redcc_worker *worker) {
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

void redcc_take_sample(struct member *member, const redcc_entry *end) {
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
void redcc_gather_touched(struct execution *execution) {
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
void redcc_cut_and_sweep(struct execution *execution) {
    regroup_seen(execution);
    set_owners(execution);
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

void redcc_after_sample(struct execution *execution) {
    if (redcc_some_failed(execution)) {
        redcc_refuse(execution, REASON_NO_MEMORY);
        return;
    }
    thin_samples(execution);
    redcc_gather_touched(execution);
    if (redcc_partition_merge(&execution->partition, execution->touched) == MERGE_REFUSED)
        redcc_refuse(execution, REASON_OUT_OF_STEP);
    else
        redcc_cut_and_sweep(execution);
}
