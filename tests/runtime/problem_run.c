/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The loop of problem.h in the form that redcc generates (docs/generated-code.md). */
#include "loop.h"
#include "problem.h"

#include <stdlib.h>
#include <string.h>

#include <omp.h>

void problem_describe(const struct problem *problem, struct described *described) {
    const redcc_u32 size = sizeof(double);
    const redcc_u32 width = (redcc_u32)problem->width,
                    second_width = (redcc_u32)problem->second_width;
    *described = (struct described){
        .arrays = {{"first", REDCC_SUM, REDCC_DOUBLE, size, size * width, 0},
                   {"second", REDCC_SUM, REDCC_DOUBLE, size, size * second_width, 0}},
        .sources = {{"start", 1}, {"row", 1}, {"other", 1}, {"value", 0}}};
    described->loop = (redcc_loop){.file = "problem.h",
                                   .line = 5,
                                   .function = "problem_run",
                                   .order = REDCC_ORDER_SERIAL,
                                   .flags = REDCC_VERIFIABLE | REDCC_SELECTS,
                                   .array_count = problem->second_width ? 2 : 1,
                                   .arrays = described->arrays,
                                   .source_count = 4,
                                   .sources = described->sources,
                                   .key_count = 3};
}

#define TELL_READ(...) redcc_read(worker, __VA_ARGS__)
#define TELL_TOUCH(...) redcc_touch(worker, __VA_ARGS__)
#define PROBE_READ(...) redcc_probe_read(&probe, worker, __VA_ARGS__)
#define PROBE_TOUCH(...) redcc_probe_touch(&probe, worker, __VA_ARGS__)

/* Makes the slice more expensive than the body. */
static void search(void) {
    for (volatile int n = 0; n < problem_searches; n++)
        ;
}

#define INSPECT(t, READ, TOUCH)                                                                    \
    search();                                                                                      \
    for (k = start[t]; k < start[t + 1]; k++) {                                                    \
        READ(1, &row[k], sizeof row[k]);                                                           \
        READ(3, &value[k], sizeof value[k]);                                                       \
        TOUCH(0, &first[row[k] * width], sizeof *first *(redcc_size)width);                        \
        if (second_width) {                                                                        \
            READ(2, &other[k], sizeof other[k]);                                                   \
            TOUCH(1, &second[other[k] * second_width], sizeof *second *(redcc_size)second_width);  \
        }                                                                                          \
    }

#define BODY(t, MAY_FIRST, MAY_SECOND)                                                             \
    for (k = start[t]; k < start[t + 1]; k++) {                                                    \
        for (c = 0; c < width; c++)                                                                \
            if (MAY_FIRST(&b[row[k] * width + c]))                                                 \
                b[row[k] * width + c] += value[k] * (c + 1);                                       \
        for (c = 0; c < second_width; c++)                                                         \
            if (MAY_SECOND(&d[other[k] * second_width + c]))                                       \
                d[other[k] * second_width + c] -= value[k] * (c + 2);                              \
    }                                                                                              \
    mine = 3 * (t) + 1

#define ALWAYS(address) 1
#define OWN_FIRST(address) redcc_owns(&own_first, address)
#define OWN_SECOND(address) redcc_owns(&own_second, address)

int problem_run(struct problem *problem, struct described *described, int threads, long *last) {
    return problem_run_fewer(problem, described, threads, threads, last);
}

/* Sets the extents that are known before an inspection. */
static void set_known(const struct problem *problem, redcc_extent known[4]) {
    memset(known, 0, 4 * sizeof *known);
    if (problem->trip <= 0)
        return;
    known[0] = (redcc_extent){(const char *)problem->start,
                              (const char *)(problem->start + problem->trip + 1)};
    known[1].first = (const char *)problem->row;
    known[2].first = (const char *)problem->other;
    known[3].first = (const char *)problem->value;
}

