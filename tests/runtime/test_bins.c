/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* In-order binning against the plain loop, bit for bit: every operator and type, 1 to 33 threads,
 * rounds of every size, bins of one row up to one bin for all rows, direct pushes and write
 * combining. Run with REDCC_METHOD=binning, binning:records and binning:copies. */
#include "base/bins_kind.h"
#include "base/memory.h"
#include "binned.h"
#include "bins/window.h"
#include "loop.h"
#include "problem.h"
#include "settings.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

struct row {
    double x, y, z;
};
struct pair {
    int count;
    float sum;
};

BINNED_LOOP(double_sum, double, double, REDCC_SUM, REDCC_DOUBLE, 0, *r += e)
BINNED_LOOP(double_less, double, double, REDCC_SUM, REDCC_DOUBLE, 0, *r -= e)
BINNED_LOOP(double_product, double, double, REDCC_PRODUCT, REDCC_DOUBLE, 0, *r *= e)
BINNED_LOOP(double_minimum, double, double, REDCC_MINIMUM, REDCC_DOUBLE, 0, if (e < *r) *r = e)
BINNED_LOOP(double_maximum, double, double, REDCC_MAXIMUM, REDCC_DOUBLE, 0, if (*r < e) *r = e)
BINNED_LOOP(double_from, double, double, REDCC_SUM, REDCC_OTHER_TYPE, 0, *r = e - *r)
BINNED_LOOP(double_affine, double, double, REDCC_SUM, REDCC_OTHER_TYPE, 0, *r = *r * by + e)
BINNED_LOOP(double_store, double, double, REDCC_SUM, REDCC_OTHER_TYPE, 0, *r = e)
BINNED_LOOP(float_sum, float, float, REDCC_SUM, REDCC_FLOAT, 0, *r += e)
BINNED_LOOP(float_by_double, float, double, REDCC_SUM, REDCC_FLOAT, 0, *r = (float)(*r + e))
BINNED_LOOP(rounded, int, double, REDCC_SUM, REDCC_OTHER_TYPE, 0,
            *r = (int)((double)(*r % 1000) + e * 0x1p-60))
BINNED_LOOP(int8_sum, int8_t, int, REDCC_SUM, REDCC_INT8, 1, *r = (int8_t)(*r + e))
BINNED_LOOP(uint8_product, uint8_t, int, REDCC_PRODUCT, REDCC_UINT8, 1,
            *r = (uint8_t)((unsigned)*r * (unsigned)e))
BINNED_LOOP(int16_maximum, int16_t, int16_t, REDCC_MAXIMUM, REDCC_INT16, 1, if (e > *r) *r = e)
BINNED_LOOP(uint16_or, uint16_t, uint16_t, REDCC_OR, REDCC_UINT16, 1, *r = (uint16_t)(*r | e))
BINNED_LOOP(int32_minimum, int32_t, int32_t, REDCC_MINIMUM, REDCC_INT32, 1, if (e < *r) *r = e)
BINNED_LOOP(uint32_sum, uint32_t, uint32_t, REDCC_SUM, REDCC_UINT32, 1, *r += e)
BINNED_LOOP(uint32_and, uint32_t, uint32_t, REDCC_AND, REDCC_UINT32, 1, *r &= e)
BINNED_LOOP(int64_xor, int64_t, int64_t, REDCC_XOR, REDCC_INT64, 1, *r ^= e)
BINNED_LOOP(uint64_sum, uint64_t, uint64_t, REDCC_SUM, REDCC_UINT64, 1, *r += e)
BINNED_LOOP(uint64_last, uint64_t, uint64_t, REDCC_SUM, REDCC_UINT64, 0, *r = *r * 31 + e)
BINNED_LOOP(struct_row, struct row, struct row, REDCC_SUM, REDCC_OTHER_TYPE, 0, r->x += e.x;
            r->y = e.y - r->y; r->z += e.z)
BINNED_LOOP(struct_pair, struct pair, float, REDCC_SUM, REDCC_OTHER_TYPE, 0, r->count++;
            r->sum += e)

BINNED_LOOP(float_said_exact, float, float, REDCC_SUM, REDCC_FLOAT, 1, *r += e)

static const struct binned_loop *const loops[] = {
    &double_sum,    &double_less,   &double_product, &double_minimum, &double_maximum,
    &double_from,   &double_affine, &double_store,   &float_sum,      &float_by_double,
    &rounded,       &int8_sum,      &uint8_product,  &int16_maximum,  &uint16_or,
    &int32_minimum, &uint32_sum,    &uint32_and,     &int64_xor,      &uint64_sum,
    &uint64_last,   &struct_row,    &struct_pair};
