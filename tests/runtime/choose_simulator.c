/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose_simulator.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { THREADS = 2, PLANS = 4 };

/* A kept plan. A new one replaces the least recently used one. */
struct kept_plan {
    enum way way; /* WAY_SEQUENTIAL if the entry is unused */
    int subscripts;
    long long trip;
    int used;
};

struct simulation {
    const struct trace *trace;
    struct choice_state *state;
    struct kept_plan plan[PLANS];
    int clock;
    int steady;
    int met[PLANS];   /* subscripts of the last calls, latest first, or -1 */
    bool started;     /* the threads were started */
    double excess;    /* twice the largest excess of an execution over the sequential one, plus a
                         block, in seconds */
    double overdraft; /* the largest overdraft, seconds */
    double longest;   /* the longest sequential execution, seconds */
    double told;      /* seconds reported to the decision code, all of which are in its ledger */
    struct simulated so_far;
};

static struct kept_plan *find_plan(struct simulation *it, enum way way, long long trip) {
    for (int p = 0; p < PLANS; p++)
        if (it->plan[p].way == way && it->plan[p].trip == trip)
            return &it->plan[p];
    return NULL;
}

static void keep_plan(struct simulation *it, struct kept_plan plan) {
    struct kept_plan *place = find_plan(it, plan.way, plan.trip);
    for (int p = 0; p < PLANS && !place; p++)
        if (it->plan[p].way == WAY_SEQUENTIAL)
            place = &it->plan[p];
    if (!place)
        place = it->plan;
    for (int p = 0; p < PLANS && place->way != plan.way; p++)
        if (it->plan[p].used < place->used)
            place = &it->plan[p];
    *place = plan;
    place->used = ++it->clock;
}

static bool note_met(struct simulation *it, int subscripts) {
    int at = 0;
    while (at < PLANS - 1 && it->met[at] != subscripts)
        at++;
    const bool met = it->met[at] == subscripts;
    memmove(it->met + 1, it->met, (size_t)at * sizeof *it->met);
    it->met[0] = subscripts;
    return met;
}

static double start_left(const struct simulation *it) {
    return it->started ? 0 : it->trace->start;
}

static struct situation situation_of(struct simulation *it, const struct simulated_call *call) {
    const bool hidden = it->trace->hidden, same = call->subscripts == it->met[0];
    const bool met = note_met(it, call->subscripts);
    it->steady = hidden || met ? it->steady + 1 : 0;
    struct situation now = {.trip = call->trip,
                            .threads = THREADS,
                            .wake = it->trace->wake,
                            .start = start_left(it),
                            .dry_run = it->trace->dry_run > 0,
                            .steady = it->steady,
                            .verified = it->trace->compared && same};
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        const struct kept_plan *plan = find_plan(it, way, call->trip);
        const bool fits = plan && (plan->subscripts == call->subscripts || hidden);
        now.kept[way] = fits ? KEPT_FITS : plan ? KEPT_CHANGED : KEPT_NONE;
    }
    now.kept[WAY_BINS] = it->trace->possible[WAY_BINS] ? KEPT_FITS : KEPT_NONE;
    now.kept[WAY_DIRECT] = it->trace->possible[WAY_DIRECT] ? KEPT_FITS : KEPT_NONE;
    return now;
}

static void tell(struct simulation *it, struct outcome outcome) {
    const struct ledger *ledger = &it->state->ledger;
    it->so_far.total += outcome.seconds + outcome.set_up;
    it->told += outcome.seconds + outcome.set_up;
    redcc_observe(it->state, &outcome);
    if (fabs(ledger->sequential + ledger->overhead - it->told) > 1e-9 * it->told)
        fail_msg("the ledger holds %g seconds of %g", ledger->sequential + ledger->overhead,
                 it->told);
}

static struct outcome outcome_of(enum result result, enum way way,
                                 const struct simulated_call *call, double seconds) {
    return (struct outcome){.result = result, .way = way, .trip = call->trip, .seconds = seconds};
}

static void run_sequentially(struct simulation *it, const struct simulated_call *call, bool timed) {
    if (timed)
        tell(it, outcome_of(RESULT_SEQUENTIAL, WAY_SEQUENTIAL, call, call->sequential));
    else
        it->so_far.total += call->sequential;
}

/* Simulates a trial of binning: a round of a 16th of the loop, and as many sequential iterations.
 * Then each round is as long as all earlier ones together, or shorter, so that the loss stays
 * within may_lose. */
