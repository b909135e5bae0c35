/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/choose.h"

/* Measured or reckoned; docs/methods.md says how. */
enum { SMALL_TRIP = 4096, GRAPH_REST = 1024 };
static const double least_seconds = 10e-6; /* a region and its barriers take 2 to 10 microseconds */
static const double least_alone = 100e-6;  /* of one thread: half of it is saved by a second */
static const double even_share = 1.1;      /* of an equal share of the iterations */
static const double most_share = 0.85;     /* of the iterations, executed by one thread */
static const double most_spared = 0.015;   /* of the iterations; spare parts save 2 to 20 % */
/* Seconds: where the iterations of a spare part do not lie together, the subscripts of its
 * neighbours are read with its own, which takes some 10 ns. */
static const double long_iteration = 100e-9;
static const double least_part = 100e-6; /* seconds that say how company slows a thread down */
static const double clearly = 0.75;      /* of the sequential loop, where that is only reckoned */
static const double slack = 1.05;
static const double sweep_touch = 10e-9; /* seconds that inspecting takes for a touch */
static const double frequent = 0.25;     /* runs, of the iterations */
static const double least_costly = 1e-3; /* seconds; what takes less is not put off */
static const double much = 0.5;          /* of the sequential loop's time */
/* Seconds: a touch that is executed once more, a run, a byte of a copy that is filled and brought
 * in, and one that the system has to find a page for as well. */
static const double touch_again = 4e-9, run_begun = 3e-9, byte_copied = 0.15e-9,
                    new_byte_copied = 0.6e-9;

/* The first parallel execution is not counted: threads start, a plan is made, pages are touched. */
enum { PARALLEL_TRIES = 3, PACES = 4, SLOW_IN_TURN = 16 };

/* Of the access graph and of what there was before, in turn: the first is not counted either. */
enum { GRAPH_TRIES = 4, RIVAL_TRIES = 3 };

static int size_of(redcc_int trip) {
    return 63 - __builtin_clzll((unsigned long long)trip | 1);
}

static double shorter(double before, double now) {
    return before > 0 && before < now ? before : now;
}

static struct trial *trial_of(struct chooser *chooser, redcc_int trip) {
    return &chooser->trial[size_of(trip)];
}

enum rule redcc_choose_rule(const struct chooser *chooser, redcc_int trip) {
    return chooser->trial[size_of(trip)].rule;
}

static void rest(struct trial *trial, enum reason reason, long first, long factor, long most) {
    trial->rest = trial->rest ? trial->rest * factor : first;
    trial->rest = trial->rest > most ? most : trial->rest;
    trial->doubted = false;
    trial->decided = COURSE_SERIAL;
    trial->reason = reason;
    trial->retry_at = trial->calls + trial->rest;
}

/* Its retry, of so many executions that take so much longer, is to cost no more than a hundredth of
 * the rest before: who lost by little, or because the machine was busy, may soon win. */
static long rest_after_loss(int tries, double longer, long most) {
    const double calls = 100 * tries * (longer - 1);
    return calls < 16 ? 16 : calls > (double)most ? most : (long)calls;
}

static void try_again(struct trial *trial) {
    trial->decided = COURSE_UNDECIDED;
    trial->serial_tries = trial->parallel_tries = trial->slow = 0;
    trial->doubted = false;
    trial->pace = (struct pace_trial){0};
}

/* After the first parallel execution, as long as the part was timed in each: twice either way,
 * since something else may run meanwhile. */
static enum pace next_pace(const struct trial *trial) {
    const int timed = trial->pace.timed;
    if (trial->serial_best > 0 || trial->pace.given_up || timed == PACES ||
        timed != trial->parallel_tries - 1)
        return PACE_UNTIMED;
    return timed % 2 == 0 ? PACE_ALONE : PACE_BESIDE;
}

static int serial_tries_needed(redcc_int trip) {
    return trip < SMALL_TRIP ? 2 : 1;
}

/* Is it the turn of owners cut from the access graph? */
static bool graph_turn(struct trial *trial, double budget) {
    if (trial->graph.state == GRAPH_LOST && trial->calls >= trial->graph.retry_at)
        trial->graph.state = GRAPH_UNTRIED;
    if (trial->graph.state == GRAPH_UNTRIED && trial->graph.seconds > 0 &&
        trial->decided != COURSE_UNDECIDED && trial->serial_best > 0 &&
        budget >= trial->graph.seconds) {
        trial->graph.state = GRAPH_TRIED;
        trial->graph.tries = trial->graph.rival_tries = 0;
    }
    const bool rivals_turn = trial->graph.rival_tries < trial->graph.tries - 1;
    return trial->graph.state == GRAPH_KEPT || (trial->graph.state == GRAPH_TRIED && !rivals_turn);
}

