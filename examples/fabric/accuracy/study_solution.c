/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Experiments about solving the equations: steps, tolerances, preconditioners, precisions. */
#include <math.h>
#include <stdio.h>

#include "accuracy/study.h"
#include "solver/solver.h"
#include "solver/solver_direct.h"
#include "step/integrator.h"

/* The variant that runs the scene unchanged, with its own integrator, step and tolerances. */
static const char *const scene_default = "default";

/* Runs an integrator with its best settings: the loosest tolerance that alone causes at most a
 * tenth of the error of time stepping, or else the tightest one. Returns 0, or -1 after a
 * message. */
static int run_fairly(study *of, int kind, int steps) {
    static const double tolerances[] = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6};
    enum { COUNT = sizeof tolerances / sizeof *tolerances };
    const scene tight = divided_by(&of->base, kind, steps, 1e-7);
    measured exact = {0};
    int found = COUNT - 1, status = measure(&tight, &of->cloth, 1, ANY_REJECTIONS, &exact);
    const double allowed = 0.1 * measured_distance(&exact, &of->reference, NULL);
    for (int k = 0; k + 1 < COUNT && status == 0 && found == COUNT - 1; k += of->quick ? 3 : 1) {
        const scene s = divided_by(&of->base, kind, steps, tolerances[k]);
        measured got = {0};
        status = measure(&s, &of->cloth, 1, ANY_REJECTIONS, &got);
        if (status == 0 && measured_distance(&got, &exact, NULL) <= allowed)
            found = k;
        measured_free(&got);
    }
    const scene s = divided_by(&of->base, kind, steps, tolerances[found]);
    if (status == 0)
        status = study_run(of, "dt", scene_integrators[kind], &s, &of->cloth, tolerances[found]);
    if (status == 0) {
        study_row *r = &of->rows[of->row_count - 1];
        r->error_own = measured_distance(&r->got, &exact, NULL);
    }
    measured_free(&exact);
    return status;
}

int study_dt(study *of) {
    if (study_reference(of) != 0 ||
        study_run(of, "dt", scene_default, &of->base, &of->cloth, of->base.solution.tolerance) != 0)
        return -1;
    for (int kind = INTEGRATOR_LINEAR_EULER; kind <= INTEGRATOR_MIDPOINT; kind++)
        for (int k = 0; k < of->step_count; k++)
            if (run_fairly(of, kind, of->steps[k]) != 0)
                return -1;
    study_compare(of);
    const int trusted = study_trusts_reference(of);
    return study_write(of, "dt") == 0 ? trusted : -1;
}

/* Computes error_own of the rows from `first` on, relative to row `exact`. */
static void compare_own(study *of, int first, int exact) {
    for (int k = first; k < of->row_count; k++)
        of->rows[k].error_own = measured_distance(&of->rows[k].got, &of->rows[exact].got, NULL);
}

int study_cg(study *of) {
    static const double tolerances[] = {1e-12, 1e-1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8};
    const int count = of->quick ? 4 : 8, steps = of->steps[of->step_count / 2];
    if (study_reference(of) != 0)
        return -1;
    for (int k = 0; k < count; k++) {
        scene s = divided(&of->base, steps);
        s.solution.tolerance = tolerances[k];
        if (study_run(of, "cg", "linear-euler", &s, &of->cloth, tolerances[k]) != 0)
            return -1;
    }
    compare_own(of, 0, 0);
    study_compare(of);
    return study_write(of, "cg");
}

int study_newton(study *of) {
    static const double tolerances[] = {1e-10, 1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8};
    const int count = of->quick ? 3 : 7, steps = of->steps[of->step_count / 2];
    if (study_reference(of) != 0)
        return -1;
    for (int kind = INTEGRATOR_EULER; kind <= INTEGRATOR_MIDPOINT; kind++) {
        const int first = of->row_count;
        for (int k = 0; k < count; k++) {
            scene s = divided(&of->base, steps);
            s.time.integrator = kind;
            s.solution.tolerance = 1e-2;
            s.solution.newton_tolerance = tolerances[k];
            s.solution.newton_iterations = 200;
            if (study_run(of, "newton", scene_integrators[kind], &s, &of->cloth, tolerances[k]) !=
                0)
                return -1;
        }
        compare_own(of, first, first);
    }
    study_compare(of);
    return study_write(of, "newton");
}

