/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "stage.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/vector.h"

stage stage_of(mesh m, scene s) {
    return (stage){.m = m, .s = s};
}

stage stage_with(collider *k) {
    stage on = stage_of(cloth_sheet(4, 4, 0.1, 0.2, 3), cloth_scene());
    on.s.colliders = k;
    on.s.collider_count = 1;
    return on;
}

stage stage_of_slivers(void) {
    static pin hold = {.low = {-0.001, -1}, .high = {0.001, 1}};
    stage on = stage_of(cloth_sheet(30, 3, 0.05, 0, 1), cloth_scene());
    for (int i = 0; i < on.m.vertex_count; i++) {
        on.m.position[i][1] *= 5e-3;
        on.m.material[i][1] *= 5e-3;
    }
    on.s.pins = &hold;
    on.s.pin_count = 1;
    on.s.solution.max_iterations = 20;
    on.s.surroundings.gravity[0] = 5;
    on.s.solution.tolerance = 1e-8;
    on.s.monitor.energy = 1;
    return on;
}

void stage_begin(stage *on) {
    char error[256] = "";
    on->sim = simulation_new(&on->m, &on->s, error);
    if (!on->sim)
        fail_msg("%s", error);
}

/* FNV-1a (Fowler, Noll and Vo) of bytes, starting from `hash`. */
static uint64_t hash_bytes(uint64_t hash, const void *bytes, size_t size) {
    for (size_t k = 0; k < size; k++)
        hash = (hash ^ ((const unsigned char *)bytes)[k]) * UINT64_C(0x100000001b3);
    return hash;
}

/* Appends a line with the run's end and a hash of positions and velocities to the file
 * $FABRIC_STAGE_BITS. */
static void tell_bits(const simulation *sim, int vertices) {
    const char *path = getenv("FABRIC_STAGE_BITS");
    FILE *file = path && sim ? fopen(path, "a") : NULL;
    if (!file)
        return;
    const size_t size = (size_t)vertices * sizeof *simulation_positions(sim);
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    hash = hash_bytes(hash, simulation_positions(sim), size);
    hash = hash_bytes(hash, simulation_velocities(sim), size);
    fprintf(file, "%d vertices, %ld steps, %.17g s: %016" PRIx64 "\n", vertices,
            simulation_counts(sim).taken, simulation_time(sim), hash);
    fclose(file);
}

int stage_compares_bits(void) {
    return getenv("FABRIC_STAGE_BITS") != NULL;
}

void stage_end(stage *on) {
    tell_bits(on->sim, on->m.vertex_count);
    simulation_free(on->sim);
    cloth_free(&on->m);
}

void stage_changed(stage *on) {
    const monitored_step now = simulation_monitored(on->sim);
    monitor_begin(&on->sim->monitor, &on->s, &now);
}

void stage_run(stage *on, int steps) {
    char error[256] = "";
    for (int n = 0; n < steps; n++)
        if (simulation_step(on->sim, error) != 0)
            fail_msg("%s", error);
}

double stage_energy(const stage *on) {
    simulation *sim = on->sim;
    const double(*x)[3] = simulation_positions(sim);
    double stretch, shear, sum = 0;
    triangle_energies(&sim->cloth.triangles, &sim->cloth.triangle_material, x, &stretch, &shear);
    hinge_update_angles(&sim->cloth.hinges, x);
    for (int i = 0; i < on->m.vertex_count; i++)
        sum += sim->cloth.mass[i] * vector_dot(sim->state.v[i], sim->state.v[i]) / 2;
    return stretch + shear + hinge_energy(&sim->cloth.hinges, &sim->cloth.hinge_material) + sum;
}

double stage_area(const stage *on) {
    double area = 0;
    for (int t = 0; t < on->m.triangle_count; t++) {
        const int *v = on->m.triangle[t];
        double one[3], other[3], cross[3];
        vector_subtract(on->sim->state.x[v[1]], on->sim->state.x[v[0]], one);
        vector_subtract(on->sim->state.x[v[2]], on->sim->state.x[v[0]], other);
        vector_cross(one, other, cross);
        area += vector_length(cross) / 2;
    }
    return area;
}

double stage_distance(const stage *on, const stage *other, const int *of) {
    double most = 0;
    for (int i = 0; i < on->m.vertex_count; i++) {
        double apart[3];
        vector_subtract(on->sim->state.x[i], other->sim->state.x[of ? of[i] : i], apart);
        most = fmax(most, vector_length(apart));
    }
    return most;
}

void stage_assert_finite(const stage *on) {
    for (int i = 0; i < on->m.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            assert_true(isfinite(simulation_positions(on->sim)[i][a]) &&
                        isfinite(simulation_velocities(on->sim)[i][a]));
}