/* What there was before the access graph, timed beside it. */
static struct choice choose_rival(const struct trial *trial) {
    return (struct choice){.course =
                               trial->decided == COURSE_SERIAL ? COURSE_SOLO : COURSE_PARALLEL};
}

static struct choice choose_plainly(struct trial *trial, redcc_int trip, double budget) {
    long rested = 0;
    if (trial->decided == COURSE_SERIAL) {
        const bool affordable = trial->sweep_seconds > 0 && budget >= trial->sweep_seconds;
        if (trial->calls < trial->retry_at && !affordable)
            return (struct choice){.course = COURSE_SERIAL, .reason = trial->reason};
        rested = trial->calls - (trial->retry_at - trial->rest);
        try_again(trial);
    }
    if (trial->decided == COURSE_PARALLEL)
        return (struct choice){.course = COURSE_PARALLEL};
    if (trip < SMALL_TRIP && trial->calls == 1) { /* once is no reason to wake threads */
        trial->rule = RULE_SMALL_FIRST;
        return (struct choice){.course = COURSE_SERIAL, .reason = REASON_LITTLE_WORK};
    }
    const bool enough = trial->serial_tries >= serial_tries_needed(trip);
    const bool small_first = trip < SMALL_TRIP && trial->serial_tries == 0;
    const enum pace pace = next_pace(trial);
    if (small_first ||
        (trial->parallel_tries >= PARALLEL_TRIES - 1 && !enough && pace == PACE_UNTIMED)) {
        trial->rule = trip < SMALL_TRIP ? RULE_SMALL : RULE_FASTER;
        return (struct choice){.course = COURSE_SOLO};
    }
    return (struct choice){.course = COURSE_PARALLEL, .rested = rested, .pace = pace};
}

bool redcc_choose_rests(struct chooser *chooser, redcc_int trip, int threads,
                        struct choice *choice) {
    struct trial *trial = trial_of(chooser, trip);
    const bool asks_budget = trial->sweep_seconds > 0 || trial->graph.seconds > 0 ||
                             trial->graph.state == GRAPH_TRIED || trial->graph.state == GRAPH_KEPT;
    if (trial->threads != threads || trial->decided != COURSE_SERIAL || asks_budget ||
        trial->calls + 1 >= trial->retry_at)
        return false;
    trial->calls++;
    *choice = (struct choice){COURSE_SERIAL, .reason = trial->reason, .rule = trial->rule};
    return true;
}

struct choice redcc_choose_course(struct chooser *chooser, redcc_int trip, int threads,
                                  double budget) {
    struct trial *trial = trial_of(chooser, trip);
    if (trial->threads != threads)
        *trial = (struct trial){.threads = threads};
    trial->calls++;
    struct choice choice = {.course = COURSE_PARALLEL, .by_graph = true};
    if (trial->doubted)
        choice =
            (struct choice){.course = COURSE_SOLO, .by_graph = trial->graph.state == GRAPH_KEPT};
    else if (!graph_turn(trial, budget))
        choice = trial->graph.state == GRAPH_TRIED ? choose_rival(trial)
                                                   : choose_plainly(trial, trip, budget);
    if (trial->graph.state == GRAPH_KEPT) {
        choice.graph_settled = trial->graph.tries > 0;
        trial->graph.tries = 0;
    }
    choice.rule = trial->rule;
    return choice;
}

static void learn_serial(struct trial *trial, redcc_int trip, double seconds) {
    const double each = seconds / (double)trip;
    if (trial->serial_tries++ == 0 || each < trial->serial_best)
        trial->serial_best = each;
    trial->sweep_seconds = 0;
    if (trip < SMALL_TRIP && seconds < least_seconds)
        rest(trial, REASON_LITTLE_WORK, 256, 4, 1 << 20);
}

void redcc_choose_learn_pace(struct chooser *chooser, redcc_int trip, enum pace pace, double part,
                             double working) {
    struct trial *trial = trial_of(chooser, trip);
    struct pace_trial *it = &trial->pace;
    if (pace == PACE_BESIDE) {
        it->beside = shorter(it->beside, part);
        it->working = shorter(it->working, working);
    } else {
        it->alone = shorter(it->alone, part);
    }
    it->given_up = it->given_up || part < least_part;
    if (++it->timed < PACES || it->given_up)
        return;
    const double serial = it->working * it->alone / it->beside / (double)trip;
    it->given_up = trial->parallel_best > clearly * serial;
    if (it->given_up)
        return;
    trial->serial_best = serial;
    trial->serial_tries = serial_tries_needed(trip);
}

/* Counts executions in turn that took longer than the sequential loop did; at the sixteenth it is
 * timed again: that one may take longer now, too. */
static void watch(struct trial *trial, double each) {
    const bool slow = each > trial->serial_best * slack;
    trial->slow_best = slow && trial->slow > 0 ? shorter(trial->slow_best, each) : each;
    trial->slow = slow ? trial->slow + 1 : 0;
    trial->doubted = trial->slow == SLOW_IN_TURN;
}