/* Runs the scene with each value of a setting and at each tolerance. `chosen` points to the setting
 * in `s`, and `kinds` are the names of its values. The first row, with the first value and
 * tolerance 1e-12, is the reference for error_own. */
static int compare_kinds(study *of, const char *experiment, scene *s, int *chosen,
                         const char *const *kinds) {
    static const double tolerances[] = {1e-12, 1e-2, 1e-4, 1e-6, 1e-8};
    const int count = of->quick ? 2 : 5;
    for (*chosen = 0; kinds[*chosen]; ++*chosen)
        for (int k = *chosen == 0 ? 0 : 1; k < count; k++) {
            s->solution.tolerance = tolerances[k];
            if (study_run(of, experiment, kinds[*chosen], s, &of->cloth, tolerances[k]) != 0)
                return -1;
        }
    return 0;
}

/* Returns the scene with the middle number of steps, solved by conjugate gradients with
 * Gauss-Seidel. */
static scene middle_scene(const study *of) {
    scene s = divided(&of->base, of->steps[of->step_count / 2]);
    s.solution.preconditioner = PRECONDITIONER_GAUSS_SEIDEL;
    return s;
}

int study_preconditioner(study *of) {
    scene s = middle_scene(of);
    if (compare_kinds(of, "preconditioner", &s, &s.solution.preconditioner,
                      scene_preconditioners) != 0)
        return -1;
    s.solution.preconditioner = PRECONDITIONER_INCOMPLETE_CHOLESKY;
    s.solution.method = METHOD_DIRECT;
    if (direct_solver_available() &&
        study_run(of, "preconditioner", "direct", &s, &of->cloth, 0) != 0)
        return -1;
    compare_own(of, 0, 0);
    return study_write(of, "preconditioner");
}

int study_precision(study *of) {
    scene s = middle_scene(of);
    if (compare_kinds(of, "precision", &s, &s.solution.precision, scene_precisions) != 0)
        return -1;
    compare_own(of, 0, 0);
    return study_write(of, "precision");
}

/* Measures the cost of a step on one mesh with each solver, for several step lengths. Returns 0, or
 * -1 after a message. */
static int compare_solvers(study *of, const mesh *cloth) {
    static const double steps[] = {0.001, 0.0033, 0.01, 0.033}, shortest = 0.02; /* s */
    static const struct {
        const char *name;
        int method;
        double tolerance;
    } solvers[] = {{"gauss-seidel to 1e-2", METHOD_CONJUGATE_GRADIENTS, 1e-2},
                   {"gauss-seidel to 1e-6", METHOD_CONJUGATE_GRADIENTS, 1e-6},
                   {"direct", METHOD_DIRECT, 0}};
    for (int h = of->quick ? 2 : 0; h < 4; h++)
        for (int k = 0; k < 3; k++) {
            scene s = of->base;
            s.time.integrator = INTEGRATOR_LINEAR_EULER;
            s.solution.preconditioner = PRECONDITIONER_GAUSS_SEIDEL;
            s.time.step = steps[h];
            s.time.steps = (int)fmax(4, ceil(shortest / steps[h]));
            s.solution.method = solvers[k].method;
            s.solution.tolerance = solvers[k].method == METHOD_DIRECT ? of->base.solution.tolerance
                                                                      : solvers[k].tolerance;
            if ((s.solution.method != METHOD_DIRECT || direct_solver_available()) &&
                study_run(of, "solver", solvers[k].name, &s, cloth, solvers[k].tolerance) != 0)
                return -1;
        }
    return 0;
}

int study_solver(study *of) {
    static const double factors[] = {0.25, 1, 4};
    for (int k = 0; k < (of->quick ? 1 : 3); k++) {
        mesh cloth;
        const scene s = refined(&of->base, factors[k]);
        if (scene_mesh(&s, &cloth, NULL) != 0)
            return -1;
        const int status = compare_solvers(of, &cloth);
        mesh_free(&cloth);
        if (status != 0)
            return -1;
    }
    return study_write(of, "solver");
}
