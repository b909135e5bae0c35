/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* More scenes with `contact: barrier`: layers, a seam and piles. Also the energy account. */
#include "barrier_scene.h"

#include <stdio.h>

#include "base/vector.h"
#include "step/barrier_step.h"

static void three_layers_on_a_pole(void **state) {
    (void)state;
    collider bodies[2] = {barrier_ground, barrier_pole(0.005)};
    barrier_run("three layers, pole", barrier_layers(3, 7, 0.04, 0.22, 0.0045, 0),
                barrier_scene(2, bodies), 25);
}

/* Returns two adjacent sheets whose borders coincide. */
static mesh two_halves(double apart) {
    return barrier_layers(2, 5, 0.04, 0.05, 0, 0.16 + apart);
}

/* Two sheets along a seam that is not joined. If they touch at the start, the scene is refused with
 * a message that suggests contact.untangle. With that option, or slightly apart, the sheets run. */
static void seam(void **state) {
    (void)state;
    collider bodies[1] = {barrier_ground};
    barrier_refused("seam", two_halves(0), barrier_scene(1, bodies), "touching");
    barrier_refused("seam", two_halves(0), barrier_scene(1, bodies), "contact.untangle");
    barrier_run("seam, 1 mm apart", two_halves(1e-3), barrier_scene(1, bodies), 20);
    scene untangled = barrier_scene(1, bodies);
    untangled.contact.untangle = 1;
    barrier_run("seam, untangled", two_halves(0), untangled, 15);
}

/* Returns sheets above each other, each turned and tilted by its number. */
static mesh thrown(int count, int columns) {
    mesh m = barrier_layers(count, columns, 0.04, 0, 0, 0);
    const int vertices = m.vertex_count / count;
    const double middle = 0.02 * (columns - 1);
    for (int i = 0; i < m.vertex_count; i++) {
        const int n = i / vertices;
        const double turn = 0.7 * n, tilt = 0.3 * (n % 3 - 1);
        const double x = m.position[i][0] - middle, y = m.position[i][1] - middle;
        const double u = cos(turn) * x - sin(turn) * y;
        m.position[i][0] = cos(tilt) * u + 0.01 * (n % 2);
        m.position[i][1] = sin(turn) * x + cos(turn) * y;
        m.position[i][2] = 0.08 + 0.015 * columns * n + sin(tilt) * u;
    }
    return m;
}

static void pile_of(const char *name, int count, int columns, int steps) {
    collider bodies[2] = {barrier_ground,
                          {.kind = COLLIDER_CYLINDER,
                           .position = {0.01, 0.015, 0.02},
                           .axis = {0, 1, 0},
                           .size = {0.01, 0.06},
                           .friction = 0.3,
                           .gap = 0.004}};
    barrier_run(name, thrown(count, columns), barrier_scene(2, bodies), steps);
}

static void pile(void **state) {
    (void)state;
    pile_of("pile", 3, 5, 25);
}

static void pile_for_long(void **state) {
    (void)state;
    pile_of("pile of eight", 8, 7, 60);
}

/* Returns the kinetic, elastic, potential and contact energy, J, by independent sums. */
static double whole_energy(const stage *on) {
    const simulation *sim = on->sim;
    double sum = stage_energy(on) + barrier_energy(&sim->barrier->contact,
                                                   (const double(*)[3])sim->barrier->contact.x);
    for (int i = 0; i < on->m.vertex_count; i++)
        sum -= sim->cloth.mass[i] *
               vector_dot(on->s.surroundings.gravity, simulation_positions(sim)[i]);
    return sum;
}

/* Two sheets fall onto a ball and the floor. In each step, the monitor's energy minus the work must
 * change by as much as the independent sum of the total energy, and must not increase. */
static void the_account_is_closed(void **state) {
    (void)state;
    collider bodies[2] = {
        barrier_ground,
        {.kind = COLLIDER_SPHERE, .position = {0.06, 0.05, 0.01}, .size = {0.02}, .gap = 0.004}};
    scene s = barrier_scene(2, bodies);
    s.surroundings.drag = 0; /* its work is not in the total energy */
    stage on = stage_of(barrier_layers(2, 5, 0.04, 0.045, 0.006, 0.007), s);
    stage_begin(&on);
    double before = whole_energy(&on), lost = 0;
    for (int n = 0; n < 25; n++) {
        const double energy = on.sim->monitor.energy;
        stage_run(&on, 1);
        const double after = whole_energy(&on);
        const double gained = on.sim->monitor.energy - energy - on.sim->monitor.work;
        assert_near(gained, after - before, 1e-9 * on.sim->monitor.reference);
        assert_below(gained, 1e-6 * on.sim->monitor.reference);
        lost -= gained;
        before = after;
    }
    printf("the account        %.3g J put in, %.3g J lost\n", on.sim->monitor.reference, lost);
    assert_true(on.sim->account.effects[EFFECT_CONTACT].visited > 0);
    assert_true(on.sim->account.effects[EFFECT_SELF_COLLISION].visited > 0);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

int main(int argc, char **argv) {
    const struct CMUnitTest long_tests[] = {cmocka_unit_test(pile_for_long)};
    if (argc > 1 && strcmp(argv[1], "long") == 0)
        return cmocka_run_group_tests(long_tests, NULL, NULL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_layers_on_a_pole),
        cmocka_unit_test(seam),
        cmocka_unit_test(pile),
        cmocka_unit_test(the_account_is_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
