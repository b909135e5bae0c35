/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/check.h"

#include <assert.h>

#include "ownership/graph/levels.h"

/* Walks through the runs of a schedule in the order of execution. */
struct walk {
    const struct schedule *schedule;
    size_t chunk; /* index of the next chunk */
    struct run_reader runs;
    redcc_int origin;
    redcc_int begin; /* the first remaining iteration of the current run */
    redcc_int count; /* number of remaining iterations of the run */
    uint32_t stage;
    bool checked;
};

/* Advances to the next run if the current run has no iterations left. False: there is no next run.
 */
static bool advance(struct walk *walk) {
    redcc_iterations run;
    while (walk->count == 0) {
        if (redcc_runs_read(&walk->runs, &run, 1) == 1) {
            walk->begin = walk->origin + run.begin;
            walk->count = run.count_and_check / 2;
            walk->checked = run.count_and_check & 1;
        } else if (walk->chunk < walk->schedule->chunk_count) {
            const struct chunk *chunk = &walk->schedule->chunk[walk->chunk++];
            walk->runs = redcc_runs_of(walk->schedule, chunk);
            walk->origin = chunk->origin;
            walk->stage = chunk->stage;
        } else {
            return false;
        }
    }
    return true;
}

enum expected { CHECKED_NEVER, CHECKED_MAYBE, CHECKED_ALWAYS };

/* Are the iterations [begin, begin + count) the next iterations of the walk? */
static bool comes_next(struct walk *walk, redcc_int begin, redcc_int count,
                       enum expected expected) {
    while (count > 0) {
        if (!advance(walk) || walk->begin != begin ||
            (expected == CHECKED_NEVER && walk->checked) ||
            (expected == CHECKED_ALWAYS && !walk->checked))
            return false;
        const redcc_int piece = walk->count < count ? walk->count : count;
        walk->begin += piece;
        walk->count -= piece;
        begin += piece;
        count -= piece;
    }
    return true;
}

/* ---- LOCALWRITE ------------------------------------------------------------------------------ */

static bool contains(const struct sets *sets, uint32_t set, uint32_t owner) {
    for (size_t m = sets->start[set]; m < sets->start[set + 1]; m++)
        if (sets->member[m] == owner)
            return true;
    return false;
}

/* Does the walk continue with those iterations of the summary that the owner must execute? */
static bool owner_follows(struct walk *walk, const struct summary *summary, uint32_t owner,
                          bool takes_idle) {
    for (size_t b = 0; b < summary->block_count; b++) {
        const struct block *block = &summary->block[b];
        for (size_t s = block->span_begin; s < block->span_end; s++) {
            const struct span span = summary->span[s];
            const bool shared = redcc_set_size(&summary->sets, span.set) > 1;
            const bool own = span.set ? contains(&summary->sets, span.set, owner) : takes_idle;
            const enum expected expected = shared ? CHECKED_ALWAYS : CHECKED_MAYBE;
            if (own && !comes_next(walk, block->origin + span.begin,
                                   redcc_span_count(summary, block, s), expected))
                return false;
        }
    }
    return true;
}

static bool owner_is_right(const struct plan *plan, const struct evidence *evidence,
                           uint32_t owner) {
    const uint32_t each = plan->method->steals ? 1 + REDCC_STEALABLE : 1;
    const int thread = owner % each == 0 ? (int)(owner / each) : -1; /* -1: a stealable block */
    struct walk walk = {.schedule = &plan->schedule[owner]};
    for (int from = 0; from < evidence->threads; from++)
        if (!owner_follows(&walk, evidence->summary[from], owner,
                           evidence->every_iteration && from == thread))
            return false;
    if (!evidence->every_iteration && thread == evidence->threads - 1 &&
        redcc_last_touches_nothing(evidence) &&
        !comes_next(&walk, evidence->trip - 1, 1, CHECKED_NEVER))
        return false;
    return !advance(&walk);
}

/* ---- levels ---------------------------------------------------------------------------------- */

