/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Loops with one update, in the form that redcc generates for binning (redcc/bins.h), and as plain
 * loops:
 *
 *     for (t = 0; t < trip; t++)
 *         STATEMENT, which updates r, the row at subscript k[t], by e, the contribution value[t]
 *
 * BINNED_LOOP(NAME, ROW, RECORD, OPERATION, TYPE, EXACT, STATEMENT) defines NAME, a struct
 * binned_loop. STATEMENT may name `by`, an operand constant in the loop.
 */
#ifndef BINNED_H
#define BINNED_H

#include "redcc/bins.h"

#include <omp.h>
#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

struct binned_problem {
    redcc_int trip;
    const int *k;      /* [trip] */
    const void *value; /* [trip] */
    void *rows;        /* address of the row with subscript 0 */
    const double *by;
    redcc_int slow; /* the first `slow` iterations take 20 microseconds longer, or the last -slow if
                       < 0 */
};

static inline void binned_delay(const struct binned_problem *p, redcc_int t) {
    if (t < p->slow || t >= p->trip + (p->slow < 0 ? p->slow : 0))
        usleep(20);
}

struct binned_loop {
    const char *name;
    size_t row, record; /* bytes */
    redcc_binned *descriptor;
    void (*oracle)(const struct binned_problem *);
    /** Returns true if the loop was executed. If it returns false, nothing has changed. Adds to
     * *last the number of threads that claim the last iteration. */
    bool (*run)(const struct binned_problem *, int threads, int *last);
};

#define BINNED_LOOP(NAME, ROW, RECORD, OPERATION, TYPE, EXACT, STATEMENT)                          \
    static void NAME##_apply(const redcc_applied *applied) {                                       \
        ROW *const rows = applied->rows[0];                                                        \
        const RECORD *const records = applied->records;                                            \
        const double by = *(const double *)applied->operands;                                      \
        (void)by;                                                                                  \
        for (redcc_size n = 0; n < applied->count; n++) {                                          \
            REDCC_APPLY_AHEAD(applied, n, rows, 0);                                                \
            ROW *const r = &rows[applied->place[n]];                                               \
            const RECORD e = records[n];                                                           \
            STATEMENT;                                                                             \
        }                                                                                          \
    }                                                                                              \
    static const redcc_array NAME##_arrays[] = {                                                   \
        {"R", OPERATION, TYPE, sizeof(ROW), sizeof(ROW), 0}};                                      \
    static const redcc_source NAME##_sources[] = {{"k", 1}, {"value", 0}};                         \
    static const redcc_stream NAME##_streams[] = {                                                 \
        {NAME##_apply, 1, {0}, {sizeof(ROW)}, sizeof(RECORD), 0, EXACT}};                          \
    static redcc_binned NAME##_descriptor = {{__FILE__, __LINE__, #NAME, REDCC_ORDER_SERIAL,       \
                                              REDCC_BINNED | REDCC_ORDER_NEEDED, 1, NAME##_arrays, \
                                              2, NAME##_sources, 0, 0},                            \
                                             1,                                                    \
                                             0,                                                    \
                                             NAME##_streams};                                      \
    static void NAME##_oracle(const struct binned_problem *p) {                                    \
        const RECORD *const value = p->value;                                                      \
        const double by = *p->by;                                                                  \
        (void)by;                                                                                  \
        for (redcc_int t = 0; t < p->trip; t++) {                                                  \
            ROW *const r = &((ROW *)p->rows)[p->k[t]];                                             \
            const RECORD e = value[t];                                                             \
            STATEMENT;                                                                             \
        }                                                                                          \
    }                                                                                              \
    static int NAME##_push(const struct binned_problem *p, redcc_worker *worker, int *last) {      \
        const RECORD *const value = p->value;                                                      \
        redcc_bins bins[1];                                                                        \
        int handed;                                                                                \
        while ((handed = redcc_bins_next(worker, bins, p->by)) == REDCC_TO_PUSH) {                 \
            const redcc_bins to_0 = bins[0];                                                       \
            for (redcc_int t = worker->first; t < worker->last; t++) {                             \
                const RECORD e = value[t];                                                         \
                binned_delay(p, t);                                                                \
                if (EXACT && REDCC_ARE_COPIED(&to_0))                                              \
                    redcc_update(&to_0, &NAME##_streams[0], p->k[t], 0, &e);                       \
                else                                                                               \
                    redcc_push(&to_0, &NAME##_streams[0], p->k[t], 0, &e);                         \
            }                                                                                      \
            if (worker->last == p->trip && redcc_claims_last(worker))                              \
                __atomic_fetch_add(last, 1, __ATOMIC_RELAXED);                                     \
        }                                                                                          \
        return handed == REDCC_TO_EXECUTE;                                                         \
    }                                                                                              \
    static void NAME##_execute(const struct binned_problem *p, redcc_worker *worker, int *last) {  \
        const RECORD *const value = p->value;                                                      \
        const double by = *p->by;                                                                  \
        (void)by;                                                                                  \
        while (redcc_next(worker)) {                                                               \
            ROW *const rows = worker->base[0];                                                     \
            for (const redcc_iterations *run = worker->run; run != worker->run_end; run++) {       \
                const redcc_int begin = worker->origin + run->begin;                               \
                const redcc_int end = begin + run->count_and_check / 2;                            \
                for (redcc_int t = begin; t < end; t++) {                                          \
                    ROW *const r = &rows[p->k[t]];                                                 \
                    const RECORD e = value[t];                                                     \
                    STATEMENT;                                                                     \
                }                                                                                  \
                if (end == p->trip && redcc_claims_last(worker))                                   \
                    __atomic_fetch_add(last, 1, __ATOMIC_RELAXED);                                 \
            }                                                                                      \
        }                                                                                          \
    }                                                                                              \
    static bool NAME##_run(const struct binned_problem *p, int threads, int *last) {               \
        void *const bases[] = {p->rows};                                                           \
        const redcc_extent known[] = {                                                             \
            {(const char *)p->k, (const char *)(p->k + p->trip)},                                  \
            {p->value, (const char *)p->value + (size_t)p->trip * sizeof(RECORD)}};                \
        redcc_call call;                                                                           \
        if (redcc_enter(&call, &NAME##_descriptor.loop, p->trip, bases, known, NULL, threads,      \
                        omp_in_parallel())) {                                                      \
            _Pragma("omp parallel num_threads(call.threads)") {                                    \
                redcc_worker worker;                                                               \
                redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());           \
                while (redcc_inspect(&worker))                                                     \
                    ;                                                                              \
                while (NAME##_push(p, &worker, last))                                              \
                    NAME##_execute(p, &worker, last);                                              \
                NAME##_execute(p, &worker, last);                                                  \
            }                                                                                      \
        }                                                                                          \
        return redcc_leave(&call);                                                                 \
    }                                                                                              \
    static const struct binned_loop NAME = {                                                       \
        #NAME, sizeof(ROW), sizeof(RECORD), &NAME##_descriptor, NAME##_oracle, NAME##_run};

#endif