enum { LOOPS = sizeof loops / sizeof *loops };

static const int thread_counts[] = {1, 2, 3, 7, 16, 33};
enum { COUNTS = sizeof thread_counts / sizeof *thread_counts };

static const double by = 0.875;
static const struct bins_tuning *usual; /* the default of redcc_bins_tuning */
static struct bins_tuning usual_tuning;

/* ---- data ------------------------------------------------------------------------------------ */

struct data {
    struct binned_problem problem;
    const struct binned_loop *loop;
    int rows;
    char *before, *expected, *memory; /* [rows] */
    size_t bytes;
};

/* Returns a NaN made by the processor, which has the same bits each time. */
static double no_number(void) {
    volatile double infinite = __builtin_inf();
    return infinite - infinite;
}

static double some_double(unsigned long *state) {
    static const double special[] = {0.0, -0.0, 1e308, -1e308, 5e-324, 1.0, -1.0};
    const unsigned long kind = next_random(state) % 64;
    if (kind < 7)
        return special[kind];
    if (kind == 7)
        return __builtin_inf();
    if (kind == 8)
        return no_number();
    return ((double)next_random(state) - 0x1p63) * 0x1p-50;
}

static void fill(const struct binned_loop *loop, char *to, size_t count, size_t bytes,
                 unsigned long *state) {
    const bool floating = loop == &float_sum || loop == &struct_pair;
    const bool doubles = strncmp(loop->name, "double", 6) == 0 || loop == &struct_row;
    for (size_t i = 0; i < count * bytes; i++)
        to[i] = (char)(next_random(state) >> 17);
    for (size_t i = 0; floating && i < count * bytes / 4; i++) {
        const float value = (float)(int)(next_random(state) % 2000) - 1000.25f;
        memcpy(to + 4 * i, &value, 4);
    }
    for (size_t i = 0; doubles && i < count * bytes / 8; i++) {
        const double value = some_double(state);
        memcpy(to + 8 * i, &value, 8);
    }
    for (size_t i = 0; (loop == &float_by_double || loop == &rounded) && i < count * bytes / 8;
         i++) {
        const double value = (double)(long)(next_random(state) >> 40) * 1.1;
        memcpy(to + 8 * i, &value, 8);
    }
    if (loop == &float_by_double && bytes == 4)
        memset(to, 0, count * bytes);
}

/* Subscripts: uniform, mostly the same, ascending, or of two rows only. */
enum { UNIFORM, SKEWED, ASCENDING, TWO_ROWS, KINDS };

static int subscript(int kind, redcc_int t, redcc_int trip, int rows, unsigned long *state) {
    const int any = (int)(next_random(state) % (unsigned long)rows);
    switch (kind) {
    case SKEWED:
        return next_random(state) % 8 ? rows / 3 : any;
    case ASCENDING:
        return (int)(t * rows / trip);
    case TWO_ROWS:
        return any % 2 ? 0 : rows - 1;
    default:
        return any;
    }
}

static struct data new_data(const struct binned_loop *loop, int rows, redcc_int trip, int kind,
                            unsigned long seed) {
    unsigned long state = seed * 977 + 5;
    struct data it = {.loop = loop, .rows = rows, .bytes = (size_t)rows * loop->row};
    int *k = malloc((size_t)trip * sizeof *k);
    char *value = malloc((size_t)trip * loop->record);
    it.before = malloc(it.bytes);
    it.expected = malloc(it.bytes);
    it.memory = malloc(it.bytes);
    for (redcc_int t = 0; t < trip; t++)
        k[t] = subscript(kind, t, trip, rows, &state) - rows / 2;
    fill(loop, value, (size_t)trip, loop->record, &state);
    fill(loop, it.before, (size_t)rows, loop->row, &state);
    it.problem = (struct binned_problem){.trip = trip,
                                         .k = k,
                                         .value = value,
                                         .rows = it.expected + (size_t)(rows / 2) * loop->row,
                                         .by = &by};
    memcpy(it.expected, it.before, it.bytes);
    loop->oracle(&it.problem);
    it.problem.rows = it.memory + (size_t)(rows / 2) * loop->row;
    return it;
}

