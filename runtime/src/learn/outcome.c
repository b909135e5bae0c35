/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Processes the results of decisions: measurements replace estimates, comparisons end, and
 * unprofitable loops back off. */
#include "learn/learner.h"

#include <assert.h>

const struct size_state *redcc_size_of(const struct choice_state *state, long long trip) {
    assert(trip >= 0);
    const int logarithm = 63 - __builtin_clzll((unsigned long long)trip | 1);
    return &state->size[logarithm < REDCC_SIZES ? logarithm : REDCC_SIZES - 1];
}

double redcc_typical(const struct timings *it) {
    const double *t = it->recent;
    if (it->count < 3)
        return it->count == 2 && t[1] < t[0] ? t[1] : t[0];
    const double low = t[0] < t[1] ? t[0] : t[1], high = t[0] < t[1] ? t[1] : t[0];
    return t[2] < low ? low : t[2] > high ? high : t[2];
}

double redcc_usual(const struct size_state *size) {
    return redcc_typical(&size->sequential);
}

static void note_time(struct timings *it, double each) {
    it->recent[it->count++ % 3] = each;
}

/* The shortest of the last times of the sequential loop, in seconds per iteration; 0: unknown. The
 * shortest time is used so that gains are not overestimated. */
static double least_of_last(const struct size_state *size) {
    double low = size->sequential.recent[0];
    for (int i = 1; i < 3 && i < size->sequential.count; i++)
        low = size->sequential.recent[i] < low ? size->sequential.recent[i] : low;
    return size->sequential.count ? low : 0;
}

static bool missed(const struct set_ups *it) {
    return it->invested > 0 && it->earned < it->invested;
}

int redcc_misses(const struct set_ups *it) {
    return missed(it) ? it->misses + 1 : 0;
}

/* Each plan construction that did not pay doubles the factor, and each one that paid halves it. */
double redcc_factor(const struct set_ups *it) {
    const double now = it->factor > 0 ? it->factor : LEARN_FACTOR;
    if (it->invested == 0)
        return now;
    return missed(it) ? 2 * now : now > 2 ? now / 2 : 1;
}

double redcc_expected(const struct size_state *size, enum way way) {
    assert(way > WAY_SEQUENTIAL && way < WAY_COUNT);
    const struct arm *it = &size->arm[way];
    return it->timed.count > 0    ? redcc_typical(&it->timed)
           : size->looked_at <= 0 ? it->execution
                                  : it->execution * redcc_usual(size) / size->looked_at;
}

bool redcc_is_better(const struct size_state *size, enum way way, double current) {
    assert(way > WAY_SEQUENTIAL && way < WAY_COUNT);
    return size->arm[way].possible && redcc_expected(size, way) < LEARN_BETTER * current;
}

void redcc_compare(struct size_state *size, enum way contender, enum way incumbent) {
    assert(contender != incumbent && contender < WAY_COUNT && incumbent < WAY_COUNT);
    const bool proven = size->phase == PHASE_PARALLEL && size->way == contender;
    size->comparison = (struct comparison){contender, incumbent, proven, {0}};
    size->phase = PHASE_COMPARING;
    size->rule = RULE_COMPARING;
}

static void back_off(struct size_state *size, enum rule rule) {
    redcc_back_off(&size->back_off, size->calls);
    size->phase = PHASE_BACK_OFF;
    size->rule = rule;
}

static void leave_back_off(struct size_state *size, enum phase phase) {
    size->back_off.length = 0;
    size->phase = phase;
}

/* Rules out the strategy that failed. Returns whether another strategy is expected to be better
 * than the sequential loop. */
static bool another_may_do(struct size_state *size, enum way failed) {
    size->arm[failed].possible = false;
    size->arm[failed].ruled_out = true;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (redcc_is_better(size, way, redcc_usual(size)))
            return true;
    return false;
}

/* Called after a strategy has failed. If it was one without plans, another strategy may still be
 * tried; otherwise the loop backs off. */
static void return_to_sequential(struct size_state *size, enum way way) {
    if (!redcc_is_planned(way) && another_may_do(size, way))
        leave_back_off(size, PHASE_SAVING);
    else
        back_off(size, RULE_SLOWER);
}

/* Ends a comparison: selects the faster strategy, or backs off. */
static void settle(struct size_state *size, bool contender_won) {
    const struct comparison *it = &size->comparison;
    struct arm *arm = &size->arm[it->contender];
    if (arm->timed.count == 0)
        note_time(&arm->timed, it->pairs.least[0]);
    size->way = contender_won || it->incumbent == WAY_SEQUENTIAL ? it->contender : it->incumbent;
    size->unchecked = 0;
    if (contender_won || it->incumbent != WAY_SEQUENTIAL) {
        leave_back_off(size, PHASE_PARALLEL);
        size->rule = RULE_FASTER;
        return;
    }
    size->checks = 0;
    if (it->proven)
        back_off(size, RULE_SLOWER);
    else
        return_to_sequential(size, it->contender);
}

