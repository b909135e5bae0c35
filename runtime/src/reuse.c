/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Using plans again: which one may fit, and are its subscripts what they were? */
#include "loop.h"

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
            redcc_ask_watch(execution);
            return;
        }
    }
}

static struct reading reading_of(const struct execution *execution, uint32_t source) {
    return redcc_reading_of(execution->request.loop, execution->request.known, execution->sources,
                            source);
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
    member->fingerprint[source] = redcc_share_fingerprint(member, reading_of(execution, source));
    if (redcc_barrier_arrive(&execution->barrier, member->threads)) {
        execution->verified = redcc_fingerprint_equal(
            joined(execution, source), execution->candidate->source[source].fingerprint);
        redcc_barrier_release(&execution->barrier);
    }
    return execution->verified;
}

static bool verify_alone(const struct execution *execution, uint32_t source) {
    return redcc_fingerprint_equal(redcc_reading_fingerprint(reading_of(execution, source)),
                                   execution->candidate->source[source].fingerprint);
}

/* What a later execution goes by is written by the first thread, and read by no other in this
 * one. */
static bool verify_by_reading(struct member *member, uint32_t source) {
    struct execution *execution = member->execution;
    const bool same = redcc_is_small(reading_of(execution, source))
                          ? verify_alone(execution, source)
                          : verify_together(member, source);
    if (same && member->thread == 0)
        redcc_note_unchanged(execution, source);
    return same;
}

bool redcc_verify(struct member *member) {
    const struct execution *execution = member->execution;
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++) {
        if (!loop->sources[s].is_subscript)
            continue;
        const bool same = execution->candidate->source[s].vouch.stands
                              ? redcc_vouched_unchanged(execution, s)
                              : verify_by_reading(member, s);
        if (!same)
            return false;
    }
    return true;
}

void redcc_record_fingerprints(const struct execution *execution) {
    const redcc_loop *loop = execution->request.loop;
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (loop->sources[s].is_subscript)
            execution->plan->source[s].fingerprint =
                redcc_is_small(reading_of(execution, s))
                    ? execution->state->member[0]->fingerprint[s]
                    : joined(execution, s);
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

static void drop_plan(struct loop_state *state, int place) {
    redcc_plan_free(state->plans[place]);
    state->plans[place] = NULL;
}

void redcc_drop_plans(struct loop_state *state) {
    for (int p = 0; p < REDCC_PLANS; p++)
        drop_plan(state, p);
}

void redcc_drop_plain_plans(struct loop_state *state) {
    for (int p = 0; p < REDCC_PLANS; p++)
        if (state->plans[p] && !state->plans[p]->method->by_graph)
            drop_plan(state, p);
}
