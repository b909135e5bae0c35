/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The experiments `integrator` (energy, and which steps survive), `mesh` (finer meshes) and `sum`
 * (orders of reduction). */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "accuracy/study.h"
#include "base/clock.h"
#include "base/files.h"
#include "base/options.h"
#include "base/vector.h"
#include "output/state.h"
#include "step/integrator.h"
#include "step/simulation_state.h"

/* Runs the scene without damping and drag in the middle one of the study's numbers of steps, and
 * writes the energy over time. */
static int write_energy(study *of, integrator_kind kind, FILE *file) {
    char error[256] = "";
    scene s = divided(&of->base, of->steps[of->step_count / 2]);
    s.time.integrator = (int)kind;
    s.material.stretch_damping = s.material.shear_damping = s.material.bend_damping =
        s.surroundings.drag = s.surroundings.tangential_drag = 0;
    s.solution.tolerance = kind == INTEGRATOR_LINEAR_EULER ? 1e-6 : 1e-2;
    s.solution.newton_tolerance = 1e-7;
    s.solution.newton_iterations = 200;
    simulation *sim = study_simulation(&of->cloth, &s);
    if (!sim)
        return -1;
    const double first = total_energy(sim);
    for (int n = 0; n < s.time.steps && simulation_step(sim, error) == 0; n++)
        fprintf(file, "%s,%.6g,%.9g,%ld\n", scene_integrators[kind], simulation_time(sim),
                total_energy(sim) - first, simulation_counts(sim).rejected);
    simulation_free(sim);
    return 0;
}

/* Runs the scene with this step and stiffness for about 0.1 s and at least 3 steps, and writes the
 * outcome: whether the run finishes, and whether steps were halved. */
static int write_survival(study *of, integrator_kind kind, double step, double stretch,
                          FILE *file) {
    static const char *const outcomes[] = {"finished", "halved", "gave up"};
    enum { MOST_REJECTIONS_HERE = 40 };
    measured got;
    scene s = of->base;
    s.time.integrator = (int)kind;
    s.time.step = step;
    s.time.steps = step < 0.03 ? (int)ceil(0.1 / step) : 3;
    s.material.stretch = stretch;
    s.material.shear = stretch / 5;
    s.solution.newton_tolerance = 1e-4;
    s.solution.newton_iterations = 30;
    s.solution.max_iterations = 2000;
    if (measure(&s, &of->cloth, 1, MOST_REJECTIONS_HERE, &got) != 0)
        return -1;
    const int outcome = !got.finished ? 2 : got.rejected > 0 ? 1 : 0;
    fprintf(file, "%s,%g,%g,%d,%s,%ld,%.4g\n", scene_integrators[kind], step, stretch, outcome,
            outcomes[outcome], got.rejected, got.cpu_seconds);
    fprintf(stderr, "%-13s step %7.4f s  stretch %8.1e N/m  %s (%ld rejected)\n",
            scene_integrators[kind], step, stretch, outcomes[outcome], got.rejected);
    measured_free(&got);
    return 0;
}

