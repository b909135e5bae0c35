/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * Random hard scenes. Usage: random_scenes COUNT [SEED [driven|barrier]]. The scenes have sizes,
 * stiffness, densities and steps over many decades and broken meshes, and run for three steps. With
 * `driven`, worn cloth runs for 40 steps among bodies that move through it. With `barrier`, contact
 * is by a barrier as well, and nothing may cross. Each scene runs in a child process: it must end
 * with finite values and within its energy, or be refused with a message. Exit status 1: a scene
 * crashes or hangs, or its end is neither of these. For each driven scene a line gives the numbers
 * of steps, of steps repeated, and of passages that the monitor permitted in steps that cannot be
 * halved.
 */
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/vector.h"
#include "cloth.h"
#include "contact/shape.h"
#include "crossings.h"
#include "mesh/mesh_parts.h"
#include "mesh/mesh_rest.h"
#include "step/simulation.h"
#include "step/simulation_state.h"

enum { PATIENCE = 900 /* s of CPU time, after which a scene counts as hung */ };
enum {
    FINISHED,
    REFUSED,
    NOT_FINITE,
    TOO_MUCH_ENERGY,
    CROSSED,
    NOT_THE_SAME,
    SILENT,
    CRASHED,
    HUNG,
    OUTCOME_COUNT
};
static const char *const outcomes[OUTCOME_COUNT] = {"finished",
                                                    "refused",
                                                    "not finite",
                                                    "energy",
                                                    "crossed",
                                                    "resumed to other bits",
                                                    "refused without a word",
                                                    "crashed",
                                                    "hung"};

static double between(unsigned *seed, double low, double high) {
    return low + (high - low) * (random_number(seed) + 1) / 2;
}

static int one_in(unsigned *seed, int n) {
    return (int)between(seed, 0, n) == 0;
}

/* Returns 10 to a random power from low to high, or sometimes 0. */
static double decades(unsigned *seed, double low, double high) {
    const double exponent = between(seed, low, high);
    return one_in(seed, 6) ? 0 : pow(10, exponent);
}

static int any(unsigned *seed, int count) {
    return (int)between(seed, 0, count) % count;
}

/* Introduces one of the usual errors of meshes. */
static void break_mesh(mesh *m, double size, unsigned *seed) {
    const int v = any(seed, m->vertex_count), t = any(seed, m->triangle_count);
    const int *corner = m->triangle[t], other = any(seed, m->triangle_count);
    switch (any(seed, 12)) {
    case 0: /* a sliver or a triangle without area */
        for (int a = 0; a < 2; a++)
            m->material[corner[0]][a] = m->position[corner[0]][a] =
                (m->material[corner[1]][a] + m->material[corner[2]][a]) / 2 +
                (one_in(seed, 2) ? 0 : 1e-7 * size);
        break;
    case 1: /* a triangle turned inside out */
        for (int a = 0; a < 3; a++)
            m->position[corner[0]][a] =
                m->position[corner[1]][a] + m->position[corner[2]][a] - m->position[corner[0]][a];
        break;
    case 2:
        m->position[v][any(seed, 3)] = one_in(seed, 2) ? NAN : INFINITY;
        break;
    case 3:
        m->material[v][any(seed, 2)] = NAN;
        break;
    case 4: /* an edge of three triangles, or a triangle twice */
        memcpy(m->triangle[other], corner, sizeof(int[2]));
        break;
    case 5:
        m->triangle[t][1] = m->triangle[t][0];
        break;
    case 6:
        m->triangle[t][2] = one_in(seed, 2) ? -1 : m->vertex_count;
        break;
    case 7: /* two vertices in one position */
        memcpy(m->position[v], m->position[corner[0]], sizeof *m->position);
        break;
    case 8: /* no material coordinates */
        memset(m->material, 0, sizeof *m->material * (size_t)m->vertex_count);
        break;
    case 9: /* all vertices in one position */
        memset(m->position, 0, sizeof *m->position * (size_t)m->vertex_count);
        break;
    case 10: /* a vertex far away */
        m->position[v][2] = 1e30;
        break;
    default: /* a triangle gets another triangle's vertex, which may leave a vertex without
                triangles */
        m->triangle[t][0] = m->triangle[other][1];
    }
}

