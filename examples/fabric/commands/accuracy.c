/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric accuracy: measures what accuracy costs, and finds settings that reach a given error. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy/advise.h"
#include "accuracy/study.h"
#include "base/files.h"
#include "commands/commands.h"
#include "solver/solver.h"
#include "step/integrator.h"

static const char *const names[] = {"dt",        "cg",     "newton", "integrator", "preconditioner",
                                    "precision", "solver", "sum",    "mesh",       "horizon",
                                    "all",       "advise", NULL};
static int (*const experiments[])(study *) = {
    study_dt,        study_cg,     study_newton, study_integrator, study_preconditioner,
    study_precision, study_solver, study_sum,    study_mesh,       study_horizon};
enum { EXPERIMENTS = sizeof experiments / sizeof *experiments, ALL = EXPERIMENTS, ADVISE };

typedef struct request {
    int name; /* -1: none yet */
    const char *scene_name, *folder;
    setting_list settings;
    int quick;
    long repeat, most_steps; /* most_steps 0: none given */
    double error;            /* m; 0: none given */
} request;

/* Takes a length such as "1mm", "0.001" (m) or "50um". */
static int take_length(const options *o, void *length) {
    static const struct {
        const char *name;
        double metres;
    } units[] = {{"", 1}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};
    char *end;
    const double value = strtod(o->value, &end);
    for (size_t k = 0; k < sizeof units / sizeof *units; k++)
        if (end != o->value && strcmp(end, units[k].name) == 0 && isfinite(value) && value > 0) {
            *(double *)length = value * units[k].metres;
            return 0;
        }
    return options_complain(
        o->of, "--error is '%s', expected a length above 0, such as 1mm or 0.001", o->value);
}

#define VALUE(field) offsetof(request, field)
static const option accuracy_options[] = {
    {"--scene", "SCENE", "the scene (default: flap)", .offset = VALUE(scene_name)},
    {"-o", "DIR", "folder for tables (default: accuracy)", .offset = VALUE(folder)},
    SETTING_OPTION(request, "mesh.vertices=100"),
    {"--repeat", "N", "measure each time N times and keep the least (default 1)", OPTION_WHOLE,
     VALUE(repeat), .low = 1, .high = 1000},
    {"--most-steps", "N",
     "the finest division of the scene (default 64; advise: 16 times its steps)", OPTION_WHOLE,
     VALUE(most_steps), .low = 8, .high = 100000},
    {"--quick", NULL, "few and coarse runs, as a test", OPTION_FLAG, .offset = VALUE(quick)},
    {"--error", "LENGTH", "advise: the rms error to reach, in m, or with mm, um", OPTION_OWN,
     VALUE(error), .take = take_length},
    {.name = NULL}};

static int take_word(const options *o, void *to) {
    request *r = to;
    if (r->name < 0) {
        r->name = options_choice(o, "the experiment", names);
        return r->name < 0;
    }
    if (r->name == ADVISE && !r->scene_name) {
        r->scene_name = o->value;
        return 0;
    }
    return options_complain(o->of, "one experiment at a time, not '%s' as well", o->value);
}

/** Reads the command line. Returns OPTIONS_READ, or the exit status. */
static int read_request(const command *self, int argc, char **argv, request *r) {
    const int status = options_read(self, argc, argv, r, take_word);
    if (status != OPTIONS_READ)
        return status;
    if (r->name < 0)
        return options_complain(self, "which experiment? %s", self->synopsis);
    if (r->name == ADVISE && (r->error <= 0 || !r->scene_name))
        return options_complain(self, "advise needs --error and a scene: advise --error 1mm SCENE");
    return OPTIONS_READ;
}

