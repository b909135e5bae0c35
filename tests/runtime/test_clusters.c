/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Clusters of the access graph are compared with direct counts after each round, for a mesh, a path
 * and random iterations, with one thread and with several. */
#include "ownership/graph/clusters.h"

#include "base/memory.h"
#include "ownership/graph/neighbours.h"
#include "problem.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { UNITS = 900, ITERATIONS = 2000, MOST_EACH = 6, THREADS_MOST = 5 };

/* The units that each iteration touches, each unit once. */
struct touched {
    int iterations;
    uint32_t count[ITERATIONS];
    uint32_t unit[ITERATIONS][MOST_EACH];
};

static void add(struct touched *it, uint32_t count, const uint32_t *unit) {
    it->count[it->iterations] = count;
    memcpy(it->unit[it->iterations++], unit, count * sizeof *unit);
}

/* Makes two triangles per square of 30 x 30 nodes; every tenth iteration touches nothing. */
static void make_mesh(struct touched *it) {
    for (uint32_t node = 0; node + 31 < UNITS; node++) {
        if (node % 30 == 29)
            continue;
        add(it, 3, (const uint32_t[]){node, node + 1, node + 31});
        if (node % 10 == 0)
            add(it, 0, &node);
        add(it, 3, (const uint32_t[]){node, node + 31, node + 30});
    }
}

/* Makes the mesh and a unit that all iterations touch, whose cluster is soon full. */
static void make_hub(struct touched *it) {
    make_mesh(it);
    for (int i = 0; i < it->iterations; i++)
        it->unit[i][it->count[i]++] = UNITS - 1;
}

static void make_path(struct touched *it) {
    for (uint32_t node = 0; node + 1 < UNITS; node++)
        add(it, 2, (const uint32_t[]){node, node + 1});
}

/* Makes random touches: some units are never touched, and one is touched by every second
 * iteration. */
static void make_random(struct touched *it) {
    unsigned long random = 88172645463325252u;
    for (int i = 0; i < ITERATIONS; i++) {
        uint32_t unit[MOST_EACH], count = 0;
        for (unsigned long n = next_random(&random) % MOST_EACH; n > 0; n--) {
            const uint32_t next = (uint32_t)(next_random(&random) % (UNITS - 100)) + 50;
            unit[count] = i % 2 && count == 0 ? 7 : next;
            bool there = false;
            for (uint32_t before = 0; before < count; before++)
                there = there || unit[before] == unit[count];
            count += !there;
        }
        add(it, count, unit);
    }
}

static void tell(const struct touched *it, struct access_log *logged, int threads) {
    memset(logged, 0, (size_t)threads * sizeof *logged);
    for (int thread = 0; thread < threads; thread++)
        for (int i = it->iterations * thread / threads; i < it->iterations * (thread + 1) / threads;
             i++) {
            uint32_t unit[MOST_EACH] = {REDCC_NO_UNIT};
            const uint32_t count = it->count[i] ? it->count[i] : 1;
            memcpy(unit, it->unit[i], it->count[i] * sizeof *unit);
            unit[count - 1] |= REDCC_LAST;
            assert_true(redcc_unit_list_add(&logged[thread].leading, unit, count));
        }
}

static uint32_t root_of(uint32_t *parent, uint32_t unit) {
    while (parent[unit] != unit)
        unit = parent[unit];
    return unit;
}

/* Checks for each cluster that iterations connect its units, without units of other clusters
 * between them. */
static void check_connected(const struct touched *it, const struct clusters *clusters) {
    uint32_t parent[UNITS];
    for (uint32_t unit = 0; unit < UNITS; unit++)
        parent[unit] = unit;
    for (int i = 0; i < it->iterations; i++)
        for (uint32_t a = 0; a < it->count[i]; a++)
            for (uint32_t b = 0; b < a; b++)
                if (clusters->of[it->unit[i][a]] == clusters->of[it->unit[i][b]])
                    parent[root_of(parent, it->unit[i][a])] = root_of(parent, it->unit[i][b]);
    uint32_t *root = calloc(clusters->count, sizeof *root);
    for (uint32_t unit = 0; unit < UNITS; unit++) {
        const uint32_t of = clusters->of[unit], mine = root_of(parent, unit) + 1;
        if (of == REDCC_NO_UNIT)
            continue;
        assert_true(root[of] == 0 || root[of] == mine);
        root[of] = mine;
    }
    free(root);
}

