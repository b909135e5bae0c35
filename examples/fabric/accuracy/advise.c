/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "accuracy/advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy/measure.h"
#include "base/random.h"
#include "solver/solver.h"
#include "solver/solver_direct.h"
#include "step/integrator.h"

/* Part of the error that is aimed at, that algebra may have, and by which starts are moved. */
static const double aim = 0.7, of_algebra = 0.1, moved = 1e-3;

/* Each in twice as many steps as the one before. */
enum { MOST_RUNS = 24 };

/** Runs of one integrator, in ever more steps. */
typedef struct pilot {
    const scene *base;
    const mesh *cloth;
    int integrator, method, preconditioner;
    double tolerance;            /* of the linear systems, or of Newton's method */
    int steps;                   /* of `last` */
    measured before, last;       /* the last two runs */
    measured coarser[MOST_RUNS]; /* [coarser_count] those before them, the coarsest first */
    int coarser_count;
    double difference;  /* m, of the last two, */
    double usable;      /* the same where the error follows from it; else not a number */
    double rate, error; /* of the last differences; m, of `last`, as they let expect */
} pilot;

static scene settings_of(const pilot *p, int steps, double tolerance) {
    scene s = divided_by(p->base, p->integrator, steps, tolerance);
    s.solution.method = p->method;
    s.solution.preconditioner = p->preconditioner;
    return s;
}

static int run_at(const pilot *p, int steps, double tolerance, measured *got) {
    const scene s = settings_of(p, steps, tolerance);
    return measure(&s, p->cloth, 1, ANY_REJECTIONS, got);
}

/* The order that the method has where everything is smooth; no more is believed. */
static double best_order(int integrator) {
    return integrator == INTEGRATOR_MIDPOINT ? 2 : 1;
}

static double order_of(const pilot *p) {
    return fmin(log2(p->rate), best_order(p->integrator));
}

/* Did the second run halve all steps? Where the monitor cut those of both to one length, at an
 * impact, they are as far off there as each other, and the error does not follow from their
 * difference.
 */
static int are_all_halved(const measured *one, const measured *other) {
    return other->shortest < 0.75 * one->shortest;
}

/* One more run, in twice as many steps. */
static int refine(pilot *p) {
    if (p->before.x)
        p->coarser[p->coarser_count++] = p->before;
    p->before = p->last;
    p->last = (measured){0};
    p->steps *= 2;
    if (run_at(p, p->steps, p->tolerance, &p->last) != 0)
        return -1;
    p->difference = measured_distance(&p->before, &p->last, NULL);
    const double usable = are_all_halved(&p->before, &p->last) ? p->difference : NAN;
    p->rate = p->usable / usable;
    p->usable = usable;
    p->error = p->rate > 1.2 ? usable / (pow(2, order_of(p)) - 1) : NAN;
    return 0;
}

static void pilot_free(pilot *p) {
    measured_free(&p->before);
    measured_free(&p->last);
    while (p->coarser_count > 0)
        measured_free(&p->coarser[--p->coarser_count]);
}

/* Refines until the error is reached. 0; 1: it is not, in most_steps; -1 after a message. */
static int reach(pilot *p, double error, int most_steps) {
    p->difference = p->usable = p->error = NAN;
    if (run_at(p, p->steps, p->tolerance, &p->last) != 0)
        return -1;
    while (!(p->error <= error)) {
        if (2 * p->steps > most_steps || p->coarser_count == MOST_RUNS)
            return 1;
        if (refine(p) != 0)
            return -1;
    }
    return 0;
}

/* `last` becomes the coarsest run that is exact enough: by its distance from the last, and the
 * error of that one. */
static void go_back(pilot *p, double error) {
    measured finest = p->last;
    const double doubt = p->error;
    int is_last = 1;
    while (p->coarser_count > 0) {
        const double found = measured_distance(&p->before, &finest, NULL) + doubt;
        if (!(found <= aim * error))
            break;
        if (!is_last)
            measured_free(&p->last);
        is_last = 0;
        p->last = p->before;
        p->before = p->coarser[--p->coarser_count];
        p->steps /= 2;
        p->error = found;
    }
    if (!is_last)
        measured_free(&finest);
}

/* The way to solve that the first steps of the last run take least time by, if it is clearly less
 * than that of the default; `last` is then run by it. */
static int choose_solver(pilot *p) {
    static const int ways[][2] = {{METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_GAUSS_SEIDEL},
                                  {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_BLOCK_JACOBI},
                                  {METHOD_DIRECT, PRECONDITIONER_GAUSS_SEIDEL}};
    enum { COUNT = sizeof ways / sizeof *ways };
    double least = INFINITY;
    int best = 0;
    for (int k = 0; k < COUNT; k++) {
        scene s = settings_of(p, p->steps, p->tolerance);
        measured got;
        if (ways[k][0] == METHOD_DIRECT && !direct_solver_available())
            continue;
        s.time.steps = s.time.steps < 8 ? s.time.steps : 8;
        s.solution.method = ways[k][0];
        s.solution.preconditioner = ways[k][1];
        if (measure(&s, p->cloth, 3, ANY_REJECTIONS, &got) != 0)
            return -1;
        if (got.finished && got.cpu_seconds < least * (k == 0 ? 1 : 0.8)) {
            least = got.cpu_seconds;
            best = k;
        }
        measured_free(&got);
    }
    p->method = ways[best][0];
    p->preconditioner = ways[best][1];
    if (best == 0)
        return 0;
    measured_free(&p->last);
    return run_at(p, p->steps, p->tolerance, &p->last);
}