static void free_data(struct data *it) {
    free((void *)it->problem.k);
    free((void *)it->problem.value);
    free(it->before);
    free(it->expected);
    free(it->memory);
    redcc_loop_forget(&it->loop->descriptor->loop);
}

static const struct loop_state *state_of(const struct binned_loop *loop) {
    return loop->descriptor->loop.state;
}

/* Returns the number of rounds that the execution had. */
static long compare(struct data *it, int threads) {
    int last = 0;
    memcpy(it->memory, it->before, it->bytes);
    const bool done = it->loop->run(&it->problem, threads, &last);
    const bool may_refuse = threads == 1 && redcc_settings()->parameter == BINS_EITHER;
    assert_true(done || may_refuse);
    if (!done)
        it->loop->oracle(&it->problem);
    else
        assert_true(last > 0);
    if (memcmp(it->memory, it->expected, it->bytes) != 0)
        fail_msg("%s: other bits by %d threads, trip %lld", it->loop->name, threads,
                 it->problem.trip);
    return state_of(it->loop)->binning.rounds;
}

/* ---- tests ----------------------------------------------------------------------------------- */

static void every_operator(void **unused) {
    (void)unused;
    for (int l = 0; l < LOOPS; l++)
        for (int kind = 0; kind < KINDS; kind++) {
            struct data data = new_data(loops[l], 701, 6000, kind, (unsigned long)(l + 1));
            for (int c = 0; c < COUNTS; c++)
                compare(&data, thread_counts[c]);
            free_data(&data);
        }
}

static bool takes_copies(const struct binned_loop *loop) {
    return loop->descriptor->streams->exact && redcc_settings()->parameter != BINS_RECORDS;
}

static void rounds_of_every_size(void **unused) {
    (void)unused;
    static const redcc_int sizes[] = {1, 2, 7, 100, 1999, 5000};
    for (int l = 0; l < LOOPS; l += 5)
        for (int i = 0; i < 6; i++) {
            struct data data = new_data(loops[l], 90, 300, i % KINDS, (unsigned long)i);
            redcc_bins_tuning.round = sizes[i];
            for (int c = 1; c < COUNTS - 1; c++) {
                const long rounds = compare(&data, thread_counts[c]);
                if (!takes_copies(loops[l]))
                    assert_true(rounds >= 300 / sizes[i]);
            }
            free_data(&data);
        }
    redcc_bins_tuning = *usual;
}

static void bins_of_every_size(void **unused) {
    (void)unused;
    redcc_bins_tuning.least_budget = (size_t)4 << 30; /* hardly any of this memory is touched */
    for (int l = 0; l < LOOPS; l++)
        for (uint32_t bits = 0; bits <= 12; bits += 3)
            for (uint32_t direct = 0; direct <= 4096; direct += 4096) {
                struct data data = new_data(loops[l], 1300, 9000, (int)(bits % KINDS), bits);
                redcc_bins_tuning.bin_bits = bits;
                redcc_bins_tuning.direct_bins = direct;
                compare(&data, 2);
                compare(&data, 7);
                free_data(&data);
            }
    redcc_bins_tuning = *usual;
}

static void random_problems(void **unused) {
    (void)unused;
    unsigned long state = 4711;
    for (int n = 0; n < 150; n++) {
        const struct binned_loop *loop = loops[next_random(&state) % LOOPS];
        const int rows = 1 + (int)(next_random(&state) % 5000);
        const redcc_int trip = 1 + (redcc_int)(next_random(&state) % 40000);
        struct data data = new_data(loop, rows, trip, n % KINDS, next_random(&state));
        const bool small = n % 4 == 0; /* small bins; otherwise the budget limits the bins */
        redcc_bins_tuning.bin_bits = small ? 3 + (uint32_t)(next_random(&state) % 4) : 16;
        redcc_bins_tuning.direct_bins = n % 2 ? 0 : 288;
        redcc_bins_tuning.round = n % 3 ? INT64_MAX : 1 + trip / 3;
        redcc_bins_tuning.least_budget = (size_t)1 << (small ? 32 : 20 + n % 5);
        redcc_bins_tuning.trial = n % 7 ? 0 : n % 2 ? INFINITY : -INFINITY;
        /* what an execution has learned is used in the next one, also with other numbers of
         * threads */
        for (int call = 0; call < 3; call++)
            compare(&data, thread_counts[1 + (n + call) % (COUNTS - 2)]);
        free_data(&data);
    }
    redcc_bins_tuning = *usual;
    assert_int_equal(redcc_memory_live(), 0);
}