/* It is timed. If it is the faster one, all is open again. */
static void settle_doubt(struct trial *trial, double each) {
    trial->doubted = false;
    trial->slow = 0;
    trial->serial_best = each;
    if (trial->slow_best <= each)
        return;
    try_again(trial);
    trial->graph.state = GRAPH_UNTRIED;
    trial->rule = RULE_SLOWER;
}

static void learn_parallel(struct trial *trial, redcc_int trip, double each) {
    if (trial->decided == COURSE_PARALLEL) {
        watch(trial, each);
        return;
    }
    const int before = trial->parallel_tries++;
    if (before == 1 || (before > 1 && each < trial->parallel_best))
        trial->parallel_best = each;
    if (trial->parallel_tries < PARALLEL_TRIES || trial->serial_tries < serial_tries_needed(trip))
        return;
    trial->rule = RULE_FASTER;
    if (trial->parallel_best < trial->serial_best)
        trial->decided = COURSE_PARALLEL;
    else
        rest(trial, REASON_SERIAL_FASTER,
             rest_after_loss(PARALLEL_TRIES, trial->parallel_best / trial->serial_best, 256), 4,
             1 << 20);
}

bool redcc_choose_spares(const struct chooser *chooser, redcc_int trip, int threads,
                         const struct estimate *found) {
    const struct trial *trial = &chooser->trial[size_of(trip)];
    if (found->spared > most_spared || found->share * threads > even_share)
        return false;
    return found->changes < frequent || trial->serial_best >= long_iteration;
}

static void lose_graph(struct trial *trial, long rest) {
    trial->graph.state = GRAPH_LOST;
    trial->graph.retry_at = trial->calls + rest;
    trial->rule = RULE_GRAPH_LOST;
}

static void compare_with_rival(struct trial *trial) {
    if (trial->graph.tries < GRAPH_TRIES || trial->graph.rival_tries < RIVAL_TRIES)
        return;
    if (trial->graph.best < trial->graph.rival_best) {
        trial->graph.state = GRAPH_KEPT;
        trial->rule = RULE_GRAPH_KEPT;
    } else {
        lose_graph(trial, rest_after_loss(GRAPH_TRIES, trial->graph.best / trial->graph.rival_best,
                                          GRAPH_REST));
    }
}

static void learn_rival(struct trial *trial, double each) {
    trial->graph.rival_best =
        trial->graph.rival_tries++ == 0 ? each : shorter(trial->graph.rival_best, each);
    compare_with_rival(trial);
}

static void learn_graph(struct trial *trial, redcc_int trip, double seconds) {
    const double each = seconds / (double)trip;
    trial->graph.runs++;
    if (trial->graph.state == GRAPH_KEPT) {
        watch(trial, each);
        return;
    }
    const int before = trial->graph.tries++;
    if (before == 0 && trial->graph.best == 0) { /* what the inspection takes, if done again */
        const double longer = seconds - trial->serial_best * (double)trip / trial->threads;
        trial->graph.seconds = longer > 0 ? longer : trial->graph.seconds;
    } else if (before > 0) {
        trial->graph.best = before == 1 ? each : shorter(trial->graph.best, each);
    }
    compare_with_rival(trial);
}

double redcc_choose_learn(struct chooser *chooser, redcc_int trip, enum course course,
                          bool by_graph, double seconds) {
    struct trial *trial = trial_of(chooser, trip);
    if (trial->doubted)
        settle_doubt(trial, seconds / (double)trip);
    else if (trial->graph.state == GRAPH_TRIED && !by_graph)
        learn_rival(trial, seconds / (double)trip);
    else if (course == COURSE_SOLO)
        learn_serial(trial, trip, seconds);
    else if (by_graph)
        learn_graph(trial, trip, seconds);
    else
        learn_parallel(trial, trip, seconds / (double)trip);
    const bool known = course == COURSE_PARALLEL && trial->serial_best > 0;
    return known ? trial->serial_best * (double)trip - seconds : 0;
}

void redcc_choose_refused(struct chooser *chooser, redcc_int trip, enum reason reason) {
    struct trial *trial = trial_of(chooser, trip);
    if (reason == REASON_NO_MEMORY && trial->graph.state == GRAPH_TRIED) {
        lose_graph(trial, GRAPH_REST); /* what there was before may do with less */
    } else if (reason == REASON_REPLICATION || reason == REASON_COSTLY) {
        rest(trial, reason, 16, 4, 1 << 20);
    } else { /* may be otherwise for the next call's arrays */
        rest(trial, reason, 2, 2, 64);
        trial->rule = RULE_RESTING;
    }
}

