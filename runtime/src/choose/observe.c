/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/size.h"

/* Difference of two ways that ends their comparison after one pair, two, three. */
static const double evident[] = {0.3, 0.2, 0.1};
static const double noise_low = 0.6, noise_high = 1.6;
static const double latest = 0.25; /* what an execution counts in the mean of those by a plan */

enum {
    PAIRS = 3, /* of a comparison: decides right in 19 of 20 cases at a noise of 30 % */
    /* Calls, of the first rest. */
    SLOWER_REST = 16,
    LEFT_REST = 4, /* a round is timed once, and what is lost on it is little */
    UNATTRACTIVE_REST = 64,
    REFUSED_REST = 2
};

static void stop_resting(struct size_state *size, enum stand stand) {
    size->rest.length = 0;
    size->stand = stand;
}

/* The way was tried and failed. Is there one that may be better? */
static bool another_may_do(struct size_state *size, enum way way) {
    size->prospect[way].possible = false;
    size->prospect[way].ruled_out = true;
    return redcc_some_way_is_better(size);
}

/* The way was slower than the sequential loop. Bins have no set-up that is lost with them. */
static void return_to_sequential(struct size_state *size, enum way way, long rest) {
    if (way == WAY_BINS && another_may_do(size, WAY_BINS))
        stop_resting(size, STAND_SAVING);
    else
        redcc_rest(size, STAND_RESTING, RULE_SLOWER, rest, REDCC_REST_MOST);
}

/* A comparison is over: the contender was the faster way, or not. */
static void settle(struct size_state *size, bool contender_won) {
    const struct comparison *it = &size->comparison;
    struct prospect *prospect = &size->prospect[it->contender];
    prospect->execution = it->contender_sum / it->contended;
    prospect->measured = true;
    size->way = contender_won || it->incumbent == WAY_SEQUENTIAL ? it->contender : it->incumbent;
    size->unchecked = 0;
    if (!contender_won && it->incumbent == WAY_SEQUENTIAL) {
        size->checks = 0;
        return_to_sequential(size, it->contender, SLOWER_REST);
        return;
    }
    stop_resting(size, STAND_PARALLEL);
    size->rule = RULE_FASTER;
}

static void settle_if_evident(struct size_state *size) {
    const struct comparison *it = &size->comparison;
    if (it->incumbent == WAY_SEQUENTIAL && it->contended == 1 && it->defended == 0 &&
        it->contender_sum < redcc_clear * redcc_usual(&size->sequential)) {
        settle(size, true);
        return;
    }
    if (it->contended != it->defended)
        return;
    const double difference = it->incumbent_sum - it->contender_sum;
    const double needed = evident[it->contended - 1] * it->incumbent_sum;
    if (difference > needed || -difference > needed || it->contended >= PAIRS)
        settle(size, difference > 0);
}

static void count_in_comparison(struct size_state *size, enum way way, double each) {
    struct comparison *it = &size->comparison;
    if (way != (it->incumbents_turn ? it->incumbent : it->contender))
        return; /* sequential for want of credit */
    if (it->incumbents_turn) {
        it->incumbent_sum += each;
        it->defended++;
    } else {
        it->contender_sum += each;
        it->contended++;
    }
    it->incumbents_turn = !it->incumbents_turn;
    settle_if_evident(size);
}

/* More than noise lies between two timings of a loop. */
static bool is_another(double before, double now) {
    return now < noise_low * before || now > noise_high * before;
}

static void observe_sequential(struct choice_state *state, struct size_state *size,
                               const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    const double all = outcome->seconds * (double)(1 + outcome->untimed);
    state->ledger.sequential += all;
    size->set_ups.since += all;
    size->rest.calls += outcome->untimed;
    const bool comparing = size->stand == STAND_COMPARING;
    const bool checked = comparing && size->comparison.incumbent == WAY_SEQUENTIAL &&
                         size->comparison.incumbents_turn && size->comparison.defended == 0;
    if (checked && is_another(redcc_usual(&size->sequential), each))
        size->sequential.count = 0; /* timed before the machine changed: of no use */
    redcc_note_timing(&size->sequential, each);
    if (size->rest.calls < size->sequential.count) /* timed before the loop had a state */
        size->rest.calls = size->sequential.count;
    if (comparing)
        count_in_comparison(size, WAY_SEQUENTIAL, each);
}

static void count_set_up(struct size_state *size, enum way way, double seconds) {
    struct set_ups *it = &size->set_ups;
    const double factor = redcc_next_factor(it);
    const int misses = redcc_next_misses(it);
    *it = (struct set_ups){.factor = factor,
                           .invested = seconds,
                           .misses = misses,
                           .begun = size->rest.calls,
                           .met = size->steady,
                           .lifetime = it->lifetime};
    size->prospect[way].learned = seconds;
    size->prospect[way].possible = true;
    size->checks = 0;
}

/* The first execution by a new plan starts threads and touches pages: it is only compared where it
 * is clearly the faster way in spite of that. */
static void begin_trial(struct size_state *size, enum way way, double each) {
    const bool rival = size->stand == STAND_PARALLEL && size->way != way;
    redcc_compare(size, way, rival ? size->way : WAY_SEQUENTIAL);
    if (!rival && each < redcc_clear * redcc_usual(&size->sequential))
        count_in_comparison(size, way, each);
}

