/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/size.h"

/* The bound's e: of the sequential time, what trials may cost. At a tenth a program that is never
 * worth it is slower by no more than two runs of it differ on a machine that others use (5 to 15 %,
 * script/bench choice), and a loop that gains begins to after 4 to 12 executions. */
static const double share = 0.1;
/* Reserved for an execution by a plan, of a sequential one. LOCALWRITE on loops without runs took
 * up to 1.6 times the sequential loop, but there estimates say so; else no more than 1.25 times. */
static const double reserve = 0.25;
/* Before any sample was taken: 8192 iterations of some touches, and waking threads. 0.2 to 0.6 ms
 * where data is shuffled. */
static const double first_look = 0.5e-3;

static const double wakes = 50;          /* waking the threads costs 2 % of an execution then */
static const double forecast_least = 20; /* inspections: one costs 5 % of an execution then */
static const double checked_after = 64;  /* timing the sequential loop again costs 1/64 */

enum { MISSES = 2, STEADY = 2, SHORT_REST = 16, SHORT_REST_MOST = 1024 };

double redcc_credit(const struct choice_state *state) {
    return share * state->ledger.sequential - state->ledger.overhead;
}

static struct decision sequentially(struct size_state *size, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_SEQUENTIAL, .timed = true, .rule = rule};
}

static struct decision reuse(struct size_state *size, enum way way, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_REUSE, .way = way, .rule = rule};
}

/* Seconds that an inspection may take now. */
static double allowance(const struct choice_state *state, const struct size_state *size,
                        const struct situation *now) {
    return redcc_credit(state) - reserve * redcc_usual(&size->sequential) * (double)now->trip;
}

static bool may_set_up(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now, double cost) {
    return allowance(state, size, now) >= cost &&
           size->set_ups.since >= redcc_next_factor(&size->set_ups) * cost;
}

static bool keeps_changing(const struct size_state *size, const struct situation *now) {
    return redcc_next_misses(&size->set_ups) >= MISSES && now->steady >= 0 && now->steady < STEADY;
}

static double set_up_of(const struct prospect *prospect) {
    return prospect->learned > 0 ? prospect->learned : prospect->set_up;
}

/* How many executions a plan made now may serve: as many as there were (rent or buy); where plans
 * were ended by other subscripts, as many as the last one, until that is long ago. */
static double horizon_of(const struct size_state *size) {
    const struct set_ups *it = &size->set_ups;
    const long since = (size->rest.calls - it->begun) / 8;
    return (double)(it->lifetime == 0      ? size->rest.calls
                    : it->lifetime > since ? it->lifetime
                                           : since);
}

/* The way that is the cheapest, set-up included, over the executions to come; of those within
 * `allowed` seconds that are better than `current` seconds an iteration. SEQUENTIAL: none. */
static enum way best_way(const struct size_state *size, long long trip, double current,
                         double allowed, double settled) {
    const double horizon = horizon_of(size) * (double)trip;
    const double factor = redcc_next_factor(&size->set_ups);
    enum way best = WAY_SEQUENTIAL;
    double least_cost = current * horizon;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        const struct prospect *it = &size->prospect[way];
        const double cost = set_up_of(it) + it->execution * horizon;
        if (!it->possible || it->execution >= redcc_better * current || cost >= least_cost ||
            set_up_of(it) > allowed || set_up_of(it) * factor > settled)
            continue;
        best = way;
        least_cost = cost;
    }
    return best;
}

/* Of the plans kept for these subscripts, the one with the least expected time below the sequential
 * one. */
static enum way kept_way(const struct size_state *size, const struct situation *now) {
    enum way best = WAY_SEQUENTIAL;
    double least_each = redcc_better * redcc_usual(&size->sequential);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (now->kept[way] == KEPT_FITS && size->prospect[way].execution < least_each) {
            best = way;
            least_each = size->prospect[way].execution;
        }
    return best;
}

static struct decision set_up(struct choice_state *state, struct size_state *size,
                              const struct situation *now, enum way way) {
    const double cost = set_up_of(&size->prospect[way]), allowed = allowance(state, size, now);
    size->rule = RULE_SET_UP;
    return (struct decision){.action = ACTION_INSPECT,
                             .way = way,
                             .deadline = 2 * cost < allowed ? 2 * cost : allowed,
                             .rule = RULE_SET_UP};
}

static struct decision look(struct choice_state *state, struct size_state *size,
                            const struct situation *now) {
    const double cost = size->look > 0 ? size->look : first_look;
    if (!may_set_up(state, size, now, cost))
        return sequentially(size, RULE_SAVING);
    size->rule = RULE_LOOKING;
    return (struct decision){
        .action = ACTION_INSPECT, .deadline = allowance(state, size, now), .rule = RULE_LOOKING};
}

static struct decision decide_saving(struct choice_state *state, struct size_state *size,
                                     const struct situation *now) {
    const enum way kept = kept_way(size, now);
    if (kept != WAY_SEQUENTIAL && allowance(state, size, now) >= 0) {
        if (size->prospect[kept].measured) {
            size->way = kept;
            size->stand = STAND_PARALLEL;
            return reuse(size, kept, RULE_FASTER);
        }
        redcc_compare(size, kept, WAY_SEQUENTIAL);
        return reuse(size, kept, RULE_COMPARING);
    }
    if (keeps_changing(size, now))
        return sequentially(size, RULE_CHANGING);
    if (!size->looked)
        return look(state, size, now);
    const enum way way = best_way(size, now->trip, redcc_usual(&size->sequential),
                                  allowance(state, size, now) - size->look, size->set_ups.since);
    return way == WAY_SEQUENTIAL ? sequentially(size, RULE_SAVING) : set_up(state, size, now, way);
}

