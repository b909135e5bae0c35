/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Hard cases of meshes: slivers, topology, refinement and numbering. Numbers such as S11 refer to
 * docs/fabric-hard-cases.md. */
#include "stage.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "mesh/mesh_rest.h"
#include "solver/solver_direct.h"

enum { columns = 12, slivers = 10 };

/* Returns a sheet with slivers. Ten triangles get a vertex inside, at 1e-2 to 1e-6 of the way from
 * an edge's middle to the opposite corner. An eleventh gets a vertex on the edge. Each becomes a
 * sliver and two triangles. The slivers are the last triangles. */
static mesh sheet_with_slivers(void) {
    mesh sheet = cloth_sheet(columns, columns, 0.1, 0.3, 1);
    const int triangles = sheet.triangle_count, added = slivers + 1;
    double(*material)[2] = calloc(columns * columns + slivers + 1, sizeof *material);
    int(*triangle)[3] = calloc((size_t)(triangles + 2 * added), sizeof *triangle);
    memcpy(material, sheet.material, sizeof *material * columns * columns);
    memcpy(triangle, sheet.triangle, sizeof *triangle * (size_t)triangles);
    for (int n = 0; n < added; n++) {
        const int inner = columns * columns + n, split = 1 + n * (triangles / added);
        const int a = triangle[split][0], b = triangle[split][1], c = triangle[split][2];
        const double height = n < slivers ? pow(10, -2 - 4.0 * n / (slivers - 1)) : 0;
        for (int k = 0; k < 2; k++) {
            const double foot = (material[a][k] + material[b][k]) / 2;
            material[inner][k] = foot + height * (material[c][k] - foot);
        }
        const int right[3] = {b, c, inner}, left[3] = {c, a, inner};
        memcpy(triangle[split], right, sizeof right);
        memcpy(triangle[triangles + n], left, sizeof left);
        triangle[triangles + added + n][0] = a;
        triangle[triangles + added + n][1] = b;
        triangle[triangles + added + n][2] = inner;
    }
    mesh m = cloth_of(columns * columns + added, (const double(*)[2])material,
                      triangles + 2 * added, (const int(*)[3])triangle);
    free(material);
    free(triangle);
    cloth_free(&sheet);
    return m;
}

static stage held(mesh m) {
    static pin hold = {.low = {-0.01, -1}, .high = {0.01, 100}, .velocity = {0, 0, 0}};
    stage on = stage_of(m, cloth_scene());
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.solution.tolerance = 1e-4;
    return on;
}

static void S12_slivers(void **state) {
    (void)state;
    stage regular = held(cloth_sheet(12, 12, 0.1, 0.3, 1)), on = held(sheet_with_slivers());
    stage_begin(&regular);
    stage_begin(&on);
    stage_run(&regular, 200);
    stage_run(&on, 200);
    stage_assert_finite(&on);
    const double ratio = (double)simulation_counts(on.sim).iterations /
                         (double)simulation_counts(regular.sim).iterations;
    print_message("S12 iterations against a regular mesh: %.2f; rejected: %ld\n", ratio,
                  simulation_counts(on.sim).rejected);
    assert_below(ratio, 5);
    mesh_problem found[MESH_PROBLEM_COUNT];
    char error[256];
    assert_int_equal(mesh_clean(&on.m, found, error), 0);
    assert_int_equal(mesh_check(&on.m, found), 0);
    assert_int_equal(found[MESH_FLAT_TRIANGLE].count,
                     on.m.triangle_count - on.sim->cloth.triangles.count);
    assert_in_range(found[MESH_FLAT_TRIANGLE].count, 5, slivers + 1);
    assert_in_range(found[MESH_FLAT_TRIANGLE].first, on.m.triangle_count - slivers - 1,
                    on.m.triangle_count - 1);
    assert_int_equal(found[MESH_FLIPPED].count, 0);
    stage_end(&regular);
    stage_end(&on);
}