/* Is the comparison decided? One pair may be enough to keep a strategy that is in use; all pairs
 * are needed to abandon it. */
static bool is_settled(const struct comparison *it) {
    const int winner = redcc_paired_winner(&it->pairs);
    return it->pairs.timed % PAIRED_ARMS == 0 &&
           (winner == 0 ||
            (winner == 1 && !(it->proven && it->pairs.timed < PAIRED_ARMS * LEARN_PAIRS)));
}

enum way redcc_arm_to_run(const struct comparison *it) {
    return redcc_arm_of(it->pairs.timed) == 0 ? it->contender : it->incumbent;
}

/* Records a time in the comparison. `usual` is the sequential loop's time per iteration, as known
 * in this execution. */
static void count_in_comparison(struct size_state *size, enum way way, double each, double usual) {
    struct comparison *it = &size->comparison;
    if (way != redcc_arm_to_run(it))
        return; /* the credit was too low, so that the loop ran sequentially */
    redcc_paired_note(&it->pairs, each);
    if (it->pairs.timed == 1 && it->incumbent == WAY_SEQUENTIAL && each < LEARN_CLEAR * usual)
        settle(size, true);
    else if (is_settled(it))
        settle(size, redcc_paired_winner(&it->pairs) == 0);
}

/* Do two times differ by more than twice the noise? If so, the load of the machine has changed. */
static bool is_another(double before, double now) {
    return now * (1 + 2 * LEARN_NOISE) < before || now > (1 + 2 * LEARN_NOISE) * before;
}

static void observe_sequential(struct choice_state *state, struct size_state *size,
                               const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    const double all = outcome->seconds * (double)(1 + outcome->untimed);
    struct timings *timings = &size->sequential;
    const struct comparison *it = &size->comparison;
    state->ledger.sequential += all;
    size->set_ups.since += all;
    size->calls += outcome->untimed;
    const bool comparing = size->phase == PHASE_COMPARING;
    const bool is_check =
        comparing && it->pairs.timed == 1 && redcc_arm_to_run(it) == WAY_SEQUENTIAL;
    if (is_check && is_another(redcc_usual(size), each))
        timings->count = 0;
    note_time(timings, each);
    if (size->calls < timings->count) /* some were timed before the loop had a state */
        size->calls = timings->count;
    if (comparing)
        count_in_comparison(size, WAY_SEQUENTIAL, each, redcc_usual(size));
}

void redcc_note_begin(struct choice_state *state, long long rest, long long done, double seconds) {
    assert(rest > 0 && done > 0 && seconds >= 0);
    struct size_state *size = (struct size_state *)redcc_size_of(state, rest);
    note_time(&size->sequential, seconds / (double)done);
    state->ledger.sequential += seconds;
    size->set_ups.since += seconds;
}

static void count_set_up(struct size_state *size, enum way way, double seconds) {
    struct set_ups *it = &size->set_ups;
    *it = (struct set_ups){.factor = redcc_factor(it),
                           .invested = seconds,
                           .misses = redcc_misses(it),
                           .begun = size->calls,
                           .met = size->steady,
                           .lifetime = it->lifetime};
    size->arm[way].learned = seconds;
    size->arm[way].possible = true;
    size->checks = 0;
}

/* Begins a comparison after the first execution of a new strategy. Starting threads and page faults
 * slow this execution down. So its time counts in the comparison only if it was clearly faster than
 * the sequential loop nevertheless. */
static void begin_trial(struct size_state *size, enum way way, double each, double usual) {
    const bool rival = size->phase == PHASE_PARALLEL && size->way != way;
    redcc_compare(size, way, rival ? size->way : WAY_SEQUENTIAL);
    if (!rival && each < LEARN_CLEAR * usual)
        count_in_comparison(size, way, each, usual);
}

/* Records an execution of a strategy in the ledger. Returns the seconds that the sequential loop
 * would have taken. */
static double enter_in_ledger(struct choice_state *state, struct size_state *size,
                              const struct outcome *outcome) {
    const double each = outcome->usual > 0 ? outcome->usual : least_of_last(size);
    const double sequential = each * (double)outcome->trip;
    state->ledger.sequential += sequential;
    state->ledger.overhead += outcome->seconds + outcome->set_up - sequential;
    size->set_ups.since += sequential;
    return sequential;
}

/* Records a time of the sequential loop that a trial has measured. */
static void note_usual(struct size_state *size, double usual) {
    if (usual > 0)
        note_time(&size->sequential, usual);
}

