/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "team.h"

#include <assert.h>

#include "base/clock.h"

#ifdef _OPENMP
#include <omp.h>
#endif

/* share: the fraction of the time that trials may cost. margin: a trial ends when it takes more
 * than this times the expected time. gain: the number of threads of a trial is adopted if the trial
 * takes less than this times the expected time. */
static const double share = 0.02, margin = 1.5, gain = 0.97;
/* Weight of a new round in the exponential moving averages. */
static const double weight = 0.3;
/* Trials of fewer threads become rarer while they fail: each failure doubles what the next one is
 * charged, at most MOST_DOUBLINGS times. When such a trial is urgent, rounds have become slower. */
enum { MOST_DOUBLINGS = 2 };
/* Number of rounds before the first trial: the first rounds also allocate memory and inspect
 * loops. */
enum { SETTLED = 3 };
/* Probe for busy cores: PROBES parallel regions of PROBE_WORK operations, about 50 us each. Cores
 * count as busy if the probe takes more than `delay` times the expected time. */
enum { PROBES = 40, PROBE_WORK = 8000 };
static const double delay = 1.5;

static void set_threads(int threads) {
#ifdef _OPENMP
    omp_set_num_threads(threads);
#else
    (void)threads;
#endif
}

static int most_threads(void) {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

/* Does arithmetic that compilers cannot remove. Returns the seconds that it took. */
static double work(volatile double *sink) {
    const double start = clock_seconds();
    double x = 1;
    for (int k = 0; k < PROBE_WORK; k++)
        x = 0.5 * (x + 2 / x);
    *sink = x;
    return clock_seconds() - start;
}

/* Do threads often lose their core? Compares many short parallel regions with the same work in one
 * thread. */
static int is_busy(void) {
    volatile double sink;
    double least = work(&sink), start = 0, seconds = 0;
    for (int k = 0; k <= PROBES && seconds <= delay * (double)(2 * PROBES) * least; k++) {
        if (k == 1) /* the clock starts after the first region, which starts the threads */
            start = clock_seconds();
#pragma omp parallel
        {
            volatile double own;
            work(&own);
        }
        const double between = work(&sink);
        least = between < least ? between : least;
        seconds = k > 0 ? clock_seconds() - start : 0;
    }
    return seconds > delay * (double)(2 * PROBES) * least;
}

void team_start(team *t, int most, int busy) {
    *t = (team){.most = most > 1 ? most : 0};
    while (t->levels < TEAM_LEVELS && t->most >> t->levels > 0)
        t->levels++;
    if (t->most != 0 && busy)
        t->level = t->levels - 1;
    t->trial = t->level;
    t->upward = t->level > 0;
}

void team_choose(team *t) {
    const int most = most_threads();
    team_start(t, most, most > 1 && is_busy());
}

static double predicted(const team_level *at, long iterations) {
    return at->others + at->iteration * (double)iterations;
}

/* Returns the level of the next round: that of a trial, or the chosen one if no trial is due. */
static int next_trial(const team *t) {
    assert(t->level >= 0 && t->level < t->levels);
    const int other = t->level + (t->upward ? -1 : 1);
    const team_level *at = &t->at[t->level];
    if (t->confirms && t->rested > 0)
        return other;
    if (at->rounds < SETTLED || t->rested < SETTLED || other < 0 || other >= t->levels)
        return t->level;
    const double least = (margin - 1) * predicted(at, t->last_iterations);
    const double risk = t->at[other].risk > least ? t->at[other].risk : least;
    return t->credit >= risk ? other : t->level;
}

void team_begin(team *t, double now) {
    if (t->most == 0)
        return;
    t->trial = next_trial(t);
    t->ended = 0;
    t->begun = now;
    t->expected = predicted(&t->at[t->level], t->last_iterations);
    set_threads(t->most >> t->trial);
}

void team_check(team *t, double now) {
    if (t->most == 0 || t->trial == t->level || now - t->begun <= margin * t->expected)
        return;
    t->ended = 1;
    set_threads(t->most >> t->level);
}

static void take_in(team_level *at, const team_round *round) {
    const double iterations = round->iterations > 0 ? (double)round->iterations : 1;
    const double iteration = round->solve_seconds / iterations;
    const double others = round->seconds - round->solve_seconds;
    const double w = at->rounds < 2 ? 1 : weight; /* the second round replaces the first */
    at->others += w * (others - at->others);
    at->iteration += w * (iteration - at->iteration);
    at->rounds++;
}

/* Returns the time that a trial must beat: that of a usual round or, in a second trial, that of the
 * round between the two trials if it is shorter. */
static double time_to_beat(const team *t, long iterations) {
    const double usual = predicted(&t->at[t->level], iterations);
    const double before = t->confirms ? predicted(&t->between, iterations) : usual;
    return before < usual ? before : usual;
}

static void change_direction(team *t, int better) {
    const int can_up = t->level > 0, can_down = t->level + 1 < t->levels;
    const int wants_up = better ? t->upward : !t->upward;
    t->upward = wants_up ? can_up : !can_down;
}

/* Evaluates a trial: chooses its level if it is the second one that is faster. Otherwise the next
 * trial goes in the other direction. */
static void evaluate_trial(team *t, const team_round *round) {
    assert(t->trial != t->level && t->trial < t->levels);
    team_level *at = &t->at[t->trial];
    const double expected = time_to_beat(t, round->iterations);
    const double loss = round->seconds - expected;
    const int better = !t->ended && round->seconds < gain * expected, confirms = t->confirms;
    t->confirms = better && !confirms;
    t->rested = 0;
    if (t->confirms)
        return;
    if (better) {
        *at = (team_level){0};
        take_in(at, round);
        t->level = t->trial;
    } else {
        at->risk = t->trial > t->level ? loss * (double)(1 << at->failures) : loss;
        at->failures += at->failures < MOST_DOUBLINGS;
        t->credit -= at->risk > 0 ? at->risk : 0;
    }
    change_direction(t, better);
}

/* Lets a trial follow, whatever it may lose. */
static void allow_trial(team *t, double seconds) {
    const double enough = (margin - 1) * seconds;
    t->credit = t->credit > enough ? t->credit : enough;
}

void team_end(team *t, const team_round *round) {
    if (t->most == 0)
        return;
    set_threads(t->most);
    team_level *at = &t->at[t->level];
    t->last_iterations = round->iterations;
    t->credit += share * round->seconds;
    if (t->trial != t->level) {
        evaluate_trial(t, round);
        return;
    }
    const double expected = predicted(at, round->iterations);
    t->rested++;
    t->between = (team_level){0};
    take_in(&t->between, round);
    if (at->rounds == SETTLED - 1)
        allow_trial(t, round->seconds);
    /* The round was much slower than expected. If that is not because of its work, another level
     * may be faster. */
    if (t->level + 1 < t->levels && at->rounds >= SETTLED && round->seconds > 2 * expected) {
        allow_trial(t, round->seconds);
        for (int l = 0; l < t->levels; l++) {
            t->at[l].risk = 0;
            t->at[l].failures = 0;
        }
    }
    take_in(at, round);
}

int team_threads(const team *t) {
    return t->most >> t->level;
}