/* Two adjacent sheets are one mesh: each moves as it would alone. */
static void S30_components_are_independent(void **state) {
    (void)state;
    enum { each = 25 };
    mesh one = cloth_sheet(5, 5, 0.1, 0.3, 1);
    double material[2 * each][2];
    int(*triangle)[3] = calloc(2 * (size_t)one.triangle_count, sizeof *triangle);
    int place[each];
    for (int i = 0; i < each; i++) {
        place[i] = each + i;
        for (int a = 0; a < 2; a++) {
            material[i][a] = one.material[i][a];
            material[each + i][a] = one.material[i][a] + (a == 1 ? 10 : 0);
        }
    }
    for (int t = 0; t < one.triangle_count; t++)
        for (int p = 0; p < 3; p++) {
            triangle[t][p] = one.triangle[t][p];
            triangle[one.triangle_count + t][p] = each + one.triangle[t][p];
        }
    stage both = held(cloth_of(2 * each, (const double(*)[2])material, 2 * one.triangle_count,
                               (const int(*)[3])triangle));
    stage alone = held(one);
    both.s.solution.tolerance = alone.s.solution.tolerance = 1e-12;
    stage_begin(&both);
    stage_begin(&alone);
    stage_run(&both, 20);
    stage_run(&alone, 20);
    for (int i = 0; i < each; i++)
        both.sim->state.x[place[i]][1] -= 10;
    const double first = stage_distance(&alone, &both, NULL);
    const double second = stage_distance(&alone, &both, place);
    print_message("S30 components differ from single runs by %.3g and %.3g m\n", first, second);
    assert_below(first, 1e-9);
    assert_below(second, 1e-9);
    free(triangle);
    stage_end(&both);
    stage_end(&alone);
}

/* Returns how far the free edge of a sheet of 0.8 m hangs below the held edge, at rest. */
static double drop(int across) {
    stage on = held(cloth_sheet(across, across, 0.8 / (across - 1), 0, 1));
    double lowest = 0;
    on.s.material.bend = 0.05;
    on.s.material.bend_damping = 0;
    on.s.time.step = 0.1;
    on.s.surroundings.drag = 3;
    stage_begin(&on);
    stage_run(&on, 120);
    for (int i = 0; i < on.m.vertex_count; i++)
        lowest = fmin(lowest, on.sim->state.x[i][2]);
    double speed = 0;
    for (int i = 0; i < on.m.vertex_count; i++)
        speed = fmax(speed, vector_length(on.sim->state.v[i]));
    print_message("S32 %d x %d: drop %.6f m, speed %.2g m/s, rejected %ld\n", across, across,
                  -lowest, speed, simulation_counts(on.sim).rejected);
    stage_end(&on);
    return -lowest;
}

static void S32_refinement_converges(void **state) {
    (void)state;
    double depth[4];
    for (int k = 0; k < 4; k++)
        depth[k] = drop((2 << k) + 1);
    for (int k = 0; k + 2 < 4; k++) {
        const double ratio = fabs(depth[k] - depth[k + 1]) / fabs(depth[k + 1] - depth[k + 2]);
        print_message("S32 difference shrinks by %.3f\n", ratio);
        assert_true(ratio >= 1.7);
    }
}

/* Returns the same cloth with vertices and triangles in another order. */
static mesh permuted(const mesh *from, unsigned seed, int *place) {
    const int n = from->vertex_count, triangles = from->triangle_count;
    double(*material)[2] = calloc((size_t)n, sizeof *material);
    int(*triangle)[3] = calloc((size_t)triangles, sizeof *triangle);
    for (int i = 0; i < n; i++) {
        const int other = (int)((random_number(&seed) + 1) / 2 * (i + 1));
        place[i] = place[other];
        place[other] = i;
    }
    for (int i = 0; i < n; i++)
        memcpy(material[place[i]], from->material[i], sizeof *material);
    for (int t = 0; t < triangles; t++) {
        const int other = (int)((random_number(&seed) + 1) / 2 * (t + 1));
        memcpy(triangle[t], triangle[other], sizeof *triangle);
        for (int p = 0; p < 3; p++)
            triangle[other][p] = place[from->triangle[t][p]];
    }
    mesh m = cloth_of(n, (const double(*)[2])material, triangles, (const int(*)[3])triangle);
    free(material);
    free(triangle);
    return m;
}

