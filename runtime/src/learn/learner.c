/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Decisions: which actions a loop can afford, and which of them it takes. outcome.c processes the
 * results. */
#include "learn/learner.h"

#include <assert.h>

/* ---- affordable actions ---------------------------------------------------------------------- */

/* The data on which a decision depends: the loop's ledger, its state at trip counts of this size,
 * and the call. */
struct choice {
    struct ledger *ledger;
    struct size_state *size;
    const struct situation *now;
};

static double credit_of(const struct ledger *it) {
    return LEARN_SHARE * it->sequential - it->overhead + it->overdraft;
}

double redcc_credit(const struct choice_state *state) {
    return credit_of(&state->ledger);
}

static double least_of(double a, double b) {
    return a < b ? a : b;
}

static double most_of(double a, double b) {
    return a > b ? a : b;
}

/* Seconds of an execution of the sequential loop. */
static double usual_of(const struct choice *c) {
    return redcc_usual(c->size) * (double)c->now->trip;
}

/* Until bins are known to be faster, an execution with them is a trial, which may stop early. */
static bool is_trial(const struct choice *c, enum way way) {
    const bool compared = c->size->phase == PHASE_COMPARING && c->size->comparison.contender == way;
    return way == WAY_BINS && (compared || c->size->arm[way].timed.count == 0);
}

static bool is_clear(const struct choice *c, enum way way) {
    return redcc_expected(c->size, way) < LEARN_CLEAR * redcc_usual(c->size);
}

/* The seconds that this strategy may lose now, beyond the risk of one execution. */
static double room_for(const struct choice *c, enum way way) {
    const double risk = is_trial(c, way) ? LEARN_SHARE : is_clear(c, way) ? 0 : LEARN_RISK;
    const bool may_overdraw = redcc_is_planned(way) || (way == WAY_DIRECT && c->now->in_tiles);
    const double reserved = may_overdraw ? 0 : c->ledger->overdraft; /* for a plan construction */
    return credit_of(c->ledger) - reserved - risk * usual_of(c);
}

/* Is this the second execution by owners without a plan, whose first one has lost little, although
 * they are expected to be clearly faster? */
static bool is_second_directly(const struct choice *c, enum way way) {
    const struct comparison *it = &c->size->comparison;
    const struct arm *arm = &c->size->arm[way];
    return way == WAY_DIRECT && c->size->phase == PHASE_COMPARING && it->contender == way &&
           it->incumbent == WAY_SEQUENTIAL && !it->proven && it->pairs.timed == 0 &&
           arm->timed.count == 1 && arm->execution < LEARN_CLEAR * c->size->looked_at &&
           c->size->gained > -LEARN_RISK * usual_of(c);
}

/* May the strategy be executed with the present credit? A strategy that is clearly faster may run
 * while the credit is negative, because it repays the debt. But its executions together must have
 * gained time since the credit became negative. So one slow execution does not end its use. Page
 * faults make a first execution slow: a second one may follow if the first one has gained
 * nevertheless or, without a plan, if it has lost little. */
static bool may_execute(const struct choice *c, enum way way) {
    const bool is_second = c->size->arm[way].timed.count == 1;
    const bool repays = c->size->gained > 0 && !is_trial(c, way) && (is_clear(c, way) || is_second);
    return repays || is_second_directly(c, way) || room_for(c, way) >= 0;
}

static bool fits(const struct choice *c, enum way way) {
    return c->now->kept[way] == KEPT_FITS &&
           (redcc_is_planned(way) ||
            (c->size->arm[way].possible && room_for(c, way) >= c->now->start));
}

/* The strategy available in this call with the shortest expected time, if that is clearly below
 * `current` seconds per iteration; otherwise WAY_SEQUENTIAL. If `guessed` is set, considers only
 * strategies that a trial must evaluate; otherwise only the others. */
static enum way ready_way(const struct choice *c, double current, bool guessed) {
    enum way best = WAY_SEQUENTIAL;
    double least = LEARN_BETTER * current;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (c->size->arm[way].guessed == guessed && fits(c, way) &&
            redcc_expected(c->size, way) < least) {
            best = way;
            least = redcc_expected(c->size, way);
        }
    return best;
}

