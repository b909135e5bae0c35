/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/decide.h"

/* The bound's e: of the sequential time, what trials may cost. At a tenth a program that is never
 * worth it is slower by no more than two runs of it differ on a machine that others use (5 to 15 %,
 * script/bench choice), and a loop that gains begins to after 4 to 12 executions. */
static const double share = 0.1;
/* Reserved for an execution by a plan, of a sequential one. LOCALWRITE on loops without runs took
 * up to 1.6 times the sequential loop, but there estimates say so; else no more than 1.25 times. */
static const double reserve = 0.25;
/* A way is worth a trial below this, of the other's time: medians of executions of one loop differ
 * by 3 to 5 % without a cause. */
static const double better = 0.95;
static const double evident = 0.1; /* difference of two ways that ends their comparison at once */
static const double clear = 0.8;   /* of the sequential loop: one execution is enough */
/* Before any sample was taken: 8192 iterations of some touches, and waking threads. 0.2 to 0.6 ms
 * where data is shuffled. */
static const double first_look = 0.5e-3;
/* Set-ups wait for ten times their cost at first (the bound), for as much as it when they have paid
 * thrice. */
static const double first_factor = 10, least_factor = 1, most_factor = 1e9;

enum {
    WAKES = 50,    /* executions shorter than so many wake-ups gain less than 2 % a microsecond */
    FORECAST = 20, /* times an inspection: then it costs 5 % of one execution */
    PAIRS = 3,     /* of a comparison: decides right in 19 of 20 cases at a noise of 30 % */
    CHECKED_AFTER = 64, /* timing the sequential loop again costs 1/64 */
    MISSES = 2,
    STEADY = 2,
    SHORT_REST = 16,
    SHORT_REST_MOST = 1024,
    SLOWER_REST = 16,
    UNATTRACTIVE_REST = 64,
    REFUSED_REST = 2,
    REST_MOST = 1 << 20
};

static struct size_state *size_of(struct choice_state *state, long long trip) {
    const int logarithm = 63 - __builtin_clzll((unsigned long long)trip | 1);
    return &state->size[logarithm < REDCC_SIZES ? logarithm : REDCC_SIZES - 1];
}

/* Seconds an iteration: the median of the last three sequential executions, of two the lower. */
static double usual(const struct timings *timings) {
    const double *t = timings->recent;
    if (timings->count < 3)
        return timings->count == 2 && t[1] < t[0] ? t[1] : t[0];
    const double low = t[0] < t[1] ? t[0] : t[1], high = t[0] < t[1] ? t[1] : t[0];
    return t[2] < low ? low : t[2] > high ? high : t[2];
}

/* The shortest of them: what is gained is not to be overestimated. */
static double least(const struct timings *timings) {
    double low = timings->recent[0];
    for (int i = 1; i < 3 && i < timings->count; i++)
        low = timings->recent[i] < low ? timings->recent[i] : low;
    return timings->count ? low : 0;
}

static void note_timing(struct timings *timings, double each) {
    timings->recent[timings->count++ % 3] = each;
}

double redcc_credit(const struct choice_state *state) {
    return share * state->ledger.sequential - state->ledger.overhead;
}

double redcc_usual_sequential(const struct choice_state *state, long long trip) {
    const struct size_state *size = size_of((struct choice_state *)state, trip);
    return usual(&size->sequential) * (double)trip;
}

enum rule redcc_rule_of(const struct choice_state *state, long long trip) {
    return size_of((struct choice_state *)state, trip)->rule;
}

/* ---- back-off ---- */

static void rest(struct size_state *size, enum stand stand, enum rule rule, long first, long most) {
    struct back_off *it = &size->rest;
    it->length = it->length ? it->length * 2 : first;
    it->length = it->length > most ? most : it->length;
    it->until = it->calls + it->length;
    size->stand = stand;
    size->rule = rule;
}

static void stop_resting(struct size_state *size, enum stand stand) {
    size->rest.length = 0;
    size->stand = stand;
}

/* ---- decisions ---- */

static struct decision sequentially(struct size_state *size, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_SEQUENTIAL, .timed = true, .rule = rule};
}

static struct decision reuse(struct size_state *size, enum way way, enum rule rule) {
    size->rule = rule;
    return (struct decision){.action = ACTION_REUSE, .way = way, .rule = rule};
}

/* Did the last set-up pay? Then the next one may come sooner, else later. */
static double next_factor(const struct set_ups *set_ups) {
    const double now = set_ups->factor > 0 ? set_ups->factor : first_factor;
    if (set_ups->invested == 0)
        return now;
    const double next = set_ups->earned >= set_ups->invested ? now / 2 : now * 2;
    return next < least_factor ? least_factor : next > most_factor ? most_factor : next;
}

static int next_misses(const struct set_ups *set_ups) {
    const bool missed = set_ups->invested > 0 && set_ups->earned < set_ups->invested;
    return missed ? set_ups->misses + 1 : 0;
}