static void observe_parallel(struct choice_state *state, struct size_state *size,
                             const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    struct arm *arm = &size->arm[outcome->way];
    struct set_ups *set_ups = &size->set_ups;
    const bool is_first =
        outcome->set_up > 0 || (!redcc_is_planned(outcome->way) && arm->timed.count == 0);
    if (outcome->set_up > 0) {
        if (size->phase == PHASE_SAVING && set_ups->uses > 0)
            set_ups->lifetime = set_ups->met + set_ups->uses;
        count_set_up(size, outcome->way, outcome->set_up);
    }
    note_usual(size, outcome->usual);
    const bool goes_on_in_debt = outcome->set_up == 0 && redcc_credit(state) < 0;
    const double sequential = enter_in_ledger(state, size, outcome);
    set_ups->uses++;
    set_ups->earned += sequential - outcome->seconds;
    size->gained = (goes_on_in_debt ? size->gained : 0) + sequential - outcome->seconds;
    if (outcome->set_up == 0)
        note_time(&arm->timed, each);
    const double usual = outcome->usual > 0 ? outcome->usual : redcc_usual(size);
    if (is_first)
        begin_trial(size, outcome->way, each, usual);
    else if (size->phase == PHASE_COMPARING) {
        count_in_comparison(size, outcome->way, each, usual);
        if (outcome->usual > 0 && size->phase == PHASE_COMPARING)
            count_in_comparison(size, WAY_SEQUENTIAL, outcome->usual, usual);
    } else if (size->phase == PHASE_PARALLEL)
        size->unchecked += outcome->seconds;
}

static void observe_left(struct choice_state *state, struct size_state *size,
                         const struct outcome *outcome) {
    struct arm *arm = &size->arm[outcome->way];
    note_usual(size, outcome->usual);
    enter_in_ledger(state, size, outcome);
    arm->timed = (struct timings){0};
    note_time(&arm->timed, outcome->seconds / (double)outcome->trip);
    size->way = outcome->way;
    return_to_sequential(size, outcome->way);
}

static void observe_stop(struct size_state *size, const struct outcome *outcome) {
    size->rule = RULE_STOPPED;
    const double whole = outcome->done > 0.01 ? outcome->seconds / outcome->done : 0;
    const double twice = 2 * outcome->seconds;
    const double expected = whole > twice ? whole : twice;
    if (outcome->way == WAY_SEQUENTIAL) { /* a sample was stopped, because of its dry run */
        size->look = expected > 2 * size->look ? expected : 2 * size->look;
        return;
    }
    count_set_up(size, outcome->way, outcome->seconds);
    size->arm[outcome->way].learned = expected;
    if (size->phase != PHASE_PARALLEL)
        size->phase = PHASE_SAVING;
}

/* Is the cost of a refusal within the share that may be lost? Then a guard may occasionally forbid
 * the strategy in use, which stays in use. */
static bool is_little(const struct size_state *size, const struct outcome *outcome) {
    return outcome->seconds <= LEARN_SHARE * redcc_usual(size) * (double)outcome->trip;
}

/* Called when a sample or a guard has ruled out a strategy. RESULT_REFUSED with WAY_SEQUENTIAL
 * rules out all strategies. */
static void observe_refusal(struct size_state *size, const struct outcome *outcome) {
    const bool refused = outcome->result == RESULT_REFUSED;
    if (size->phase == PHASE_PARALLEL && size->way == outcome->way && is_little(size, outcome))
        return;
    const bool another =
        another_may_do(size, outcome->way) && (!refused || outcome->way != WAY_SEQUENTIAL);
    if (size->phase == PHASE_PARALLEL && size->way != outcome->way) {
        size->looked = true; /* prevents further samples */
        return;
    }
    if (another)
        size->phase = PHASE_SAVING;
    else
        back_off(size, refused ? RULE_REFUSED : RULE_UNATTRACTIVE);
}

static void observe_loss(struct size_state *size, const struct outcome *outcome) {
    if (outcome->result == RESULT_CHANGED) {
        size->phase = PHASE_SAVING;
        size->rule = RULE_CHANGED;
    } else if (outcome->result == RESULT_STOPPED) {
        observe_stop(size, outcome);
    } else {
        if (outcome->result == RESULT_UNATTRACTIVE && outcome->way != WAY_SEQUENTIAL)
            count_set_up(size, outcome->way, outcome->seconds);
        observe_refusal(size, outcome);
    }
}

void redcc_observe(struct choice_state *state, const struct outcome *outcome) {
    assert(outcome->way < WAY_COUNT);
    struct size_state *size = (struct size_state *)redcc_size_of(state, outcome->trip);
    bool failed = false;
    if (outcome->result == RESULT_SEQUENTIAL) {
        observe_sequential(state, size, outcome);
    } else if (outcome->result == RESULT_PARALLEL) {
        observe_parallel(state, size, outcome);
    } else if (outcome->result == RESULT_LEFT) {
        observe_left(state, size, outcome);
        failed = true;
    } else {
        observe_loss(size, outcome);
        state->ledger.overhead += outcome->seconds;
        failed = true;
    }
    /* Is the overdraft repaid, or has its purpose failed? Then no more of it may be spent. */
    if (failed || size->phase == PHASE_BACK_OFF || redcc_credit(state) >= state->ledger.overdraft)
        state->ledger.overdraft = 0;
}