static void S33_numbering_does_not_matter(void **state) {
    (void)state;
    int place[100];
    double worst = 0;
    for (unsigned seed = 1; seed <= 5; seed++) {
        stage on = held(cloth_sheet(10, 10, 0.1, 0.3, 1));
        stage other = held(permuted(&on.m, seed, place));
        on.s.solution.tolerance = other.s.solution.tolerance = 1e-12;
        stage_begin(&on);
        stage_begin(&other);
        stage_run(&on, 10);
        stage_run(&other, 10);
        worst = fmax(worst, stage_distance(&on, &other, place));
        stage_end(&on);
        stage_end(&other);
    }
    print_message("S33 another numbering moves a vertex by %.3g m\n", worst);
    assert_below(worst, 1e-9);
}

/* S11: a corner is turned inwards. Its triangle lies on the others, and its edges keep their
 * lengths. */
static void S11_inverted_triangle(void **state) {
    (void)state;
    stage on = stage_of(cloth_sheet(10, 10, 0.1, 0.3, 1), cloth_scene());
    mesh_problem found[MESH_PROBLEM_COUNT];
    char error[256];
    int corner = -1, of = 0;
    /* Finds a corner of the sheet that belongs to one triangle only. */
    for (int i = 0; i < on.m.vertex_count; i++) {
        int triangles = 0, last = 0;
        for (int t = 0; t < on.m.triangle_count; t++)
            for (int p = 0; p < 3; p++)
                if (on.m.triangle[t][p] == i) {
                    triangles++;
                    last = t;
                }
        if (triangles == 1) {
            corner = i;
            of = last;
        }
    }
    assert_true(corner >= 0);
    assert_int_equal(mesh_clean(&on.m, found, error), 0);
    assert_int_equal(mesh_check(&on.m, found), 0);
    assert_int_equal(found[MESH_FLIPPED].count, 0);
    for (int p = 0; p < 3; p++)
        if (on.m.triangle[of][p] == corner) /* moves it to the other side of the opposite edge */
            for (int a = 0; a < 3; a++)
                on.m.position[corner][a] = on.m.position[on.m.triangle[of][(p + 1) % 3]][a] +
                                           on.m.position[on.m.triangle[of][(p + 2) % 3]][a] -
                                           on.m.position[corner][a];
    assert_int_equal(mesh_check(&on.m, found), 0);
    assert_int_equal(found[MESH_FLIPPED].count, 1);
    assert_int_equal(found[MESH_FLIPPED].first, of);
    stage_begin(&on);
    stage_run(&on, 50);
    stage_assert_finite(&on);
    assert_int_equal(simulation_counts(on.sim).rejected, 0);
    stage_end(&on);
}

static void scale_material(mesh *m, double u, double v) {
    for (int i = 0; i < m->vertex_count; i++) {
        m->material[i][0] *= u;
        m->material[i][1] *= v;
    }
}

/* S13: sheets without material coordinates, with coordinates in another unit, and mirrored. A push
 * at the start moves them. Without coordinates each triangle has a weave of its own, along an
 * edge. */