/* Checks the number of units in each cluster, and the weights. */
static void check_counts(const struct touched *it, const struct clusters *clusters) {
    uint32_t *size = calloc(clusters->count, sizeof *size);
    uint32_t *weight = calloc(clusters->count, sizeof *weight);
    bool touched[UNITS] = {false};
    for (int i = 0; i < it->iterations; i++)
        for (uint32_t a = 0; a < it->count[i]; a++) {
            touched[it->unit[i][a]] = true;
            assert_in_range(clusters->of[it->unit[i][a]], 0, clusters->count - 1);
            weight[clusters->of[it->unit[i][a]]] += redcc_work_of(it->count[i]);
        }
    for (uint32_t unit = 0; unit < UNITS; unit++) {
        assert_int_equal(clusters->of[unit] == REDCC_NO_UNIT, !touched[unit]);
        if (touched[unit])
            size[clusters->of[unit]]++;
    }
    for (uint32_t cluster = 0; cluster < clusters->count; cluster++) {
        assert_in_range(size[cluster], 1, clusters->most);
        assert_int_equal(clusters->size[cluster], size[cluster]);
        assert_int_equal(clusters->share[0].weight[cluster], weight[cluster]);
    }
    free(size);
    free(weight);
}

/* Checks that exactly the iterations of several clusters are listed, in order. */
static void check_lists(const struct touched *it, const struct clusters *clusters) {
    int thread = 0;
    size_t at = 0;
    for (int i = 0; i < it->iterations; i++) {
        bool several = false;
        for (uint32_t a = 1; a < it->count[i]; a++)
            several = several || clusters->of[it->unit[i][a]] != clusters->of[it->unit[i][0]];
        if (!several)
            continue;
        for (; at == clusters->share[thread].list.count; at = 0)
            thread++;
        for (uint32_t a = 0; a < it->count[i]; a++, at++)
            assert_int_equal(clusters->share[thread].list.item[at],
                             clusters->of[it->unit[i][a]] |
                                 (a + 1 == it->count[i] ? REDCC_LAST : 0));
    }
    assert_int_equal(at, clusters->share[thread].list.count);
}

/* Joins clusters until there are at most `most`. Returns the number of rounds. Sets `of` [UNITS] to
 * the units' clusters and *count to the number of clusters. */
static int cluster(const struct touched *it, uint32_t most, int threads, uint32_t *of,
                   uint32_t *count) {
    static struct access_log logged[THREADS_MOST];
    struct clusters clusters;
    tell(it, logged, threads);
    assert_true(redcc_clusters_begin(&clusters, UNITS, most, logged, threads));
    for (int thread = 0; thread < threads; thread++)
        redcc_clusters_choose(&clusters, thread);
    redcc_clusters_agree(&clusters, 0, UNITS);
    while (redcc_clusters_join(&clusters)) {
        redcc_clusters_place(&clusters, 0, UNITS / 2);
        redcc_clusters_place(&clusters, UNITS / 2, UNITS);
        for (int thread = 0; thread < threads; thread++)
            redcc_clusters_map(&clusters, thread);
        redcc_clusters_agree(&clusters, 0, clusters.count / 3);
        redcc_clusters_agree(&clusters, clusters.count / 3, clusters.count);
        check_connected(it, &clusters);
        check_counts(it, &clusters);
        check_lists(it, &clusters);
    }
    const int rounds = clusters.rounds;
    memcpy(of, clusters.of, UNITS * sizeof *of);
    *count = clusters.count;
    redcc_clusters_end(&clusters);
    for (int thread = 0; thread < threads; thread++)
        redcc_unit_list_end(&logged[thread].leading);
    assert_int_equal(redcc_memory_live(), 0);
    return rounds;
}

/* Checks that clusters are the same with any number of threads, and that there are at most
 * `count_most` after at least `rounds_least` rounds. */
static void check_all(void (*make)(struct touched *), uint32_t most, uint32_t count_most,
                      int rounds_least) {
    struct touched *it = calloc(1, sizeof *it);
    uint32_t alone[UNITS], several[UNITS], count;
    make(it);
    const int rounds = cluster(it, most, 1, alone, &count);
    assert_in_range(rounds, rounds_least, 6);
    assert_in_range(count, 2, count_most);
    for (int threads = 2; threads <= THREADS_MOST; threads++) {
        assert_int_equal(cluster(it, most, threads, several, &count), rounds);
        assert_memory_equal(several, alone, sizeof alone);
    }
    free(it);
}

