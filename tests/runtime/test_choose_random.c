/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The bounds of docs/choosing.md on 10,000 random simulated loops, on the worst that a search
 * finds, and on the worst found so far. */
#include "choose_traces.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* A loop encoded in digits: its properties and, for each call, the times of plans and whether the
 * subscripts change. */
enum { KNOBS = 14, CALLS = 120 };
struct digits {
    char like[KNOBS + 1];
    char slow[CALLS + 1];
    char change[CALLS + 1];
};

static double part(char digit) {
    return (digit - '0') / 9.0;
}

static struct trace *loop_of(const struct digits *digits, double noise) {
    const char *like = digits->like;
    struct trace *trace = ordinary((int)strlen(digits->slow));
    const double sequential = 1e-4 * pow(1e3, part(like[0]));
    trace->set_up_error = 0.1 * pow(100, part(like[1]));
    trace->execution_error = 0.5 * pow(4, part(like[2]));
    trace->set_up[WAY_INDEX] = 1e-6 * sequential * 0.05 * pow(400, part(like[3]));
    trace->set_up[WAY_GRAPH] = trace->set_up[WAY_INDEX] * (1 + 9 * part(like[4]));
    const double by_index = 0.5 + part(like[5]), by_graph = 0.5 + part(like[6]);
    trace->look = sequential * (0.001 + part(like[7]));
    trace->check = part(like[8]);
    trace->hidden = like[9] < '5';
    trace->compared = like[10] < '5';
    trace->block = 0.01 * sequential;
    trace->possible[WAY_BINS] = like[7] % 2 == 1; /* binning suits any subscripts */
    trace->start = like[11] < '5' ? 0 : 4 * part(like[11]) * sequential;
    int subscripts = 0;
    for (int c = 0; c < trace->count; c++) {
        struct simulated_call *call = &trace->call[c];
        const double slow = 0.5 + 1.5 * part(digits->slow[c]);
        subscripts += digits->change[c] == '1';
        call->subscripts = subscripts;
        call->sequential = sequential;
        call->execution[WAY_INDEX] = fmax(0.5, fmin(2, by_index * slow)) * sequential;
        call->execution[WAY_GRAPH] = fmax(0.5, fmin(2, by_graph * slow)) * sequential;
        call->execution[WAY_BINS] = fmax(0.5, fmin(2, (0.5 + part(like[6])) * slow)) * sequential;
        const double parallel = 1 + noise * (2 * uniform() - 1);
        scale(call, 1 + noise * (2 * uniform() - 1), parallel);
    }
    return trace;
}

static char random_digit(void) {
    return (char)('0' + (int)(10 * uniform()));
}

static struct digits random_digits(void) {
    struct digits it = {{0}, {0}, {0}};
    const double slow = uniform() * uniform(), change = pow(uniform(), 4);
    const int calls = 10 + (int)((CALLS - 10) * uniform());
    for (int k = 0; k < KNOBS; k++)
        it.like[k] = random_digit();
    for (int c = 0; c < calls; c++) {
        it.slow[c] = uniform() < slow ? random_digit() : '3';
        it.change[c] = uniform() < change ? '1' : '0';
    }
    return it;
}

static void random_loops(void **unused) {
    (void)unused;
    random_state = 88172645463325252u;
    double worst[2] = {0, 0}, best[2] = {0, 0}; /* without noise, and with noise */
    for (int loop = 0; loop < 10000; loop++) {
        const struct digits digits = random_digits();
        struct trace *trace = loop_of(&digits, loop % 2 ? 0.3 * uniform() : 0);
        const struct simulated it = simulate(trace);
        worst[loop % 2] = fmax(worst[loop % 2], it.worst_prefix);
        best[loop % 2] = fmax(best[loop % 2], (it.total - it.allowance) / it.best);
        free(trace);
    }
    if (getenv("CHOOSE_SHOW"))
        printf("random: prefix %.4f and %.4f, total/best %.4f and %.4f\n", worst[0], worst[1],
               best[0], best[1]);
    assert_true(worst[0] <= 1 + share);
    /* untimed executions are known only approximately */
    assert_true(worst[1] <= (1 + share) * 1.005);
    assert_true(best[0] <= fastest * (1 + share));
    assert_true(best[1] <= fastest * (1 + share) * 1.1); /* with noise plans may be even faster */
}

/* Returns the quantity that the search maximises. */
static double badness(const struct digits *digits, bool against_best) {
    struct trace *trace = loop_of(digits, 0);
    const struct simulated it = simulate(trace);
    free(trace);
    return against_best ? (it.total - it.allowance) / it.best : it.worst_prefix;
}

static struct digits mutated(struct digits it) {
    const int calls = (int)strlen(it.slow);
    for (int m = 0; m < 1 + (int)(4 * uniform()); m++) {
        const int c = (int)(calls * uniform());
        const double which = uniform();
        if (which < 0.4)
            it.like[(int)((double)KNOBS * uniform())] = random_digit();
        else if (which < 0.7)
            it.slow[c] = random_digit();
        else
            it.change[c] = it.change[c] == '1' ? '0' : '1';
    }
    return it;
}

/* Searches for bad loops by hill climbing from random loops. */
static struct digits search(int climbs, int steps, bool against_best, double *worst) {
    struct digits found = random_digits();
    *worst = 0;
    for (int climb = 0; climb < climbs; climb++) {
        struct digits here = random_digits();
        double height = badness(&here, against_best);
        for (int step = 0; step < steps; step++) {
            const struct digits next = mutated(here);
            const double there = badness(&next, against_best);
            if (there >= height) {
                here = next;
                height = there;
            }
        }
        if (height > *worst) {
            *worst = height;
            found = here;
        }
    }
    return found;
}

static void loops_made_to_be_bad(void **unused) {
    (void)unused;
    const char *given = getenv("CHOOSE_CLIMBS");
    const int climbs = given ? atoi(given) : 10;
    for (int against_best = 0; against_best < 2; against_best++) {
        double worst;
        random_state = 0x9e3779b97f4a7c15u;
        const struct digits found = search(climbs, 1000, against_best, &worst);
        if (getenv("CHOOSE_SHOW"))
            printf("search: %.4f {\"%s\", \"%s\", \"%s\"}\n", worst, found.like, found.slow,
                   found.change);
        assert_true(worst <= (against_best ? fastest * (1 + share) : 1 + share));
    }
}

/* The worst loops that the search has found in 400,000 steps. */
static void the_worst_found(void **unused) {
    (void)unused;
    static const struct digits worst[] = {
        {"51372000076053",
         "89968108885384879513243333105532807599076764998933970399481323712161519255898593"
         "472487868354754971782316863626313809052",
         "11101001111000111110101100011011000111011011100001111001100101010000000100001010"
         "111000101101010100111011100111010010000"},
        {"51297101093778",
         "23323313203433333330313330533003302333013313131303113231221330123001303330333323"
         "031230333233023313330323333303320",
         "00000110101101100010001010001111100001001010110111011110101101011100000100010111"
         "010100110010011001010011110001010"}};
    random_state = 1;
    const double sequential = badness(&worst[0], false), best = badness(&worst[1], true);
    if (getenv("CHOOSE_SHOW"))
        printf("worst found: %.4f of the sequential, %.4f of the best\n", sequential, best);
    assert_true(sequential <= 1 + share);
    assert_true(best <= fastest * (1 + share));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_loops),
        cmocka_unit_test(loops_made_to_be_bad),
        cmocka_unit_test(the_worst_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