/* are_new: are the subscripts new, as far as is known? are_stable: are they likely to stay? */
static bool are_new(const struct choice *c) {
    return !c->now->verified && c->now->steady < LEARN_STABLE / 2;
}

static bool are_stable(const struct choice *c) {
    return c->now->verified || c->now->steady >= LEARN_STABLE;
}

/* Seconds that a plan construction will still take, including starting threads. At least half of
 * the inspection's cost, without its dry run and waits, is assumed to remain. If the subscripts are
 * new, and neither a construction nor the slice was timed, the slice is assumed to take as long as
 * the body. */
static double cost_of(const struct choice *c, enum way way) {
    const struct arm *it = &c->size->arm[way];
    const double all = it->learned > 0 ? it->learned : it->set_up;
    const double left = most_of(all - c->now->spent, (all - c->now->dried - c->now->awaited) / 2);
    const bool counts_body = are_new(c) && it->learned == 0 && !c->now->measured;
    return left + c->now->start + (counts_body ? usual_of(c) / c->now->threads : 0);
}

/* The expected number of executions of a plan that is constructed now. If no change of subscripts
 * has ended a plan, it is the number of calls so far (the rent-or-buy rule), or 1 if the subscripts
 * are new. Otherwise the present subscripts are expected to last as long as those of the last plan,
 * or an eighth of the calls since that plan. If they have already lasted longer, they are expected
 * to last as long again. */
static double horizon_of(const struct choice *c) {
    const struct set_ups *it = &c->size->set_ups;
    if (it->lifetime == 0)
        return are_new(c) && c->now->steady >= 0 ? 1 : (double)c->size->calls;
    const long since = (c->size->calls - it->begun) / (2 * LEARN_STABLE),
               age = c->now->steady > 0 ? c->now->steady : 0;
    const long life = it->lifetime > since ? it->lifetime : since;
    return (double)(life > age ? life - age : age);
}

/* The rent-or-buy rule: since the last plan construction, has the sequential loop taken the
 * required multiple of `seconds`? */
static bool has_waited_for(const struct choice *c, double seconds) {
    return seconds * redcc_factor(&c->size->set_ups) <= c->size->set_ups.since;
}

/* Does the credit cover the plan construction, and has the loop waited long enough for it? */
static bool is_affordable(const struct choice *c, enum way way) {
    const double all = c->now->spent + cost_of(c, way);
    return all <= room_for(c, way) && has_waited_for(c, all);
}

/* May an overdraft be allowed, or the present overdraft be extended? Only in PHASE_SAVING, and not
 * after a plan construction that did not recover its cost. A new overdraft also requires that there
 * is no debt. */
static bool can_overdraw(const struct choice *c) {
    return c->size->phase == PHASE_SAVING && redcc_misses(&c->size->set_ups) == 0 &&
           (c->ledger->overdraft > 0 || credit_of(c->ledger) >= 0);
}

/* Is a plan worth an overdraft? It must be clearly faster, and must repay its construction by as
 * many executions as its subscripts have lasted, or by LEARN_STABLE. If the subscripts are not
 * known to be stable, the first execution must repay it. If they were only sampled, the plan may
 * turn out useless after its first execution, which has no check; then the loss must be within a
 * share of the time so far. */
static bool is_worth_overdraft(const struct choice *c, enum way way) {
    const double usual = usual_of(c), set_up = cost_of(c, way);
    const double gained = usual - redcc_expected(c->size, way) * (double)c->now->trip;
    const double soon = most_of(LEARN_STABLE, c->now->steady);
    const double repaid = are_stable(c) ? least_of(soon, horizon_of(c)) : LEARN_BETTER;
    const double checked = c->size->arm[way].check * (double)c->now->trip;
    const double misled = set_up - c->now->start - (gained + checked);
    return is_clear(c, way) && set_up <= LEARN_OVERDRAFT * usual && set_up <= repaid * gained &&
           (c->now->verified || misled <= LEARN_SHARE * c->ledger->sequential);
}

typedef bool allows(const struct choice *, enum way);

/* The strategy with the cheapest plan, over `executions` executions and including its construction,
 * among the allowed ones. It must be cheaper than executions that take `current` seconds per
 * iteration; otherwise the result is WAY_SEQUENTIAL. */
