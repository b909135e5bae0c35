/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* What binning has to give up, or to do again, in the middle of a loop: reads that overlap what a
 * round writes, streams that overlap, memory that fails or does not suffice, rows far apart. And
 * several arrays in a record, several updates of an array, loops inside. */
#include "base/memory.h"
#include "base/trace.h"
#include "bins/window.h"
#include "loop.h"
#include "problem.h"
#include "redcc/bins.h"
#include "settings.h"

#include <errno.h>
#include <omp.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

/*  for (t = 0; t < trip; t++)
 *      for (n = start[t]; n < start[t + 1]; n++) {
 *          if (value[n] > 0) { count[k[n]]++; sum[k[n]] += value[n]; }
 *          other[j[n]] -= value[n] * x[m[t]];
 *          other[j[n] + 1] = other[j[n] + 1] * half + 1;
 *      }
 * Where value[n] is WRONG, a mathematical function fails. */
struct work {
    redcc_int trip;
    int *start, *k, *j, *m;
    double *value;
    long *count;
    double *sum, *other;
    const double *x;
};

static const double half = 0.5, WRONG = -7777;

static double checked(double value) {
    if (value == WRONG)
        errno = EDOM;
    return value;
}

static void oracle(const struct work *w, redcc_int from, redcc_int to) {
    for (redcc_int t = from; t < to; t++)
        for (int n = w->start[t]; n < w->start[t + 1]; n++) {
            const double value = checked(w->value[n]);
            if (value > 0) {
                w->count[w->k[n]]++;
                w->sum[w->k[n]] += value;
            }
            w->other[w->j[n]] -= value * w->x[w->m[t]];
            w->other[w->j[n] + 1] = w->other[w->j[n] + 1] * half + 1;
        }
}

/* ---- as redcc would write it ----------------------------------------------------------------- */

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

static const redcc_array arrays[] = {{"count", REDCC_SUM, REDCC_INT64, 8, 8},
                                     {"sum", REDCC_SUM, REDCC_DOUBLE, 8, 8},
                                     {"other", REDCC_SUM, REDCC_OTHER_TYPE, 8, 8}};
static const redcc_source sources[] = {{"x", 0}, {"value", 0}};
static const redcc_stream streams[] = {{apply_means, 2, {0, 1}, {8, 8}, 8, 0, 0},
                                       {apply_other, 1, {2}, {8}, 8, TAG_BITS, 0}};
static redcc_binned loop = {{"test_bins_guard.c", 20, "work", REDCC_ORDER_SERIAL,
                             REDCC_BINNED | REDCC_ORDER_NEEDED, 3, arrays, 2, sources, 0, 0},
                            2,
                            streams};

static void push(const struct work *w, redcc_worker *worker) {
    redcc_bins bins[2];
    while (redcc_bins_next(worker, bins, &half)) {
        const redcc_bins means = bins[0], others = bins[1];
        for (redcc_int t = worker->first; t < worker->last; t++)
            for (int n = w->start[t]; n < w->start[t + 1]; n++) {
                const double value = checked(w->value[n]);
                if (value > 0)
                    redcc_push(&means, &streams[0], w->k[n], 0, &value);
                redcc_read(worker, 0, &w->x[w->m[t]], sizeof *w->x);
                const double e = value * w->x[w->m[t]];
                redcc_push(&others, &streams[1], w->j[n], 0, &e);
                redcc_push(&others, &streams[1], w->j[n] + 1, 1, &e);
            }
    }
}

static int fewer; /* threads than asked for, that OpenMP is made to give; 0: as many */

static bool run(const struct work *w, int threads) {
    void *const bases[] = {w->count, w->sum, w->other};
    const redcc_extent known[] = {
        {(const char *)w->x, NULL},
        {(const char *)w->value, (const char *)(w->value + w->start[w->trip])}};
    redcc_call call;
    if (redcc_enter(&call, &loop.loop, w->trip, bases, known, NULL, threads, omp_in_parallel())) {
#pragma omp parallel num_threads(fewer ? fewer : call.threads)
        {
            redcc_worker worker;
            redcc_join(&worker, &call, omp_get_thread_num(), omp_get_num_threads());
            while (redcc_inspect(&worker))
                ;
            push(w, &worker);
            while (redcc_next(&worker))
                for (const redcc_run *r = worker.run; r != worker.run_end; r++)
                    oracle(w, worker.origin + r->begin,
                           worker.origin + r->begin + r->count_and_guard / 2);
        }
    }
    return redcc_leave(&call);
}

