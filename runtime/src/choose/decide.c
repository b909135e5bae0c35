/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/size.h"

#include <assert.h>

/* The bound's e: of the sequential time, what trials may cost. At a 32nd a loop that is never worth
 * it is slower by 3 % at the most, and by less than 5 where trials overrun: two runs of it differ
 * by as much on a machine that others use (5 to 15 %, script/bench choice). */
static const double share = 1.0 / 32;
/* Reserved for an execution by a plan that is not clearly the faster way, of a sequential one.
 * LOCALWRITE on loops without runs took up to 1.6 times the sequential loop, but there estimates
 * say so; else no more than 1.25 times. */
static const double reserve = 0.25;
/* ... and for a trial in bins, which ends after the first round that has lost as much: paid for by
 * two sequential executions and a look. */
static const double tried = 1.0 / 24;
/* Before any sample was taken: 256 iterations of some touches, by one thread; of a short loop no
 * more than that part of an execution. */
static const double first_look = 0.4e-3, sampled_most = 0.75;
/* Where nothing tells whether subscripts stay, a set-up waits so many times as long. */
static const double unknown = 4;

/* A loan is twice what the set-up is expected to cost, and at most so many executions: twice what
 * cutting the access graph of a heavy loop takes. */
static const double loan_most = 1.25;
/* ... and a part of an execution, for a thread that the system has no core for at once. */
static const double waited = 0.25;
/* It is given where so many executions by the plan are expected to repay the set-up, and all
 * subscripts were compared with those of the call before, or their samples were met in so many
 * calls in a row: then they are likely to stay for as many more (rent or buy), and half of those
 * may be what repays it; */
static const double repaid_within = 2;
enum { SURE = 4 };
/* or where the first one will: then it does not matter whether the subscripts stay. */
static const double repaid_at_once = 0.9;
/* Threads are started for a look as well where look and start take so much of an execution. */
static const double started_most = 1.0 / 8;
/* Executions that count when ways are compared for a loan: with less each, the second execution
 * could not tell a plan that is used ten times from one that is used twice. */
static const double soon = 8;

static const double wakes = 16; /* waking two threads takes an eighth of what each executes then */
static const double checked_after = 64; /* timing the sequential loop again costs 1/64, and half as
                                          much each time until it costs 1/512; */
/* where only its first execution was timed, which found no page in place, 1/16, or 1/32 where the
 * plan takes so little of it that it is likely to be faster than the next one as well */
static const double checked_early = 16, checked_soon = 32, likely = 0.4;

enum { MISSES = 2, STEADY = 2, SHORT_REST = 16, SHORT_REST_MOST = 1024, DOUBLINGS = 3 };

double redcc_credit(const struct choice_state *state) {
    return share * state->ledger.sequential - state->ledger.overhead + state->ledger.loan;
}

static double least_of(double a, double b) {
    return a < b ? a : b;
}

static struct decision sequentially(struct size_state *size, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_SEQUENTIAL, .timed = true, .rule = rule};
}

/* Bins need no set-up: until they are the faster way, an execution by them is a trial. */
static bool is_trial(const struct size_state *size, enum way way) {
    const bool compared = size->stand == STAND_COMPARING && size->comparison.contender == way;
    return way == WAY_BINS && (compared || !size->prospect[way].measured);
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
    if (is_trial(size, way) && !was_faster) /* whose short rounds would hide a gain */
        decision.trial = (struct trial){usual, tried * usual * (double)now->trip};
    return decision;
}

/* Seconds that may be lost by this way now. */
static double room_for(const struct choice_state *state, const struct size_state *size,
                       long long trip, enum way way) {
    const double usual = redcc_usual(&size->sequential);
    const bool is_clear = redcc_expected(size, way) < redcc_clear * usual;
    const double risk = is_trial(size, way) ? tried : is_clear ? 0 : reserve;
    const double lent = way == WAY_BINS ? state->ledger.loan : 0; /* for a set-up */
    return redcc_credit(state) - lent - risk * usual * (double)trip;
}

/* May a plan be executed? One that was measured and is clearly the faster way repays what is owed,
 * as long as it does. */
static bool may_execute(const struct choice_state *state, const struct size_state *size,
                        long long trip, enum way way) {
    const bool gains = size->gained && size->prospect[way].measured && !is_trial(size, way) &&
                       redcc_expected(size, way) < redcc_clear * redcc_usual(&size->sequential);
    return gains || room_for(state, size, trip, way) >= 0;
}

static bool keeps_changing(const struct size_state *size, const struct situation *now) {
    return redcc_next_misses(&size->set_ups) >= MISSES && now->steady >= 0 && now->steady < STEADY;
}

static double set_up_of(const struct prospect *prospect) {
    return prospect->learned > 0 ? prospect->learned : prospect->set_up;
}

/* Not ones that were met lately, as far as is known. */
static bool are_new(const struct situation *now) {
    return !now->verified && now->steady < STEADY;
}