static enum way best_plan(const struct choice *c, double current, double executions,
                          allows *is_allowed) {
    enum way best = WAY_SEQUENTIAL;
    double least = current * executions * (double)c->now->trip;
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++) {
        const double each = redcc_expected(c->size, way) * (double)c->now->trip;
        const double cost = cost_of(c, way) + each * executions;
        if (redcc_is_better(c->size, way, current) && cost < least && is_allowed(c, way)) {
            best = way;
            least = cost;
        }
    }
    return best;
}

static enum way affordable_way(const struct choice *c, double current) {
    return best_plan(c, current, horizon_of(c), is_affordable);
}

/* Can the loop be executed without a plan (WAY_DIRECT), whatever its subscripts are? */
static bool goes_without_plan(const struct choice *c) {
    return c->now->kept[WAY_DIRECT] == KEPT_FITS && !c->size->arm[WAY_DIRECT].ruled_out;
}

/* If subscripts are not new, one thread's sample takes this part of LEARN_SAMPLE: 0.17 to 0.21 ms
 * were measured. With scattered subscripts, which often change in each call, 0.3 ms were. */
static const double sampled_alone = 0.6;

/* Seconds that a sample is expected to take. Until a dry run was timed, it is assumed to take as
 * long as an execution. In a loop that needs no plan, a 16th of that is assumed (in loops over
 * blocks, 0.05 was measured). If a dry run takes longer, a deadline ends it. */
static double look_of(const struct choice *c, bool alone) {
    const double usual = usual_of(c),
                 sample = alone && !are_new(c) ? sampled_alone * LEARN_SAMPLE : LEARN_SAMPLE;
    const double dry =
        c->now->dry_run ? (goes_without_plan(c) ? 2 * LEARN_SHARE * usual : usual) : 0;
    return c->size->look > 0 ? c->size->look : least_of(sample, LEARN_CLEAR * usual) + dry;
}

/* ---- decisions ------------------------------------------------------------------------------- */

static struct decision sequentially(const struct choice *c, enum rule rule) {
    c->size->rule = rule;
    return (struct decision){.action = ACTION_SEQUENTIAL, .timed = true, .rule = rule};
}

static struct decision reuse(const struct choice *c, enum way way, enum rule rule) {
    struct decision decision = {.action = ACTION_REUSE,
                                .way = way,
                                .earned = c->size->set_ups.earned - c->size->set_ups.invested,
                                .rule = rule};
    c->size->rule = rule;
    if (is_trial(c, way))
        decision.may_lose = usual_of(c) > 0 ? LEARN_SHARE * usual_of(c) : -LEARN_SHARE;
    return decision;
}

/* Sets the overdraft to `seconds`, or extends it. The part that was spent remains a debt. */
static void allow_overdraft(const struct choice *c, double seconds) {
    c->ledger->overdraft = most_of(c->ledger->overdraft, seconds);
}

/* Decides about a plan construction within an overdraft or the credit, if a strategy is expected to
 * take less than `current` seconds per iteration. The overdraft covers twice the cost of the
 * construction, and a fraction of an execution, because threads may not get a core at once. It is
 * at most LEARN_OVERDRAFT executions. */
static struct decision set_up(const struct choice *c, double current) {
    const double usual = usual_of(c);
    enum way way = can_overdraw(c)
                       ? best_plan(c, redcc_usual(c->size), LEARN_FACTOR, is_worth_overdraft)
                       : WAY_SEQUENTIAL;
    const bool may_overdraw = way != WAY_SEQUENTIAL;
    way = may_overdraw ? way : affordable_way(c, current);
    if (way == WAY_SEQUENTIAL)
        return sequentially(c, RULE_SAVING);
    const double most = 2 * cost_of(c, way) + (may_overdraw ? LEARN_RISK * usual : 0);
    if (may_overdraw)
        allow_overdraft(c,
                        least_of(c->now->spent + most, c->now->awaited + LEARN_OVERDRAFT * usual));
    c->size->rule = RULE_SET_UP;
    return (struct decision){.action = ACTION_INSPECT,
                             .way = way,
                             .deadline = least_of(most, room_for(c, way) - c->now->spent),
                             .rule = RULE_SET_UP};
}

