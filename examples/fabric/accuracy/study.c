/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "accuracy/study.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/files.h"
#include "step/integrator.h"

/* The reference is computed at most this many times, each time with twice as many steps. */
enum { MOST_ROUNDS = 4 };

int study_run(study *of, const char *experiment, const char *variant, const scene *s,
              const mesh *cloth, double tolerance) {
    if (of->row_count == MOST_ROWS) {
        fprintf(stderr, "accuracy: more than %d runs in one experiment\n", MOST_ROWS);
        return -1;
    }
    study_row *r = &of->rows[of->row_count];
    *r = (study_row){.experiment = experiment,
                     .vertices = cloth->vertex_count,
                     .step = s->time.step,
                     .tolerance = tolerance,
                     .error_rms = NAN,
                     .error_max = NAN,
                     .error_own = NAN,
                     .error_strain = NAN,
                     .error_energy = NAN};
    snprintf(r->variant, sizeof r->variant, "%s", variant);
    if (measure(s, cloth, of->repeat, ANY_REJECTIONS, &r->got) != 0)
        return -1;
    of->row_count++;
    fprintf(stderr, "%-15s %-22s step %8.3g s  tolerance %7.1g  %6ld its  %8.3f s\n", experiment,
            variant, r->step, tolerance, r->got.cg_iterations, r->got.cpu_seconds);
    return 0;
}

/* Returns the base scene with settings for a reference. Newton's method to 1e-6 has an error of
 * some 1e-4 mm (accuracy newton), far below the measured ones. */
static scene exact(const study *of, integrator_kind kind, int steps) {
    scene s = divided(&of->base, steps);
    s.time.integrator = (int)kind;
    s.solution.tolerance = 1e-3;
    s.solution.newton_tolerance = 1e-6;
    s.solution.newton_iterations = 200;
    return s;
}

int study_reference(study *of) {
    int steps = 2 * of->steps[of->step_count - 1];
    measured coarse = {0}, other = {0};
    const scene last = exact(of, INTEGRATOR_MIDPOINT, of->steps[of->step_count - 1]);
    if (of->reference.x)
        return 0;
    if (measure(&last, &of->cloth, 1, ANY_REJECTIONS, &coarse) != 0)
        return -1;
    for (int round = 0; round < MOST_ROUNDS; round++, steps *= 2) {
        const scene one = exact(of, INTEGRATOR_MIDPOINT, 2 * steps);
        const scene two = exact(of, INTEGRATOR_BDF2, 4 * steps);
        measured_free(&of->reference);
        measured_free(&other);
        if (measure(&one, &of->cloth, 1, ANY_REJECTIONS, &of->reference) != 0 ||
            measure(&two, &of->cloth, 1, ANY_REJECTIONS, &other) != 0)
            break;
        of->reference_gap = measured_distance(&of->reference, &other, NULL);
        const double smallest = measured_distance(&of->reference, &coarse, NULL);
        fprintf(stderr, "reference: midpoint in %d steps and BDF2 in %d differ by %.3g m rms\n",
                2 * steps, 4 * steps, of->reference_gap);
        if (of->quick || of->reference_gap <= 0.1 * smallest)
            break;
    }
    measured_free(&coarse);
    const int status = other.x && of->reference.x ? 0 : -1;
    measured_free(&other);
    return status;
}

double scene_stiffness(const scene *s) {
    static const double gravity = 9.81; /* m/s^2, also for scenes without gravity */
    return s->material.stretch / (s->material.density * gravity * s->mesh.side);
}

/* Is the row on the Pareto front of time and error? It is if no other run has less error in the
 * same time, and no interpolation of two runs by a power of time does. */
static int is_on_front(const study *of, const study_row *r) {
    for (int k = 0; k < of->row_count; k++)
        for (int m = 0; m < of->row_count; m++) {
            const study_row *one = &of->rows[k], *other = &of->rows[m];
            const double time = log(r->got.cpu_seconds / one->got.cpu_seconds);
            const double between = log(other->got.cpu_seconds / one->got.cpu_seconds);
            if (time >= 0 && one->error_rms < r->error_rms)
                return 0;
            if (time > 0 && time < between &&
                log(one->error_rms) + time / between * log(other->error_rms / one->error_rms) <
                    log(r->error_rms))
                return 0;
        }
    return isfinite(r->error_rms);
}

