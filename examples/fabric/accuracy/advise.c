/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "accuracy/advise.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include "accuracy/measure.h"
#include "accuracy/study.h"
#include "solver/solver.h"
#include "solver/solver_direct.h"
#include "step/integrator.h"

/* Fractions of the requested error. aim: error of the advised run before tolerances and solver are
 * chosen. of_algebra: error that the tolerances may cause. agreed: difference of the two most exact
 * runs. moved: perturbation of the start. */
static const double aim = 0.85, of_algebra = 0.1, agreed = 0.3, moved = 1e-3;

enum { MOST_RUNS = 24, METHODS = 3 };

/** A run and its settings. */
typedef struct trial {
    scene settings;
    measured got;
} trial;

/** Runs of one integrator; each takes twice the steps of the previous one. */
typedef struct series {
    int integrator;
    trial run[MOST_RUNS];
    int count;
    double difference; /* m, distance between the last two runs */
    double usable;     /* equal to `difference` if an error can be derived from it; otherwise NaN */
    double error;      /* m, estimated error of the last run */
} series;

typedef struct adviser {
    const scene *base;
    const mesh *cloth;
    double error; /* m, requested */
    int most_steps;
    series of[METHODS]; /* the second-order integrators first */
    const measured *reference;
    double doubt; /* m, distance between the reference and the final state by the second
                   * integrator */
} adviser;

static const trial *last_of(const series *r) {
    return &r->run[r->count - 1];
}

static int run_trial(const adviser *a, trial *t) {
    return measure(&t->settings, a->cloth, 1, ANY_REJECTIONS, &t->got);
}

/* Did the second run halve all steps? If the monitor cut the steps of both runs to one length, as
 * at an impact, both runs have the same error there. The error then does not follow from their
 * difference. */
static bool are_all_halved(const measured *one, const measured *other) {
    return other->shortest < 0.75 * one->shortest;
}

/* Estimates the last run's error by Richardson extrapolation. The assumed order of convergence is
 * at most that of the integrator. */
static void estimate_error(series *r) {
    const measured *before = &r->run[r->count - 2].got, *now = &last_of(r)->got;
    const double order = r->integrator == INTEGRATOR_LINEAR_EULER ? 1 : 2;
    r->difference = measured_distance(before, now, NULL);
    const double usable = are_all_halved(before, now) ? r->difference : NAN;
    const double rate = fmin(r->usable / usable, pow(2, order));
    r->usable = usable;
    r->error = rate > 1.2 ? usable / (rate - 1) : NAN;
}

/* Makes one more run, with twice the steps. Returns 0, 1 if that is too many steps, or -1 after a
 * message. */
static int extend(const adviser *a, series *r) {
    const int least = a->base->time.steps / 8 > 4 ? a->base->time.steps / 8 : 4;
    const int steps = r->count > 0 ? 2 * last_of(r)->settings.time.steps : least;
    const double tolerance = r->integrator == INTEGRATOR_LINEAR_EULER ? 1e-3 : 1e-4;
    if ((r->count > 0 && steps > a->most_steps) || r->count == MOST_RUNS)
        return 1;
    trial *next = &r->run[r->count];
    next->settings = divided_by(a->base, r->integrator, steps, tolerance);
    next->settings.solution.method = METHOD_CONJUGATE_GRADIENTS;
    next->settings.solution.preconditioner = PRECONDITIONER_GAUSS_SEIDEL;
    if (run_trial(a, next) != 0)
        return -1;
    if (r->count++ == 0)
        r->difference = r->usable = r->error = NAN;
    else
        estimate_error(r);
    return 0;
}

/* Extends the series until its expected error is small enough. Returns what `extend` returns. */
static int reach(const adviser *a, series *r, double error) {
    while (r->count == 0 || !(r->error <= error)) {
        const int status = extend(a, r);
        if (status != 0)
            return status;
    }
    return 0;
}

static void say_unreached(const series *r, double error, char *reason) {
    snprintf(reason, 256,
             "runs of %s in %d and %d steps still end %.3g m apart: ask for a larger error than %g "
             "m, for more --most-steps, or for less time",
             scene_integrators[r->integrator], last_of(r)->settings.time.steps / 2,
             last_of(r)->settings.time.steps, r->difference, error);
}

/* Refines the second series until both final states agree. Returns 0, 1 with a reason if they do
 * not agree, or -1 after a message. */