/* Takes a sample. If all threads take part, a plan construction can follow immediately. They do if
 * the subscripts are likely to stay or no plan is needed, and if the credit covers starting the
 * threads. An overdraft covers the cost if it is small compared with an execution; it also covers a
 * dry run of twice the assumed length. Otherwise one thread takes the sample alone: most short
 * loops turn out not to be worth more. */
static struct decision look(const struct choice *c) {
    const double credit = credit_of(c->ledger), together = look_of(c, false);
    const bool at_once = goes_without_plan(c) || c->now->begun;
    const bool may_overdraw = (at_once || (c->now->verified && credit >= together)) &&
                              credit < together + c->now->start && can_overdraw(c) &&
                              together + c->now->start <= LEARN_RISK / 2 * usual_of(c);
    const double wanted = c->now->start + (at_once ? (c->now->dry_run ? 2 : 1) * together : 0);
    const double lent = may_overdraw ? most_of(wanted - c->ledger->overdraft, 0) : 0;
    const bool is_covered = credit + lent >= together + c->now->start;
    const bool alone = !(are_stable(c) || at_once) || !is_covered;
    const double cost = alone ? look_of(c, true) : together;
    if ((alone && credit < cost) || !(c->now->begun || has_waited_for(c, cost)))
        return sequentially(c, RULE_SAVING);
    if (!alone && lent > 0)
        allow_overdraft(c, wanted);
    c->size->rule = RULE_SAMPLING;
    return (struct decision){
        .action = ACTION_INSPECT,
        .alone = alone,
        .deadline = least_of(2 * cost, credit_of(c->ledger) - (alone ? 0 : c->now->start)),
        .rule = RULE_SAMPLING};
}

static struct decision take_up(const struct choice *c, enum way way) {
    if (c->size->arm[way].timed.count == 0) {
        redcc_compare(c->size, way, WAY_SEQUENTIAL);
        return reuse(c, way, RULE_COMPARING);
    }
    c->size->way = way;
    c->size->phase = PHASE_PARALLEL;
    return reuse(c, way, RULE_FASTER);
}

static struct decision decide_set_up(const struct choice *c) {
    if (redcc_misses(&c->size->set_ups) >= LEARN_STABLE / 2 && c->now->steady >= 0 &&
        c->now->steady < LEARN_STABLE / 2)
        return sequentially(c, RULE_CHANGING);
    return set_up(c, redcc_usual(c->size));
}

bool redcc_goes_at_once(const struct situation *now) {
    return now->bins_only && !now->whole && now->threads > 1 &&
           now->trip >= (long long)LEARN_SAMPLED * LEARN_SAMPLED;
}

/* Are bins tried before any inspection? They are
 * - if the loop cannot be inspected;
 * - if an inspection begins with a dry run, which may take as long as the loop;
 * - if iterations are so long that an inspection may take longer than a trial of bins may lose.
 *   Long iterations have inner loops, and the inspection records all rows that these touch (for
 *   tiles, only the first and the last row).
 * If the loop was never timed, the first execution may be a trial that times the sequential loop as
 * well. */
static bool tries_first(const struct choice *c) {
    const struct arm *bins = &c->size->arm[WAY_BINS];
    const double usual = redcc_usual(c->size);
    if (c->now->threads < 2 || c->now->tiled || bins->timed.count > 0 || bins->ruled_out ||
        c->now->kept[WAY_BINS] != KEPT_FITS)
        return false;
    return usual == 0
               ? redcc_goes_at_once(c->now)
               : c->now->bins_only || c->now->dry_run || usual * LEARN_SAMPLED > LEARN_SAMPLE;
}

static struct decision try_first(const struct choice *c) {
    const double usual = redcc_usual(c->size), least = LEARN_CONTENDED / c->now->threads * usual;
    c->size->arm[WAY_BINS] = (struct arm){.possible = true, .guessed = true, .execution = least};
    const bool may = usual == 0 || c->now->begun || (fits(c, WAY_BINS) && may_execute(c, WAY_BINS));
    return may ? take_up(c, WAY_BINS) : sequentially(c, RULE_SAVING);
}

/* Are tiles tried without a sample? They compute each pair once, whatever the subscripts are, so a
 * sample would show nothing new. But if tiles have failed, or a guard has forbidden them, a sample
 * is taken after the back-off. */