void study_compare(study *of) {
    for (int k = 0; k < of->row_count; k++) {
        study_row *r = &of->rows[k];
        if (!r->got.x || !of->reference.x || r->got.vertices != of->reference.vertices)
            continue;
        r->error_rms = measured_distance(&r->got, &of->reference, &r->error_max);
        r->error_strain = fabs(r->got.strain - of->reference.strain);
        r->error_energy = fabs(r->got.energy - of->reference.energy);
    }
    for (int k = 0; k < of->row_count; k++)
        of->rows[k].front = is_on_front(of, &of->rows[k]);
}

int study_trusts_reference(study *of) {
    double smallest = INFINITY;
    for (int k = 0; k < of->row_count; k++)
        smallest = fmin(smallest, of->rows[k].error_rms);
    if (of->quick || of->reference_gap <= 0.1 * smallest)
        return 0;
    if (!isfinite(of->reference_gap)) {
        fprintf(stderr, "accuracy: there is no reference: one of its two methods did not come to "
                        "the scene's end. Ask for other --most-steps, or for a shorter scene.\n");
        return -1;
    }
    fprintf(
        stderr,
        "accuracy: the reference is not to be relied on: its two methods are %.3g m apart, more "
        "than a tenth of the smallest error, %.3g m.\n"
        "Errors below %.3g m are left out. Ask for fewer --most-steps, or for a shorter scene.\n",
        of->reference_gap, smallest, 10 * of->reference_gap);
    for (int k = 0; k < of->row_count; k++)
        if (of->rows[k].error_rms < 10 * of->reference_gap) {
            of->rows[k].error_rms = of->rows[k].error_max = NAN;
            of->rows[k].front = 0;
        }
    return -1;
}

static void print_number(FILE *file, double value) {
    if (isfinite(value))
        fprintf(file, ",%.6g", value);
    else
        fputc(',', file);
}

FILE *study_open(const study *of, const char *name, const char *columns) {
    char path[FILE_PATH_SIZE];
    if (files_join(path, of->folder, name) != 0)
        return NULL;
    FILE *file = fopen(path, "w");
    if (!file)
        fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    else
        fputs(columns, file);
    return file;
}

int study_close(FILE *file) {
    const int failed = ferror(file);
    if (fclose(file) == 0 && !failed)
        return 0;
    fprintf(stderr, "accuracy: a table could not be written\n");
    return -1;
}

double lowest_point(int count, const double (*x)[3]) {
    double z = INFINITY;
    for (int i = 0; i < count; i++)
        z = x[i][2] < z ? x[i][2] : z;
    return z;
}

int study_write(study *of, const char *name) {
    char file_name[64];
    snprintf(file_name, sizeof file_name, "%s.csv", name);
    FILE *file = study_open(
        of, file_name,
        "experiment,scene,vertices,variant,step,tolerance,steps,rejected,cg_iterations,"
        "newton_iterations,cpu_seconds,error_rms,error_max,error_own,front,side,stiffness,"
        "contact,wind,error_strain,error_energy,depth\n");
    if (!file)
        return -1;
    for (int k = 0; k < of->row_count; k++) {
        study_row *r = &of->rows[k];
        fprintf(file, "%s,%s,%d,%s,%.9g,%.3g,%ld,%ld,%ld,%ld,%.6g", r->experiment, of->base.name,
                r->vertices, r->variant, r->step, r->tolerance, r->got.steps, r->got.rejected,
                r->got.cg_iterations, r->got.newton_iterations, r->got.cpu_seconds);
        print_number(file, r->error_rms);
        print_number(file, r->error_max);
        print_number(file, r->error_own);
        fprintf(file, ",%d,%.6g,%.6g,%d,%d", r->front, of->base.mesh.side,
                scene_stiffness(&of->base), of->base.collider_count > 0, scene_has_wind(&of->base));
        print_number(file, r->error_strain);
        print_number(file, r->error_energy);
        print_number(file, r->got.depth);
        fputc('\n', file);
        measured_free(&r->got);
    }
    of->row_count = 0;
    return study_close(file);
}

void study_free(study *of) {
    for (int k = 0; k < of->row_count; k++)
        measured_free(&of->rows[k].got);
    measured_free(&of->reference);
    mesh_free(&of->cloth);
    scene_free(&of->base);
}
