/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/size.h"

/* Set-ups wait for ten times their cost at first (the bound), for as much as it when they have paid
 * thrice. */
static const double first_factor = 10, least_factor = 1, most_factor = 1e9;

/* Estimates were 10 % off where all went well: what is not expected to gain that, a set-up may show
 * to be no gain at all. */
static const double promising = 0.9;

const struct size_state *redcc_seen_size(const struct choice_state *state, long long trip) {
    const int logarithm = 63 - __builtin_clzll((unsigned long long)trip | 1);
    return &state->size[logarithm < REDCC_SIZES ? logarithm : REDCC_SIZES - 1];
}

struct size_state *redcc_size_of(struct choice_state *state, long long trip) {
    return (struct size_state *)redcc_seen_size(state, trip);
}

double redcc_usual(const struct timings *timings) {
    const double *t = timings->recent;
    if (timings->count < 3)
        return timings->count == 2 && t[1] < t[0] ? t[1] : t[0];
    const double low = t[0] < t[1] ? t[0] : t[1], high = t[0] < t[1] ? t[1] : t[0];
    return t[2] < low ? low : t[2] > high ? high : t[2];
}

double redcc_least(const struct timings *timings) {
    double low = timings->recent[0];
    for (int i = 1; i < 3 && i < timings->count; i++)
        low = timings->recent[i] < low ? timings->recent[i] : low;
    return timings->count ? low : 0;
}

void redcc_note_timing(struct timings *timings, double each) {
    timings->recent[timings->count++ % 3] = each;
}

void redcc_rest(struct size_state *size, enum stand stand, enum rule rule, long first, long most) {
    struct back_off *it = &size->rest;
    it->length = it->length ? it->length * 2 : first;
    it->length = it->length > most ? most : it->length;
    it->until = it->calls + it->length;
    size->stand = stand;
    size->rule = rule;
}

double redcc_next_factor(const struct set_ups *set_ups) {
    const double now = set_ups->factor > 0 ? set_ups->factor : first_factor;
    if (set_ups->invested == 0)
        return now;
    const double next = set_ups->earned >= set_ups->invested ? now / 2 : now * 2;
    return next < least_factor ? least_factor : next > most_factor ? most_factor : next;
}

int redcc_next_misses(const struct set_ups *set_ups) {
    const bool missed = set_ups->invested > 0 && set_ups->earned < set_ups->invested;
    return missed ? set_ups->misses + 1 : 0;
}

double redcc_expected(const struct size_state *size, enum way way) {
    const struct prospect *it = &size->prospect[way];
    return it->measured || size->looked_at <= 0
               ? it->execution
               : it->execution * redcc_usual(&size->sequential) / size->looked_at;
}

bool redcc_is_better(const struct size_state *size, enum way way, double current) {
    const struct prospect *it = &size->prospect[way];
    const double below = it->measured ? redcc_better : promising;
    return it->possible && redcc_expected(size, way) < below * current;
}

bool redcc_some_way_is_better(const struct size_state *size) {
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (redcc_is_better(size, way, redcc_usual(&size->sequential)))
            return true;
    return false;
}

void redcc_compare(struct size_state *size, enum way contender, enum way incumbent) {
    size->comparison = (struct comparison){.contender = contender, .incumbent = incumbent};
    size->stand = STAND_COMPARING;
    size->rule = RULE_COMPARING;
}

double redcc_usual_sequential(const struct choice_state *state, long long trip) {
    const struct size_state *size = redcc_seen_size(state, trip);
    return redcc_usual(&size->sequential) * (double)trip;
}

long redcc_timings_of(const struct choice_state *state, long long trip) {
    return redcc_seen_size(state, trip)->sequential.count;
}

enum rule redcc_rule_of(const struct choice_state *state, long long trip) {
    return redcc_seen_size(state, trip)->rule;
}