/* Seconds of a set-up from now on, and of starting threads where they are not there. What was spent
 * so far may show that less is left than is likely: no less than half of what the inspection itself
 * takes. A plan for subscripts that are new each time must not count on a slice that is cheaper
 * than the body, as estimates do. */
static double cost_of(const struct size_state *size, const struct situation *now, enum way way) {
    const struct prospect *it = &size->prospect[way];
    const double body = redcc_usual(&size->sequential) * (double)now->trip / now->threads;
    const double all = set_up_of(it), left = all - now->spent;
    const double half = (all - now->dried - now->awaited) / 2;
    return (left > half ? left : half) + now->start + (are_new(now) && it->learned == 0 ? body : 0);
}

/* How many executions a plan made now may serve: as many as there were (rent or buy), or this one
 * alone where the subscripts were not yet met. Where plans were ended by other subscripts: until
 * these are as old as those of the last one were, or, where that is long ago or they are older, as
 * long again. */
static double horizon_of(const struct size_state *size, const struct situation *now) {
    const struct set_ups *it = &size->set_ups;
    const long since = (size->rest.calls - it->begun) / 8;
    if (it->lifetime == 0)
        return are_new(now) && now->steady >= 0 ? 1 : (double)size->rest.calls;
    const long age = now->steady > 0 ? now->steady : 0;
    const long life = it->lifetime > since ? it->lifetime : since;
    return (double)(life > age ? life - age : age);
}

/* The way that is the cheapest, set-up included, over the executions to come; of those that the
 * credit allows and that are better than `current` seconds an iteration. SEQUENTIAL: none. */
static enum way best_way(const struct choice_state *state, const struct size_state *size,
                         const struct situation *now, double current) {
    const double horizon = horizon_of(size, now) * (double)now->trip;
    const double factor = redcc_next_factor(&size->set_ups) * (now->steady < 0 ? unknown : 1);
    enum way best = WAY_SEQUENTIAL;
    double least_cost = current * horizon;
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++) {
        const double set_up = cost_of(size, now, way), each = redcc_expected(size, way);
        const double cost = set_up + each * horizon;
        const double all = now->spent + set_up;
        if (!redcc_is_better(size, way, current) || cost >= least_cost ||
            all > room_for(state, size, now->trip, way) || all * factor > size->set_ups.since)
            continue;
        best = way;
        least_cost = cost;
    }
    return best;
}

/* One loan at a time, and none after a set-up that did not earn its cost. */
static bool may_borrow(const struct choice_state *state, const struct size_state *size) {
    return size->stand == STAND_SAVING && redcc_next_misses(&size->set_ups) == 0 &&
           (state->ledger.loan > 0 || redcc_credit(state) >= 0);
}

/* What is spent of a loan already stays lent. */
static void lend(struct choice_state *state, double seconds) {
    if (state->ledger.loan < seconds)
        state->ledger.loan = seconds;
}

/* Are the subscripts likely to stay? */
static bool is_sure(const struct situation *now) {
    return now->verified || now->steady >= SURE;
}

/* Where samples have missed a change, the plan serves once: that may lose a share of the time so
 * far. Threads that were started for it stay. */
static bool may_be_misled(const struct choice_state *state, const struct situation *now,
                          double set_up, double gained) {
    return now->verified || set_up - now->start - gained <= share * state->ledger.sequential;
}

/* The best way that is worth a loan; SEQUENTIAL: none. */
static enum way borrowing_way(const struct choice_state *state, const struct size_state *size,
                              const struct situation *now) {
    const double usual = redcc_usual(&size->sequential), trip = (double)now->trip;
    const double awaited = now->steady > 2 * repaid_within ? now->steady / 2.0 : repaid_within;
    const double repaid = is_sure(now) ? least_of(awaited, horizon_of(size, now)) : repaid_at_once;
    enum way best = WAY_SEQUENTIAL;
    double least_cost = usual * soon * trip;
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++) {
        const struct prospect *it = &size->prospect[way];
        const double set_up = cost_of(size, now, way), each = redcc_expected(size, way);
        const double cost = set_up + each * soon * trip;
        const double gained = (usual - each) * trip; /* by an execution */
        if (!it->possible || each >= redcc_clear * usual || cost >= least_cost ||
            set_up > loan_most * usual * trip || set_up > repaid * gained ||
            !may_be_misled(state, now, set_up, gained))
            continue;
        best = way;
        least_cost = cost;
    }
    return best;
}

/* A sample said that bins may be worth a trial, and it would not be the first thing that is lost.
 */
static bool may_bin(const struct choice_state *state, const struct size_state *size,
                    const struct situation *now) {
    return size->prospect[WAY_BINS].possible &&
           room_for(state, size, now->trip, WAY_BINS) >= now->start;
}

/* Of the plans kept for these subscripts, the one with the least expected time below `least_each`
 * seconds an iteration. */
