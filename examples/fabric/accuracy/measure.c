/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "accuracy/measure.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/vector.h"
#include "step/integrator.h"
#include "step/simulation_state.h"

double cpu_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double total_energy(const simulation *sim) {
    double sum = sim->monitor.energy;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        sum -= sim->cloth.mass[i] * vector_dot(sim->scene->surroundings.gravity, sim->state.x[i]);
    return sum;
}

scene divided(const scene *s, int steps) {
    scene result = *s;
    result.time.step = s->time.step * s->time.steps / steps;
    result.time.steps = steps;
    return result;
}

scene refined(const scene *s, double factor) {
    scene result = *s;
    result.mesh.vertices = (int)(factor * s->mesh.vertices);
    result.mesh.boundary = (int)(sqrt(factor) * s->mesh.boundary);
    return result;
}

scene divided_by(const scene *s, int integrator, int steps, double tolerance) {
    scene of = divided(s, steps);
    of.time.integrator = integrator;
    if (integrator == INTEGRATOR_LINEAR_EULER) {
        of.solution.tolerance = tolerance;
    } else {
        of.solution.tolerance = 0.1;
        of.solution.newton_tolerance = tolerance;
        of.solution.newton_iterations = 200;
    }
    return of;
}

static void note_end(const simulation *sim, measured *result) {
    const run_faults faults = simulation_faults(sim);
    result->strain = faults.watched ? sim->monitor.strain : NAN;
    result->energy = faults.watched ? total_energy(sim) : NAN;
    result->depth = faults.watched ? faults.deepest : NAN;
}

/* Returns the length of the shortest step: `nominal`, or half the length of the shortest rejected
 * step, because a rejected step is repeated in halves. */
static double shortest_step(const simulation *sim, double nominal) {
    int count;
    const rejection *rejected = simulation_rejections(sim, &count);
    double shortest = nominal;
    for (int n = 0; n < count; n++)
        shortest = fmin(shortest, rejected[n].h / 2);
    return shortest;
}

simulation *study_simulation(const mesh *cloth, const scene *s) {
    char error[256] = "";
    simulation *sim = simulation_new(cloth, s, error);
    if (!sim)
        fprintf(stderr, "%s: %s\n", s->name, error);
    return sim;
}

static int run_once(const scene *s, const mesh *cloth, long most_rejections, measured *result) {
    char error[256] = "";
    simulation *sim = study_simulation(cloth, s);
    if (!sim)
        return -1;
    const double start = cpu_seconds();
    int status = 0, n = 0;
    for (; n < s->time.steps && status == 0; n++)
        if (simulation_step(sim, error) != 0 ||
            (most_rejections >= 0 && simulation_counts(sim).rejected > most_rejections))
            status = 1;
    const double seconds = cpu_seconds() - start;
    if (seconds < result->cpu_seconds)
        result->cpu_seconds = seconds;
    result->finished = status == 0;
    result->steps = simulation_counts(sim).taken;
    result->rejected = simulation_counts(sim).rejected;
    result->shortest = shortest_step(sim, s->time.step);
    result->cg_iterations = simulation_counts(sim).iterations;
    result->newton_iterations = simulation_counts(sim).newton_iterations;
    note_end(sim, result);
    memcpy(result->x, simulation_positions(sim), sizeof *result->x * (size_t)result->vertices);
    simulation_free(sim);
    return 0;
}

int measure(const scene *s, const mesh *cloth, int repeat, long most_rejections, measured *result) {
    *result = (measured){.vertices = cloth->vertex_count, .cpu_seconds = INFINITY};
    result->x = malloc(sizeof *result->x * ((size_t)result->vertices + 1));
    if (!result->x) {
        fprintf(stderr, "%s: out of memory\n", s->name);
        return -1;
    }
    for (int n = 0; n < repeat; n++)
        if (run_once(s, cloth, most_rejections, result) != 0) {
            measured_free(result);
            return -1;
        }
    return 0;
}

void measured_free(measured *m) {
    free(m->x);
    *m = (measured){0};
}

double distance_of(int count, const double (*x)[3], const double (*y)[3], double *largest) {
    double sum = 0, most = 0;
    for (int i = 0; i < count; i++) {
        double apart[3];
        vector_subtract(x[i], y[i], apart);
        const double square = vector_dot(apart, apart);
        sum += square;
        most = square > most ? square : most;
    }
    if (largest)
        *largest = sqrt(most);
    return sqrt(sum / count);
}

double measured_distance(const measured *a, const measured *b, double *largest) {
    if (a->finished && b->finished)
        return distance_of(a->vertices, read_only(a->x), read_only(b->x), largest);
    if (largest)
        *largest = NAN;
    return NAN;
}

int move_start(const mesh *from, double most, random_source *source, mesh *to) {
    *to = *from;
    to->position = malloc(sizeof *to->position * ((size_t)to->vertex_count + 1));
    if (!to->position) {
        fprintf(stderr, "accuracy: out of memory\n");
        return -1;
    }
    for (int i = 0; i < to->vertex_count; i++)
        for (int a = 0; a < 3; a++)
            to->position[i][a] = from->position[i][a] + most * random_signed(source);
    return 0;
}
