/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Bodies that start, stop and turn by keyframes. Numbers such as S42 refer to
 * docs/fabric-hard-cases.md. */
#include "stage.h"

#include <stdlib.h>

#include "base/vector.h"
#include "contact/motion.h"

static const double degree = 3.14159265358979323846 / 180;

static void assert_at(const collider *k, double time, double x, double y, double z) {
    const double p[3] = {1, 0, 0}, where[3] = {x, y, z};
    double back[3];
    body_pose pose;
    motion_pose(k, time, &pose);
    for (int a = 0; a < 3; a++)
        assert_near(pose.origin[a] + vector_dot(pose.rotation[a], p), where[a], 1e-12);
    motion_to_body(k, time, where, back);
    for (int a = 0; a < 3; a++)
        assert_near(back[a], p[a], 1e-12);
}

/* The position of a point one metre along a body's first axis is compared at keyframes, between
 * them, before and after them. */
static void S42_keyframes(void **state) {
    (void)state;
    keyframe path[3] = {{1, {0, 0, 0}, 0}, {2, {0, 0, 4}, 90}, {4, {0, 2, 4}, 90}};
    const collider k = {.kind = COLLIDER_BOX,
                        .position = {5, 0, 0},
                        .turn_axis = {0, 0, 1},
                        .keyframe_count = 3,
                        .keyframes = path};
    assert_at(&k, 0, 6, 0, 0);
    assert_at(&k, 1, 6, 0, 0);
    assert_at(&k, 1.5, 5 + sqrt(0.5), sqrt(0.5), 2);
    assert_at(&k, 2, 5, 1, 4);
    assert_at(&k, 3, 5, 2, 4);
    assert_at(&k, 4, 5, 3, 4);
    assert_at(&k, 9, 5, 3, 4);
    assert_true(motion_rotates(&k));
    assert_near(motion_end(&k), 4, 0);
}

/* A step of a turning body: a vertex that the body carries along does not move in the body's axes.
 * The body's velocity and its normal in space are those of the rotation. */
static void S42_step_of_a_turning_body(void **state) {
    (void)state;
    keyframe path[2] = {{0, {0, 0, 0}, 0}, {1, {0.5, 0, 0}, 120}};
    const collider k = {.turn_axis = {0, 0, 1}, .keyframe_count = 2, .keyframes = path};
    const double own[3] = {0.3, 0.1, -0.2}, h = 0.1;
    double x[3], end[3], v[3], p[3], u[3], normal[3] = {1, 0, 0}, carried[3];
    body_pose pose;
    body_motion m;
    motion_in_step(&k, 0.4, h, &m);
    motion_pose(&k, 0.4, &pose);
    for (int a = 0; a < 3; a++)
        x[a] = pose.origin[a] + vector_dot(pose.rotation[a], own);
    motion_pose(&k, 0.5, &pose);
    for (int a = 0; a < 3; a++) {
        end[a] = pose.origin[a] + vector_dot(pose.rotation[a], own);
        v[a] = (end[a] - x[a]) / h;
    }
    motion_enter(&k, &m, 0.4, h, x, v, p, u);
    motion_carry(&k, &m, p, normal, carried);
    for (int a = 0; a < 3; a++) {
        assert_near(p[a], own[a], 1e-14);
        assert_near(u[a], 0, 1e-14);
        assert_near(carried[a], v[a], 1e-13);
    }
    assert_near(normal[0], cos(60 * degree), 1e-14);
    assert_near(normal[1], sin(60 * degree), 1e-14);
}

static collider ball(void) {
    return (collider){.kind = COLLIDER_SPHERE,
                      .position = {0.2, 0.2, -0.2},
                      .size = {0.12},
                      .friction = 0.4,
                      .gap = 0.005,
                      .turn_axis = {0, 0, 1}};
}

static stage sheet_over(collider *body) {
    stage on = stage_of(cloth_sheet(9, 9, 0.05, 0.2, 3), cloth_scene());
    on.s.solution.tolerance = 1e-10;
    on.s.surroundings.drag = 0.3;
    on.s.colliders = body;
    on.s.collider_count = 1;
    return on;
}

/* A ball that keyframes move evenly equals a ball with this velocity. Without friction a turning
 * ball equals one that does not turn, up to the error of a step's turn of 3.6 degrees. A box turned
 * by a right angle equals a box with exchanged sides. */