/* The loosest tolerance whose own error is small enough; `last` becomes the run with it. */
static int choose_tolerance(pilot *p, double error) {
    measured exact = {0}, looser = {0};
    int status = run_at(p, p->steps, 1e-3 * p->tolerance, &exact);
    for (int n = 0; n < 3 && status == 0; n++) {
        if (measured_distance(&p->last, &exact, NULL) <= of_algebra * error)
            break;
        p->tolerance /= 10;
        measured_free(&p->last);
        status = run_at(p, p->steps, p->tolerance, &p->last);
    }
    for (int n = 0; n < 2 && status == 0 && p->tolerance < 0.05; n++) {
        status = run_at(p, p->steps, 10 * p->tolerance, &looser);
        if (status != 0 || !(measured_distance(&looser, &exact, NULL) <= of_algebra * error))
            break;
        p->tolerance *= 10;
        measured_free(&p->last);
        p->last = looser;
        looser = (measured){0};
    }
    measured_free(&exact);
    measured_free(&looser);
    return status;
}

/* How far a run ends from `last` whose start is moved a little, each coordinate at random. */
static int spread_of(const pilot *p, double error, double *spread) {
    mesh other = *p->cloth;
    measured got = {0};
    random_source source = {1};
    other.position = malloc(sizeof *other.position * ((size_t)other.vertex_count + 1));
    if (!other.position) {
        fprintf(stderr, "%s: out of memory\n", p->base->name);
        return -1;
    }
    for (int i = 0; i < other.vertex_count; i++)
        for (int a = 0; a < 3; a++)
            other.position[i][a] =
                p->cloth->position[i][a] + moved * error * random_signed(&source);
    const scene s = settings_of(p, p->steps, p->tolerance);
    const int status = measure(&s, &other, 1, ANY_REJECTIONS, &got);
    *spread = status == 0 ? measured_distance(&got, &p->last, NULL) : NAN;
    measured_free(&got);
    free(other.position);
    return status;
}

/* What the runs let expect of one in the number of steps that the error asks for. Time grows with
 * the steps to the power `growth`, and so do iterations to theirs. */
static void expect(const pilot *p, double error, double growth, double growth_of_iterations,
                   advice *a) {
    const double order = order_of(p);
    const double more = fmin(fmax(pow(p->error / (aim * error), 1 / order), 0.5), 1.5);
    const int steps = (int)ceil(p->steps * more);
    a->settings = settings_of(p, steps, p->tolerance);
    a->order = order;
    /* Runs as coarse as the error allows do not tell that it is smaller by far. */
    a->error = fmax(p->error / pow(more, order), 0.25 * error);
    a->cpu_seconds = p->last.cpu_seconds * pow(more, fmin(fmax(growth, 0), 1.5));
    a->iterations =
        (double)p->last.cg_iterations * pow(more, fmin(fmax(growth_of_iterations, -0.5), 1.5));
}

/* Advice by one integrator, but for the solver. 0, 1 with a reason, or -1. */
static int advise_by(int integrator, const scene *s, const mesh *cloth, double error,
                     int most_steps, advice *a, char *reason) {
    pilot p = {.base = s,
               .cloth = cloth,
               .integrator = integrator,
               .method = METHOD_CONJUGATE_GRADIENTS,
               .preconditioner = PRECONDITIONER_GAUSS_SEIDEL,
               .tolerance = 1e-3,
               .steps = s->time.steps / 8 > 4 ? s->time.steps / 8 : 4};
    int status = reach(&p, error, most_steps);
    if (status == 1)
        snprintf(reason, 256,
                 "runs in %d and %d steps still end %.3g m apart, and the error is not below %g m: "
                 "ask for a larger error, for more --most-steps, or for less time",
                 p.steps / 2, p.steps, p.difference, error);
    if (status == 0)
        go_back(&p, error);
    const double growth = log2(p.last.cpu_seconds / p.before.cpu_seconds);
    const double more_iterations =
        log2(fmax((double)p.last.cg_iterations, 1) / fmax((double)p.before.cg_iterations, 1));
    if (status == 0 && (choose_solver(&p) != 0 || choose_tolerance(&p, error) != 0))
        status = -1;
    if (status == 0)
        status = spread_of(&p, error, &a->spread);
    if (status == 0 && !(a->spread <= 0.5 * error)) {
        snprintf(
            reason, 256,
            "past the scene's horizon: runs that start %.3g m apart end %.3g m apart, whatever "
            "the step; ask for a larger error or for less time",
            moved * error, a->spread);
        status = 1;
    }
    if (status == 0)
        expect(&p, error, growth, more_iterations, a);
    pilot_free(&p);
    return status;
}

int advise(const scene *s, const mesh *cloth, double error, int most_steps, advice *result,
           char *reason) {
    static const int integrators[] = {INTEGRATOR_LINEAR_EULER, INTEGRATOR_MIDPOINT};
    char why[256] = "";
    int best = 1;
    for (int k = 0; k < 2; k++) {
        advice a = {0};
        const int status =
            advise_by(integrators[k], s, cloth, error, most_steps, &a, k == 0 ? reason : why);
        if (status < 0)
            return -1;
        if (status == 0 && (best != 0 || a.cpu_seconds < result->cpu_seconds)) {
            *result = a;
            best = 0;
        }
    }
    return best;
}