/* ---- data ------------------------------------------------------------------------------------ */

enum { ROWS = 3000, TRIP = 4000, MOST = 16 * TRIP, X = 50 };

/* One block of memory, so that all may overlap: [ROWS] count, [ROWS] sum, [ROWS + X] other, [X] x,
 * which is `other` from ROWS on. */
struct memory {
    long count[ROWS];
    double sum[ROWS];
    double other[ROWS + X];
};

static struct memory now, before, expected;

static struct work new_work(unsigned long seed, int most_inside) {
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

static void free_work(struct work *w) {
    free(w->start);
    free(w->k);
    free(w->j);
    free(w->m);
    free(w->value);
    redcc_loop_forget(&loop.loop);
    assert_int_equal(redcc_memory_live(), 0);
}

static const struct loop_state *state(void) {
    return loop.loop.state;
}

static long fallbacks(enum reason reason) {
    return atomic_load(&state()->reported.statistics.fallback[reason]);
}

/* Returns whether all or the first rounds were binned. */
static bool compare(const struct work *w, int threads) {
    memcpy(&now, &before, sizeof now);
    oracle(w, 0, w->trip);
    memcpy(&expected, &now, sizeof now);
    memcpy(&now, &before, sizeof now);
    const bool done = run(w, threads);
    if (!done)
        oracle(w, 0, w->trip);
    assert_memory_equal(&now, &expected, sizeof now);
    return done;
}

static struct bins_tuning usual;

/* ---- tests ----------------------------------------------------------------------------------- */

static void records_of_several_arrays_and_updates(void **unused) {
    (void)unused;
    static const int threads[] = {1, 2, 3, 7, 16, 33};
    for (int n = 0; n < 24; n++) {
        struct work w = new_work((unsigned long)n + 1, 1 + n % 7);
        redcc_bins_tuning.bin_bits = n % 4 == 0 ? 3 : 15;
        redcc_bins_tuning.least_budget = (size_t)1 << (n % 4 == 0 ? 32 : 23);
        redcc_bins_tuning.round = n % 3 ? INT64_MAX : 700;
        redcc_bins_tuning.direct_bins = n % 2 ? 0 : 4096;
        assert_true(compare(&w, threads[n % 6]));
        assert_true(compare(&w, threads[(n + 3) % 6]));
        assert_int_equal(state()->binning.reason, REASON_NONE); /* x lies beside what is written */
        free_work(&w);
    }
    redcc_bins_tuning = usual;
}

/* From iteration `from` on x is read where it is written. */
static void reads_overlap_from(redcc_int from, redcc_int round) {
    struct work w = new_work(9, 3);
    w.x = now.other + ROWS - X;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = w.j[n] % (ROWS - 2 * X);
    while (from < TRIP && w.start[from] == w.start[from + 1])
        from--;
    for (int t = (int)from; t < TRIP; t++)
        w.m[t] = w.j[w.start[t]] - (ROWS - X);
    for (int threads = 1; threads <= 7; threads += 3) {
        redcc_bins_tuning.round = round;
        const bool binned = compare(&w, threads);
        assert_int_equal(binned, from >= round);
        assert_int_equal(state()->binning.reason, from < TRIP ? REASON_OVERLAP : REASON_NONE);
        assert_true(state()->binning.round.begin <= from);
        if (binned && from < TRIP)
            assert_true(state()->binning.round.begin > from - round);
        assert_string_equal(state()->reported.statistics.overlap[0].text,
                            from < TRIP ? "'x' overlaps 'other'" : "");
    }
    redcc_bins_tuning = usual;
    free_work(&w);
}

static void late_guard(void **unused) {
    (void)unused;
    reads_overlap_from(0, 1000);
    reads_overlap_from(1, 1000);
    reads_overlap_from(1, 1);
    reads_overlap_from(2500, 100);
    reads_overlap_from(TRIP - 1, 1000);
    reads_overlap_from(TRIP - 1, 1);
    reads_overlap_from(TRIP, 1000);
}

/* What is read in earlier rounds may be written in later ones: in the loop it is so as well. */
static void reads_before_writes(void **unused) {
    (void)unused;
    struct work w = new_work(19, 3);
    w.x = now.other;
    for (int t = 0; t < TRIP; t++) {
        w.m[t] = t < TRIP / 2 ? w.m[t] : ROWS + w.m[t] % X;
        for (int n = w.start[t]; n < w.start[t + 1]; n++)
            w.j[n] = t < TRIP / 2 ? 2 * X + w.j[n] / 2 : w.j[n] / 40;
    }
    redcc_bins_tuning.round = TRIP / 4;
    for (int threads = 1; threads <= 5; threads++) {
        assert_true(compare(&w, threads));
        assert_int_equal(state()->binning.reason, REASON_NONE);
        assert_int_equal(state()->binning.rounds, 4);
    }
    redcc_bins_tuning = usual;
    free_work(&w);
}

static void fewer_threads_come(void **unused) {
    (void)unused;
    struct work w = new_work(29, 3);
    for (int asked = 2; asked <= 8; asked++)
        for (int given = 1; given <= asked; given += 3) {
            fewer = given;
            assert_true(compare(&w, asked));
            assert_int_equal(state()->reported.statistics.threads, given);
        }
    fewer = 0;
    free_work(&w);
}

static void streams_overlap(void **unused) {
    (void)unused;
    struct work w = new_work(4, 3);
    w.other = now.sum + 10;
    assert_false(compare(&w, 2));
    assert_int_equal(fallbacks(REASON_OUT_OF_STEP), 1);
    w.other = now.other;
    w.x = now.other + ROWS;
    w.sum = (double *)(void *)now.count; /* arrays of one stream, at one subscript */
    w.count = now.count + 1;
    assert_false(compare(&w, 2));
    assert_int_equal(fallbacks(REASON_OUT_OF_STEP), 2);
    free_work(&w);
}

static void memory_does_not_suffice(void **unused) {
    (void)unused;
    for (int heavy = 0; heavy < 3; heavy++) { /* some iterations have more records than the rest */
        struct work w = new_work(77, 2);
        const int all = w.start[TRIP];
        for (int t = TRIP / 2; heavy && t <= TRIP; t++)
            w.start[t] = t < TRIP / 2 + 2 * heavy ? w.start[t] : all;
        redcc_bins_tuning.least_budget = 400 * 1024;
        assert_true(compare(&w, 2));
        assert_true(compare(&w, 3) || heavy);
        redcc_bins_tuning.least_budget = 1024;
        redcc_bins_drop((struct binning *)&state()->binning);
        assert_false(compare(&w, 2));
        assert_int_equal(fallbacks(REASON_NO_MEMORY) > 0, 1);
        redcc_bins_tuning = usual;
        free_work(&w);
    }
}

/* One iteration has half of all records: more than the blocks of a round hold. */
static void records_are_many_all_at_once(void **unused) {
    (void)unused;
    struct work w = new_work(78, 15);
    for (int t = TRIP / 2 + 1; t < TRIP; t++)
        w.start[t] = w.start[TRIP];
    for (int threads = 1; threads <= 3; threads++) {
        redcc_bins_tuning.round = 200;
        redcc_bins_tuning.least_budget = (size_t)8 << 20;
        assert_true(compare(&w, threads));
        assert_int_equal(state()->binning.reason, REASON_NONE);
        assert_true(state()->binning.rounds > TRIP / 200);
        redcc_bins_tuning.least_budget = (size_t)threads * 200000; /* not enough for that one */
        redcc_loop_forget(&loop.loop);
        assert_true(compare(&w, threads));
        assert_int_equal(state()->binning.reason, REASON_NO_MEMORY);
        assert_in_range(state()->binning.round.begin, 1, TRIP / 2);
        redcc_loop_forget(&loop.loop);
    }
    redcc_bins_tuning = usual;
    free_work(&w);
}

static void failing_memory(void **unused) {
    (void)unused;
    struct work w = new_work(5, 3);
    redcc_bins_tuning.round = 900;
    for (int threads = 1; threads <= 3; threads++) {
        long failures = 0;
        for (bool failed = true; failed; failures++) {
            redcc_memory_fail_after(failures);
            const bool done = compare(&w, threads);
            failed = redcc_memory_is_exhausted();
            redcc_memory_fail_after(-1);
            assert_true(failed || done);
            assert_true(compare(&w, threads)); /* again, with memory */
            redcc_loop_forget(&loop.loop);
            assert_int_equal(redcc_memory_live(), 0);
        }
        assert_true(failures > 20);
    }
    redcc_bins_tuning = usual;
    redcc_memory_limit(100000);
    assert_false(compare(&w, 2));
    assert_true(redcc_memory_in_use() <= 100000);
    assert_int_equal(fallbacks(REASON_NO_MEMORY), 1);
    redcc_memory_limit(8 << 20);
    assert_true(compare(&w, 2));
    assert_true(redcc_memory_in_use() <= 8 << 20);
    redcc_memory_limit(0);
    free_work(&w);
}

/* Memory for other bins fails after the first rounds: rows go elsewhere in the middle. */
static void memory_fails_in_the_middle(void **unused) {
    (void)unused;
    for (long failure = 0; failure < 12; failure++) {
        struct work w = new_work(31, 3);
        redcc_bins_tuning.round = 500;
        redcc_bins_tuning.bin_bits = 8;
        assert_true(compare(&w, 2));
        for (int n = 0; n < w.start[TRIP]; n++)
            w.j[n] = n < w.start[TRIP / 2] ? w.j[n] / 4 : w.j[n];
        redcc_loop_forget(&loop.loop);
        for (int n = 0; n < w.start[TRIP]; n++)
            w.j[n] = w.j[n] / 2;
        assert_true(compare(&w, 2));
        for (int n = w.start[TRIP / 2]; n < w.start[TRIP]; n++)
            w.j[n] = ROWS - 2 - w.j[n];
        redcc_memory_fail_after(failure + 14);
        compare(&w, 2);
        redcc_memory_fail_after(-1);
        assert_true(state()->binning.rounds > 0);
        free_work(&w);
    }
    redcc_bins_tuning = usual;
}

static void errors_of_functions(void **unused) {
    (void)unused;
    struct work w = new_work(6, 3);
    memcpy(&now, &before, sizeof now);
    redcc_bins_tuning.round = 1000;
    errno = ERANGE;
    assert_true(run(&w, 3));
    assert_int_equal(errno, ERANGE);
    w.value[w.start[TRIP / 2]] = WRONG;
    assert_true(run(&w, 3));
    assert_int_equal(errno, EDOM);
    redcc_bins_tuning = usual;
    free_work(&w);
}

/* One row far below the others: the loop itself, in memory of which hardly anything is there. */
static void rows_far_apart(void **unused) {
    (void)unused;
    const size_t distance = (size_t)1 << 38, room = 1 << 16;
    char *all =
        mmap(NULL, distance + room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    assert_ptr_not_equal(all, MAP_FAILED);
    assert_int_equal(mprotect(all, room, PROT_READ | PROT_WRITE), 0);
    assert_int_equal(mprotect(all + distance, room, PROT_READ | PROT_WRITE), 0);
    const redcc_int far = (redcc_int)(distance / sizeof(double));
    assert_int_equal(redcc_window(&streams[1], (struct row_range){0, far}, 0, 2, 1, 1000).rows, 0);
    const struct row_range widest = {INT64_MIN, INT64_MAX};
    assert_int_equal(redcc_window(&streams[1], widest, 0, 2, 1, 1000).rows, 0);
    const struct row_range many = {0, 1 << 20};
    assert_int_equal(redcc_window(&streams[1], many, 0, 1, 1, 10).shift, 15); /* and a tag */
    struct work w = new_work(12, 1);
    w.other = (double *)(void *)all;
    w.k[0] = 0;
    for (int n = 0; n < w.start[TRIP]; n++)
        w.j[n] = w.j[n] % 100;
    assert_true(run(&w, 2));
    munmap(all, distance + room);
    free_work(&w);
}

static void loops_without_the_form_are_left_alone(void **unused) {
    (void)unused;
    struct work w = new_work(12, 1);
    loop.loop.flags &= ~(unsigned)REDCC_BINNED;
    assert_false(compare(&w, 2));
    assert_int_equal(fallbacks(REASON_NO_BINS), 1);
    free_work(&w);
    loop.loop.flags |= REDCC_BINNED;
}

int main(void) {
    usual = redcc_bins_tuning;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(records_of_several_arrays_and_updates),
        cmocka_unit_test(late_guard),
        cmocka_unit_test(reads_before_writes),
        cmocka_unit_test(fewer_threads_come),
        cmocka_unit_test(streams_overlap),
        cmocka_unit_test(memory_does_not_suffice),
        cmocka_unit_test(records_are_many_all_at_once),
        cmocka_unit_test(failing_memory),
        cmocka_unit_test(memory_fails_in_the_middle),
        cmocka_unit_test(errors_of_functions),
        cmocka_unit_test(rows_far_apart),
        cmocka_unit_test(loops_without_the_form_are_left_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