static void meshes(void **unused) {
    (void)unused;
    check_all(make_mesh, 32, 70, 2);
    check_all(make_mesh, 4, 700, 1);
}

static void a_unit_that_all_touch(void **unused) {
    (void)unused;
    check_all(make_hub, 8, 200, 2);
    check_all(make_hub, 32, 60, 2);
}

static void paths(void **unused) {
    (void)unused;
    check_all(make_path, 32, 90, 2);
    check_all(make_path, 1, UNITS, 1);
}

static void random_iterations(void **unused) {
    (void)unused;
    check_all(make_random, 16, 180, 1);
    check_all(make_random, 64, 120, 1);
}

/* Lists grow to any number of items; logging stops at a limit. */
static void lists_grow(void **unused) {
    (void)unused;
    struct unit_list list = {0};
    for (uint32_t i = 0; i < 1000; i++)
        assert_true(redcc_unit_list_add(&list, (const uint32_t[]){2 * i, 2 * i + 1}, 2));
    assert_int_equal(list.count, 2000);
    for (uint32_t i = 0; i < 2000; i++)
        assert_int_equal(list.item[i], i);
    redcc_unit_list_end(&list);
    assert_int_equal(redcc_memory_live(), 0);
}

enum { ROWS = 4000, MOST_KEPT = 1000 };
static char row[8 * ROWS];

static void begin_told(struct access_log *logged, struct units *units, struct partition *partition,
                       struct range *seen) {
    static const redcc_array arrays[] = {{"row", REDCC_SUM, REDCC_DOUBLE, 8, 8, 0}};
    static const redcc_loop loop = {.arrays = arrays, .array_count = 1};
    void *const bases[] = {row};
    const struct range touched = {(uintptr_t)row, (uintptr_t)(row + 8 * ROWS)};
    *seen = redcc_nowhere;
    assert_true(redcc_partition_begin(partition, &loop, bases, 2));
    assert_true(redcc_units_begin(units, partition, &touched));
    assert_true(redcc_access_log_begin(logged, units, partition, seen, 0, (const size_t[]){0, 0},
                                       MOST_KEPT));
}

static void end_told(struct access_log *logged, struct units *units, struct partition *partition) {
    redcc_access_log_end(logged);
    redcc_units_end(units);
    redcc_partition_end(partition);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Records two rows per iteration; the preceding iteration has touched the first of them. */
static void tell_rows(struct access_log *logged, uint32_t first, uint32_t end) {
    for (uint32_t r = first; r < end; r++) {
        const redcc_entry entries[] = {{row + 8 * r, 0, 8},
                                       {row + 8 * (r + 1), 0, 8},
                                       {row + 8 * r, 0, 8},
                                       {0, REDCC_END_OF_ITERATION, 0}};
        redcc_access_log_take(logged, entries, entries + 4);
    }
}

static void touches_are_kept_up_to_a_limit(void **unused) {
    (void)unused;
    struct partition partition;
    struct units units;
    struct access_log logged;
    struct range seen;
    begin_told(&logged, &units, &partition, &seen);
    tell_rows(&logged, 0, 400);
    assert_false(logged.too_much || logged.failed || logged.beyond);
    assert_int_equal(logged.leading.count, 800);
    for (uint32_t r = 0; r < 400; r++) {
        assert_int_equal(logged.leading.item[2 * r], r);
        assert_int_equal(logged.leading.item[2 * r + 1], (r + 1) | REDCC_LAST);
    }
    tell_rows(&logged, 400, 1200);
    assert_true(logged.too_much && !logged.failed);
    assert_in_range(logged.leading.count, MOST_KEPT, 2 * MOST_KEPT + 64);
    assert_int_equal(logged.iterations, 1200);
    end_told(&logged, &units, &partition);
    begin_told(&logged, &units, &partition, &seen);
    redcc_memory_fail_after(0);
    tell_rows(&logged, 0, 400);
    redcc_memory_fail_after(-1);
    assert_true(logged.failed && !logged.too_much);
    end_told(&logged, &units, &partition);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(meshes),     cmocka_unit_test(a_unit_that_all_touch),
        cmocka_unit_test(paths),      cmocka_unit_test(random_iterations),
        cmocka_unit_test(lists_grow), cmocka_unit_test(touches_are_kept_up_to_a_limit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
