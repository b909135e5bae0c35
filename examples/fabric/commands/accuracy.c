/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric accuracy: what accuracy costs, and what to choose for an error. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy/advise.h"
#include "accuracy/study.h"
#include "commands/commands.h"
#include "files.h"

enum { SCENE, OUTPUT, SET, REPEAT, STEPS, QUICK, ERROR, CURVES };
static const option accuracy_options[] = {
    [SCENE] = {"--scene", "SCENE", "what is simulated (default: flap)"},
    [OUTPUT] = {"-o", "DIR", "where tables and plots go (default: accuracy)"},
    [SET] = {"--set", "KEY=VALUE", "change a key of the scene, such as mesh.vertices=100"},
    [REPEAT] = {"--repeat", "N", "measure each time N times and keep the least (default 1)"},
    [STEPS] = {"--most-steps", "N", "the finest division of the scene (default 64)"},
    [QUICK] = {"--quick", NULL, "few and coarse runs, to see that it works"},
    [ERROR] = {"--error", "LENGTH", "advise: the rms error to reach, in m, or with mm, um"},
    [CURVES] = {"--curves", "FILE", "advise: measured curves instead of the installed ones"},
    {NULL, NULL, NULL}};

static const char *const names[] = {"dt",        "cg",  "newton", "integrator", "preconditioner",
                                    "precision", "sum", "mesh",   "all",        "advise",
                                    NULL};
static int (*const experiments[])(study *) = {
    study_dt,        study_cg,  study_newton, study_integrator, study_preconditioner,
    study_precision, study_sum, study_mesh};
enum { EXPERIMENTS = sizeof experiments / sizeof *experiments, ALL = EXPERIMENTS, ADVISE };

typedef struct request {
    int name; /* -1: none yet */
    const char *scene_name, *folder, *curves;
    setting_list settings;
    int quick;
    long repeat, most_steps;
    double error; /* m; 0: none given */
} request;

/* "1mm", "0.001", "50um". 0, or -1 after a message. */
static int read_length(const command *self, const char *text, double *length) {
    static const struct {
        const char *name;
        double metres;
    } units[] = {{"", 1}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};
    char *end;
    const double value = strtod(text, &end);
    for (size_t k = 0; k < sizeof units / sizeof *units; k++)
        if (end != text && strcmp(end, units[k].name) == 0 && isfinite(value) && value > 0) {
            *length = value * units[k].metres;
            return 0;
        }
    options_complain(self, "--error is '%s', expected a length above 0, such as 1mm or 0.001",
                     text);
    return -1;
}

static int take_word(const command *self, const options *o, request *r) {
    if (r->name < 0) {
        r->name = options_choice(o, "the experiment", names);
        return r->name < 0;
    }
    if (r->name == ADVISE && !r->scene_name) {
        r->scene_name = o->value;
        return 0;
    }
    options_complain(self, "one experiment at a time, not '%s' as well", o->value);
    return 1;
}

/** Exit status, or -1 to go on. */
static int read_request(const command *self, int argc, char **argv, request *r) {
    options o = {self, argc, argv, 0, NULL, 0};
    int wrong = 0;
    for (int next; !wrong && (next = options_next(&o)) != OPTIONS_END;)
        switch (next) {
        case SCENE:
            r->scene_name = o.value;
            break;
        case OUTPUT:
            r->folder = o.value;
            break;
        case SET:
            wrong = add_setting(self, &r->settings, o.value);
            break;
        case REPEAT:
            wrong = options_whole(&o, "--repeat", 1, 1000, &r->repeat);
            break;
        case STEPS:
            wrong = options_whole(&o, "--most-steps", 8, 100000, &r->most_steps);
            break;
        case QUICK:
            r->quick = 1;
            break;
        case ERROR:
            wrong = read_length(self, o.value, &r->error);
            break;
        case CURVES:
            r->curves = o.value;
            break;
        case OPTIONS_WORD:
            wrong = take_word(self, &o, r);
            break;
        case OPTIONS_HELP:
            return EXIT_SUCCESS;
        default:
            return EXIT_USAGE;
        }
    if (wrong)
        return EXIT_USAGE;
    if (r->name < 0)
        return options_complain(self, "which experiment? %s", self->synopsis);
    if (r->name == ADVISE && (r->error <= 0 || !r->scene_name))
        return options_complain(self, "advise needs --error and a scene: advise --error 1mm SCENE");
    return -1;
}