static void print_advice(const scene *s, const advice *a) {
    const scene *to = &a->settings;
    const int linear = to->time.integrator == INTEGRATOR_LINEAR_EULER;
    const int direct = to->solution.method == METHOD_DIRECT;
    printf("integrator      %s\n", scene_integrators[to->time.integrator]);
    printf("step            %.3g s: %d steps instead of %d\n", to->time.step, to->time.steps,
           s->time.steps);
    printf("tolerance       %.0e%s\n",
           linear ? to->solution.tolerance : to->solution.newton_tolerance,
           linear ? "" : " of Newton's method");
    printf("solver          %s\n", direct ? scene_methods[to->solution.method]
                                          : scene_preconditioners[to->solution.preconditioner]);
    printf("error           at most %.3g m rms at the end\n", a->error);
    printf("time            %.3g s of one core of this machine, %.0f iterations\n", a->cpu_seconds,
           a->iterations);
    printf("how sure        it was run; a second integrator ends as near to where it should; "
           "starts\n                a thousandth of the error apart end %.2g m apart\n",
           a->spread);
    printf("--set time.integrator=%s --set time.step=%.17g --set time.steps=%d --set "
           "solution.tolerance=%g --set solution.newton_tolerance=%g --set "
           "solution.newton_iterations=%d --set solution.method=%s --set "
           "solution.preconditioner=%s\n",
           scene_integrators[to->time.integrator], to->time.step, to->time.steps,
           to->solution.tolerance, to->solution.newton_tolerance, to->solution.newton_iterations,
           scene_methods[to->solution.method], scene_preconditioners[to->solution.preconditioner]);
}

static int give_advice(const request *r) {
    char reason[256] = "";
    advice a;
    scene s;
    mesh cloth;
    if (read_scene(&s, r->scene_name, &r->settings) != 0)
        return EXIT_FAILURE;
    if (scene_mesh(&s, &cloth, NULL) != 0) {
        scene_free(&s);
        return EXIT_FAILURE;
    }
    const int most = r->most_steps > 0 ? (int)r->most_steps : 16 * s.time.steps;
    const int status = advise(&s, &cloth, r->error, most, &a, reason);
    if (status == 0)
        print_advice(&s, &a);
    else if (status > 0)
        fprintf(stderr, "%s: no advice for %g m: %s\n", s.name, r->error, reason);
    mesh_free(&cloth);
    scene_free(&s);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int run_experiments(study *of, int name) {
    for (int k = 0; k < EXPERIMENTS; k++)
        if (of->base.mesh.from == SHEET_FILE &&
            (experiments[k] == study_mesh || experiments[k] == study_solver)) {
            if (name == k || name == ALL)
                fprintf(stderr, "%s: its mesh is a file, which cannot be refined: no '%s'\n",
                        of->base.name, names[k]);
            if (name == k)
                return -1;
        } else if ((name == k || name == ALL) && experiments[k](of) != 0)
            return -1;
    return 0;
}

/** Writes the heading of plots. */
static int write_heading(const study *of) {
    FILE *file = study_open(of, "study.gnuplot", "");
    if (!file)
        return -1;
    fprintf(file, "scene = '%s, %d vertices'\n", of->base.name, of->cloth.vertex_count);
    return study_close(file);
}

static int experiment(const request *r) {
    study of = {.folder = r->folder, .repeat = (int)r->repeat, .quick = r->quick};
    if (files_make_folder(r->folder) != 0 ||
        read_scene(&of.base, r->scene_name ? r->scene_name : "flap", &r->settings) != 0)
        return EXIT_FAILURE;
    const int most = r->most_steps > 0 ? (int)r->most_steps : 64;
    const int least = r->quick ? most / 4 : 8;
    for (int steps = least; steps <= most && of.step_count < MOST_COUNTS; steps *= 2)
        of.steps[of.step_count++] = steps;
    const int status = scene_mesh(&of.base, &of.cloth, NULL) == 0 && write_heading(&of) == 0
                           ? run_experiments(&of, r->name)
                           : -1;
    if (status == 0)
        printf("tables are in %s; fabric-view plot draws them\n", r->folder);
    study_free(&of);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int run(const command *self, int argc, char **argv) {
    request r = {.name = -1, .folder = "accuracy", .repeat = 1};
    const int read = read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    return r.name == ADVISE ? give_advice(&r) : experiment(&r);
}

const command accuracy_command = {
    "accuracy",
    "dt|cg|newton|integrator|preconditioner|precision|solver|sum|mesh|horizon|all|advise [SCENE] "
    "[options]",
    "Measures error against time; writes a table for each experiment. 'advise' finds "
    "step,"
    "\nintegrator, tolerance and solver for an error by runs of the scene.",
    accuracy_options, run};