static void try_bins(struct simulation *it, const struct simulated_call *call, double may_lose) {
    const double more = call->execution[WAY_BINS] - call->sequential, start = start_left(it);
    const double least = 1.0 / 16;
    double done = 2 * least, binned = least;
    while (done < 1 && binned * more <= may_lose) {
        const double left = more > 0 ? may_lose / more - binned : 1;
        double next = done < left ? done : left;
        next = next > least ? next : least;
        next = next < 1 - done ? next : 1 - done;
        binned += next;
        done += next;
    }
    const enum result result = done < 1 ? RESULT_LEFT : RESULT_PARALLEL;
    const double seconds = call->sequential + binned * more + start;
    it->started = true;
    it->so_far.parallel += result == RESULT_PARALLEL;
    it->so_far.left += result == RESULT_LEFT;
    struct outcome outcome = outcome_of(result, WAY_BINS, call, seconds);
    outcome.usual = call->sequential / (double)call->trip;
    tell(it, outcome);
}

static bool is_refused(const struct simulation *it, const struct simulated_call *call) {
    return it->trace->refused_from > 0 && call - it->trace->call >= it->trace->refused_from;
}

static void refuse(struct simulation *it, const struct simulated_call *call) {
    it->so_far.refused++;
    tell(it, outcome_of(RESULT_REFUSED, WAY_BINS, call, it->trace->refusal));
    run_sequentially(it, call, true);
}

static void run_by_plan(struct simulation *it, const struct simulated_call *call, enum way way) {
    struct kept_plan *plan = !redcc_is_planned(way) ? NULL : find_plan(it, way, call->trip);
    if (!plan || plan->subscripts == call->subscripts) {
        if (plan)
            plan->used = ++it->clock;
        it->so_far.parallel++;
        const double seconds = call->execution[way] + start_left(it);
        it->started = true;
        tell(it, outcome_of(RESULT_PARALLEL, way, call, seconds));
        return;
    }
    plan->way = WAY_SEQUENTIAL;
    it->steady = 0;
    tell(it, outcome_of(RESULT_CHANGED, way, call, it->trace->check * call->sequential));
    run_sequentially(it, call, true);
}

/* Simulates a plan construction. spent: seconds that the inspection has taken so far. */
static void make_plan(struct simulation *it, const struct simulated_call *call, enum way way,
                      double spent, double deadline) {
    const struct trace *trace = it->trace;
    const double rest = trace->set_up[way] * (double)call->trip;
    const double set_up = spent + rest + trace->overrun;
    it->so_far.set_ups++;
    if (rest > deadline) {
        it->so_far.stopped++;
        struct outcome stopped =
            outcome_of(RESULT_STOPPED, way, call, spent + deadline + trace->block);
        stopped.done = deadline / rest;
        tell(it, stopped);
        run_sequentially(it, call, true);
        return;
    }
    it->so_far.parallel++;
    keep_plan(it, (struct kept_plan){way, call->subscripts, call->trip, 0});
    struct outcome made = outcome_of(RESULT_PARALLEL, way, call, call->execution[way]);
    made.set_up = set_up;
    tell(it, made);
}

static void note_loan(struct simulation *it, const struct simulated_call *call) {
    it->overdraft = fmax(it->overdraft, it->state->ledger.overdraft);
    it->longest = fmax(it->longest, call->sequential);
}

static void end_look(struct simulation *it, const struct simulated_call *call, double spent) {
    tell(it, outcome_of(RESULT_UNATTRACTIVE, WAY_SEQUENTIAL, call, spent));
    run_sequentially(it, call, true);
}

static void inspect(struct simulation *it, const struct simulated_call *call,
                    const struct situation *now, struct decision entry) {
    const struct trace *trace = it->trace;
    struct arm arm[WAY_COUNT] = {{0}};
    const double team = entry.alone || it->started ? 0 : trace->start + trace->late;
    const double dry_run = trace->dry_run * (double)call->trip;
    const double spent = dry_run + trace->look + team;
    struct situation there = *now;
    there.dried = dry_run;
    there.awaited = team;
    if (!entry.alone) {
        it->started = true;
        there.start = 0;
    }
    if (dry_run > 0 && dry_run > entry.deadline) {
        it->so_far.stopped++;
        struct outcome stopped =
            outcome_of(RESULT_STOPPED, entry.way, call, team + entry.deadline / 16 + trace->block);
        stopped.done = entry.deadline / 16 / dry_run;
        tell(it, stopped);
        run_sequentially(it, call, true);
        return;
    }
    if (trace->no_inspection) {
        it->so_far.looks++;
        tell(it, outcome_of(RESULT_REFUSED, WAY_SEQUENTIAL, call, spent));
        run_sequentially(it, call, true);
        return;
    }
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        const double trip = (double)call->trip;
        arm[way].possible = trace->possible[way];
        arm[way].set_up = spent + trace->set_up[way] * trip * trace->set_up_error;
        arm[way].execution = call->execution[way] / trip * trace->execution_error;
    }
    if (trace->guessed) {
        arm[WAY_BINS].guessed = true;
        arm[WAY_BINS].execution = 0.55 * call->sequential / (double)call->trip;
    }
    if (entry.alone) {
        it->so_far.looks++;
        redcc_note_arms(it->state, call->trip, arm, spent);
        end_look(it, call, spent);
        return;
    }
    const struct decision decision = redcc_pick_way(it->state, &there, arm, spent);
    note_loan(it, call);
    if (decision.action == ACTION_INSPECT)
        make_plan(it, call, decision.way, spent, decision.deadline);
    else
        end_look(it, call, spent);
}

