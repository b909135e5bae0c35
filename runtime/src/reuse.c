/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Using plans again: which one may fit, and are its subscripts what they were? */
#include "loop.h"

/* A source below this size is read by every thread rather than shared out: dearer by less than the
 * barrier that is saved. */
enum { SMALL = 8192, STRIPE = 64 };

void redcc_find_candidate(struct execution *execution, int threads) {
    struct loop_state *state = execution->state;
    execution->candidate = NULL;
    for (int p = 0; p < REDCC_PLANS; p++) {
        struct plan *plan = state->plans[p];
        if (plan && !execution->method && plan->method->by_graph != execution->by_graph)
            continue;
        if (plan && redcc_plan_fits(plan, &execution->request, threads, execution->sources)) {
            plan->last_use = ++state->plan_clock;
            plan->round++;
            execution->candidate = plan;
            return;
        }
    }
}

static size_t bytes_of(struct range range) {
    return redcc_range_empty(range) ? 0 : range.end - range.first;
}

/* What is read to compare a source: not what an earlier one (counted from 1; 0: none) has shown
 * already, as of row_start[i] and row_start[i + 1]. How the two lie to each other is compared too.
 */
struct reading {
    struct range range;
    uint32_t beside;
    uintptr_t distance; /* from there to the source */
};

static struct reading reading_of(const struct execution *execution, uint32_t source) {
    const redcc_source *sources = execution->request.loop->sources;
    const struct range it = execution->sources[source];
    for (uint32_t s = 0; s < source; s++) {
        const struct range shown = execution->sources[s];
        struct range rest = it;
        if (!sources[s].is_subscript || !redcc_ranges_overlap(it, shown))
            continue;
        if (shown.first <= it.first)
            rest.first = shown.end < it.end ? shown.end : it.end;
        else if (shown.end >= it.end)
            rest.end = shown.first;
        else
            continue; /* on both sides something is left */
        return (struct reading){rest, s + 1, it.first - shown.first};
    }
    return (struct reading){it, 0, 0};
}

static struct fingerprint whole_of(struct reading reading) {
    const struct fingerprint parts[2] = {
        redcc_fingerprint((const char *)reading.range.first, bytes_of(reading.range)),
        {{reading.beside, reading.distance}}};
    return redcc_fingerprint_join(parts, 2);
}

static struct fingerprint share_of(struct reading reading, const struct member *member) {
    const size_t bytes = bytes_of(reading.range);
    const redcc_int stripes = (redcc_int)((bytes + STRIPE - 1) / STRIPE);
    const size_t first = (size_t)redcc_share(stripes, member->threads, member->thread) * STRIPE;
    const size_t end = (size_t)redcc_share(stripes, member->threads, member->thread + 1) * STRIPE;
    return redcc_fingerprint((const char *)reading.range.first + first,
                             (end < bytes ? end : bytes) - (first < bytes ? first : bytes));
}

static struct fingerprint joined(const struct execution *execution, uint32_t source) {
    enum { AT_ONCE = 64 };
    const struct reading reading = reading_of(execution, source);
    struct fingerprint part[AT_ONCE + 1] = {{{reading.beside, reading.distance}}};
    int count = 1;
    for (int thread = 0; thread < execution->threads; thread++) {
        part[count++] = execution->state->member[thread]->fingerprint[source];
        if (count > AT_ONCE) { /* what came first, then the next ones */
            part[0] = redcc_fingerprint_join(part, count);
            count = 1;
        }
    }
    return redcc_fingerprint_join(part, count);
}

/* The range of the next source may come from the contents of this one: no thread goes on to it
 * before all have found this one unchanged. */
static bool verify_together(struct member *member, uint32_t source) {
    struct execution *execution = member->execution;
    member->fingerprint[source] = share_of(reading_of(execution, source), member);
    if (redcc_barrier_arrive(&execution->barrier, member->threads)) {
        execution->verified = redcc_fingerprint_equal(
            joined(execution, source), execution->candidate->source[source].fingerprint);
        redcc_barrier_release(&execution->barrier);
    }
    return execution->verified;
}

bool redcc_verify(struct member *member) {
    const struct execution *execution = member->execution;
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!loop->sources[s].is_subscript)
            continue;
        const struct reading reading = reading_of(execution, s);
        const bool same = bytes_of(reading.range) > SMALL
                              ? verify_together(member, s)
                              : redcc_fingerprint_equal(
                                    whole_of(reading), execution->candidate->source[s].fingerprint);
        if (!same)
            return false;
    }
    return true;
}

void redcc_take_fingerprints(struct member *member) {
    const struct execution *execution = member->execution;
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!loop->sources[s].is_subscript)
            continue;
        const struct reading reading = reading_of(execution, s);
        if (bytes_of(reading.range) > SMALL)
            member->fingerprint[s] = share_of(reading, member);
        else if (member->thread == 0)
            member->fingerprint[s] = whole_of(reading);
    }
}

void redcc_record_fingerprints(const struct execution *execution) {
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (loop->sources[s].is_subscript)
            execution->plan->source[s].fingerprint =
                bytes_of(reading_of(execution, s).range) > SMALL
                    ? joined(execution, s)
                    : execution->state->member[0]->fingerprint[s];
}

void redcc_drop_candidate(struct execution *execution) {
    for (int p = 0; p < REDCC_PLANS; p++)
        if (execution->candidate && execution->state->plans[p] == execution->candidate)
            execution->state->plans[p] = NULL;
    redcc_plan_free(execution->candidate);
    execution->candidate = NULL;
}

void redcc_keep_plan(struct execution *execution) {
    struct loop_state *state = execution->state;
    int place = 0;
    for (int p = 1; p < REDCC_PLANS; p++)
        if (state->plans[place] &&
            (!state->plans[p] || state->plans[p]->last_use < state->plans[place]->last_use))
            place = p;
    redcc_plan_free(state->plans[place]);
    state->plans[place] = execution->plan;
    execution->plan->last_use = ++state->plan_clock;
    execution->plan_is_kept = true;
}

void redcc_drop_plans(struct loop_state *state) {
    for (int p = 0; p < REDCC_PLANS; p++) {
        redcc_plan_free(state->plans[p]);
        state->plans[p] = NULL;
    }
}
