/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/afford.h"

#include <assert.h>

static const double checked_after = 64; /* timing the sequential loop again costs 1/64, and half as
                                          much each time until it costs 1/512; */
/* where only its first execution was timed, which found no page in place, 1/16, or 1/32 where the
 * plan takes so little of it that it is likely to be faster than the next one as well */
static const double checked_early = 16, checked_soon = 32, likely = 0.4;

enum { MISSES = 2, SHORT_REST = 16, SHORT_REST_MOST = 1024, DOUBLINGS = 3 };

static struct decision sequentially(struct size_state *size, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_SEQUENTIAL, .timed = true, .rule = rule};
}

static struct decision reuse(struct size_state *size, const struct situation *now, enum way way,
                             enum rule rule) {
    const double usual = redcc_usual(&size->sequential);
    struct decision decision = {.action = ACTION_REUSE,
                                .way = way,
                                .earned = size->set_ups.earned - size->set_ups.invested,
                                .rule = rule};
    const bool was_faster = size->prospect[way].measured && size->prospect[way].execution < usual;
    size->rule = rule;
    if (redcc_is_trial(size, way) && !was_faster) /* whose short rounds would hide a gain */
        decision.trial = (struct trial){usual, redcc_trial_may_lose(size, now->trip)};
    return decision;
}

static bool keeps_changing(const struct size_state *size, const struct situation *now) {
    return redcc_next_misses(&size->set_ups) >= MISSES && now->steady >= 0 &&
           now->steady < REDCC_STEADY;
}

/* What is spent of a loan already stays lent. */
static void lend(struct choice_state *state, double seconds) {
    if (state->ledger.loan < seconds)
        state->ledger.loan = seconds;
}

/* Of the plans kept for these subscripts, the one with the least expected time below `least_each`
 * seconds an iteration. */
static enum way kept_way(const struct choice_state *state, const struct size_state *size,
                         const struct situation *now, double least_each) {
    enum way best = WAY_SEQUENTIAL;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (now->kept[way] == KEPT_FITS && (way != WAY_BINS || redcc_may_bin(state, size, now)) &&
            redcc_expected(size, way) < least_each) {
            best = way;
            least_each = redcc_expected(size, way);
        }
    return best;
}

/* A set-up that a loan or the credit allows, for a way better than `current` seconds an iteration,
 * if there is one. */
static struct decision set_up(struct choice_state *state, struct size_state *size,
                              const struct situation *now, double current) {
    enum way way = redcc_way_to_borrow_for(state, size, now);
    const bool is_lent = way != WAY_SEQUENTIAL;
    if (is_lent)
        lend(state, redcc_loan_for(size, now, way));
    else
        way = redcc_affordable_way(state, size, now, current);
    if (way == WAY_SEQUENTIAL)
        return sequentially(size, RULE_SAVING);
    assert(way > WAY_SEQUENTIAL && way < WAY_COUNT && size->prospect[way].possible);
    size->rule = RULE_SET_UP;
    return (struct decision){.action = ACTION_INSPECT,
                             .way = way,
                             .deadline = redcc_deadline(state, size, now, way, is_lent),
                             .rule = RULE_SET_UP};
}

/* By all threads, so that a set-up can follow at once, where the subscripts are likely to stay and
 * the credit covers starting them; where that is little beside an execution, it is lent. Else by
 * one thread, which waits for nobody: most light loops are not worth more than the look. */
static struct decision look(struct choice_state *state, struct size_state *size,
                            const struct situation *now) {
    if (!redcc_may_look(state, size, now))
        return sequentially(size, RULE_SAVING);
    if (redcc_looks_alone(state, size, now) && redcc_may_lend_start(state, size, now))
        lend(state, now->start);
    const bool alone = redcc_looks_alone(state, size, now);
    size->rule = RULE_LOOKING;
    return (struct decision){.action = ACTION_INSPECT,
                             .alone = alone,
                             .deadline = redcc_credit(state) - (alone ? 0 : now->start),
                             .rule = RULE_LOOKING};
}