static void S13_material_coordinates(void **state) {
    (void)state;
    const double scale[4][2] = {{1, 1}, {0, 0}, {1e-6, 1e-6}, {-1, 1}};
    stage run[4];
    unsigned seed = 5;
    double push[36][3];
    for (int i = 0; i < 36; i++)
        for (int a = 0; a < 3; a++)
            push[i][a] = 0.2 * random_number(&seed);
    for (int k = 0; k < 4; k++) {
        mesh_problem found[MESH_PROBLEM_COUNT];
        char error[256];
        run[k] = stage_of(cloth_sheet(6, 6, 0.1, 0.3, 1), cloth_scene());
        scale_material(&run[k].m, scale[k][0], scale[k][1]);
        assert_int_equal(mesh_clean(&run[k].m, found, error), 0);
        assert_int_equal(mesh_check(&run[k].m, found), 0);
        const int generated = k == 1 || k == 2;
        assert_int_equal(found[MESH_NO_MATERIAL].count, generated ? run[k].m.triangle_count : 0);
        run[k].s.solution.tolerance = 1e-13;
        stage_begin(&run[k]);
        memcpy(run[k].sim->state.v, push, sizeof push);
        stage_changed(&run[k]);
        stage_run(&run[k], 20);
        stage_assert_finite(&run[k]);
    }
    print_message("S13 no material against another unit: %.3g m; mirrored against not: %.3g m, "
                  "energies differ by %.3g\n",
                  stage_distance(&run[1], &run[2], NULL), stage_distance(&run[0], &run[3], NULL),
                  fabs(stage_energy(&run[0]) / stage_energy(&run[3]) - 1));
    assert_below(stage_distance(&run[1], &run[2], NULL), 1e-12);
    assert_below(stage_distance(&run[0], &run[3], NULL), 1e-12);
    assert_below(fabs(stage_energy(&run[0]) / stage_energy(&run[3]) - 1), 1e-12);
    for (int k = 0; k < 4; k++)
        stage_end(&run[k]);
}

/* S30: an edge of three triangles, a triangle twice, a triangle with a vertex twice, and a vertex
 * without triangles. */
static void S30_bad_topology(void **state) {
    (void)state;
    const double material[6][2] = {{0, 0}, {0, 1}, {1, 0.5}, {-1, 0.5}, {-0.9, 0.4}, {7, 7}};
    const int triangle[5][3] = {{0, 2, 1}, {0, 1, 3}, {0, 1, 4}, {1, 3, 0}, {2, 2, 1}};
    stage on = stage_of(cloth_of(6, material, 5, triangle), cloth_scene());
    mesh_problem found[MESH_PROBLEM_COUNT];
    char error[256] = "";
    int non_manifold;
    on.m.position[4][2] = 0.5;
    assert_int_equal(mesh_clean(&on.m, found, error), 0);
    assert_int_equal(mesh_connect(&on.m, &non_manifold, error), 0);
    assert_int_equal(mesh_check(&on.m, found), 0);
    assert_int_equal(on.m.triangle_count, 3);
    assert_int_equal(found[MESH_DUPLICATE].count, 1);
    assert_int_equal(found[MESH_DUPLICATE].first, 3);
    assert_int_equal(found[MESH_REPEATED_VERTEX].count, 1);
    assert_int_equal(found[MESH_REPEATED_VERTEX].first, 4);
    assert_int_equal(found[MESH_LONE_VERTEX].count, 1);
    assert_int_equal(found[MESH_LONE_VERTEX].first, 5);
    assert_int_equal(non_manifold, 1);
    assert_int_equal(on.m.hinge_count, 1);
    stage_begin(&on);
    stage_run(&on, 50);
    stage_assert_finite(&on);
    simulation_free(on.sim);
    mesh_free(&on.m);
}

/* Data that are no mesh are refused with a message. */
static void S30_no_mesh(void **state) {
    (void)state;
    const double material[3][2] = {{0, 0}, {0, 1}, {1, 0.5}};
    const int triangle[1][3] = {{0, 1, 2}};
    mesh_problem found[MESH_PROBLEM_COUNT];
    char error[256] = "";
    mesh m = cloth_of(3, material, 1, triangle);
    m.material[1][0] = NAN;
    assert_int_equal(mesh_clean(&m, found, error), -1);
    assert_string_equal(error, "vertex 2 has a coordinate that is not finite");
    m.material[1][0] = 0;
    m.triangle[0][2] = 3;
    assert_int_equal(mesh_clean(&m, found, error), -1);
    assert_string_equal(error, "triangle 1 names vertex 4 of 3");
    m.triangle[0][2] = 1;
    assert_int_equal(mesh_clean(&m, found, error), -1);
    assert_string_equal(error, "no triangle is left");
    cloth_free(&m);
}