static bool goes_in_tiles(const struct choice *c) {
    return c->now->in_tiles && c->now->threads > 1 && !c->now->dry_run &&
           c->size->back_off.length == 0 && goes_without_plan(c);
}

/* Tries tiles. An overdraft covers starting the threads, if the first execution is expected to
 * repay that. The first parallel execution is slow. So the overdraft also covers a fraction of an
 * execution or, if the loop is not new, a whole one. */
static struct decision try_tiles(const struct choice *c) {
    const double usual = redcc_usual(c->size), each = LEARN_CONTENDED / c->now->threads * usual;
    const double gained = (usual - each) * (double)c->now->trip;
    const bool is_new = c->ledger->sequential < (LEARN_STABLE - 1) * usual_of(c);
    const bool may_overdraw = can_overdraw(c) && c->now->start <= LEARN_BETTER * gained;
    c->size->arm[WAY_DIRECT] = (struct arm){.possible = true, .execution = each};
    c->size->looked_at = usual;
    if (may_overdraw && is_clear(c, WAY_DIRECT))
        allow_overdraft(c, is_new ? c->now->start + LEARN_RISK * usual_of(c)
                                  : LEARN_OVERDRAFT * usual_of(c));
    return fits(c, WAY_DIRECT) ? take_up(c, WAY_DIRECT) : sequentially(c, RULE_SAVING);
}

/* The decision in PHASE_SAVING. In this order, uses a strategy that is available and expected to
 * pay; tries tiles or bins, or takes a sample, if no sample was taken; constructs a plan; tries a
 * strategy that only a trial can evaluate. */
static struct decision decide_saving(const struct choice *c) {
    const double usual = redcc_usual(c->size);
    const enum way ready = ready_way(c, usual, false);
    if (ready != WAY_SEQUENTIAL && may_execute(c, ready))
        return take_up(c, ready);
    if (!c->size->looked)
        return goes_in_tiles(c)    ? try_tiles(c)
               : tries_first(c)    ? try_first(c)
               : c->now->bins_only ? sequentially(c, RULE_SAVING)
                                   : look(c);
    const struct decision decision = decide_set_up(c);
    const enum way guessed = ready_way(c, usual, true);
    return decision.action == ACTION_SEQUENTIAL && guessed != WAY_SEQUENTIAL &&
                   may_execute(c, guessed)
               ? take_up(c, guessed)
               : decision;
}

/* Called if no plan of the strategy in use fits this call. Time lost within an overdraft is still
 * owed, but no more of the overdraft may be spent. */
static struct decision leave_plan(const struct choice *c) {
    c->size->phase = PHASE_SAVING;
    c->ledger->overdraft = 0;
    return decide_saving(c);
}

static struct decision decide_comparing(const struct choice *c) {
    const struct comparison *it = &c->size->comparison;
    if (c->now->kept[it->contender] != KEPT_FITS ||
        (it->incumbent != WAY_SEQUENTIAL && c->now->kept[it->incumbent] != KEPT_FITS))
        return leave_plan(c);
    const enum way next = redcc_arm_to_run(it);
    if (next == WAY_SEQUENTIAL)
        return sequentially(c, RULE_COMPARING);
    return may_execute(c, next) ? reuse(c, next, RULE_COMPARING) : sequentially(c, RULE_SAVING);
}

/* Must the sequential loop be timed again? It must as soon as timing it costs at most half of
 * LEARN_SHARE of the time since the last check. Each of the first three checks that find the plan
 * faster halves this fraction. If only the first execution was timed, a check is due four times as
 * early, because page faults make first executions slow. */
static bool is_check_due(const struct choice *c) {
    const double more = redcc_usual(c->size) - redcc_expected(c->size, c->size->way);
    const double half = 2 / LEARN_SHARE;
    const double after =
        c->size->sequential.count > 1 ? half * (double)(1 << c->size->checks) : half / LEARN_STABLE;
    return c->size->unchecked > after * more * (double)c->now->trip;
}

/* If the strategy in use was tried without a sample, should a sample be taken now, because another
 * strategy may be better? The execution after a sample is sequential, so the sample's cost includes
 * the gain of one execution. The credit and a share of the time since the last plan construction
 * must cover this cost. */