static scene random_scene(unsigned *seed) {
    scene s = cloth_scene();
    s.material.density = pow(10, between(seed, -6, 6));
    s.material.stretch = decades(seed, 0, 10);
    s.material.shear = decades(seed, 0, 10);
    s.material.bend = decades(seed, -8, 6);
    s.material.stretch_damping = decades(seed, -6, 6);
    s.material.shear_damping = decades(seed, -6, 6);
    s.material.bend_damping = decades(seed, -8, 6);
    s.surroundings.gravity[2] = -decades(seed, -2, 4);
    s.surroundings.drag = decades(seed, -4, 4);
    s.surroundings.wind[any(seed, 3)] = decades(seed, -2, 4);
    s.surroundings.wind_from = one_in(seed, 2) ? 0 : 1e30;
    s.time.step = pow(10, between(seed, -6, 2));
    s.solution.tolerance = pow(10, between(seed, -6, -1));
    s.solution.max_iterations = 200;
    s.solution.newton_iterations = 20;
    s.solution.newton_tolerance = 1e-4;
    s.time.integrator = one_in(seed, 2) ? 0 : any(seed, 4);
    return s;
}

static collider random_collider(double size, unsigned *seed) {
    collider c = {.kind = (collider_kind)any(seed, 4), .friction = decades(seed, -2, 2)};
    for (int a = 0; a < 3; a++) {
        c.position[a] = size * random_number(seed);
        c.size[a] = size * pow(10, between(seed, -3, 1));
        c.axis[a] = random_number(seed);
        c.velocity[a] = one_in(seed, 2) ? 0 : size * random_number(seed) * decades(seed, -2, 2);
    }
    const double length = vector_length(c.axis);
    for (int a = 0; a < 3; a++)
        c.axis[a] /= length;
    c.gap = size * pow(10, between(seed, -6, -1));
    return c;
}

static double energy_of(simulation *sim) {
    double stretch, shear, sum = 0;
    const double(*x)[3] = simulation_positions(sim);
    triangle_energies(&sim->cloth.triangles, &sim->cloth.triangle_material, x, &stretch, &shear);
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        sum += sim->cloth.mass[i] * vector_dot(sim->state.v[i], sim->state.v[i]) / 2;
    if (sim->scene->material.strain_limit > 0)
        stretch += strain_limit_energy(&sim->cloth.strain_limit, &sim->cloth.triangles, x);
    return sum + stretch + shear +
           hinge_energy_at(&sim->cloth.hinges, &sim->cloth.hinge_material, x);
}

static double height_of(const simulation *sim) {
    double sum = 0;
    for (int i = 0; i < sim->mesh->vertex_count; i++)
        sum -= sim->cloth.mass[i] * vector_dot(sim->state.x[i], sim->scene->surroundings.gravity);
    return sum;
}

/* Does the cloth have too much energy, in a scene that only gravity drives? Kinetic and elastic
 * energy may be up to 3 times the sum of the initial energy and the energy of the fall from the
 * highest position so far. */
static int has_too_much(const simulation *sim, double first, double highest, double now) {
    const double given = highest - height_of(sim);
    const double allowed = first + (given > 0 ? given : 0);
    return now > 3 * allowed + 1e-9 * sim->cloth.total_mass;
}

/* Does worn cloth among moving bodies have too much energy? A state may have up to twice the
 * monitor's reference: the initial energy plus the work done on the cloth. A refused step should
 * end early, with at most 1000 times the sum of the reference and m v^2, where m is the cloth's
 * mass and v is twice the fastest body's speed. */
static int has_run_away(const simulation *sim, int is_refused) {
    const monitor *m = &sim->monitor;
    const double most_speed = 20; /* m/s */
    const double scale = m->reference + sim->cloth.total_mass * most_speed * most_speed;
    return m->energy > 2 * m->reference + m->noise || (is_refused && m->next_energy > 1e3 * scale);
}

/* Returns the bytes of simulation_save without seconds, which the caller frees, or NULL if memory
 * is lacking. */
