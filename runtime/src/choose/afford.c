/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/afford.h"

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

double redcc_credit(const struct choice_state *state) {
    return share * state->ledger.sequential - state->ledger.overhead + state->ledger.loan;
}

static double least_of(double a, double b) {
    return a < b ? a : b;
}

bool redcc_is_trial(const struct size_state *size, enum way way) {
    const bool compared = size->stand == STAND_COMPARING && size->comparison.contender == way;
    return way == WAY_BINS && (compared || !size->prospect[way].measured);
}

double redcc_trial_may_lose(const struct size_state *size, long long trip) {
    return tried * redcc_usual(&size->sequential) * (double)trip;
}

/* Seconds that may be lost by this way now. */
static double room_for(const struct choice_state *state, const struct size_state *size,
                       long long trip, enum way way) {
    const double usual = redcc_usual(&size->sequential);
    const bool is_clear = redcc_expected(size, way) < redcc_clear * usual;
    const double risk = redcc_is_trial(size, way) ? tried : is_clear ? 0 : reserve;
    const double lent = way == WAY_BINS ? state->ledger.loan : 0; /* for a set-up */
    return redcc_credit(state) - lent - risk * usual * (double)trip;
}

bool redcc_may_execute(const struct choice_state *state, const struct size_state *size,
                       long long trip, enum way way) {
    const bool gains = size->gained && size->prospect[way].measured && !redcc_is_trial(size, way) &&
                       redcc_expected(size, way) < redcc_clear * redcc_usual(&size->sequential);
    return gains || room_for(state, size, trip, way) >= 0;
}

bool redcc_may_bin(const struct choice_state *state, const struct size_state *size,
                   const struct situation *now) {
    return size->prospect[WAY_BINS].possible &&
           room_for(state, size, now->trip, WAY_BINS) >= now->start;
}

bool redcc_is_short(const struct size_state *size, const struct situation *now) {
    return redcc_usual(&size->sequential) * (double)now->trip < wakes * now->wake;
}

static double set_up_of(const struct prospect *prospect) {
    return prospect->learned > 0 ? prospect->learned : prospect->set_up;
}

/* Not ones that were met lately, as far as is known. */
static bool are_new(const struct situation *now) {
    return !now->verified && now->steady < REDCC_STEADY;
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

enum way redcc_affordable_way(const struct choice_state *state, const struct size_state *size,
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

/* Or will be, as soon as something is decided. */
static bool is_saving(const struct size_state *size) {
    return size->stand == STAND_SAVING ||
           (size->stand == STAND_UNTIMED && size->sequential.count > 0);
}

/* One loan at a time, and none after a set-up that did not earn its cost. */
static bool may_borrow(const struct choice_state *state, const struct size_state *size) {
    return is_saving(size) && redcc_next_misses(&size->set_ups) == 0 &&
           (state->ledger.loan > 0 || redcc_credit(state) >= 0);
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

enum way redcc_way_to_borrow_for(const struct choice_state *state, const struct size_state *size,
                                 const struct situation *now) {
    const double usual = redcc_usual(&size->sequential), trip = (double)now->trip;
    const double awaited = now->steady > 2 * repaid_within ? now->steady / 2.0 : repaid_within;
    const double repaid = is_sure(now) ? least_of(awaited, horizon_of(size, now)) : repaid_at_once;
    enum way best = WAY_SEQUENTIAL;
    double least_cost = usual * soon * trip;
    if (!may_borrow(state, size))
        return WAY_SEQUENTIAL;
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

static double slack_of(const struct size_state *size, long long trip) {
    return waited * redcc_usual(&size->sequential) * (double)trip;
}

double redcc_loan_for(const struct size_state *size, const struct situation *now, enum way way) {
    const double most = loan_most * redcc_usual(&size->sequential) * (double)now->trip;
    const double wanted = 2 * cost_of(size, now, way) + slack_of(size, now->trip);
    return least_of(now->spent + wanted, now->awaited + most);
}

double redcc_deadline(const struct choice_state *state, const struct size_state *size,
                      const struct situation *now, enum way way, bool is_lent) {
    const double slack = is_lent ? slack_of(size, now->trip) : 0;
    const double allowed = room_for(state, size, now->trip, way) - now->spent;
    return least_of(2 * cost_of(size, now, way) + slack, allowed);
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

bool redcc_may_look(const struct choice_state *state, const struct size_state *size,
                    const struct situation *now) {
    const double cost = look_of(size, now);
    return redcc_credit(state) >= cost &&
           size->set_ups.since >= redcc_next_factor(&size->set_ups) * cost;
}

bool redcc_may_lend_start(const struct choice_state *state, const struct size_state *size,
                          const struct situation *now) {
    const double usual = redcc_usual(&size->sequential) * (double)now->trip;
    return now->verified && may_borrow(state, size) &&
           look_of(size, now) + now->start <= started_most * usual;
}

bool redcc_looks_alone(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now) {
    return !is_sure(now) || redcc_credit(state) < look_of(size, now) + now->start;
}

/* Was the loop looked at and found worth a set-up that it can pay for? */
static bool may_set_up(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now) {
    if (now->kept[WAY_BINS] == KEPT_FITS && redcc_may_bin(state, size, now))
        return true;
    return redcc_way_to_borrow_for(state, size, now) != WAY_SEQUENTIAL ||
           redcc_affordable_way(state, size, now, redcc_usual(&size->sequential)) != WAY_SEQUENTIAL;
}

enum reach redcc_reach(const struct choice_state *state, const struct situation *now) {
    const struct size_state *size = redcc_seen_size(state, now->trip);
    const bool as_before = size->threads == 0 || size->threads == now->threads;
    if (size->stand == STAND_UNTIMED && size->sequential.count == 0)
        return REACH_NOTHING;
    if (!is_saving(size) || !as_before || size->set_ups.begun > 0 || redcc_is_short(size, now))
        return REACH_TEAM;
    if (size->looked)
        return may_set_up(state, size, now) ? REACH_TEAM : REACH_NOTHING;
    if (!redcc_may_look(state, size, now))
        return REACH_NOTHING;
    return redcc_looks_alone(state, size, now) && !redcc_may_lend_start(state, size, now)
               ? REACH_LOOK
               : REACH_TEAM;
}
