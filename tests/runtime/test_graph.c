/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Owners cut from the access graph of shuffled meshes, with and without
 * REDCC_METHOD=graph-localwrite. */
#include "base/memory.h"
#include "loop.h"
#include "ownership/graph/bisect.h"
#include "plan_check.h"
#include "problem.h"
#include "settings.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { NODES_AN_ITERATION = 3 };

/* A sheet of side * side nodes, with two triangles per square. */
struct mesh {
    int side;
    int sheets;      /* number of separate sheets */
    bool hub;        /* every iteration updates row 0 as well */
    bool gaps;       /* every third iteration updates nothing */
    bool two_arrays; /* each iteration also updates a row of a second array for each side of the
                        triangle */
};

static int *shuffled(int count, unsigned long *random) {
    int *place = malloc((size_t)count * sizeof *place);
    for (int i = 0; i < count; i++)
        place[i] = i;
    for (int i = count - 1; i > 0; i--) {
        const int j = (int)(next_random(random) % (unsigned long)(i + 1)), other = place[j];
        place[j] = place[i];
        place[i] = other;
    }
    return place;
}

/* Numbers a triangle side by its lower node and its direction: along, up or across the square. */
static int side_of(int a, int b, int side) {
    const int low = a < b ? a : b, apart = a < b ? b - a : a - b;
    return 3 * low + (apart == 1 ? 0 : apart == side ? 1 : 2);
}

static void add_triangle(struct problem *problem, const struct mesh *mesh, const int *node,
                         const int corner[3]) {
    for (int p = 0; p < NODES_AN_ITERATION; p++) {
        const long at = problem->touches++;
        problem->row[at] = mesh->hub && p == 0 ? 0 : node[corner[p]];
        problem->other[at] = side_of(corner[p], corner[(p + 1) % 3], mesh->side);
        problem->value[at] = (double)(at % 97) / 3.0;
    }
}

static struct problem mesh_problem(const struct mesh *mesh) {
    const int side = mesh->side, squares = (side - 1) * (side - 1);
    const int nodes = side * side * mesh->sheets, triangles = 2 * squares * mesh->sheets;
    unsigned long random = 88172645463325252u;
    int *node = shuffled(nodes, &random), *order = shuffled(triangles, &random);
    struct problem problem = {.name = "mesh", .trip = triangles, .rows = nodes, .width = 3};
    const size_t touches = (size_t)triangles * NODES_AN_ITERATION;
    problem.start = malloc(((size_t)triangles + 1) * sizeof(int));
    problem.row = malloc(touches * sizeof(int));
    problem.other = malloc(touches * sizeof(int));
    problem.value = malloc(touches * sizeof(double));
    for (int t = 0; t < triangles; t++) {
        const int number = order[t], square = number / 2 % squares, sheet = number / 2 / squares;
        const int here = sheet * side * side + square / (side - 1) * side + square % (side - 1);
        const int low[3] = {here, here + 1, here + side + 1};
        const int high[3] = {here, here + side + 1, here + side};
        problem.start[t] = (int)problem.touches;
        if (!mesh->gaps || t % 3 > 0)
            add_triangle(&problem, mesh, node, number % 2 ? high : low);
    }
    problem.start[triangles] = (int)problem.touches;
    problem.doubles = 3 * (long)nodes;
    problem.first = malloc((size_t)problem.doubles * sizeof(double));
    if (mesh->two_arrays) {
        problem.second_rows = 3 * nodes;
        problem.second_width = 2;
        problem.second = malloc(6 * (size_t)nodes * sizeof(double));
    }
    problem_reset(&problem);
    free(node);
    free(order);
    return problem;
}

/* Runs the loop twice, compares all bits with the expected result and checks the plan. Returns the
 * number of executed iterations divided by the trip count. Sets *most to the iterations of the most
 * loaded thread divided by an equal share. */