/* Seconds that an inspection may take now. */
static double allowance(const struct choice_state *state, const struct size_state *size,
                        const struct situation *now) {
    return redcc_credit(state) - reserve * usual(&size->sequential) * (double)now->trip;
}

static bool may_set_up(const struct choice_state *state, const struct size_state *size,
                       const struct situation *now, double cost) {
    return allowance(state, size, now) >= cost &&
           size->set_ups.since >= next_factor(&size->set_ups) * cost;
}

static bool keeps_changing(const struct size_state *size, const struct situation *now) {
    return next_misses(&size->set_ups) >= MISSES && now->steady >= 0 && now->steady < STEADY;
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
    const double factor = next_factor(&size->set_ups);
    enum way best = WAY_SEQUENTIAL;
    double least_cost = current * horizon;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        const struct prospect *it = &size->prospect[way];
        const double cost = set_up_of(it) + it->execution * horizon;
        if (!it->possible || it->execution >= better * current || cost >= least_cost ||
            set_up_of(it) > allowed || set_up_of(it) * factor > settled)
            continue;
        best = way;
        least_cost = cost;
    }
    return best;
}

static bool some_way_is_better(const struct size_state *size) {
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (size->prospect[way].possible &&
            size->prospect[way].execution < better * usual(&size->sequential))
            return true;
    return false;
}

/* Of the plans kept for these subscripts, the one with the least expected time below the sequential
 * one. */
static enum way kept_way(const struct size_state *size, const struct situation *now) {
    enum way best = WAY_SEQUENTIAL;
    double least_each = better * usual(&size->sequential);
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

static void compare(struct size_state *size, enum way contender, enum way incumbent) {
    size->comparison = (struct comparison){.contender = contender, .incumbent = incumbent};
    size->stand = STAND_COMPARING;
    size->rule = RULE_COMPARING;
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
        compare(size, kept, WAY_SEQUENTIAL);
        return reuse(size, kept, RULE_COMPARING);
    }
    if (keeps_changing(size, now))
        return sequentially(size, RULE_CHANGING);
    if (!size->looked)
        return look(state, size, now);
    const enum way way = best_way(size, now->trip, usual(&size->sequential),
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
    const double more = usual(&size->sequential) - size->prospect[size->way].execution;
    return size->unchecked > CHECKED_AFTER * more * (double)trip;
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
        compare(size, size->way, WAY_SEQUENTIAL);
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
    if (now->forecast <= 0 || now->forecast < FORECAST * now->forecast_set_up ||
        now->forecast < WAKES * now->wake)
        return sequentially(size, RULE_FIRST);
    note_timing(&size->sequential, now->forecast / (double)now->trip);
    size->rule = RULE_FIRST;
    return (struct decision){
        .action = ACTION_INSPECT, .deadline = now->forecast / FORECAST * 2, .rule = RULE_FIRST};
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
        compare(size, size->way, WAY_SEQUENTIAL);
        return;
    }
    size->looked = false;
    for (enum way way = 0; way < WAY_COUNT; way++)
        size->prospect[way] = (struct prospect){.learned = size->prospect[way].learned};
    size->stand = STAND_SAVING;
}

static bool is_short(const struct size_state *size, const struct situation *now) {
    return usual(&size->sequential) * (double)now->trip < WAKES * now->wake;
}

bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads) {
    struct size_state *size = size_of(state, trip);
    if (size->stand != STAND_SHORT || size->threads != threads ||
        size->rest.calls + 1 >= size->rest.until)
        return false;
    size->rest.calls++;
    return true;
}

