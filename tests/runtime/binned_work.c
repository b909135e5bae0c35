/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "binned_work.h"

#include "base/memory.h"
#include "problem.h"

#include <errno.h>
#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const double half = 0.5;
static struct memory expected;
struct memory now, before;
int fewer;

static double checked(double value) {
    if (value == WRONG)
        errno = EDOM;
    return value;
}

static void execute(const struct work *w, redcc_int from, redcc_int to) {
    for (redcc_int t = from; t < to; t++)
        for (int n = w->start[t]; n < w->start[t + 1]; n++) {
            const double value = checked(w->value[n]);
            if (value > 0) {
                w->count[w->k[n]]++;
                w->sum[w->k[n]] += value;
            }
            w->other[w->j[n]] -= value * checked(w->x[w->m[t]]);
            w->other[w->j[n] + 1] = w->other[w->j[n] + 1] * half + 1;
        }
}

void work_oracle(const struct work *w) {
    execute(w, 0, w->trip);
}

/* ---- as redcc generates it ------------------------------------------------------------------- */

static void apply_means(const redcc_applied *applied) {
    long *const count = applied->rows[0];
    double *const sum = applied->rows[1];
    const double *const value = applied->records;
    for (redcc_size n = 0; n < applied->count; n++) {
        count[applied->place[n]]++;
        sum[applied->place[n]] += value[n];
    }
}

enum { TAG_BITS = 1 };

static void apply_other(const redcc_applied *applied) {
    double *const other = applied->rows[0];
    const double *const value = applied->records;
    const double factor = *(const double *)applied->operands;
    for (redcc_size n = 0; n < applied->count; n++) {
        REDCC_APPLY_AHEAD(applied, n, other, TAG_BITS);
        double *const r = &other[REDCC_PLACE_ROW(applied->place[n], TAG_BITS)];
        if (REDCC_PLACE_TAG(applied->place[n], TAG_BITS) == 0)
            *r -= value[n];
        else
            *r = *r * factor + 1;
    }
}

static const redcc_array arrays[] = {{"count", REDCC_SUM, REDCC_INT64, 8, 8, 0},
                                     {"sum", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0},
                                     {"other", REDCC_SUM, REDCC_OTHER_TYPE, 8, 8, 0}};
static const redcc_source sources[] = {{"x", 0}, {"value", 0}};
static const redcc_stream streams[] = {{apply_means, 2, {0, 1}, {8, 8}, 8, 0, 0},
                                       {apply_other, 1, {2}, {8}, 8, TAG_BITS, 0}};
redcc_binned work_loop = {{"binned_work.c", 20, "work", REDCC_ORDER_SERIAL,
                           REDCC_BINNED | REDCC_ORDER_NEEDED, 3, arrays, 2, sources, 0, 0},
                          2,
                          0,
                          streams};

static int push(const struct work *w, redcc_worker *worker) {
    redcc_bins bins[2];
    int handed;
    while ((handed = redcc_bins_next(worker, bins, &half)) == REDCC_TO_PUSH) {
        const redcc_bins means = bins[0], others = bins[1];
        for (redcc_int t = worker->first; t < worker->last; t++)
            for (int n = w->start[t]; n < w->start[t + 1]; n++) {
                const double value = checked(w->value[n]);
                if (value > 0)
                    redcc_push(&means, &streams[0], w->k[n], 0, &value);
                redcc_read(worker, 0, &w->x[w->m[t]], sizeof *w->x);
                const double e = value * checked(w->x[w->m[t]]);
                redcc_push(&others, &streams[1], w->j[n], 0, &e);
                redcc_push(&others, &streams[1], w->j[n] + 1, 1, &e);
            }
    }
    return handed;
}

bool work_run(const struct work *w, int threads) {
    void *const bases[] = {w->count, w->sum, w->other};
    const redcc_extent known[] = {
        {(const char *)w->x, NULL},
        {(const char *)w->value, (const char *)(w->value + w->start[w->trip])}};
    redcc_call call;
    if (redcc_enter(&call, &work_loop.loop, w->trip, bases, known, NULL, threads,
                    omp_in_parallel())) {
#pragma omp parallel num_threads(fewer ? fewer : call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                ;
            int more;
            do {
                more = push(w, &worker);
                while (redcc_next(&worker))
                    for (const redcc_iterations *r = worker.run; r != worker.run_end; r++)
                        execute(w, worker.origin + r->begin,
                                worker.origin + r->begin + r->count_and_check / 2);
            } while (more == REDCC_TO_EXECUTE);
        }
    }
    return redcc_leave(&call);
}

/* ---- data ------------------------------------------------------------------------------------ */

struct work work_new(unsigned long seed, int most_inside) {
    unsigned long state = seed;
    struct work w = {.trip = TRIP, .count = now.count, .sum = now.sum, .other = now.other};
    w.start = malloc((TRIP + 1) * sizeof *w.start);
    w.k = malloc(MOST * sizeof *w.k);
    w.j = malloc(MOST * sizeof *w.j);
    w.m = malloc(TRIP * sizeof *w.m);
    w.value = malloc(MOST * sizeof *w.value);
    w.x = now.other + ROWS;
    int n = 0;
    for (int t = 0; t < TRIP; t++) {
        w.start[t] = n;
        w.m[t] = (int)(next_random(&state) % X);
        const int inside = (int)(next_random(&state) % (unsigned long)(most_inside + 1));
        for (int i = 0; i < inside; i++, n++) {
            w.k[n] = (int)(next_random(&state) % ROWS);
            w.j[n] = (int)(next_random(&state) % (ROWS - 1));
            w.value[n] = (double)(int)(next_random(&state) % 2001) * 0.37 - 370;
        }
    }
    w.start[TRIP] = n;
    for (int i = 0; i < ROWS + X; i++)
        before.other[i] = (double)i * 0.1;
    return w;
}

void work_free(struct work *w) {
    free(w->start);
    free(w->k);
    free(w->j);
    free(w->m);
    free(w->value);
    redcc_loop_forget(&work_loop.loop);
    assert_int_equal(redcc_memory_live(), 0);
}

const struct loop_state *work_state(void) {
    return work_loop.loop.state;
}

long work_validated(void) {
    return work_state()->reported.statistics.validated.executions;
}

long work_fallbacks(enum reason reason) {
    return atomic_load(&work_state()->reported.statistics.fallback[reason]);
}

/* Returns true if binning executed all rounds, or at least the first ones. */
bool work_compare(const struct work *w, int threads) {
    memcpy(&now, &before, sizeof now);
    work_oracle(w);
    memcpy(&expected, &now, sizeof now);
    memcpy(&now, &before, sizeof now);
    const bool done = work_run(w, threads);
    if (!done)
        work_oracle(w);
    assert_memory_equal(&now, &expected, sizeof now);
    if (work_state())
        assert_int_equal(work_state()->reported.statistics.validated.broken, 0);
    return done;
}