static double replication(const struct mesh *mesh, int threads, double *most) {
    struct problem problem = mesh_problem(mesh);
    struct described described;
    const size_t first = (size_t)problem.doubles,
                 second = (size_t)problem.second_rows * (size_t)problem.second_width;
    double *expected = malloc((first + second) * sizeof *expected);
    long last;
    problem_oracle(&problem);
    memcpy(expected, problem.first, first * sizeof *expected);
    if (second)
        memcpy(expected + first, problem.second, second * sizeof *expected);
    problem_describe(&problem, &described);
    for (int call = 0; call < 2; call++) {
        problem_reset(&problem);
        assert_int_equal(problem_run(&problem, &described, threads, &last), threads > 1);
        assert_memory_equal(problem.first, expected, first * sizeof *expected);
        if (second)
            assert_memory_equal(problem.second, expected + first, second * sizeof *expected);
    }
    const struct loop_state *state = described.loop.state;
    double executed = 1;
    *most = 1;
    if (threads > 1) {
        const struct plan *plan = state->cache.kept[0]->plan;
        check_plan(&problem, plan);
        assert_non_null(plan->map.owner);
        executed = (double)plan->executed / (double)problem.trip;
        *most = (double)plan->length * threads / (double)problem.trip;
    }
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    free(expected);
    assert_int_equal(redcc_memory_live(), 0);
    return executed;
}

static void few_iterations_have_several_owners(void **unused) {
    (void)unused;
    static const struct {
        int threads;
        double executed, most;
    } limits[] = {{1, 1.0, 1.0},   {2, 1.05, 1.05},  {3, 1.06, 1.1},
                  {7, 1.08, 1.15}, {16, 1.12, 1.22}, {33, 1.2, 1.35}};
    for (int arrays = 1; arrays <= 2; arrays++)
        for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
            const struct mesh mesh = {.side = 100, .sheets = 1, .two_arrays = arrays == 2};
            double most;
            const double executed = replication(&mesh, limits[i].threads, &most);
            assert_true(executed >= 1.0 && executed <= limits[i].executed);
            assert_true(most <= limits[i].most);
        }
}

static void sheets_that_do_not_touch(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 12, .sheets = 20};
    double most;
    assert_true(replication(&mesh, 4, &most) < 1.06);
    assert_true(most < 1.15);
}

static void iterations_that_update_nothing(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 40, .sheets = 1, .gaps = true, .two_arrays = true};
    double most;
    assert_true(replication(&mesh, 4, &most) < 1.0);
}

/* All iterations need the owner of row 0, but the other rows are still divided. */
static void a_row_that_all_update(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 60, .sheets = 1, .hub = true};
    double most;
    assert_true(replication(&mesh, 4, &most) < 2.0);
}

/* The same loop and number of owners must give the same plan, run by run. */
static void a_division_depends_on_the_loop_alone(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 30, .sheets = 1, .two_arrays = true};
    struct problem problem = mesh_problem(&mesh);
    unsigned char *map = NULL;
    uint32_t units = 0;
    for (int round = 0; round < 5; round++) {
        struct described described;
        long last;
        problem_describe(&problem, &described);
        assert_true(problem_run(&problem, &described, 7, &last));
        const struct plan *plan = ((struct loop_state *)described.loop.state)->cache.kept[0]->plan;
        units = plan->map.of[0].count + plan->map.of[1].count;
        if (round == 0) {
            map = malloc(units);
            memcpy(map, plan->map.owner, units);
        }
        assert_memory_equal(map, plan->map.owner, units);
        redcc_loop_forget(&described.loop);
    }
    free(map);
    problem_free(&problem);
}