/* Executed by each thread first: records the touches of the blocks that the thread gets. */
static void inspect_blocks(redcc_worker *worker, const struct problem *problem) {
    const int *start = problem->start, *row = problem->row, *other = problem->other;
    const double *value = problem->value, *first = problem->first, *second = problem->second;
    const int width = problem->width, second_width = problem->second_width;
    int k;
    while (redcc_inspect(worker))
        for (redcc_int t = worker->first; t < worker->last; t += worker->stride) {
            if (redcc_is_settled(worker)) {
                const redcc_int from = t;
                for (; t < worker->last; t++) {
                    redcc_probe probe = {0, 0, 0, 0, 0, 0, 0, 0};
                    INSPECT(t, PROBE_READ, PROBE_TOUCH);
                    if (!redcc_is_alike(&probe))
                        break;
                }
                worker->alike += t - from;
                if (t == worker->last)
                    break;
            }
            INSPECT(t, TELL_READ, TELL_TOUCH);
            redcc_iteration_done(worker);
        }
}

/* Classifies the iterations of a block: does an iteration write a row that the thread owns? */
static void classify(redcc_worker *worker, const struct problem *problem) {
    const int *start = problem->start, *row = problem->row, *other = problem->other;
    const double *value = problem->value, *first = problem->first, *second = problem->second;
    const int width = problem->width, second_width = problem->second_width;
    unsigned char class[REDCC_SELECTED];
    int k;
    redcc_int t = worker->first;
    for (; t < worker->last; t++) {
        redcc_probe probe = {0, 0, 1, 0, 0, 0, 0, 0};
        INSPECT(t, PROBE_READ, PROBE_TOUCH);
        if (probe.strays)
            break;
        class[t - worker->first] = redcc_class_of(&probe);
    }
    redcc_store_classes(worker, class, t);
}

/* Executes a chunk, run by run. In the loop's last iteration t, sets *last to 3 t + 1. */
static void execute_chunk(redcc_worker *worker, const struct problem *problem, long *last) {
    const int *start = problem->start, *row = problem->row, *other = problem->other;
    const double *value = problem->value;
    const int width = problem->width, second_width = problem->second_width;
    double *const b = worker->base[0];
    double *const d = second_width ? worker->base[1] : 0;
    const redcc_owner own_first = worker->owner[0];
    const redcc_owner own_second = worker->owner[second_width ? 1 : 0];
    long mine = 0;
    int k, c;
    for (const redcc_iterations *run = worker->run; run != worker->run_end; run++) {
        redcc_int t = worker->origin + run->begin;
        const redcc_int end = t + run->count_and_check / 2;
        if (!(run->count_and_check & 1))
            for (; t < end; t++) {
                BODY((long)t, ALWAYS, ALWAYS);
            }
        else
            for (; t < end; t++) {
                BODY((long)t, OWN_FIRST, OWN_SECOND);
            }
        if (end == problem->trip && redcc_claims_last(worker))
            *last = mine;
    }
}

int problem_run_fewer(struct problem *problem, struct described *described, int threads, int given,
                      long *last) {
    const redcc_int trip = problem->trip;
    void *const bases[] = {problem->first, problem->second};
    redcc_extent known[4];
    const redcc_word key[] = {(redcc_size)problem->start, (redcc_size)problem->row,
                              (redcc_size)problem->other};
    set_known(problem, known);
    redcc_call call;
    /* creates a state even for a short loop, because tests inspect it */
    redcc_loop_make(&described->loop);
    if (redcc_enter(&call, &described->loop, trip, bases, known, key, threads, omp_in_parallel())) {
#pragma omp parallel num_threads(given < call.threads ? given : call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            inspect_blocks(&worker, problem);
            for (int asked; (asked = redcc_next(&worker)) != 0;)
                if (asked == REDCC_SELECT)
                    classify(&worker, problem);
                else
                    execute_chunk(&worker, problem, last);
        }
    }
    const int done = redcc_leave(&call);
    if (!done)
        problem_oracle(problem);
    redcc_sequential_done(&described->loop);
    if (done)
        return 1;
    if (problem_run_tells && !getenv("REDCC_METHOD"))
        problem_tell_slow(&described->loop, trip, 1e-3);
    if (trip > 0)
        *last = 3 * (long)trip - 2;
    return 0;
}