static void print_advice(const scene *s, const advice *a) {
    const int steps = (int)ceil(s->step * s->steps / a->step - 1e-9);
    const int linear = strcmp(a->integrator, "linear-euler") == 0;
    printf("integrator      %s (order %.2f there)\n", a->integrator, a->order);
    printf("step            %.3g s: %d steps instead of %d\n", s->step * s->steps / steps, steps,
           s->steps);
    printf("tolerance       %.0e%s\n", a->tolerance, linear ? "" : " of Newton's method");
    printf("error           %.3g m rms expected\n", a->error);
    printf("time            %.3g s of one core, on a machine as the curves were measured on\n",
           a->cpu_seconds);
    if (a->exact_scene && a->within)
        printf("how sure        measured on this scene on both sides of it: within 1.5 times\n");
    else if (a->exact_scene)
        printf("how sure        measured on this scene, continued past what was measured: within 3 "
               "times\n");
    else
        printf(
            "how sure        carried over from '%s', the nearest that was measured, %.1f unlike\n"
            "                (log2 of vertices, side, stiffness, duration; 4 for contact, 2 for\n"
            "                wind, 3 for another name): a guess, which may be 10 times off;\n"
            "                'fabric accuracy dt --scene' measures it\n",
            a->measured_on, a->unlike);
    printf("--set time.integrator=%s --set time.step=%.9g --set time.steps=%d --set "
           "solution.%s=%g%s\n",
           a->integrator, s->step * s->steps / steps, steps,
           linear ? "tolerance" : "newton_tolerance", a->tolerance,
           linear ? "" : " --set solution.tolerance=0.01");
}

static int give_advice(const request *r) {
    char path[FILE_PATH_SIZE];
    curve_point *points;
    advice a;
    scene s;
    if (r->curves ? snprintf(path, sizeof path, "%s", r->curves) < 0
                  : files_find_beside_scenes("accuracy/curves.csv", path) != 0)
        return EXIT_FAILURE;
    if (read_scene(&s, r->scene_name, &r->settings) != 0)
        return EXIT_FAILURE;
    const int count = curves_read(path, &points);
    int status = count < 0 ? EXIT_FAILURE : EXIT_SUCCESS;
    if (count >= 0 && advise(&s, r->error, points, count, &a) != 0) {
        fprintf(stderr, "%s: no curve of any integrator\n", path);
        status = EXIT_FAILURE;
    } else if (count >= 0)
        print_advice(&s, &a);
    free(points);
    scene_free(&s);
    return status;
}

static int run_experiments(study *of, int name) {
    static const char *const refined = "mesh";
    for (int k = 0; k < EXPERIMENTS; k++)
        if (of->base.sheet_from == SHEET_FILE && strcmp(names[k], refined) == 0) {
            if (name == k || name == ALL)
                fprintf(stderr, "%s: its mesh is a file, which cannot be refined: no '%s'\n",
                        of->base.name, refined);
            if (name == k)
                return -1;
        } else if ((name == k || name == ALL) &&
                   (experiments[k](of) != 0 || study_plot(of, names[k]) != 0))
            return -1;
    return 0;
}

static int experiment(const request *r) {
    char error[256] = "";
    study of = {.folder = r->folder, .repeat = (int)r->repeat, .quick = r->quick};
    if (files_make_folder(r->folder) != 0 ||
        read_scene(&of.base, r->scene_name ? r->scene_name : "flap", &r->settings) != 0)
        return EXIT_FAILURE;
    const int least = r->quick ? (int)r->most_steps / 4 : 8;
    for (int steps = least; steps <= r->most_steps && of.step_count < MOST_COUNTS; steps *= 2)
        of.steps[of.step_count++] = steps;
    int status = -1;
    if (scene_mesh(&of.base, &of.cloth, NULL, error) != 0)
        fprintf(stderr, "%s: mesh: %s\n", of.base.name, error);
    else
        status = run_experiments(&of, r->name);
    if (status == 0)
        printf("tables and plots are in %s\n", r->folder);
    study_free(&of);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int run(const command *self, int argc, char **argv) {
    request r = {.name = -1, .folder = "accuracy", .repeat = 1, .most_steps = 64};
    const int wrong = read_request(self, argc, argv, &r);
    if (wrong >= 0)
        return wrong;
    return r.name == ADVISE ? give_advice(&r) : experiment(&r);
}

const command accuracy_command = {
    "accuracy",
    "dt|cg|newton|integrator|preconditioner|precision|sum|mesh|all|advise [SCENE] [options]",
    "Measures what accuracy costs in time; writes a table and a plot an experiment. 'advise' picks "
    "step,\nintegrator and tolerance for an error from curves measured before.",
    accuracy_options, run};