static unsigned char *saved(simulation *sim, size_t *size) {
    *size = simulation_saved_size(sim);
    unsigned char *bytes = malloc(*size);
    for (int k = 0; k < PHASE_COUNT; k++)
        sim->account.phases[k].seconds = 0;
    for (int k = 0; k < EFFECT_COUNT; k++)
        sim->account.effects[k].seconds = 0;
    if (bytes)
        simulation_save(sim, bytes, *size);
    return bytes;
}

/* Restores a simulation, makes two more steps and returns the bytes then saved, or NULL if a step
 * fails or memory is lacking. */
static unsigned char *saved_later(const mesh *m, const scene *s, unsigned char *from, size_t size,
                                  size_t *later) {
    char error[256];
    simulation *sim = simulation_new(m, s, error);
    unsigned char *bytes = NULL;
    int status = sim ? simulation_restore(sim, from, size) : -1;
    for (int n = 0; n < 2 && status == 0; n++)
        status = simulation_step(sim, error);
    if (status == 0)
        bytes = saved(sim, later);
    simulation_free(sim);
    return bytes;
}

/* Does a simulation that was saved after one step and restored reach the same state as one that
 * made three steps? */
static int goes_on(const mesh *m, const scene *s) {
    char error[256];
    size_t size = 0, whole_size = 0, later_size = 0;
    simulation *sim = simulation_new(m, s, error);
    int status = sim ? simulation_step(sim, error) : -1;
    unsigned char *middle = status == 0 ? saved(sim, &size) : NULL, *whole = NULL, *later = NULL;
    for (int n = 0; n < 2 && status == 0; n++)
        status = simulation_step(sim, error);
    if (status == 0 && middle) {
        whole = saved(sim, &whole_size);
        later = saved_later(m, s, middle, size, &later_size);
    }
    simulation_free(sim);
    const int same = status != 0 || (whole && later && whole_size == later_size &&
                                     memcmp(whole, later, whole_size) == 0);
    free(middle);
    free(whole);
    free(later);
    return same;
}

/* Writes the counts of steps and of verdicts on them to error[256]. */
static void tell_account(const simulation *sim, char *error) {
    int length = snprintf(error, 256, "%ld steps, %ld taken again", simulation_counts(sim).taken,
                          simulation_counts(sim).rejected);
    for (int k = 0; k < STEP_VERDICT_COUNT; k++)
        if (sim->monitor.let_pass[k] > 0)
            length += snprintf(error + length, (size_t)(256 - length), ", %ld let pass: %s",
                               sim->monitor.let_pass[k], monitor_verdict_name((monitor_verdict)k));
}

/* Returns the number of crossing edges of cloth and bodies, comparing all with all. With a barrier
 * it must be 0. */
static int crossed_now(const mesh *m, const scene *s, simulation *sim) {
    const stage on = {*m, *s, sim};
    int count = s->self_collision.gap > 0 ? crossings(&on) : 0;
    for (int n = 0; n < s->collider_count; n++) {
        const double middle[3] = {0};
        double at[3];
        mesh body;
        if (solid_mesh(&s->colliders[n], middle, 1, &body) != 0)
            return -1;
        vector_add_scaled(s->colliders[n].position, simulation_time(sim), s->colliders[n].velocity,
                          at);
        count += crossings_with(&on, &body, at);
        mesh_free(&body);
    }
    return count;
}