static bool levels_are_right(const struct plan *plan, const struct evidence *evidence, int thread) {
    const struct levels *levels = evidence->levels;
    struct walk walk = {.schedule = &plan->schedule[thread]};
    for (uint32_t stage = 0; stage < levels->stages; stage++) {
        uint32_t first, end;
        redcc_levels_share(levels, stage, plan->threads, thread, &first, &end);
        for (uint32_t i = first; i < end; i++)
            if (!comes_next(&walk, levels->iteration[i], 1, CHECKED_NEVER) || walk.stage != stage)
                return false;
    }
    return !advance(&walk);
}

/* ---- each iteration once --------------------------------------------------------------------- */

/* Moments of a multiset of iterations: their number, sum, and sum of squares, modulo 2^64. */
struct moments {
    uint64_t count;
    uint64_t sum;
    uint64_t squares;
};

/* 0 + 1 + 4 + ... + (n - 1)^2 = (n - 1) n (2 n - 1) / 6 */
static uint64_t squares_below(uint64_t n) {
    uint64_t factor[] = {n - 1, n, 2 * n - 1};
    factor[n % 2 ? 0 : 1] /= 2;
    for (int f = 0; f < 3; f++)
        if (factor[f] % 3 == 0) {
            factor[f] /= 3;
            break;
        }
    return factor[0] * factor[1] * factor[2];
}

static void add_moments(struct moments *moments, redcc_int begin, redcc_int count) {
    const uint64_t b = (uint64_t)begin, n = (uint64_t)count;
    if (n == 0)
        return;
    const uint64_t below = n % 2 ? (n - 1) / 2 * n : n / 2 * (n - 1);
    moments->count += n;
    moments->sum += n * b + below;
    moments->squares += n * b * b + 2 * b * below + squares_below(n);
}

static bool moments_equal(struct moments a, struct moments b) {
    return a.count == b.count && a.sum == b.sum && a.squares == b.squares;
}

static struct moments moments_of_touching(const struct evidence *evidence) {
    struct moments moments = {0};
    for (int from = 0; from < evidence->threads; from++) {
        const struct summary *summary = evidence->summary[from];
        for (size_t b = 0; b < summary->block_count; b++)
            for (size_t s = summary->block[b].span_begin; s < summary->block[b].span_end; s++)
                if (summary->span[s].set)
                    add_moments(&moments, summary->block[b].origin + summary->span[s].begin,
                                redcc_span_count(summary, &summary->block[b], s));
    }
    if (redcc_last_touches_nothing(evidence))
        add_moments(&moments, evidence->trip - 1, 1);
    return moments;
}

static bool each_is_there_once(const struct plan *plan, const struct evidence *evidence) {
    struct moments found = {0}, all = {0};
    for (uint32_t s = 0; s < plan->schedules; s++) {
        struct walk walk = {.schedule = &plan->schedule[s]};
        for (; advance(&walk); walk.count = 0) {
            if (walk.checked)
                return false;
            add_moments(&found, walk.begin, walk.count);
        }
    }
    add_moments(&all, 0, evidence->trip);
    return moments_equal(found, all) ||
           (!evidence->every_iteration && moments_equal(found, moments_of_touching(evidence)));
}

bool redcc_plan_is_right(const struct plan *plan, const struct evidence *evidence) {
    assert(plan->trip == evidence->trip);
    const struct method *method = plan->method;
    if (redcc_goes_without_schedules(method)) {
        for (uint32_t s = 0; s < plan->schedules; s++)
            if (plan->schedule[s].chunk_count > 0)
                return false;
    } else if (method->in_levels) {
        for (int thread = 0; thread < plan->threads; thread++)
            if (!levels_are_right(plan, evidence, thread))
                return false;
    } else if (method->keeps == REDCC_ORDER_SERIAL && method->copies == COPY_NONE) {
        for (uint32_t owner = 0; owner < plan->schedules; owner++)
            if (!owner_is_right(plan, evidence, owner))
                return false;
    } else if (!each_is_there_once(plan, evidence))
        return false;
    redcc_int executed = 0;
    for (uint32_t s = 0; s < plan->schedules; s++)
        executed += plan->schedule[s].iterations;
    return executed == plan->executed;
}