static struct decision decide_comparing(struct choice_state *state, struct size_state *size,
                                        const struct situation *now) {
    const struct comparison *it = &size->comparison;
    const bool both_fit =
        now->kept[it->contender] == KEPT_FITS &&
        (it->incumbent == WAY_SEQUENTIAL || now->kept[it->incumbent] == KEPT_FITS);
    if (!both_fit) {
        size->stand = STAND_SAVING;
        return decide_saving(state, size, now);
    }
    const enum way turn = it->incumbents_turn ? it->incumbent : it->contender;
    if (turn == WAY_SEQUENTIAL)
        return sequentially(size, RULE_COMPARING);
    return allowance(state, size, now) < 0 ? sequentially(size, RULE_SAVING)
                                           : reuse(size, turn, RULE_COMPARING);
}

/* Was the sequential loop not timed for so long that timing it costs a 64th? Where the plan was as
 * slow lately, it costs nothing. */
static bool is_check_due(const struct size_state *size, long long trip) {
    const double more = redcc_usual(&size->sequential) - size->prospect[size->way].execution;
    return size->unchecked > checked_after * more * (double)trip;
}

static struct decision decide_parallel(struct choice_state *state, struct size_state *size,
                                       const struct situation *now) {
    if (now->kept[size->way] != KEPT_FITS) {
        size->stand = STAND_SAVING;
        return decide_saving(state, size, now);
    }
    if (allowance(state, size, now) < 0)
        return sequentially(size, RULE_SAVING);
    const double current = size->prospect[size->way].execution;
    if (is_check_due(size, now->trip)) {
        redcc_compare(size, size->way, WAY_SEQUENTIAL);
        size->comparison.contender_sum = current;
        size->comparison.contended = 1;
        size->comparison.incumbents_turn = true;
        return sequentially(size, RULE_COMPARING);
    }
    const enum way way = best_way(size, now->trip, current,
                                  allowance(state, size, now) - size->look, size->set_ups.since);
    if (way != WAY_SEQUENTIAL && way != size->way && now->kept[way] != KEPT_FITS)
        return set_up(state, size, now, way);
    return reuse(size, size->way, RULE_FASTER);
}

static struct decision decide_first(struct size_state *size, const struct situation *now) {
    if (now->forecast <= 0 || now->forecast < forecast_least * now->forecast_set_up ||
        now->forecast < wakes * now->wake)
        return sequentially(size, RULE_FIRST);
    redcc_note_timing(&size->sequential, now->forecast / (double)now->trip);
    size->rule = RULE_FIRST;
    return (struct decision){.action = ACTION_INSPECT,
                             .deadline = now->forecast / forecast_least * 2,
                             .rule = RULE_FIRST};
}

/* Calls that are left to the sequential loop end here: a compare and a counter. */
static bool is_resting(const struct size_state *size) {
    return (size->stand == STAND_SHORT || size->stand == STAND_RESTING) &&
           size->rest.calls < size->rest.until;
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

static bool is_short(const struct size_state *size, const struct situation *now) {
    return redcc_usual(&size->sequential) * (double)now->trip < wakes * now->wake;
}

bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads) {
    struct size_state *size = redcc_size_of(state, trip);
    if (size->stand != STAND_SHORT || size->threads != threads ||
        size->rest.calls + 1 >= size->rest.until)
        return false;
    size->rest.calls++;
    return true;
}

struct decision redcc_decide(struct choice_state *state, const struct situation *now) {
    struct size_state *size = redcc_size_of(state, now->trip);
    if (size->threads != now->threads)
        *size = (struct size_state){.threads = now->threads};
    size->rest.calls++;
    if (is_resting(size))
        return (struct decision){
            .action = ACTION_SEQUENTIAL, .timed = size->stand == STAND_RESTING, .rule = size->rule};
    switch (size->stand) {
    case STAND_UNTIMED:
        if (size->sequential.count == 0)
            return decide_first(size, now);
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
    if (size->stand == STAND_SAVING && is_short(size, now)) {
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

struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct prospect *prospect, double spent) {
    struct size_state *size = redcc_size_of(state, now->trip);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        note_prospect(&size->prospect[way], &prospect[way]);
    size->looked = true;
    size->look = spent;
    const double allowed = size->stand == STAND_UNTIMED
                               ? redcc_usual(&size->sequential) * (double)now->trip / forecast_least
                               : allowance(state, size, now) - spent;
    const double settled = size->stand == STAND_UNTIMED
                               ? allowed * redcc_next_factor(&size->set_ups)
                               : size->set_ups.since;
    const double current = size->stand == STAND_PARALLEL ? size->prospect[size->way].execution
                                                         : redcc_usual(&size->sequential);
    const enum way way = best_way(size, now->trip, current, allowed, settled);
    if (way == WAY_SEQUENTIAL)
        return sequentially(size, RULE_SAVING);
    const double cost = 2 * set_up_of(&size->prospect[way]);
    size->rule = RULE_SET_UP;
    return (struct decision){.action = ACTION_INSPECT,
                             .way = way,
                             .deadline = cost < allowed ? cost : allowed,
                             .rule = RULE_SET_UP};
}