/* Returns a ribbon 0.8 m wide of triangles 1 mm high, a ratio of 800:1. Held at one end it swings
 * down. */
static stage long_triangles(void) {
    enum { segments = 1000 };
    static pin hold = {.low = {-0.0005, -1}, .high = {0.0005, 1}};
    double material[2 * (segments + 1)][2];
    int triangle[2 * segments][3];
    for (int k = 0; k <= segments; k++)
        for (int side = 0; side < 2; side++) {
            material[2 * k + side][0] = 1e-3 * k;
            material[2 * k + side][1] = 0.8 * side;
        }
    for (int k = 0; k < segments; k++) {
        const int first[3] = {2 * k, 2 * k + 2, 2 * k + 1},
                  second[3] = {2 * k + 1, 2 * k + 2, 2 * k + 3};
        memcpy(triangle[2 * k], first, sizeof first);
        memcpy(triangle[2 * k + 1], second, sizeof second);
    }
    stage on = stage_of(cloth_of(2 * (segments + 1), (const double(*)[2])material, 2 * segments,
                                 (const int(*)[3])triangle),
                        cloth_scene());
    on.s.material.stretch = 400;
    on.s.material.shear = 80;
    on.s.material.bend = 1e-4;
    on.s.time.step = 0.033;
    on.s.solution.tolerance = 1e-4;
    on.s.pins = &hold;
    on.s.pin_count = 1;
    return on;
}

/* Systems that would take the conjugate gradients thousands of iterations are solved directly,
 * after the first failure has shown this. Iterations are spent only on the few systems that are
 * tried again. The cloth must end where it ends if the scene requests the direct solution. */
static void S40_ribbon_of_800_to_1(void **state) {
    (void)state;
    enum { steps = 100 };
    stage on = long_triangles(), direct = long_triangles();
    direct.s.solution.method = METHOD_DIRECT;
    if (!direct_solver_available()) {
        cloth_free(&on.m);
        cloth_free(&direct.m);
        skip();
    }
    stage_begin(&on);
    stage_begin(&direct);
    stage_run(&on, steps);
    stage_run(&direct, steps);
    const run_faults f = simulation_faults(on.sim);
    print_message(
        "S40 ribbon of 800:1: %ld solved directly, %ld iterations, apart by %.2g m, strain "
        "%.2g, %ld rejected\n",
        f.solved_directly, simulation_counts(on.sim).iterations, stage_distance(&on, &direct, NULL),
        f.greatest_strain, simulation_counts(on.sim).rejected);
    stage_assert_finite(&on);
    assert_in_range(f.solved_directly, steps - 3, steps - 1); /* every 51st system is tried again */
    assert_int_equal(f.not_solved, 0);
    assert_in_range(simulation_counts(on.sim).iterations, 0, 3L * on.s.solution.max_iterations);
    assert_below(stage_distance(&on, &direct, NULL), 1e-4);
    stage_end(&on);
    stage_end(&direct);
}

enum { around = 24, rings = 9 };
static const double tube_radius = 0.05, tube_length = 0.2; /* m */

/* Returns a tube along z with open ends, of quadrilaterals divided in two, with or without a slit
 * along one side. */
static mesh tube(int has_slit) {
    double material[around * rings][2];
    int triangle[2 * around * (rings - 1)][3], count = 0;
    for (int r = 0; r < rings; r++)
        for (int k = 0; k < around; k++) {
            material[r * around + k][0] = k;
            material[r * around + k][1] = r;
        }
    for (int r = 0; r + 1 < rings; r++)
        for (int k = 0; k < around - has_slit; k++) {
            const int a = r * around + k, b = r * around + (k + 1) % around;
            const int right[3] = {a, b, b + around}, left[3] = {a, b + around, a + around};
            memcpy(triangle[count++], right, sizeof right);
            memcpy(triangle[count++], left, sizeof left);
        }
    mesh m =
        cloth_of(around * rings, (const double(*)[2])material, count, (const int(*)[3])triangle);
    for (int i = 0; i < m.vertex_count; i++) {
        const double angle = 2 * acos(-1) * (i % around) / (int)around;
        m.position[i][0] = tube_radius * cos(angle);
        m.position[i][1] = tube_radius * sin(angle);
        m.position[i][2] = tube_length * (i / (int)around) / (rings - 1);
    }
    m.rest_in_space = 1;
    return m;
}