/* A path of nodes of weights 1 to 3 is cut into consecutive parts of equal weight. */
static void a_path_is_cut_into_even_parts(void **unused) {
    (void)unused;
    enum { COUNT = 600, PARTS = 5 };
    static uint32_t start[COUNT + 1], neighbour[2 * COUNT], weight[COUNT];
    static unsigned char part[COUNT];
    uint32_t edges = 0, load[PARTS] = {0}, cuts = 0;
    for (uint32_t node = 0; node < COUNT; node++) {
        start[node] = edges;
        if (node > 0)
            neighbour[edges++] = node - 1;
        if (node + 1 < COUNT)
            neighbour[edges++] = node + 1;
        weight[node] = 1 + node % 3;
    }
    start[COUNT] = edges;
    const struct graph graph = {
        .count = COUNT, .start = start, .neighbour = neighbour, .weight = weight};
    assert_true(redcc_divide_graph(&graph, PARTS, 0, part));
    for (uint32_t node = 0; node < COUNT; node++) {
        assert_in_range(part[node], 0, PARTS - 1);
        load[part[node]] += weight[node];
        cuts += node > 0 && part[node] != part[node - 1];
    }
    assert_int_equal(cuts, PARTS - 1);
    for (int p = 0; p < PARTS; p++)
        assert_in_range(load[p], 2 * COUNT / PARTS - 12, 2 * COUNT / PARTS + 12);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Iterations with touches of several units, of none, and of one unit repeatedly: the log must list
 * each unit once. */
static void what_is_told_is_kept(void **unused) {
    (void)unused;
    static char b[240], a[700];
    const redcc_array arrays[] = {{"b", REDCC_SUM, REDCC_DOUBLE, 8, 24, 0},
                                  {"a", REDCC_SUM, REDCC_INT8, 1, 7, 0}};
    const redcc_loop loop = {.arrays = arrays, .array_count = 2};
    void *const bases[] = {b + 48, a};
    const struct range touched[] = {{(uintptr_t)b, (uintptr_t)(b + 240)},
                                    {(uintptr_t)(a + 10), (uintptr_t)(a + 700)}};
    struct partition partition;
    struct units units;
    struct access_log logged;
    assert_true(redcc_partition_begin(&partition, &loop, bases, 2));
    assert_true(redcc_units_begin(&units, &partition, touched));
    assert_int_equal(units.leading, 10);
    assert_int_equal(units.count, 10 + 99);
    for (uint64_t offset = 0; offset < 700; offset++)
        assert_int_equal(redcc_units_in(&units.of[1], offset), offset / 7);
    struct range seen[] = {redcc_nowhere, redcc_nowhere};
    assert_true(
        redcc_access_log_begin(&logged, &units, &partition, seen, 0, (const size_t[]){0, 0}, 1000));
    const redcc_entry end = {0, REDCC_END_OF_ITERATION, 0};
    const redcc_entry entries[] = {
        {b + 24, 0, 24}, {a + 13, 1, 2},  {b, 0, 0}, {b + 40, 0, 1}, end, end,
        {a + 699, 1, 1}, {b + 20, 0, 30}, end};
    redcc_access_log_take(&logged, entries, entries + 5);
    redcc_access_log_take(&logged, entries + 5, entries + 9);
    static const uint32_t leading[] = {1 | REDCC_LAST, REDCC_NO_UNIT | REDCC_LAST, 0, 1,
                                       2 | REDCC_LAST};
    static const uint32_t further[] = {10, 11 | REDCC_LAST, REDCC_NO_UNIT | REDCC_LAST,
                                       108 | REDCC_LAST};
    assert_int_equal(logged.iterations, 3);
    assert_int_equal(logged.leading.count, 5);
    assert_int_equal(logged.further.count, 4);
    assert_memory_equal(logged.leading.item, leading, sizeof leading);
    assert_memory_equal(logged.further.item, further, sizeof further);
    assert_true(seen[0].first == (uintptr_t)(b + 20) && seen[0].end == (uintptr_t)(b + 50));
    assert_true(seen[1].first == (uintptr_t)(a + 13) && seen[1].end == (uintptr_t)(a + 700));
    assert_false(logged.too_much || logged.beyond);
    const redcc_entry beyond = {b + 239, 0, 2};
    redcc_access_log_take(&logged, &beyond, &beyond + 1);
    assert_true(logged.beyond);
    assert_true(seen[0].end == (uintptr_t)b + 241);
    redcc_access_log_end(&logged);
    redcc_units_end(&units);
    redcc_partition_end(&partition);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Returns the method of the plan with a map, or NULL if no plan has one. */
static const struct method *method_with_map(const struct described *described) {
    const struct loop_state *state = described->loop.state;
    for (int p = 0; p < REDCC_PLANS; p++)
        if (state->cache.kept[p] && state->cache.kept[p]->plan->map.owner)
            return state->cache.kept[p]->plan->method;
    return NULL;
}

/* Calls a loop by auto; each call must give the expected bits. Returns the number of calls after
 * which there was a plan with a map. */
static int call_often(struct problem *problem, struct described *described, int threads,
                      int calls) {
    const size_t bytes = (size_t)problem->doubles * sizeof(double);
    double *expected = malloc(bytes);
    int mapped = 0;
    long last;
    problem_reset(problem);
    problem_oracle(problem);
    memcpy(expected, problem->first, bytes);
    for (int call = 0; call < calls; call++) {
        problem_reset(problem);
        problem_run(problem, described, threads, &last);
        assert_memory_equal(problem->first, expected, bytes);
        mapped += method_with_map(described) != NULL;
    }
    free(expected);
    return mapped;
}

/* With unlimited credit auto tries the graph as soon as the other strategies have been timed.
 * Results must be correct when the subscripts change. */
static void auto_comes_to_the_graph(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 60, .sheets = 1};
    struct problem problem = mesh_problem(&mesh);
    struct described described;
    problem_describe(&problem, &described);
    assert_true(call_often(&problem, &described, 4, 20) >= 3);
    for (int change = 0; change < 6; change++) {
        problem.row[100 * change] = (problem.row[100 * change] + 1) % problem.rows;
        call_often(&problem, &described, 4, 4);
    }
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    assert_int_equal(redcc_memory_live(), 0);
}

/* Makes auto believe that each iteration took `seconds`. Returns the method that it chooses for the
 * graph. */
static const struct method *method_of_long_iterations(const struct mesh *mesh, double seconds) {
    struct problem problem = mesh_problem(mesh);
    struct described described;
    const struct method *method = NULL;
    problem_describe(&problem, &described);
    for (int call = 0; call < 12 && !method; call++) {
        call_often(&problem, &described, 2, 1);
        struct loop_state *state = described.loop.state;
        (void)state;
        problem_tell_slow(&described.loop, problem.trip, seconds);
        method = method_with_map(&described);
    }
    call_often(&problem, &described, 2, 2);
    redcc_loop_forget(&described.loop);
    problem_free(&problem);
    assert_int_equal(redcc_memory_live(), 0);
    return method;
}

static void auto_adds_stealable_blocks_where_iterations_are_long(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 257, .sheets = 1};
    assert_ptr_equal(method_of_long_iterations(&mesh, 1e-6), &redcc_method_graph_localwrite_steal);
    assert_ptr_equal(method_of_long_iterations(&mesh, 60e-9), &redcc_method_graph_localwrite);
}

/* If all iterations touch one stealable block, all stealable blocks are joined to their owners. */
static void auto_joins_stealable_blocks_that_cost_too_much(void **unused) {
    (void)unused;
    const struct mesh mesh = {.side = 257, .sheets = 1, .hub = true};
    assert_ptr_equal(method_of_long_iterations(&mesh, 1e-6), &redcc_method_graph_localwrite);
}

int main(void) {
    const struct CMUnitTest by_auto[] = {
        cmocka_unit_test(auto_comes_to_the_graph),
        cmocka_unit_test(auto_adds_stealable_blocks_where_iterations_are_long),
        cmocka_unit_test(auto_joins_stealable_blocks_that_cost_too_much)};
    if (!redcc_settings()->method)
        return cmocka_run_group_tests(by_auto, NULL, NULL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_iterations_have_several_owners),
        cmocka_unit_test(sheets_that_do_not_touch),
        cmocka_unit_test(iterations_that_update_nothing),
        cmocka_unit_test(a_row_that_all_update),
        cmocka_unit_test(a_division_depends_on_the_loop_alone),
        cmocka_unit_test(a_path_is_cut_into_even_parts),
        cmocka_unit_test(what_is_told_is_kept),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