static enum way kept_way(const struct choice_state *state, const struct size_state *size,
                         const struct situation *now, double least_each) {
    enum way best = WAY_SEQUENTIAL;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (now->kept[way] == KEPT_FITS && (way != WAY_BINS || may_bin(state, size, now)) &&
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
    enum way way = may_borrow(state, size) ? borrowing_way(state, size, now) : WAY_SEQUENTIAL;
    const double usual = redcc_usual(&size->sequential) * (double)now->trip;
    const double slack = way != WAY_SEQUENTIAL ? waited * usual : 0;
    if (way != WAY_SEQUENTIAL)
        lend(state, least_of(now->spent + 2 * cost_of(size, now, way) + slack,
                             now->awaited + loan_most * usual));
    else
        way = best_way(state, size, now, current);
    if (way == WAY_SEQUENTIAL)
        return sequentially(size, RULE_SAVING);
    const double allowed = room_for(state, size, now->trip, way) - now->spent;
    assert(way > WAY_SEQUENTIAL && way < WAY_COUNT && size->prospect[way].possible);
    size->rule = RULE_SET_UP;
    return (struct decision){.action = ACTION_INSPECT,
                             .way = way,
                             .deadline = least_of(2 * cost_of(size, now, way) + slack, allowed),
                             .rule = RULE_SET_UP};
}

/* Seconds that a look takes. */
static double look_of(const struct size_state *size, const struct situation *now) {
    const double usual = redcc_usual(&size->sequential) * (double)now->trip;
    const double sample = least_of(first_look, sampled_most * usual);
    const double first = now->dry_run ? sample + usual : sample;
    const double cost = size->look > 0 ? size->look : first;
    assert(cost > 0);
    return cost;
}

static bool may_look(const struct choice_state *state, const struct size_state *size,
                     const struct situation *now) {
    const double cost = look_of(size, now);
    return redcc_credit(state) >= cost &&
           size->set_ups.since >= redcc_next_factor(&size->set_ups) * cost;
}

/* Starting threads for a look is little beside an execution. */
static bool may_lend_start(const struct choice_state *state, const struct size_state *size,
                           const struct situation *now) {
    const double usual = redcc_usual(&size->sequential) * (double)now->trip;
    return now->verified && may_borrow(state, size) &&
           look_of(size, now) + now->start <= started_most * usual;
}

static bool looks_alone(const struct choice_state *state, const struct size_state *size,
                        const struct situation *now) {
    return !is_sure(now) || redcc_credit(state) < look_of(size, now) + now->start;
}

/* By all threads, so that a set-up can follow at once, where the subscripts are likely to stay and
 * the credit covers starting them; where that is little beside an execution, it is lent. Else by
 * one thread, which waits for nobody: most light loops are not worth more than the look. */
static struct decision look(struct choice_state *state, struct size_state *size,
                            const struct situation *now) {
    if (!may_look(state, size, now))
        return sequentially(size, RULE_SAVING);
    if (looks_alone(state, size, now) && may_lend_start(state, size, now))
        lend(state, now->start);
    const bool alone = looks_alone(state, size, now);
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
    if (kept != WAY_SEQUENTIAL && may_execute(state, size, now->trip, kept)) {
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
    return may_execute(state, size, now->trip, turn) ? reuse(size, now, turn, RULE_COMPARING)
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
    if (!may_execute(state, size, now->trip, size->way))
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
    const enum way way = best_way(state, size, now, current);
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

static bool is_short(const struct size_state *size, const struct situation *now) {
    return redcc_usual(&size->sequential) * (double)now->trip < wakes * now->wake;
}

/* Was the loop looked at and found worth a set-up that it can pay for? */
static bool may_set_up(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now) {
    if (now->kept[WAY_BINS] == KEPT_FITS && may_bin(state, size, now))
        return true;
    return (may_borrow(state, size) && borrowing_way(state, size, now) != WAY_SEQUENTIAL) ||
           best_way(state, size, now, redcc_usual(&size->sequential)) != WAY_SEQUENTIAL;
}

enum reach redcc_reach(const struct choice_state *state, const struct situation *now) {
    const struct size_state *size = redcc_seen_size(state, now->trip);
    const bool is_timed = size->sequential.count > 0;
    const bool saves = size->stand == STAND_SAVING || (size->stand == STAND_UNTIMED && is_timed);
    const bool as_before = size->threads == 0 || size->threads == now->threads;
    if (size->stand == STAND_UNTIMED && !is_timed)
        return REACH_NOTHING;
    if (!saves || !as_before || size->set_ups.begun > 0 || is_short(size, now))
        return REACH_TEAM;
    if (size->looked)
        return may_set_up(state, size, now) ? REACH_TEAM : REACH_NOTHING;
    if (!may_look(state, size, now))
        return REACH_NOTHING;
    return looks_alone(state, size, now) && !may_lend_start(state, size, now) ? REACH_LOOK
                                                                              : REACH_TEAM;
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
