/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "barrier_scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/vector.h"
#include "contact/shape.h"
#include "crossings.h"

const collider barrier_ground = {
    .kind = COLLIDER_PLANE, .axis = {0, 0, 1}, .friction = 0.5, .gap = 0.004};

scene barrier_scene(int colliders, collider *list) {
    scene s = cloth_scene();
    s.contact.method = CONTACT_BARRIER;
    s.time.step = 0.02;
    s.solution.tolerance = 1e-3;
    s.material.bend = 1e-4;
    s.surroundings.drag = 0.2;
    s.monitor.energy = 1e-3;
    s.self_collision.gap = 0.004;
    s.self_collision.friction = 0.3;
    s.collider_count = colliders;
    s.colliders = list;
    return s;
}

mesh barrier_layers(int count, int columns, double spacing, double low, double apart,
                    double aside) {
    const mesh one = cloth_sheet(columns, columns, spacing, 0.2, 3);
    const int vertices = one.vertex_count, triangles = one.triangle_count;
    double(*material)[2] = calloc((size_t)(vertices * count), sizeof *material);
    int(*triangle)[3] = calloc((size_t)(triangles * count), sizeof *triangle);
    for (int n = 0; n < count; n++) {
        memcpy(material[n * vertices], one.material, (size_t)vertices * sizeof *material);
        for (int t = 0; t < triangles; t++)
            for (int p = 0; p < 3; p++)
                triangle[n * triangles + t][p] = one.triangle[t][p] + n * vertices;
    }
    mesh all = cloth_of(vertices * count, (const double(*)[2])material, triangles * count,
                        (const int(*)[3])triangle);
    for (int i = 0; i < all.vertex_count; i++) {
        all.position[i][0] += aside * (i / vertices);
        all.position[i][2] = low + apart * (i / vertices);
    }
    mesh gone = one;
    cloth_free(&gone);
    free(material);
    free(triangle);
    return all;
}

int barrier_passing(const stage *on) {
    int count = crossings(on);
    for (int n = 0; n < on->s.collider_count; n++) {
        const collider *k = &on->s.colliders[n];
        const double time = simulation_time(on->sim), middle[3] = {0};
        double at[3];
        mesh body;
        vector_add_scaled(k->position, time, k->velocity, at);
        for (int i = 0; k->kind == COLLIDER_PLANE && i < on->m.vertex_count; i++) {
            double from[3];
            vector_subtract(simulation_positions(on->sim)[i], at, from);
            count += vector_dot(from, k->axis) <= 0;
        }
        if (k->kind == COLLIDER_PLANE)
            continue;
        assert_int_equal(solid_mesh(k, middle, 1, &body), 0);
        count += crossings_with(on, &body, at);
        mesh_free(&body);
    }
    return count;
}

double barrier_run_stage(const char *name, stage *on, int steps) {
    int crossed = 0;
    if (!on->sim)
        stage_begin(on);
    double simulated = 0;
    for (int n = 0; n < steps; n++) {
        const clock_t begun = clock();
        stage_run(on, 1);
        simulated += (double)(clock() - begun) / CLOCKS_PER_SEC;
        crossed += barrier_passing(on);
        if (getenv("TRACE"))
            printf("  %s %d: newton %ld cg %ld rejected %ld, %d crossings, %.2f s\n", name, n,
                   simulation_counts(on->sim).newton_iterations,
                   simulation_counts(on->sim).iterations, simulation_counts(on->sim).rejected,
                   crossed, simulated);
    }
    printf("%-18s %4d vertices, %3d steps (%ld rejected), %4ld systems, %d crossings, %.2f s\n",
           name, on->m.vertex_count, steps, simulation_counts(on->sim).rejected,
           simulation_counts(on->sim).newton_iterations, crossed, simulated);
    assert_int_equal(crossed, 0);
    stage_assert_finite(on);
    const run_faults faults = simulation_faults(on->sim);
    assert_int_equal(simulation_counts(on->sim).rejected, 0);
    assert_int_equal(faults.passing + faults.penetration + faults.not_solved, 0);
    return simulated;
}

void barrier_run(const char *name, mesh m, scene s, int steps) {
    stage on = stage_of(m, s);
    barrier_run_stage(name, &on, steps);
    stage_end(&on);
}

collider barrier_pole(double radius) {
    return (collider){.kind = COLLIDER_CYLINDER,
                      .position = {0.123, 0.137, 0},
                      .axis = {0, 0, 1},
                      .size = {radius, 0.2},
                      .friction = 0.3,
                      .gap = 0.004};
}

void barrier_refused(const char *name, mesh m, scene s, const char *expected) {
    char error[256] = "";
    simulation *sim = simulation_new(&m, &s, error);
    printf("%-18s %s\n", name, error);
    assert_null(sim);
    assert_non_null(strstr(error, expected));
    cloth_free(&m);
}