static int run(const mesh *m, const scene *s, int steps, int is_worn, char *error) {
    simulation *sim = simulation_new(m, s, error);
    int outcome = FINISHED,
        driven = s->surroundings.drag > 0 && vector_length(s->surroundings.wind) > 0;
    if (!sim)
        return error[0] ? REFUSED : SILENT;
    for (int n = 0; n < s->collider_count; n++)
        driven |= vector_length(s->colliders[n].velocity) > 0;
    for (int n = 0; n < s->collider_count; n++)
        for (int i = 0; i < m->vertex_count; i++) { /* colliders push out vertices inside them */
            double p[3], normal[3];
            vector_subtract(m->position[i], s->colliders[n].position, p);
            driven |= shape_distance(&s->colliders[n], p, normal) < s->colliders[n].gap;
        }
    const double first = energy_of(sim);
    double highest = height_of(sim);
    for (int n = 0; n < steps && outcome == FINISHED; n++) {
        if (simulation_step(sim, error) != 0) {
            outcome = error[0] ? REFUSED : SILENT;
            break;
        }
        const double now = energy_of(sim);
        for (int i = 0; i < m->vertex_count; i++)
            if (!isfinite(vector_length(simulation_positions(sim)[i])) ||
                !isfinite(vector_length(simulation_velocities(sim)[i])))
                outcome = NOT_FINITE;
        if (s->contact.method == CONTACT_BARRIER && crossed_now(m, s, sim) != 0)
            outcome = CROSSED;
        if (outcome == FINISHED && !driven && has_too_much(sim, first, highest, now)) {
            outcome = TOO_MUCH_ENERGY;
            snprintf(error, 256, "%g J of %g J and a fall of %g J", now, first,
                     highest - height_of(sim));
        }
        highest = fmax(highest, height_of(sim));
    }
    if (outcome == FINISHED)
        tell_account(sim, error);
    if (outcome <= REFUSED && is_worn && has_run_away(sim, outcome == REFUSED))
        outcome = TOO_MUCH_ENERGY;
    simulation_free(sim);
    return outcome;
}

static int run_scene(unsigned seed, char *error) {
    collider colliders[2];
    mesh_problem found[MESH_PROBLEM_COUNT];
    const int is_resumed = seed % 2 == 0; /* also run a saved and restored simulation */
    int non_manifold, outcome = REFUSED;
    for (int k = 0; k < 8; k++)
        random_number(&seed); /* neighbouring seeds begin with similar numbers */
    const double size = pow(10, between(&seed, -6, 6));
    const int columns = 2 + any(&seed, 7), rows = 2 + any(&seed, 7);
    pin hold = {.low = {-size, -size}, .high = {size / columns, size * 10}};
    mesh m = cloth_sheet(columns, rows, size / columns, 0.3, seed);
    scene s = random_scene(&seed);
    for (int k = one_in(&seed, 2) ? 0 : any(&seed, 4); k > 0; k--)
        break_mesh(&m, size, &seed);
    if (one_in(&seed, 2)) {
        s.pins = &hold;
        s.pin_count = 1;
    }
    s.colliders = colliders;
    s.collider_count = any(&seed, 3);
    for (int n = 0; n < s.collider_count; n++)
        colliders[n] = random_collider(size, &seed);
    s.material.strain_limit =
        s.material.stretch > 0 && one_in(&seed, 3) ? decades(&seed, -3, 0) : 0;
    s.self_collision.gap = one_in(&seed, 3) ? size * decades(&seed, -5, 0) / columns : 0;
    s.self_collision.friction = decades(&seed, -2, 1);
    s.monitor.penetration = 0.1 * size;
    if (mesh_clean(&m, found, error) == 0 && mesh_connect(&m, &non_manifold, error) == 0 &&
        mesh_check(&m, found) == 0)
        outcome = run(&m, &s, 3, 0, error);
    if (outcome == FINISHED && is_resumed && !goes_on(&m, &s))
        outcome = NOT_THE_SAME;
    mesh_free(&m);
    return outcome;
}

/* Returns a body of 0.02 to 0.3 m that starts above or below the sheet and moves through it. */
static collider driven_body(unsigned *seed) {
    collider c = {.kind = (collider_kind)(1 + any(seed, 3)), .friction = between(seed, 0, 1)};
    const double side = one_in(seed, 2) ? 1 : -1, speed = pow(10, between(seed, -1, 1));
    for (int a = 0; a < 3; a++) {
        c.size[a] = 0.02 * pow(10, between(seed, 0, 1.2));
        c.axis[a] = random_number(seed);
        c.position[a] = a < 2 ? between(seed, 0, 0.5) : 0;
        c.velocity[a] = 0.3 * speed * random_number(seed);
    }
    const double length = vector_length(c.axis), radius = 2 * vector_length(c.size);
    for (int a = 0; a < 3; a++)
        c.axis[a] /= length;
    c.position[2] = side * (radius + 0.02);
    c.velocity[2] = -side * speed;
    c.gap = pow(10, between(seed, -3, -2));
    return c;
}