/* Returns the answer of redcc_reach without knowledge of kept plans, with half of the time to start
 * threads as the lower bound. */
static enum reach reach_of(const struct simulation *it, struct situation now) {
    now.start /= 2;
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++)
        now.kept[way] = KEPT_NONE;
    return redcc_reach(it->state, &now);
}

static struct decision decide(struct simulation *it, const struct situation *now) {
    const enum reach reach = reach_of(it, *now);
    const struct decision decision = redcc_decide(it->state, now);
    it->so_far.left_alone += reach == REACH_NOTHING;
    if (decision.action != ACTION_SEQUENTIAL && reach == REACH_NOTHING)
        fail_msg("begun, though nothing was within reach");
    if (decision.action != ACTION_SEQUENTIAL && !decision.alone && reach == REACH_LOOK)
        fail_msg("by threads, though only a look was within reach");
    return decision;
}

static void carry_out(struct simulation *it, const struct simulated_call *call) {
    const struct situation now = situation_of(it, call);
    const struct decision decision = decide(it, &now);
    note_loan(it, call);
    switch (decision.action) {
    case ACTION_SEQUENTIAL:
        run_sequentially(it, call, decision.timed);
        break;
    case ACTION_INSPECT:
        inspect(it, call, &now, decision);
        break;
    case ACTION_REUSE:
        if (decision.way == WAY_BINS && is_refused(it, call))
            refuse(it, call);
        else if (decision.may_lose > 0)
            try_bins(it, call, decision.may_lose);
        else
            run_by_plan(it, call, decision.way);
        break;
    }
}

/* Raises the allowance to the time that this execution, or the check of a plan, takes beyond the
 * sequential execution. */
static void widen_allowance(struct simulation *it, const struct simulated_call *call) {
    double most = fmax(it->trace->check * call->sequential, it->trace->refusal);
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (it->trace->possible[way] && call->execution[way] - call->sequential > most)
            most = call->execution[way] - call->sequential;
    const double late = fmax(it->trace->block, it->trace->look) + it->trace->late;
    it->excess = fmax(it->excess, 2 * most + late);
}

static double best_in_hindsight(const struct trace *trace, double sequential) {
    double best = sequential;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++) {
        double total = 0;
        for (int c = 0; c < trace->count; c++) {
            const struct simulated_call *call = &trace->call[c], *before = call - 1;
            total += call->execution[way];
            if (c == 0 || before->subscripts != call->subscripts || before->trip != call->trip)
                total += (trace->set_up[way] + trace->dry_run) * (double)call->trip;
        }
        if (trace->possible[way] && total < best)
            best = total;
    }
    return best;
}

struct simulated simulate(const struct trace *trace) {
    struct simulation it = {
        .trace = trace, .state = calloc(1, sizeof *it.state), .met = {-1, -1, -1, -1}};
    struct simulated *result = &it.so_far;
    for (int c = 0; c < trace->count; c++) {
        result->sequential += trace->call[c].sequential;
        widen_allowance(&it, &trace->call[c]);
        carry_out(&it, &trace->call[c]);
        result->slowest = fmax(result->slowest, result->total / result->sequential);
        result->allowance = it.excess + it.overdraft;
        result->overdraft = it.overdraft / it.longest;
        const double ratio = (result->total - result->allowance) / result->sequential;
        if (ratio > result->worst_prefix)
            result->worst_prefix = ratio;
    }
    result->owed = it.state->ledger.overdraft;
    result->best = best_in_hindsight(trace, result->sequential);
    free(it.state);
    return *result;
}