int study_integrator(study *of) {
    static const double steps[] = {0.001, 0.0033, 0.01, 0.033, 0.1};
    static const double stiffness[] = {1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
    int status = 0;
    FILE *file = study_open(of, "energy.csv", "integrator,time,change,rejected\n");
    if (!file)
        return -1;
    for (int kind = INTEGRATOR_LINEAR_EULER; kind <= INTEGRATOR_MIDPOINT && status == 0; kind++)
        status = write_energy(of, (integrator_kind)kind, file);
    if (study_close(file) != 0 || status != 0)
        return -1;
    file = study_open(of, "robustness.csv",
                      "integrator,step,stretch,outcome,meaning,rejected,cpu_seconds\n");
    if (!file)
        return -1;
    for (int kind = INTEGRATOR_LINEAR_EULER; kind <= INTEGRATOR_MIDPOINT && status == 0; kind++)
        for (int h = of->quick ? 3 : 0; h < 5 && status == 0; h++)
            for (int k = 0; k < (of->quick ? 2 : 6) && status == 0; k++)
                status = write_survival(of, (integrator_kind)kind, steps[h], stiffness[k], file);
    return study_close(file) != 0 ? -1 : status;
}

int study_mesh(study *of) {
    static const double factors[] = {0.25, 0.5, 1, 2, 4};
    const int count = of->quick ? 3 : 5;
    double before = NAN;
    FILE *file =
        study_open(of, "mesh.csv", "vertices,triangles,cg_iterations,cpu_seconds,lowest,change\n");
    int status = file ? 0 : -1;
    for (int k = 0; k < count && status == 0; k++) {
        measured got;
        mesh cloth;
        const scene finer = refined(&of->base, factors[k]);
        scene s = divided(&finer, of->steps[of->step_count - 1]);
        s.solution.tolerance = 1e-5;
        if (scene_mesh(&s, &cloth, NULL) != 0) {
            status = -1;
            break;
        }
        status = measure(&s, &cloth, of->repeat, ANY_REJECTIONS, &got);
        if (status == 0) {
            const double z = lowest_point(got.vertices, (const double(*)[3])got.x);
            fprintf(file, "%d,%d,%ld,%.6g,%.9g,%.4g\n", s.mesh.vertices, cloth.triangle_count,
                    got.cg_iterations, got.cpu_seconds, z, z - before);
            fprintf(stderr, "%6d vertices: lowest %.6f m, %.3f s\n", s.mesh.vertices, z,
                    got.cpu_seconds);
            before = z;
            measured_free(&got);
        }
        mesh_free(&cloth);
    }
    return file && study_close(file) != 0 ? -1 : status;
}

/* An order of summation, with a method that uses it. Without a named method the runtime would
 * choose the fastest one, perhaps the sequential loop, for every order, and all times would be
 * equal. Compensated sums are computed in the serial order. */
static const struct {
    const char *order, *method, *sum;
} variants[] = {{"serial", "serial", "plain"},           {"serial", "localwrite", "plain"},
                {"serial", "localwrite", "compensated"}, {"fixed", "expansion-fixed", "plain"},
                {"any", "expansion", "plain"},           {"any", "auto", "plain"}};
enum { VARIANTS = sizeof variants / sizeof *variants };

/* Times of a run: elapsed seconds, and CPU seconds of all threads. */
typedef struct {
    double elapsed, cpu;
} spent;

/* Runs this program on the scene in another process, because the runtime reads its environment only
 * once. Returns 0, or -1 after a message. */
static int run_child(const study *of, int variant, const char *threads, spent *it) {
    char program[] = "/proc/self/exe", yaml[FILE_PATH_SIZE], out[FILE_PATH_SIZE];
    if (files_join(yaml, of->folder, "sum.yaml") != 0 ||
        files_join(out, of->folder, "sum-run") != 0)
        return -1;
    fflush(NULL);
    const double began = clock_seconds();
    const pid_t child = fork();
    if (child == 0) {
        setenv("REDCC_ORDER", variants[variant].order, 1);
        setenv("REDCC_METHOD", variants[variant].method, 1);
        setenv("REDCC_SUM", variants[variant].sum, 1);
        setenv("OMP_NUM_THREADS", threads, 1);
        execl(program, program_name, "run", yaml, "-o", out, "--frames", "0", "--progress", "none",
              (char *)NULL);
        _exit(127);
    }
    int status;
    struct rusage used;
    if (child < 0 || wait4(child, &status, 0, &used) != child || !WIFEXITED(status) ||
        WEXITSTATUS(status) != 0) {
        fprintf(stderr, "accuracy: the run with REDCC_ORDER=%s and REDCC_METHOD=%s failed\n",
                variants[variant].order, variants[variant].method);
        return -1;
    }
    *it = (spent){clock_seconds() - began,
                  (double)used.ru_utime.tv_sec + 1e-6 * (double)used.ru_utime.tv_usec};
    return 0;
}

/* Finds the least times of all repetitions. Returns 0, or -1 after a message. */
static int fastest_child(const study *of, int variant, const char *threads, spent *least) {
    *least = (spent){INFINITY, INFINITY};
    for (int n = 0; n < of->repeat; n++) {
        spent once;
        if (run_child(of, variant, threads, &once) != 0)
            return -1;
        least->elapsed = fmin(least->elapsed, once.elapsed);
        least->cpu = fmin(least->cpu, once.cpu);
    }
    return 0;
}

static double farthest(const state *a, const state *b) {
    double most = 0;
    for (int k = 0; k < 3 * a->vertex_count; k++)
        most = fmax(most, fabs(a->position[k] - b->position[k]));
    return most;
}

/* Runs each order at several thread counts and compares the results with those of the sequential
 * loops. */
int study_sum(study *of) {
    static const char *const counts[] = {"1", "2", "3"};
    char path[FILE_PATH_SIZE], final_state[FILE_PATH_SIZE];
    state first = {0};
#ifndef _OPENMP
    fprintf(stderr, "note: %s is serial, every order is the same to it; use fabric\n",
            program_name);
#endif
    if (files_join(path, of->folder, "sum.yaml") != 0 ||
        files_join(final_state, of->folder, "sum-run/final.state") != 0)
        return -1;
    const scene s = divided(&of->base, of->steps[of->step_count / 2]);
    if (scene_write(&s, path) != 0) {
        fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
        return -1;
    }
    FILE *file =
        study_open(of, "sum.csv", "order,method,sum,threads,seconds,cpu_seconds,difference\n");
    int status = file ? 0 : -1;
    for (int variant = 0; variant < VARIANTS && status == 0; variant++)
        for (int k = 0; k < 3 && status == 0; k++) {
            state now;
            spent least;
            if (fastest_child(of, variant, counts[k], &least) != 0 ||
                state_read(&now, final_state) != 0) {
                status = -1;
                break;
            }
            if (!first.memory)
                first = now;
            const double difference = farthest(&now, &first);
            fprintf(file, "%s,%s,%s,%s,%.4g,%.4g,%.4g\n", variants[variant].order,
                    variants[variant].method, variants[variant].sum, counts[k], least.elapsed,
                    least.cpu, difference);
            fprintf(stderr,
                    "order %-7s %-16s %-12s %s threads  %8.3f s (CPU %.3f s)  differs by %.3g m\n",
                    variants[variant].order, variants[variant].method, variants[variant].sum,
                    counts[k], least.elapsed, least.cpu, difference);
            if (now.memory != first.memory)
                state_free(&now);
        }
    state_free(&first);
    return file && study_close(file) != 0 ? -1 : status;
}