static scene of_tubes(void) {
    scene s = cloth_scene();
    s.time.step = 0.01;
    s.material.stretch = 400;
    s.material.shear = 100;
    s.material.bend = 1e-3;
    s.material.bend_damping = 1e-5;
    s.surroundings.drag = 1;
    s.solution.tolerance = 1e-6;
    s.surroundings.gravity[2] = 0;
    return s;
}

/* Computes the greatest and the least distance from the axis, m. */
static void radii(const stage *on, double *least, double *most) {
    *least = INFINITY;
    *most = 0;
    for (int i = 0; i < on->m.vertex_count; i++) {
        const double radius = hypot(on->sim->state.x[i][0], on->sim->state.x[i][1]);
        *least = fmin(*least, radius);
        *most = fmax(*most, radius);
    }
}

/* A slit tube that is bent at rest keeps its shape up to rounding. A tube of cloth that is flat at
 * rest unrolls. */
static void S41_tube_keeps_its_shape(void **state) {
    (void)state;
    double least, most;
    stage bent = stage_of(tube(1), of_tubes()), flat = stage_of(tube(1), of_tubes());
    bent.m.bent_at_rest = 1;
    stage_begin(&bent);
    stage_begin(&flat);
    stage_run(&bent, 50);
    stage_run(&flat, 50);
    radii(&bent, &least, &most);
    print_message("S41 at rest: radius off by %.2g m, energy %.2g J\n",
                  fmax(most - tube_radius, tube_radius - least), stage_energy(&bent));
    assert_below(fmax(most - tube_radius, tube_radius - least), 1e-12);
    assert_below(stage_energy(&bent), 1e-18);
    radii(&flat, &least, &most);
    print_message("S41 of cloth that is flat at rest: radius %.4f to %.4f m\n", least, most);
    assert_true(most > 1.2 * tube_radius);
    stage_end(&bent);
    stage_end(&flat);
}

/* A closed tube that was squeezed to an ellipse returns to its circle. */
static void S41_tube_springs_back(void **state) {
    (void)state;
    double least, most;
    stage on = stage_of(tube(0), of_tubes());
    on.m.bent_at_rest = 1;
    on.s.monitor.energy = 1e300; /* the monitor does not know that the test squeezes the tube */
    stage_begin(&on);
    for (int i = 0; i < on.m.vertex_count; i++) { /* an ellipse of about the same circumference */
        on.sim->state.x[i][0] *= 1.35;
        on.sim->state.x[i][1] *= 0.5;
    }
    stage_changed(&on);
    radii(&on, &least, &most);
    const double squeezed = most - least;
    stage_run(&on, 400);
    radii(&on, &least, &most);
    print_message("S41 squeezed by %.3f m, after 4 s by %.2g m\n", squeezed, most - least);
    assert_below(most - least, 0.05 * squeezed);
    stage_end(&on);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S11_inverted_triangle),
        cmocka_unit_test(S12_slivers),
        cmocka_unit_test(S13_material_coordinates),
        cmocka_unit_test(S30_bad_topology),
        cmocka_unit_test(S30_no_mesh),
        cmocka_unit_test(S30_components_are_independent),
        cmocka_unit_test(S32_refinement_converges),
        cmocka_unit_test(S33_numbering_does_not_matter),
        cmocka_unit_test(S40_ribbon_of_800_to_1),
        cmocka_unit_test(S41_tube_keeps_its_shape),
        cmocka_unit_test(S41_tube_springs_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