static void S42_same_body_otherwise(void **state) {
    (void)state;
    static pin hold[2] = {{.low = {-0.01, -1}, .high = {0.01, 1}},
                          {.low = {0.39, -1}, .high = {0.41, 1}}};
    keyframe even[2] = {{0, {0, 0, 0}, 0}, {10, {2, 1, 4}, 0}};
    keyframe turning[2] = {{0, {0, 0, 0}, 0}, {10, {2, 1, 4}, 3600}};
    keyframe turned[1] = {{0, {0, 0, 0}, 90}};
    const collider box = {.kind = COLLIDER_BOX,
                          .position = {0.2, 0.2, -0.1},
                          .friction = 0.4,
                          .gap = 0.005,
                          .turn_axis = {0, 0, 1}};
    collider body[3][2] = {{ball(), ball()}, {ball(), ball()}, {box, box}};
    for (int a = 0; a < 3; a++)
        body[0][0].velocity[a] = body[1][0].velocity[a] = even[1].move[a] / 10;
    body[2][0].velocity[2] = body[2][1].velocity[2] = 0.4;
    body[0][1].keyframes = even;
    body[1][1].keyframes = turning;
    body[0][1].keyframe_count = body[1][1].keyframe_count = 2;
    body[1][0].friction = body[1][1].friction = 0;
    const double one[3] = {0.15, 0.08, 0.05}, other[3] = {0.08, 0.15, 0.05};
    for (int a = 0; a < 3; a++) {
        body[2][0].size[a] = one[a];
        body[2][1].size[a] = other[a];
    }
    body[2][1].keyframes = turned;
    body[2][1].keyframe_count = 1;
    for (int k = 0; k < 3; k++) {
        stage plain = sheet_over(&body[k][0]), keyed = sheet_over(&body[k][1]);
        long contacts;
        plain.s.pins = keyed.s.pins = hold; /* so that small differences remain small */
        plain.s.pin_count = keyed.s.pin_count = 2;
        stage_begin(&plain);
        stage_begin(&keyed);
        stage_run(&plain, 30);
        stage_run(&keyed, 30);
        collisions_count(&plain.sim->collisions, &contacts, NULL);
        const double off = stage_distance(&plain, &keyed, NULL);
        print_message("S42 the same body otherwise: %ld contacts, off by %.2g m\n", contacts, off);
        assert_true(contacts > 0);
        assert_below(off, k == 1 ? 3e-4 : 1e-9);
        stage_end(&plain);
        stage_end(&keyed);
    }
}

/* Returns the mean angle by which the cloth has turned about the z axis through its middle,
 * degrees. */
static double turned_by(const stage *on, const double (*before)[3], double middle) {
    double sine = 0, cosine = 0;
    for (int i = 0; i < on->m.vertex_count; i++) {
        const double a = before[i][0] - middle, b = before[i][1] - middle;
        const double c = on->sim->state.x[i][0] - middle, d = on->sim->state.x[i][1] - middle;
        sine += a * d - b * c;
        cosine += a * c + b * d;
    }
    return atan2(sine, cosine) / degree;
}

static double fastest(const stage *on) {
    double speed = 0;
    for (int i = 0; i < on->m.vertex_count; i++)
        speed = fmax(speed, vector_length(on->sim->state.v[i]));
    return speed;
}