/* Two or three bodies move through a sheet from both sides. The sheet is held or falls. */
static int run_driven(unsigned seed, contact_method by, char *error) {
    collider bodies[3];
    pin hold = {.low = {-0.01, -0.01}, .high = {0.01, 10}};
    for (int k = 0; k < 8; k++)
        random_number(&seed);
    const int along = 6 + any(&seed, 8);
    mesh m = cloth_sheet(along, along, 0.5 / along, 0.3, seed);
    scene s = cloth_scene();
    s.time.step = between(&seed, 0.005, 0.033);
    s.material.stretch = pow(10, between(&seed, 1.5, 4));
    s.material.shear = s.material.stretch * between(&seed, 0.02, 0.5);
    s.material.bend = pow(10, between(&seed, -6, -3));
    s.surroundings.drag = one_in(&seed, 2) ? 0.2 : 0;
    s.colliders = bodies;
    s.collider_count = 2 + any(&seed, 2);
    for (int n = 0; n < s.collider_count; n++)
        bodies[n] = driven_body(&seed);
    s.pins = &hold;
    s.pin_count = any(&seed, 2);
    s.self_collision.gap = one_in(&seed, 2) ? 0.1 * 0.5 / along : 0;
    s.contact.method = (int)by;
    if (by == CONTACT_BARRIER)
        s.solution.tolerance = 1e-3;
    const int outcome = run(&m, &s, 40, 1, error);
    cloth_free(&m);
    return outcome;
}

/* Runs the scene in a child process, whose message comes through a pipe. */
static int run_child(unsigned seed, int is_driven, contact_method by, char *error) {
    int ends[2], status;
    error[0] = '\0';
    if (pipe(ends) != 0)
        return CRASHED;
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        setrlimit(RLIMIT_CPU, &(struct rlimit){PATIENCE, PATIENCE + 1});
        const int outcome = is_driven ? run_driven(seed, by, error) : run_scene(seed, error);
        const ssize_t written = write(ends[1], error, strlen(error));
        _exit(written < 0 ? CRASHED : outcome);
    }
    close(ends[1]);
    const ssize_t length = read(ends[0], error, 255);
    error[length > 0 ? length : 0] = '\0';
    close(ends[0]);
    if (child < 0 || waitpid(child, &status, 0) < 0)
        return CRASHED;
    if (WIFSIGNALED(status))
        return WTERMSIG(status) == SIGXCPU ? HUNG : CRASHED;
    return WEXITSTATUS(status) < OUTCOME_COUNT ? WEXITSTATUS(status) : CRASHED;
}

static double children_seconds(void) {
    struct rusage used;
    getrusage(RUSAGE_CHILDREN, &used);
    return (double)used.ru_utime.tv_sec + 1e-6 * (double)used.ru_utime.tv_usec;
}

int main(int argc, char **argv) {
    const long count = argc > 1 ? strtol(argv[1], NULL, 10) : 30;
    const unsigned first = argc > 2 ? (unsigned)strtoul(argv[2], NULL, 10) : 1;
    const contact_method by =
        argc > 3 && strcmp(argv[3], "barrier") == 0 ? CONTACT_BARRIER : CONTACT_CONSTRAINTS;
    const int is_driven = by == CONTACT_BARRIER || (argc > 3 && strcmp(argv[3], "driven") == 0);
    long sums[OUTCOME_COUNT] = {0};
    for (long n = 0; n < count; n++) {
        char error[256];
        const unsigned seed = first + (unsigned)n;
        const double before = children_seconds();
        const int outcome = run_child(seed, is_driven, by, error);
        sums[outcome]++;
        if (outcome > REFUSED || is_driven)
            printf("scene %u: %s: %s; %.1f s\n", seed, outcomes[outcome], error,
                   children_seconds() - before);
        fflush(stdout);
    }
    for (int k = 0; k < OUTCOME_COUNT; k++)
        printf("%s%s: %ld", k > 0 ? ", " : "", outcomes[k], sums[k]);
    putchar('\n');
    return sums[FINISHED] + sums[REFUSED] == count && sums[FINISHED] > 0 ? 0 : 1;
}