/* The plan in use is for other subscripts: what was lent for it is still owed, but no more may be
 * spent of it. */
static void leave_plan(struct choice_state *state, struct size_state *size) {
    size->stand = STAND_SAVING;
    state->ledger.loan = 0;
}

static struct decision decide_saving(struct choice_state *state, struct size_state *size,
                                     const struct situation *now) {
    const enum way kept = kept_way(state, size, now, redcc_better * redcc_usual(&size->sequential));
    if (kept != WAY_SEQUENTIAL && redcc_may_execute(state, size, now->trip, kept)) {
        if (size->prospect[kept].measured) {
            size->way = kept;
            size->stand = STAND_PARALLEL;
            return reuse(size, now, kept, RULE_FASTER);
        }
        redcc_compare(size, kept, WAY_SEQUENTIAL);
        return reuse(size, now, kept, RULE_COMPARING);
    }
    if (keeps_changing(size, now))
        return sequentially(size, RULE_CHANGING);
    return size->looked ? set_up(state, size, now, redcc_usual(&size->sequential))
                        : look(state, size, now);
}

static struct decision decide_comparing(struct choice_state *state, struct size_state *size,
                                        const struct situation *now) {
    const struct comparison *it = &size->comparison;
    assert(it->contender != it->incumbent && it->contender > WAY_SEQUENTIAL &&
           it->contender < WAY_COUNT);
    const bool both_fit =
        now->kept[it->contender] == KEPT_FITS &&
        (it->incumbent == WAY_SEQUENTIAL || now->kept[it->incumbent] == KEPT_FITS);
    if (!both_fit) {
        leave_plan(state, size);
        return decide_saving(state, size, now);
    }
    const enum way turn = it->incumbents_turn ? it->incumbent : it->contender;
    if (turn == WAY_SEQUENTIAL)
        return sequentially(size, RULE_COMPARING);
    return redcc_may_execute(state, size, now->trip, turn) ? reuse(size, now, turn, RULE_COMPARING)
                                                           : sequentially(size, RULE_SAVING);
}

/* Was the sequential loop not timed for so long that timing it costs little? Where the plan was as
 * slow lately, it costs nothing. A first execution finds no page of the arrays in place, and says
 * less than the others. */
static bool is_check_due(const struct size_state *size, long long trip) {
    const double sequential = redcc_usual(&size->sequential);
    const double parallel = size->prospect[size->way].execution;
    const double more = sequential - parallel;
    const double after = size->sequential.count > 1 ? checked_after * (double)(1 << size->checks)
                         : parallel < likely * sequential ? checked_soon
                                                          : checked_early;
    return size->unchecked > after * more * (double)trip;
}

static struct decision decide_parallel(struct choice_state *state, struct size_state *size,
                                       const struct situation *now) {
    assert(size->way > WAY_SEQUENTIAL && size->way < WAY_COUNT);
    if (now->kept[size->way] != KEPT_FITS) {
        leave_plan(state, size);
        return decide_saving(state, size, now);
    }
    if (!redcc_may_execute(state, size, now->trip, size->way))
        return sequentially(size, RULE_SAVING);
    const double current = size->prospect[size->way].execution;
    if (is_check_due(size, now->trip)) {
        size->checks += size->sequential.count > 1 && size->checks < DOUBLINGS;
        redcc_compare(size, size->way, WAY_SEQUENTIAL);
        size->comparison.contender_sum = current;
        size->comparison.contended = 1;
        size->comparison.incumbents_turn = true;
        return sequentially(size, RULE_COMPARING);
    }
    const enum way way = redcc_affordable_way(state, size, now, current);
    if (way != WAY_SEQUENTIAL && way != size->way && now->kept[way] != KEPT_FITS)
        return set_up(state, size, now, current);
    const enum way kept = kept_way(state, size, now, redcc_better * current);
    if (kept != WAY_SEQUENTIAL && kept != size->way) {
        redcc_compare(size, kept, size->way);
        return reuse(size, now, kept, RULE_COMPARING);
    }
    return reuse(size, now, size->way, RULE_FASTER);
}