/* An execution that was not the sequential loop's. Returns the seconds that one would have taken.
 */
static double enter_in_ledger(struct choice_state *state, const struct size_state *size,
                              const struct outcome *outcome) {
    const double sequential = redcc_least(&size->sequential) * (double)outcome->trip;
    state->ledger.sequential += sequential;
    state->ledger.overhead += outcome->seconds + outcome->set_up - sequential;
    return sequential;
}

static void observe_parallel(struct choice_state *state, struct size_state *size,
                             const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    const double sequential = enter_in_ledger(state, size, outcome);
    struct prospect *prospect = &size->prospect[outcome->way];
    if (outcome->set_up > 0) {
        if (size->stand == STAND_SAVING && size->set_ups.uses > 0)
            size->set_ups.lifetime = size->set_ups.met + size->set_ups.uses;
        count_set_up(size, outcome->way, outcome->set_up);
    }
    size->set_ups.uses++;
    size->set_ups.since += sequential;
    size->set_ups.earned += sequential - outcome->seconds;
    size->gained = outcome->seconds < sequential;
    if (outcome->set_up > 0) {
        begin_trial(size, outcome->way, each);
        return;
    }
    if (outcome->way == WAY_BINS && !prospect->measured) { /* takes memory, as a new plan does */
        prospect->execution = each;
        prospect->measured = true;
        begin_trial(size, outcome->way, each);
        return;
    }
    prospect->execution +=
        prospect->measured ? latest * (each - prospect->execution) : each - prospect->execution;
    prospect->measured = true;
    if (size->stand == STAND_COMPARING)
        count_in_comparison(size, outcome->way, each);
    else if (size->stand == STAND_PARALLEL)
        size->unchecked += outcome->seconds;
}

/* Of all ways bins alone can be left in the middle. */
static void observe_left(struct choice_state *state, struct size_state *size,
                         const struct outcome *outcome) {
    struct prospect *prospect = &size->prospect[outcome->way];
    size->set_ups.since += enter_in_ledger(state, size, outcome);
    prospect->execution = outcome->seconds / (double)outcome->trip;
    prospect->measured = true;
    size->way = outcome->way;
    return_to_sequential(size, outcome->way, LEFT_REST);
}

static void observe_stop(struct size_state *size, const struct outcome *outcome) {
    size->rule = RULE_STOPPED;
    const double whole = outcome->done > 0.01 ? outcome->seconds / outcome->done : 0;
    const double twice = 2 * outcome->seconds;
    const double expected = whole > twice ? whole : twice;
    if (outcome->way == WAY_SEQUENTIAL) { /* a look, by its dry run */
        size->look = expected;
        return;
    }
    count_set_up(size, outcome->way, outcome->seconds);
    size->prospect[outcome->way].learned = expected;
    if (size->stand != STAND_PARALLEL)
        size->stand = STAND_SAVING;
}

/* Of one way: then another one may do. Of all: the loop rests. */
static void observe_refusal(struct size_state *size, const struct outcome *outcome) {
    const bool another = another_may_do(size, outcome->way) && outcome->way != WAY_SEQUENTIAL;
    if (size->stand != STAND_PARALLEL && !another)
        redcc_rest(size, STAND_RESTING, RULE_REFUSED, REFUSED_REST, REDCC_REST_MOST);
}

/* A loan is repaid, or what it was given for has failed: then nothing more may be spent of it. */
static void end_loan(struct choice_state *state, const struct size_state *size,
                     enum result result) {
    const bool failed =
        (result != RESULT_SEQUENTIAL && result != RESULT_PARALLEL) || size->stand == STAND_RESTING;
    if (failed || redcc_credit(state) >= state->ledger.loan)
        state->ledger.loan = 0;
}

static void take_in(struct choice_state *state, struct size_state *size,
                    const struct outcome *outcome) {
    switch (outcome->result) {
    case RESULT_SEQUENTIAL:
        observe_sequential(state, size, outcome);
        return;
    case RESULT_PARALLEL:
        observe_parallel(state, size, outcome);
        return;
    case RESULT_LEFT:
        observe_left(state, size, outcome);
        return;
    case RESULT_UNATTRACTIVE:
        if (outcome->way != WAY_SEQUENTIAL)
            count_set_up(size, outcome->way, outcome->seconds);
        size->prospect[outcome->way].possible = false;
        size->prospect[outcome->way].ruled_out = true;
        if (!redcc_some_way_is_better(size))
            redcc_rest(size, STAND_RESTING, RULE_UNATTRACTIVE, UNATTRACTIVE_REST, REDCC_REST_MOST);
        break;
    case RESULT_STOPPED:
        observe_stop(size, outcome);
        break;
    case RESULT_CHANGED:
        size->stand = STAND_SAVING;
        size->rule = RULE_CHANGED;
        break;
    case RESULT_REFUSED:
        observe_refusal(size, outcome);
        break;
    }
    state->ledger.overhead += outcome->seconds;
}

void redcc_observe(struct choice_state *state, const struct outcome *outcome) {
    struct size_state *size = redcc_size_of(state, outcome->trip);
    take_in(state, size, outcome);
    end_loan(state, size, outcome->result);
}