static int check_by(adviser *a, const series *one, series *other, char *reason) {
    const double most = agreed * a->error;
    for (;;) {
        const double apart = other->count > 0
                                 ? measured_distance(&last_of(one)->got, &last_of(other)->got, NULL)
                                 : NAN;
        if (apart <= most && other->difference <= most) {
            a->reference = &last_of(one)->got;
            a->doubt = apart;
            return 0;
        }
        const int status = extend(a, other);
        if (status == 1)
            snprintf(reason, 256,
                     "%s in %d steps and %s in %d end %.3g m apart: nothing can be promised; ask "
                     "for a larger error or for less time",
                     scene_integrators[one->integrator], last_of(one)->settings.time.steps,
                     scene_integrators[other->integrator], last_of(other)->settings.time.steps,
                     apart);
        if (status != 0)
            return status;
    }
}

/* Sets a->reference to the final state by an integrator whose error decreases with its order,
 * confirmed by a second integrator. Returns 0, 1 with a reason why there is none, or -1 after a
 * message. */
static int find_reference(adviser *a, char *reason) {
    for (int k = 0; k < METHODS; k++) {
        int status = reach(a, &a->of[k], agreed * a->error);
        if (status == 1)
            say_unreached(&a->of[k], a->error, reason);
        for (int other = 0; other < METHODS && status == 0; other++) {
            if (other == k)
                continue;
            status = check_by(a, &a->of[k], &a->of[other], reason);
            if (status <= 0)
                return status;
            status = 0;
        }
        if (status < 0)
            return -1;
    }
    return 1;
}

/* An upper bound on the run's error. */
static double error_of(const adviser *a, const measured *got) {
    return measured_distance(got, a->reference, NULL) + a->doubt;
}

/* Returns the integrator's coarsest run that is exact enough, or NULL if there is none or if it
 * takes longer than `limit`. Sets *status to -1 after a message. */
static const trial *coarsest(const adviser *a, series *r, double limit, int *status) {
    for (int k = 0;; k++) {
        if (k == r->count && (*status = extend(a, r)) != 0)
            return NULL;
        if (!(r->run[k].got.cpu_seconds < limit))
            return NULL;
        if (error_of(a, &r->run[k].got) <= aim * a->error)
            return &r->run[k];
    }
}

/* Stores in *best the fastest of the integrators' coarsest runs that are exact enough. Returns 0, 1
 * if there is none, or -1 after a message. */
static int choose_run(adviser *a, trial *best) {
    double least = INFINITY;
    for (int k = METHODS - 1; k >= 0; k--) {
        int status = 0;
        const trial *found = coarsest(a, &a->of[k], least, &status);
        if (status < 0)
            return -1;
        if (!found)
            continue;
        least = found->got.cpu_seconds;
        best->settings = found->settings;
    }
    if (!(least < INFINITY))
        return 1;
    return run_trial(a, best);
}

/* Replaces *best by the run with these settings if that is exact enough and, unless `always`,
 * faster. Returns 0, 1 if *best stays, or -1 after a message. */
static int try_settings(const adviser *a, const scene *settings, bool always, trial *best) {
    trial other = {.settings = *settings};
    if (run_trial(a, &other) != 0)
        return -1;
    if (!(error_of(a, &other.got) <= a->error) ||
        !(always || other.got.cpu_seconds < best->got.cpu_seconds)) {
        measured_free(&other.got);
        return 1;
    }
    measured_free(&best->got);
    *best = other;
    return 0;
}

/* Chooses the solver that is fastest in the first 8 steps. A solver replaces those listed before it
 * only if it takes less than 0.8 of their time. */
static int choose_solver(const adviser *a, trial *best) {
    static const int solvers[][2] = {{METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_GAUSS_SEIDEL},
                                     {METHOD_CONJUGATE_GRADIENTS, PRECONDITIONER_BLOCK_JACOBI},
                                     {METHOD_DIRECT, PRECONDITIONER_GAUSS_SEIDEL}};
    enum { COUNT = sizeof solvers / sizeof *solvers };
    double least = INFINITY;
    scene chosen = best->settings;
    for (int k = 0; k < COUNT; k++) {
        scene s = best->settings;
        measured got;
        if (solvers[k][0] == METHOD_DIRECT && !direct_solver_available())
            continue;
        s.solution.method = solvers[k][0];
        s.solution.preconditioner = solvers[k][1];
        scene start = s;
        start.time.steps = s.time.steps < 8 ? s.time.steps : 8;
        if (measure(&start, a->cloth, 3, ANY_REJECTIONS, &got) != 0)
            return -1;
        if (got.finished && got.cpu_seconds < least * (k == 0 ? 1 : 0.8)) {
            least = got.cpu_seconds;
            chosen = s;
        }
        measured_free(&got);
    }
    return try_settings(a, &chosen, true, best) < 0 ? -1 : 0;
}