/* Calls that are left to the sequential loop end here: a compare and a counter. */
static bool is_resting(const struct size_state *size) {
    return (size->stand == STAND_SHORT || size->stand == STAND_RESTING) &&
           size->rest.calls < size->rest.until;
}

static struct decision at_rest(const struct size_state *size) {
    return (struct decision){
        .action = ACTION_SEQUENTIAL, .timed = size->stand == STAND_RESTING, .rule = size->rule};
}

/* What a rest was for may be otherwise now. */
static void end_rest(struct size_state *size, const struct situation *now) {
    const bool compared = size->stand == STAND_RESTING && size->rule == RULE_SLOWER &&
                          now->kept[size->way] == KEPT_FITS;
    if (compared) {
        redcc_compare(size, size->way, WAY_SEQUENTIAL);
        return;
    }
    size->looked = false;
    for (enum way way = 0; way < WAY_COUNT; way++)
        size->prospect[way] = (struct prospect){.learned = size->prospect[way].learned};
    size->stand = STAND_SAVING;
}

bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads,
                         struct decision *decision) {
    struct size_state *size = redcc_size_of(state, trip);
    if (!is_resting(size) || size->threads != threads || size->rest.calls + 2 >= size->rest.until)
        return false;
    size->rest.calls++;
    *decision = at_rest(size);
    return true;
}

struct decision redcc_decide(struct choice_state *state, const struct situation *now) {
    struct size_state *size = redcc_size_of(state, now->trip);
    if (size->threads > 0 && size->threads != now->threads)
        *size = (struct size_state){0};
    size->threads = now->threads;
    size->steady = now->steady > 0 ? now->steady : 0;
    size->rest.calls++;
    if (is_resting(size))
        return at_rest(size);
    switch (size->stand) {
    case STAND_UNTIMED:
        if (size->sequential.count == 0)
            return sequentially(size, RULE_FIRST);
        size->stand = STAND_SAVING;
        break;
    case STAND_SHORT:
        size->stand = STAND_SAVING;
        if (size->rest.calls == size->rest.until)
            return sequentially(size, RULE_SHORT);
        break;
    case STAND_RESTING:
        end_rest(size, now);
        break;
    case STAND_SAVING:
    case STAND_COMPARING:
    case STAND_PARALLEL:
        break;
    }
    if (size->stand == STAND_SAVING && redcc_is_short(size, now)) {
        redcc_rest(size, STAND_SHORT, RULE_SHORT, SHORT_REST, SHORT_REST_MOST);
        return sequentially(size, RULE_SHORT);
    }
    switch (size->stand) {
    case STAND_COMPARING:
        return decide_comparing(state, size, now);
    case STAND_PARALLEL:
        return decide_parallel(state, size, now);
    default:
        return decide_saving(state, size, now);
    }
}

/* What was measured counts for more than what is estimated anew. */
static void note_prospect(struct prospect *known, const struct prospect *found) {
    const struct prospect before = *known;
    *known = *found;
    known->learned = before.learned;
    known->ruled_out = before.ruled_out;
    known->possible = found->possible && !before.ruled_out;
    known->measured = before.measured && found->possible;
    if (known->measured)
        known->execution = before.execution;
}

void redcc_note_prospects(struct choice_state *state, long long trip,
                          const struct prospect *prospect, double spent) {
    struct size_state *size = redcc_size_of(state, trip);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        note_prospect(&size->prospect[way], &prospect[way]);
    size->looked = true;
    size->look = spent;
    size->looked_at = redcc_usual(&size->sequential);
}

struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct prospect *prospect, double spent) {
    struct size_state *size = redcc_size_of(state, now->trip);
    struct situation here = *now;
    here.spent = spent;
    redcc_note_prospects(state, now->trip, prospect, spent);
    const double current = size->stand == STAND_PARALLEL ? size->prospect[size->way].execution
                                                         : redcc_usual(&size->sequential);
    return set_up(state, size, &here, current);
}