struct decision redcc_decide(struct choice_state *state, const struct situation *now) {
    struct size_state *size = size_of(state, now->trip);
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
        rest(size, STAND_SHORT, RULE_SHORT, SHORT_REST, SHORT_REST_MOST);
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
    struct size_state *size = size_of(state, now->trip);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        note_prospect(&size->prospect[way], &prospect[way]);
    size->looked = true;
    size->look = spent;
    const double allowed = size->stand == STAND_UNTIMED
                               ? usual(&size->sequential) * (double)now->trip / FORECAST
                               : allowance(state, size, now) - spent;
    const double settled =
        size->stand == STAND_UNTIMED ? allowed * first_factor : size->set_ups.since;
    const double current = size->stand == STAND_PARALLEL ? size->prospect[size->way].execution
                                                         : usual(&size->sequential);
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

/* ---- outcomes ---- */

/* A comparison is over: the contender was the faster way, or not. */
static void settle(struct size_state *size, bool contender_won) {
    const struct comparison *it = &size->comparison;
    struct prospect *prospect = &size->prospect[it->contender];
    prospect->execution = it->contender_sum / it->contended;
    prospect->measured = true;
    size->way = contender_won || it->incumbent == WAY_SEQUENTIAL ? it->contender : it->incumbent;
    size->unchecked = 0;
    if (!contender_won && it->incumbent == WAY_SEQUENTIAL) {
        rest(size, STAND_RESTING, RULE_SLOWER, SLOWER_REST, REST_MOST);
        return;
    }
    stop_resting(size, STAND_PARALLEL);
    size->rule = RULE_FASTER;
}

static void settle_if_evident(struct size_state *size) {
    const struct comparison *it = &size->comparison;
    if (it->incumbent == WAY_SEQUENTIAL && it->contended == 1 && it->defended == 0 &&
        it->contender_sum < clear * usual(&size->sequential)) {
        settle(size, true);
        return;
    }
    if (it->contended != it->defended)
        return;
    const double difference = it->incumbent_sum - it->contender_sum;
    if (difference > evident * it->incumbent_sum || -difference > evident * it->incumbent_sum ||
        it->contended >= PAIRS)
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

static void observe_sequential(struct choice_state *state, struct size_state *size,
                               const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    state->ledger.sequential += outcome->seconds;
    size->set_ups.since += outcome->seconds;
    const bool comparing = size->stand == STAND_COMPARING;
    const bool checked = comparing && size->comparison.incumbent == WAY_SEQUENTIAL &&
                         size->comparison.incumbents_turn && size->comparison.defended == 0;
    if (checked) /* what was timed before the machine changed is of no use */
        size->sequential.count = 0;
    note_timing(&size->sequential, each);
    if (comparing)
        count_in_comparison(size, WAY_SEQUENTIAL, each);
}

static void count_set_up(struct size_state *size, enum way way, double seconds) {
    struct set_ups *it = &size->set_ups;
    const double factor = next_factor(it);
    const int misses = next_misses(it);
    *it = (struct set_ups){.factor = factor,
                           .invested = seconds,
                           .misses = misses,
                           .begun = size->rest.calls,
                           .lifetime = it->lifetime};
    size->prospect[way].learned = seconds;
    size->prospect[way].possible = true;
}

/* The first execution by a new plan starts threads and touches pages: it is not compared. */
static void begin_trial(struct size_state *size, enum way way) {
    const bool rival = size->stand == STAND_PARALLEL && size->way != way;
    compare(size, way, rival ? size->way : WAY_SEQUENTIAL);
}

static void observe_parallel(struct choice_state *state, struct size_state *size,
                             const struct outcome *outcome) {
    const double each = outcome->seconds / (double)outcome->trip;
    const double sequential = least(&size->sequential) * (double)outcome->trip;
    struct prospect *prospect = &size->prospect[outcome->way];
    state->ledger.sequential += sequential;
    state->ledger.overhead += outcome->seconds + outcome->set_up - sequential;
    if (outcome->set_up > 0) {
        if (size->stand == STAND_SAVING && size->set_ups.uses > 0)
            size->set_ups.lifetime = size->set_ups.uses;
        count_set_up(size, outcome->way, outcome->set_up);
    }
    size->set_ups.uses++;
    size->set_ups.since += sequential;
    size->set_ups.earned += sequential - outcome->seconds;
    if (outcome->set_up > 0) {
        begin_trial(size, outcome->way);
        return;
    }
    prospect->execution = prospect->measured ? (prospect->execution + each) / 2 : each;
    prospect->measured = true;
    if (size->stand == STAND_COMPARING)
        count_in_comparison(size, outcome->way, each);
    else if (size->stand == STAND_PARALLEL)
        size->unchecked += outcome->seconds;
}

static void observe_stop(struct size_state *size, const struct outcome *outcome) {
    const double whole = outcome->done > 0.01 ? outcome->seconds / outcome->done : 0;
    const double twice = 2 * outcome->seconds;
    count_set_up(size, outcome->way, outcome->seconds);
    if (outcome->way == WAY_SEQUENTIAL) /* not even the sample was there */
        size->look = twice;
    else
        size->prospect[outcome->way].learned = whole > twice ? whole : twice;
    if (size->stand != STAND_PARALLEL)
        size->stand = STAND_SAVING;
    size->rule = RULE_STOPPED;
}

/* Of one way: then another one may do. Of all: the loop rests. */
static void observe_refusal(struct size_state *size, const struct outcome *outcome) {
    size->prospect[outcome->way].possible = false;
    size->prospect[outcome->way].ruled_out = true;
    const bool another = outcome->way != WAY_SEQUENTIAL && some_way_is_better(size);
    if (size->stand != STAND_PARALLEL && !another)
        rest(size, STAND_RESTING, RULE_REFUSED, REFUSED_REST, REST_MOST);
}

void redcc_observe(struct choice_state *state, const struct outcome *outcome) {
    struct size_state *size = size_of(state, outcome->trip);
    switch (outcome->result) {
    case RESULT_SEQUENTIAL:
        observe_sequential(state, size, outcome);
        return;
    case RESULT_PARALLEL:
        observe_parallel(state, size, outcome);
        return;
    case RESULT_UNATTRACTIVE:
        if (outcome->way != WAY_SEQUENTIAL)
            count_set_up(size, outcome->way, outcome->seconds);
        size->prospect[outcome->way].possible = false;
        size->prospect[outcome->way].ruled_out = true;
        if (!some_way_is_better(size))
            rest(size, STAND_RESTING, RULE_UNATTRACTIVE, UNATTRACTIVE_REST, REST_MOST);
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