/* If binning must lose its trial, it ends after one round and the sequential part of the trial. If
 * it must gain, it continues to the end, in longer rounds. */
static void trials(void **unused) {
    (void)unused;
    for (int l = 0; l < LOOPS; l++) {
        struct data data = new_data(loops[l], 701, 6000, l % KINDS, (unsigned long)(l + 1));
        for (int c = 1; c < COUNTS; c += 2)
            for (int gains = 0; gains < 2; gains++) {
                redcc_bins_tuning.trial = gains ? INFINITY : -INFINITY;
                const long rounds = compare(&data, thread_counts[c]);
                const struct binning *binning = &state_of(loops[l])->binning;
                assert_int_equal(binning->reason, gains ? REASON_NONE : REASON_SERIAL_FASTER);
                assert_int_equal(binning->round.begin == 6000, gains);
                assert_int_equal(rounds, gains ? 4 : 1);
            }
        free_data(&data);
    }
    redcc_bins_tuning = *usual;
}

/* Between executions the subscripts change to other rows, and the loop becomes longer or shorter.
 */
static void other_subscripts(void **unused) {
    (void)unused;
    int last;
    enum { ROWS = 40000, TRIP = 20000 };
    struct data all = new_data(&double_sum, ROWS, TRIP, UNIFORM, 3);
    int *k = malloc(TRIP * sizeof *k);
    for (int call = 0; call < 12; call++) {
        struct binned_problem here = all.problem;
        const int span = call % 3 ? 1 + call * call * 20 : ROWS / 2;
        for (int t = 0; t < TRIP; t++)
            k[t] = all.problem.k[t] / (ROWS / 2 / span + 1) + (call % 2 ? ROWS / 4 : -ROWS / 4);
        here.k = k;
        here.trip = call % 4 == 1 ? 100 : TRIP - call;
        memcpy(all.expected, all.before, all.bytes);
        here.rows = all.expected + ROWS / 2 * sizeof(double);
        double_sum.oracle(&here);
        memcpy(all.memory, all.before, all.bytes);
        here.rows = all.memory + ROWS / 2 * sizeof(double);
        assert_true(double_sum.run(&here, 2 + call % 3, &last));
        assert_memory_equal(all.memory, all.expected, all.bytes);
    }
    free(k);
    free_data(&all);
}

static void small_integers_are_copied(void **unused) {
    (void)unused;
    struct data data = new_data(&uint32_sum, 4096, 100000, UNIFORM, 8);
    compare(&data, 2);
    const bool copies = redcc_settings()->parameter != BINS_RECORDS;
    assert_int_equal(state_of(&uint32_sum)->binning.copies.count > 0, copies);
    redcc_bins_tuning.copies_bytes = 4096;
    compare(&data, 2);
    assert_int_equal(state_of(&uint32_sum)->binning.copies.count > 0,
                     redcc_settings()->parameter == BINS_COPIES);
    redcc_bins_tuning = *usual;
    free_data(&data);
    data = new_data(&float_sum, 4096, 100000, UNIFORM, 8);
    compare(&data, 2);
    assert_false(state_of(&float_sum)->binning.copies.count);
    free_data(&data);
}

/* The subscripts lie directly behind the rows. A margin of the copies would overlap them, so the
 * copies get no margin. */
static void copies_beside_what_is_read(void **unused) {
    (void)unused;
    struct data data = new_data(&uint32_sum, 4096, 100000, UNIFORM, 8);
    char *memory = malloc(data.bytes + 100000 * sizeof(int));
    int *k = (int *)(void *)(memory + data.bytes), last;
    memcpy(memory, data.before, data.bytes);
    memcpy(k, data.problem.k, 100000 * sizeof *k);
    struct binned_problem beside = data.problem;
    beside.rows = memory + data.bytes / 2;
    beside.k = k;
    assert_true(uint32_sum.run(&beside, 2, &last));
    assert_memory_equal(memory, data.expected, data.bytes);
    const struct private_copies *copies = &state_of(&uint32_sum)->binning.copies;
    assert_int_equal(copies->count > 0, takes_copies(&uint32_sum));
    assert_int_equal(copies->are_tight, takes_copies(&uint32_sum));
    free(memory);
    free_data(&data);
}

/* Rows outside the expected range are found only because rounds fail, several times. Rows that do
 * not exist are never copied: no memory is mapped behind the array. */