/* Chooses the loosest tolerance that alone causes a small enough error. */
static int choose_tolerance(const adviser *a, trial *best) {
    const double fine = best->settings.time.integrator == INTEGRATOR_LINEAR_EULER
                            ? best->settings.solution.tolerance
                            : best->settings.solution.newton_tolerance;
    const measured exact = best->got;
    best->got = (measured){0};
    trial chosen = {.settings = best->settings, .got = exact};
    int status = 0;
    for (double tolerance = 0.1; tolerance > 1.5 * fine && status == 0; tolerance /= 10) {
        trial looser = {.settings = divided_by(&best->settings, best->settings.time.integrator,
                                               best->settings.time.steps, tolerance)};
        status = run_trial(a, &looser);
        if (status == 0 && measured_distance(&looser.got, &exact, NULL) <= of_algebra * a->error &&
            error_of(a, &looser.got) <= a->error) {
            measured_free(&chosen.got);
            chosen = looser;
            break;
        }
        measured_free(&looser.got);
    }
    *best = chosen;
    return status;
}

/* Sets *spread to the distance between the final states of *best and of the same run from a
 * randomly perturbed start. Returns 0, or -1 after a message. */
static int spread_of(const adviser *a, const trial *best, double *spread) {
    mesh other;
    measured got = {0};
    random_source source = {1};
    if (move_start(a->cloth, moved * a->error, &source, &other) != 0)
        return -1;
    const int status = measure(&best->settings, &other, 1, ANY_REJECTIONS, &got);
    *spread = status == 0 ? measured_distance(&got, &best->got, NULL) : NAN;
    measured_free(&got);
    free(other.position);
    return status;
}

/* Reduces the accuracy of a run to the requested one. */
static int refine_choice(adviser *a, trial *best) {
    const scene fewer = divided(&best->settings, (3 * best->settings.time.steps + 3) / 4);
    if (try_settings(a, &fewer, false, best) < 0)
        return -1;
    return choose_solver(a, best) != 0 || choose_tolerance(a, best) != 0 ? -1 : 0;
}

static int advise_from(adviser *a, trial *best, advice *result, char *reason) {
    int status = find_reference(a, reason);
    if (status == 0) {
        snprintf(reason, 256, "no run is within %g m: ask for more --most-steps", a->error);
        status = choose_run(a, best);
    }
    if (status == 0)
        status = refine_choice(a, best);
    if (status == 0)
        status = spread_of(a, best, &result->spread);
    if (status == 0 && !(result->spread <= 0.5 * a->error)) {
        snprintf(reason, 256,
                 "past the scene's horizon: runs that start %.3g m apart end %.3g m apart, "
                 "whatever the step; ask for a larger error or for less time",
                 moved * a->error, result->spread);
        return 1;
    }
    if (status != 0)
        return status;
    result->settings = best->settings;
    result->error = error_of(a, &best->got);
    result->cpu_seconds = best->got.cpu_seconds;
    result->iterations = (double)best->got.cg_iterations;
    return 0;
}

int advise(const scene *s, const mesh *cloth, double error, int most_steps, advice *result,
           char *reason) {
    static const int integrators[METHODS] = {INTEGRATOR_MIDPOINT, INTEGRATOR_BDF2,
                                             INTEGRATOR_LINEAR_EULER};
    adviser *a = calloc(1, sizeof *a);
    trial best = {.got = {0}};
    if (!a) {
        fprintf(stderr, "%s: out of memory\n", s->name);
        return -1;
    }
    a->base = s;
    a->cloth = cloth;
    a->error = error;
    a->most_steps = most_steps;
    for (int k = 0; k < METHODS; k++)
        a->of[k].integrator = integrators[k];
    const int status = advise_from(a, &best, result, reason);
    measured_free(&best.got);
    for (int k = 0; k < METHODS; k++)
        for (int n = 0; n < a->of[k].count; n++)
            measured_free(&a->of[k].run[n].got);
    free(a);
    return status;
}