static bool looks_for_more(const struct choice *c, double current) {
    const double lost = (redcc_usual(c->size) - current) * (double)c->now->trip;
    const double cost = look_of(c, false) + most_of(lost, 0);
    return !c->size->looked && !c->now->bins_only && !c->now->in_tiles &&
           cost <= credit_of(c->ledger) && cost <= LEARN_SHARE * c->size->set_ups.since;
}

static struct decision decide_parallel(const struct choice *c) {
    if (c->now->kept[c->size->way] != KEPT_FITS)
        return leave_plan(c);
    if (!may_execute(c, c->size->way))
        return sequentially(c, RULE_SAVING);
    const double current = redcc_expected(c->size, c->size->way);
    if (is_check_due(c)) {
        c->size->checks += c->size->sequential.count > 1 && c->size->checks < LEARN_PAIRS;
        redcc_compare(c->size, c->size->way, WAY_SEQUENTIAL);
        if (is_trial(c, c->size->way))
            return reuse(c, c->size->way, RULE_COMPARING);
        redcc_paired_note(&c->size->comparison.pairs, current);
        return sequentially(c, RULE_COMPARING);
    }
    if (looks_for_more(c, current))
        return look(c);
    const enum way way = affordable_way(c, current);
    if (way != WAY_SEQUENTIAL && way != c->size->way && c->now->kept[way] != KEPT_FITS)
        return set_up(c, current);
    const enum way ready = ready_way(c, current, false);
    if (ready != WAY_SEQUENTIAL && ready != c->size->way) {
        redcc_compare(c->size, ready, c->size->way);
        return reuse(c, ready, RULE_COMPARING);
    }
    return reuse(c, c->size->way, RULE_FASTER);
}

/* Among the strategies available in this call, the one that was fastest in its last executions;
 * WAY_SEQUENTIAL if there is none. A strategy without plans counts only if it was faster than the
 * sequential loop. */
static enum way fastest_known(const struct choice *c) {
    enum way best = WAY_SEQUENTIAL;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (c->size->arm[way].timed.count > 0 && c->now->kept[way] == KEPT_FITS &&
            (redcc_is_planned(way) || redcc_expected(c->size, way) < redcc_usual(c->size)) &&
            (best == WAY_SEQUENTIAL ||
             redcc_expected(c->size, way) < redcc_expected(c->size, best)))
            best = way;
    return best;
}

/* Ends a back-off, because its reason may no longer hold. After RULE_SLOWER, compares the fastest
 * known strategy again, if there is one. Otherwise discards the estimates. */
static void end_back_off(const struct choice *c) {
    const bool was_slower = c->size->rule == RULE_SLOWER;
    c->size->phase = PHASE_SAVING;
    const enum way again = was_slower ? fastest_known(c) : WAY_SEQUENTIAL;
    if (again != WAY_SEQUENTIAL) {
        redcc_compare(c->size, again, WAY_SEQUENTIAL);
        return;
    }
    c->size->looked = false;
    for (enum way way = 0; way < WAY_COUNT; way++)
        c->size->arm[way] = (struct arm){.learned = c->size->arm[way].learned};
}

static bool is_backing_off(const struct size_state *size) {
    return (size->phase == PHASE_SHORT || size->phase == PHASE_BACK_OFF) &&
           size->calls < size->back_off.until;
}

static struct decision during_back_off(const struct size_state *size) {
    return (struct decision){
        .action = ACTION_SEQUENTIAL, .timed = size->phase == PHASE_BACK_OFF, .rule = size->rule};
}

static bool is_short(const struct choice *c) {
    return usual_of(c) < LEARN_WAKES * c->now->wake;
}

static struct decision decide(const struct choice *c) {
    if (c->size->sequential.count == 0)
        return tries_first(c) ? try_first(c) : sequentially(c, RULE_FIRST);
    if (c->size->phase == PHASE_SHORT && c->size->calls == c->size->back_off.until) {
        c->size->phase = PHASE_SAVING;
        return sequentially(c, RULE_SHORT);
    }
    if (c->size->phase == PHASE_BACK_OFF)
        end_back_off(c);
    if (c->size->phase == PHASE_SAVING && is_short(c)) {
        redcc_wait_for(&c->size->back_off, c->size->calls, redcc_longer(c->size->back_off.length));
        c->size->phase = PHASE_SHORT;
        return sequentially(c, RULE_SHORT);
    }
    return c->size->phase == PHASE_COMPARING  ? decide_comparing(c)
           : c->size->phase == PHASE_PARALLEL ? decide_parallel(c)
                                              : decide_saving(c);
}