/* A cloth lies on a round table that turns by a right angle and stops. */
static void S42_turning_table(void **state) {
    (void)state;
    keyframe path[2] = {{0.5, {0, 0, 0}, 0}, {1.5, {0, 0, 0}, 90}};
    collider table = {.kind = COLLIDER_CYLINDER,
                      .position = {0.2, 0.2, -0.05},
                      .axis = {0, 0, 1},
                      .size = {0.5, 0.04},
                      .friction = 0.8,
                      .gap = 0.005,
                      .turn_axis = {0, 0, 1},
                      .keyframe_count = 2,
                      .keyframes = path};
    stage on = sheet_over(&table);
    on.s.solution.tolerance = 1e-5;
    stage_begin(&on);
    stage_run(&on, 50);
    double(*before)[3] = calloc((size_t)on.m.vertex_count, sizeof *before);
    for (int i = 0; i < on.m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            before[i][a] = on.sim->state.x[i][a];
    const double lay = fastest(&on);
    stage_run(&on, 50);
    const double midway = turned_by(&on, (const double(*)[3])before, 0.2);
    stage_run(&on, 150);
    const double angle = turned_by(&on, (const double(*)[3])before, 0.2);
    print_message("S42 table: at %.2g m/s before, turned by %.2f and %.2f degrees, at %.2g m/s "
                  "after, depth %.2g m, %ld rejected\n",
                  lay, midway, angle, fastest(&on), on.sim->monitor.deepest,
                  simulation_counts(on.sim).rejected);
    assert_near(midway, 45, 2);
    assert_near(angle, 90, 3);
    assert_below(lay, 1e-3);
    assert_below(fastest(&on), 1e-3);
    assert_below(on.sim->monitor.deepest, 1e-6);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    free(before);
    stage_end(&on);
}

/* A thin bar makes one turn per second through a hanging cloth, whose vertices are farther apart
 * than the bar is wide. The bar must sweep the cloth along. */
static void S42_turning_bar(void **state) {
    (void)state;
    static pin hold = {.low = {-0.01, -1}, .high = {0.01, 10}};
    keyframe path[2] = {{0, {0, 0, 0}, 0}, {0.25, {0, 0, 0}, 90}};
    collider bar = {.kind = COLLIDER_CYLINDER,
                    .position = {0.2, -0.3, -0.3},
                    .axis = {1, 0, 0},
                    .size = {0.008, 0.35},
                    .friction = 0.2,
                    .gap = 0.003,
                    .turn_axis = {0, 0, 1},
                    .keyframe_count = 2,
                    .keyframes = path};
    stage on = stage_of(cloth_sheet(8, 8, 0.06, 0.1, 3), cloth_scene());
    double ahead = INFINITY, farthest = -INFINITY;
    for (int i = 0; i < on.m.vertex_count; i++) { /* upright in the plane y = 0 */
        const double down = on.m.position[i][0];
        on.m.position[i][0] = on.m.position[i][1];
        on.m.position[i][1] = 0;
        on.m.position[i][2] = -down;
    }
    on.s.solution.tolerance = 1e-4;
    on.s.material.stretch = 300;
    on.s.surroundings.drag = 0.3;
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.colliders = &bar;
    on.s.collider_count = 1;
    stage_begin(&on);
    stage_run(&on, 25);
    stage_assert_finite(&on);
    for (int i = 0; i < on.m.vertex_count; i++) {
        ahead = fmin(ahead, on.sim->state.x[i][1]);
        farthest = fmax(farthest, on.sim->state.x[i][1]);
    }
    const run_faults f = simulation_faults(on.sim);
    print_message("S42 bar: cloth from y = %.3f to %.3f m, depth %.2g m, %ld rejected, %ld and %ld "
                  "let pass\n",
                  ahead, farthest, f.deepest, simulation_counts(on.sim).rejected, f.penetration,
                  f.passing);
    assert_true(farthest > 0.03);
    assert_below(f.deepest, 1e-3);
    assert_int_equal(f.penetration + f.passing, 0);
    stage_end(&on);
}

/* A cloth on a table does not sleep before the table's last keyframe, but sleeps afterwards. */
static void S42_sleeps_until_it_starts(void **state) {
    (void)state;
    keyframe path[2] = {{2, {0, 0, 0}, 0}, {2.2, {0, 0, 0.1}, 0}};
    collider table = {.kind = COLLIDER_PLANE,
                      .position = {0, 0, -0.005},
                      .axis = {0, 0, 1},
                      .friction = 0.5,
                      .gap = 0.005,
                      .keyframe_count = 2,
                      .keyframes = path};
    stage on = sheet_over(&table);
    double lowest = INFINITY;
    on.s.solution.sleep = 1e-3;
    stage_begin(&on);
    stage_run(&on, 300);
    for (int i = 0; i < on.m.vertex_count; i++)
        lowest = fmin(lowest, on.sim->state.x[i][2]);
    print_message("S42 lifted: lowest at %.4f m, %ld steps slept\n", lowest,
                  simulation_counts(on.sim).slept);
    assert_true(lowest > 0.0999);
    assert_true(simulation_counts(on.sim).slept > 10);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S42_keyframes),           cmocka_unit_test(S42_step_of_a_turning_body),
        cmocka_unit_test(S42_same_body_otherwise), cmocka_unit_test(S42_turning_table),
        cmocka_unit_test(S42_turning_bar),         cmocka_unit_test(S42_sleeps_until_it_starts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
