/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Decisions that most scenes do not test: when Newton's steps are shortened, and how long a contact
 * that pulls is kept. */
#include "stage.h"

/* A flag in a storm. If Newton's steps are not shortened, three time steps must be halved. */
static void test_newton_in_a_storm(void **state) {
    (void)state;
    static const char *const settings[] = {"mesh.vertices=300", "mesh.boundary=60",
                                           "time.integrator=euler", "surroundings.wind_from=0.0",
                                           "surroundings.wind=[0, 40, 0]"};
    stage on = {.m = {0}};
    assert_int_equal(scene_read(&on.s, SCENES_FOLDER "/flag.yaml"), 0);
    for (size_t k = 0; k < sizeof settings / sizeof *settings; k++)
        assert_int_equal(scene_set(&on.s, settings[k]), 0);
    assert_int_equal(scene_mesh(&on.s, &on.m, NULL), 0);
    stage_begin(&on);
    stage_run(&on, 10);
    print_message("storm: %ld steps rejected, %ld of Newton's iterations\n",
                  simulation_counts(on.sim).rejected, simulation_counts(on.sim).newton_iterations);
    assert_true(simulation_counts(on.sim).rejected <= 1);
    simulation_free(on.sim);
    mesh_free(&on.m);
    scene_free(&on.s);
}

/* A contact that has pulled for one step is checked again; after two steps it is released. */
static void test_a_contact_that_pulls(void **state) {
    (void)state;
    collider floor = {.kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .gap = 0.005};
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.2, 3), cloth_scene());
    on.s.colliders = &floor;
    on.s.collider_count = 1;
    for (int i = 0; i < on.m.vertex_count; i++)
        on.m.position[i][2] = 0.005;
    stage_begin(&on);
    stage_run(&on, 1);
    simulation *sim = on.sim;
    collisions *c = &sim->collisions;
    assert_int_equal(c->before[5].count, 1);
    for (int pulls = 0; pulls < 4; pulls++) {
        c->before[5].list[0].pulls = pulls;
        collisions_detect(c, simulation_time(sim), on.s.time.step, (const double(*)[3])sim->state.x,
                          (const double(*)[3])sim->state.v, (const double(*)[3])sim->step.guess);
        assert_int_equal(c->now[5].count, pulls < 2);
    }
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_newton_in_a_storm),
        cmocka_unit_test(test_a_contact_that_pulls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