void redcc_choose_no_graph(struct chooser *chooser, redcc_int trip) {
    struct trial *trial = trial_of(chooser, trip);
    lose_graph(trial, GRAPH_REST);
    trial->graph.seconds = 0;
}

void redcc_choose_levels(struct chooser *chooser, redcc_int trip) {
    trial_of(chooser, trip)->rule = RULE_LEVELS;
}

/* A thread's share of a copy's cost is the whole of one copy: it fills its own, and brings in its
 * part of all. */
static bool copies_are_cheaper(const struct findings *findings) {
    if (!findings->copies)
        return false;
    const double again = findings->share - 1.0 / findings->threads;
    const double by_owners =
        again * findings->touches * touch_again + findings->runs / findings->threads * run_begun;
    return by_owners > findings->copied * (findings->reusable ? byte_copied : new_byte_copied);
}

/* To tell owners apart is dear where every iteration has another one than the last: is it put off?
 * RULE_NONE: it is not. */
static enum rule put_off(const struct trial *trial, const struct findings *findings,
                         double sweep_seconds) {
    const double trip = (double)findings->trip;
    if (findings->swept || findings->runs < frequent * trip || sweep_seconds < least_costly ||
        findings->budget >= sweep_seconds)
        return RULE_NONE;
    if (trial->serial_best == 0)
        return RULE_TIMED;
    return sweep_seconds > much * trial->serial_best * trip ? RULE_COSTLY : RULE_NONE;
}

/* Without telling owners apart, now or at all. RULE_NONE: that is worth it. */
static enum rule undivided_way(const struct trial *trial, const struct findings *findings,
                               double sweep_seconds) {
    return copies_are_cheaper(findings) ? RULE_CHEAP_COPIES
                                        : put_off(trial, findings, sweep_seconds);
}

/* By the index cut, or serially. */
static enum rule plain_way(const struct findings *findings, double sweep_seconds) {
    if (findings->share <= most_share)
        return RULE_INDEX;
    if (findings->copies)
        return RULE_COPIES;
    return findings->swept || findings->budget >= sweep_seconds ? RULE_SERIAL : RULE_DEFERRED;
}

/* A graph was cut before, and other subscripts have come before it has paid: then it rests, longer
 * each time. */
static bool cut_in_vain(struct trial *trial, redcc_int trip) {
    if (trial->graph.runs == 0)
        return false;
    const double best = trial->graph.best > 0 ? trial->graph.best : trial->serial_best / 2;
    const double saved = (double)trial->graph.runs * (double)trip * (trial->serial_best - best);
    trial->graph.runs = 0;
    if (saved >= trial->graph.seconds) {
        trial->graph.rest = 0;
        return false;
    }
    trial->graph.rest = trial->graph.rest ? trial->graph.rest * 4 : 16;
    trial->graph.state = GRAPH_LOST;
    trial->graph.retry_at = trial->calls + trial->graph.rest;
    return true;
}

enum rule redcc_choose_way(struct chooser *chooser, const struct findings *findings) {
    struct trial *trial = trial_of(chooser, findings->trip);
    const double sweep_seconds = findings->touches * sweep_touch;
    const enum rule undivided = undivided_way(trial, findings, sweep_seconds);
    if (findings->share * findings->threads <= even_share) {
        trial->rule = undivided == RULE_NONE ? RULE_EVEN : undivided;
        if (findings->swept || trial->rule == RULE_CHEAP_COPIES)
            trial->graph.state = GRAPH_UNTRIED;
        trial->graph.seconds = 0;
        trial->sweep_seconds = trial->rule == RULE_COSTLY ? sweep_seconds : 0;
        return trial->rule;
    }
    if (!findings->reusable) {
        trial->graph.seconds = 0;
        trial->graph.state = GRAPH_UNTRIED;
    } else if (trial->graph.seconds == 0 && trial->graph.state != GRAPH_LOST)
        trial->graph.seconds = findings->touches * redcc_graph_touch;
    if (findings->by_graph && findings->reusable && trial->graph.state != GRAPH_LOST &&
        !cut_in_vain(trial, findings->trip)) {
        if (findings->budget >= trial->graph.seconds)
            return trial->rule = RULE_GRAPH;
        trial->graph.state = GRAPH_UNTRIED; /* when the budget allows it */
    }
    trial->rule = undivided == RULE_NONE ? plain_way(findings, sweep_seconds) : undivided;
    const bool deferred = trial->rule == RULE_DEFERRED || trial->rule == RULE_COSTLY;
    trial->sweep_seconds = deferred ? sweep_seconds : 0;
    return trial->rule;
}

int redcc_worth_threads(redcc_int trip, int threads, double seconds, redcc_int iterations) {
    const double each = iterations > 0 ? seconds / (double)iterations : 0;
    return trip < SMALL_TRIP && each * (double)trip < least_alone ? 1 : threads;
}