/* ---- the interface --------------------------------------------------------------------------- */

static struct size_state *size_of(struct choice_state *state, long long trip) {
    return (struct size_state *)redcc_size_of(state, trip);
}

bool redcc_is_left_alone(struct choice_state *state, long long trip, int threads,
                         struct decision *decision) {
    assert(threads >= 1);
    struct size_state *size = size_of(state, trip);
    if (!is_backing_off(size) || size->threads != threads ||
        size->calls + 2 >= size->back_off.until)
        return false;
    size->calls++;
    *decision = during_back_off(size);
    return true;
}

/* Counts the call and decides. If the number of threads has changed, first resets the state at trip
 * counts of this size. */
static struct decision take_call(const struct choice *c) {
    if (c->size->threads > 0 && c->size->threads != c->now->threads)
        *c->size = (struct size_state){0};
    c->size->threads = c->now->threads;
    c->size->steady = c->now->steady > 0 ? c->now->steady : 0;
    c->size->calls++;
    return is_backing_off(c->size) ? during_back_off(c->size) : decide(c);
}

struct decision redcc_decide(struct choice_state *state, const struct situation *now) {
    assert(now->trip >= 0 && now->threads >= 1);
    return take_call(&(struct choice){&state->ledger, size_of(state, now->trip), now});
}

enum reach redcc_reach(const struct choice_state *state, const struct situation *now) {
    /* on copies, because nothing is decided yet */
    struct size_state size = *redcc_size_of(state, now->trip);
    struct ledger ledger = state->ledger;
    const bool as_before = size.threads == 0 || size.threads == now->threads;
    if (size.sequential.count > 0 &&
        (size.phase != PHASE_SAVING || size.set_ups.begun > 0 || !as_before))
        return REACH_TEAM;
    const struct decision decision = take_call(&(struct choice){&ledger, &size, now});
    return decision.action == ACTION_SEQUENTIAL ? REACH_NOTHING
           : decision.alone                     ? REACH_LOOK
                                                : REACH_TEAM;
}

/* Are all possible plans expected to be slower than strategy `than`, even without the cost of their
 * construction? */
static bool no_plan_is_faster(const struct choice *c, enum way than) {
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++)
        if (c->size->arm[way].possible &&
            redcc_expected(c->size, way) < redcc_expected(c->size, than))
            return false;
    return true;
}

void redcc_note_arms(struct choice_state *state, long long trip, const struct arm *arm,
                     double spent) {
    assert(trip >= 0);
    struct size_state *size = size_of(state, trip);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        struct arm *known = &size->arm[way], before = *known;
        *known = arm[way];
        known->learned = before.learned;
        known->ruled_out = before.ruled_out;
        known->possible = arm[way].possible && !before.ruled_out;
        known->timed = before.timed;
    }
    size->looked = true;
    size->look = spent;
    size->looked_at = redcc_usual(size);
}

struct decision redcc_pick_way(struct choice_state *state, const struct situation *now,
                               const struct arm *arm, double spent) {
    assert(spent >= 0);
    struct size_state *size = size_of(state, now->trip);
    struct situation here = *now;
    here.spent = spent;
    redcc_note_arms(state, now->trip, arm, spent);
    const double current =
        size->phase == PHASE_PARALLEL ? redcc_expected(size, size->way) : redcc_usual(size);
    const struct choice c = {&state->ledger, size, &here};
    const bool may_be_direct = size->phase == PHASE_SAVING && goes_without_plan(&c) &&
                               size->arm[WAY_DIRECT].possible && is_clear(&c, WAY_DIRECT);
    if (may_be_direct && here.tiled && no_plan_is_faster(&c, WAY_DIRECT))
        return reuse(&c, WAY_DIRECT, RULE_COMPARING);
    const struct decision decision = set_up(&c, current);
    const bool is_direct = decision.action != ACTION_INSPECT && may_be_direct;
    return is_direct ? reuse(&c, WAY_DIRECT, RULE_COMPARING) : decision;
}