static void rows_are_found_late(void **unused) {
    (void)unused;
    enum { TRIP = 600000, STEP = 20000, PAGE = 4096 };
    int *k = malloc(TRIP * sizeof *k), last;
    uint32_t *value = calloc(TRIP, sizeof *value), *expected = calloc(PAGE / 4, 4);
    char *pages = mmap(NULL, 2 * PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_ptr_not_equal(pages, MAP_FAILED);
    assert_int_equal(mprotect(pages + PAGE, PAGE, PROT_NONE), 0);
    for (int t = 0; t < TRIP; t++) {
        const int late = t % STEP == STEP - 77 ? t / STEP + 1 : 0;
        k[t] = -31 + late;
        value[t] = (uint32_t)t;
        expected[PAGE / 4 + k[t]] += value[t];
    }
    const struct binned_problem problem = {
        .trip = TRIP, .k = k, .value = value, .rows = pages + PAGE, .by = &by};
    assert_true(uint32_sum.run(&problem, 2, &last));
    assert_memory_equal(pages, expected, PAGE);
    free(k);
    free(value);
    free(expected);
    munmap(pages, 2 * PAGE);
    redcc_loop_forget(&uint32_sum.descriptor->loop);
}

/* All work is in the first or in the last iterations: idle threads execute blocks of it, whose
 * records are applied in order. */
static void uneven_iterations(void **unused) {
    (void)unused;
    int stolen = 0;
    for (int l = 0; l < LOOPS; l++) {
        struct data data = new_data(loops[l], 301, 3000, l % KINDS, (unsigned long)(l + 1));
        data.problem.slow = l % 2 ? 40 : -40;
        for (int c = 1; c < COUNTS - 2; c++) {
            compare(&data, thread_counts[c]);
            for (int t = 0; t < thread_counts[c]; t++)
                for (int piece = 0; piece < SHARE_PIECES; piece++)
                    stolen += state_of(loops[l])->binning.binner[t]->share.piece[piece].thread != t;
        }
        free_data(&data);
    }
    assert_true(stolen > 0);
}

/* Floating-point sums are never made on copies, even if the descriptor says `exact`, since their
 * order matters. */
static void floats_are_never_copied(void **unused) {
    (void)unused;
    struct data data = new_data(&float_said_exact, 500, 20000, UNIFORM, 8);
    compare(&data, 3);
    assert_false(state_of(&float_said_exact)->binning.copies.count);
    free_data(&data);
}

/* A trial in a single round is given up if pushing is expected to take 0.8 of the sequential loop's
 * time, with what preceded it. Work that was stolen makes the pushed fraction larger than 1. */
static void slow_pushing_is_given_up(void **unused) {
    (void)unused;
    const struct bins_trial trial = {.usual = 1e-6, .began = 10, .pushes = 10.1}; /* 1 s in all */
    assert_false(redcc_bins_are_late(&trial, 1e6, 0.25, 10.1 + 0.17));
    assert_true(redcc_bins_are_late(&trial, 1e6, 0.25, 10.1 + 0.18));
    assert_false(redcc_bins_are_late(&trial, 1e6, 1, 10.1 + 0.69));
    assert_true(redcc_bins_are_late(&trial, 1e6, 1, 10.1 + 0.71));
    assert_true(redcc_bins_are_late(&trial, 1e6, 2, 10.1 + 0.71));
}

/* Measuring the last iteration does not prevent the thread that executes it from claiming it. */
static void the_last_iteration_is_claimed(void **unused) {
    (void)unused;
    struct data data = new_data(&double_sum, 500, 2000, UNIFORM, 8);
    for (int call = 0; call < 3; call++) {
        int last = 0;
        assert_true(double_sum.run(&data.problem, 2, &last));
        assert_int_equal(last, call == 0 ? 2 : 1);
    }
    free_data(&data);
}

int main(void) {
    usual_tuning = redcc_bins_tuning;
    usual = &usual_tuning;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(floats_are_never_copied),
        cmocka_unit_test(the_last_iteration_is_claimed),
        cmocka_unit_test(slow_pushing_is_given_up),
        cmocka_unit_test(every_operator),
        cmocka_unit_test(rounds_of_every_size),
        cmocka_unit_test(bins_of_every_size),
        cmocka_unit_test(random_problems),
        cmocka_unit_test(trials),
        cmocka_unit_test(other_subscripts),
        cmocka_unit_test(small_integers_are_copied),
        cmocka_unit_test(rows_are_found_late),
        cmocka_unit_test(uneven_iterations),
        cmocka_unit_test(copies_beside_what_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
