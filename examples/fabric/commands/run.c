/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric run: simulates a scene and writes what came of it. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "clock.h"
#include "commands/commands.h"
#include "files.h"
#include "output/progress.h"
#include "output/state.h"
#include "output/summary.h"
#include "simulation.h"

enum { ERROR_SIZE = 256, EXIT_INTERRUPTED = 130, FRAMES = 25 };

enum { OUTPUT, STEPS, THREADS, SET, PROGRESS, FRAME_COUNT };
static const option run_options[] = {
    [OUTPUT] = {"-o", "DIR", "where results go (default: the scene's name and -run)"},
    [STEPS] = {"--steps", "N", "how many steps, instead of the scene's"},
    [THREADS] = {"--threads", "N", "threads, instead of OMP_NUM_THREADS"},
    [SET] = {"--set", "KEY=VALUE", "change a key of the scene, such as material.bend=0.01"},
    [PROGRESS] = {"--progress", "STYLE", "auto, bar, lines, json or none"},
    [FRAME_COUNT] = {"--frames", "N", "how many states to keep for pictures (default 25; 0: none)"},
    {NULL, NULL, NULL}};

/** What the command line asks for. */
typedef struct request {
    const char *scene_name;
    const char *folder;
    long steps; /* -1: the scene's */
    long threads;
    long frames;
    progress_style progress;
    setting_list settings;
} request;

/** All that a run has in hand. */
typedef struct cloth_run {
    scene of;
    mesh cloth;
    int *original; /* [vertices] number of each vertex in the mesh as generated */
    simulation *sim;
    char folder[FILE_PATH_SIZE];
    char frames_folder[FILE_PATH_SIZE];
    run_account account;
} cloth_run;

static volatile sig_atomic_t interrupted;

static void note_interrupt(int signal_number) {
    (void)signal_number;
    interrupted = 1;
}

static int threads_in_use(void) {
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

static void set_threads(long threads) {
#ifdef _OPENMP
    if (threads > 0)
        omp_set_num_threads((int)threads);
#else
    (void)threads; /* this program has one */
#endif
}

/** Exit status, or -1 to go on. */
static int read_request(const command *self, int argc, char **argv, request *r) {
    options o = {self, argc, argv, 0, NULL, 0};
    int wrong = 0, number;
    for (int next; !wrong && (next = options_next(&o)) != OPTIONS_END;)
        switch (next) {
        case OUTPUT:
            r->folder = o.value;
            break;
        case STEPS:
            wrong = options_whole(&o, "--steps", 0, 1000000000, &r->steps);
            break;
        case THREADS:
            wrong = options_whole(&o, "--threads", 1, 4096, &r->threads);
            break;
        case SET:
            wrong = add_setting(self, &r->settings, o.value);
            break;
        case PROGRESS:
            number = options_choice(&o, "--progress", progress_styles);
            wrong = number < 0;
            r->progress = (progress_style)number;
            break;
        case FRAME_COUNT:
            wrong = options_whole(&o, "--frames", 0, 1000000, &r->frames);
            break;
        case OPTIONS_WORD:
            if (r->scene_name)
                return options_complain(self, "one scene at a time, not '%s' as well", o.value);
            r->scene_name = o.value;
            break;
        case OPTIONS_HELP:
            return EXIT_SUCCESS;
        default:
            return EXIT_USAGE;
        }
    if (wrong)
        return EXIT_USAGE;
    return r->scene_name ? -1 : options_complain(self, "which scene? %s", self->synopsis);
}

int add_setting(const command *self, setting_list *settings, const char *setting) {
    if (settings->count == MOST_SETTINGS)
        return options_complain(self, "more than %d times --set", MOST_SETTINGS);
    settings->setting[settings->count++] = setting;
    return 0;
}

int read_scene(scene *s, const char *name, const setting_list *settings) {
    char path[FILE_PATH_SIZE];
    if (files_find_scene(name, path) != 0 || scene_read(s, path) != 0)
        return -1;
    for (int k = 0; k < settings->count; k++)
        if (scene_set(s, settings->setting[k]) != 0) {
            scene_free(s);
            return -1;
        }
    return 0;
}

/** Removes what an earlier run left, so that nothing of it passes for this run's. */
static void remove_old_results(const cloth_run *run) {
    static const char *const results[] = {"final.state", "summary.json"};
    static const char *const suffixes[] = {".state", ".png"};
    char path[FILE_PATH_SIZE], name[32];
    for (int k = 0; k < 2; k++) {
        long *numbers;
        if (files_join(path, run->folder, results[k]) == 0)
            remove(path);
        const int count = files_numbered(run->frames_folder, suffixes[k], &numbers);
        for (int i = 0; i < count; i++) {
            snprintf(name, sizeof name, "%04ld%s", numbers[i], suffixes[k]);
            if (files_join(path, run->frames_folder, name) == 0)
                remove(path);
        }
        if (count > 0)
            free(numbers);
    }
}

/** The default folder: the scene's name without folders and .yaml, and "-run". */
static int name_folder(cloth_run *run, const request *r) {
    const char *slash = strrchr(r->scene_name, '/');
    const char *name = slash ? slash + 1 : r->scene_name;
    const size_t length = strlen(name);
    const size_t stem = length > 5 && strcmp(name + length - 5, ".yaml") == 0 ? length - 5 : length;
    const int written = r->folder
                            ? snprintf(run->folder, FILE_PATH_SIZE, "%s", r->folder)
                            : snprintf(run->folder, FILE_PATH_SIZE, "%.*s-run", (int)stem, name);
    if (written < FILE_PATH_SIZE)
        return files_join(run->frames_folder, run->folder, "frames");
    fprintf(stderr, "%.100s...: path too long\n", run->folder);
    return -1;
}

static int prepare_folder(cloth_run *run, const request *r) {
    char path[FILE_PATH_SIZE];
    if (name_folder(run, r) != 0 || files_make_folder(run->frames_folder) != 0 ||
        files_join(path, run->folder, "scene.yaml") != 0)
        return -1;
    remove_old_results(run);
    if (scene_write(&run->of, path) == 0)
        return 0;
    fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
    return -1;
}

static int make_mesh(cloth_run *run) {
    char error[ERROR_SIZE] = "";
    const double start = clock_seconds();
    int *new_of_old = malloc((size_t)run->of.vertices * sizeof *new_of_old);
    run->original = malloc((size_t)run->of.vertices * sizeof *run->original);
    if (!new_of_old || !run->original)
        snprintf(error, sizeof error, "out of memory");
    else if (scene_mesh(&run->of, &run->cloth, new_of_old, error) == 0) {
        for (int v = 0; v < run->of.vertices; v++)
            run->original[new_of_old[v]] = v;
        run->account.mesh_seconds = clock_seconds() - start;
        free(new_of_old);
        return 0;
    }
    fprintf(stderr, "%s: mesh: %s\n", run->of.name, error);
    free(new_of_old);
    return -1;
}

static state state_of(const cloth_run *run, unsigned parts, long step) {
    return (state){.vertex_count = run->cloth.vertex_count,
                   .triangle_count = run->cloth.triangle_count,
                   .time = simulation_time(run->sim),
                   .step = step,
                   .parts = parts,
                   .position = &simulation_positions(run->sim)[0][0],
                   .velocity = &simulation_velocities(run->sim)[0][0],
                   .triangle = &run->cloth.triangle[0][0],
                   .original = run->original};
}

/** A frame at step 0 and at the last, and in between as many as asked for, evenly. */
static int write_frame(const cloth_run *run, long frames, long step) {
    const long steps = run->of.steps, gaps = frames - 1;
    char name[32], path[FILE_PATH_SIZE];
    if (frames <= 0)
        return 0;
    if (step > 0 && step < steps && step * gaps / steps == (step - 1) * gaps / steps)
        return 0;
    /* The first frame has the triangles; the others share them. */
    const state s = state_of(run, step == 0 ? STATE_SINGLE | STATE_TRIANGLES : STATE_SINGLE, step);
    snprintf(name, sizeof name, "%04ld.state", step);
    return files_join(path, run->frames_folder, name) == 0 ? state_write(&s, path) : -1;
}

static int take_steps(cloth_run *run, const request *r) {
    char error[ERROR_SIZE] = "";
    const long steps = run->of.steps;
    int status = write_frame(run, r->frames, 0);
    double seconds = 0.0;
    for (long step = 1; status == 0 && step <= steps && !interrupted; step++) {
        const double start = clock_seconds();
        if (simulation_step(run->sim, error) != 0) {
            fprintf(stderr, "%s: step %ld: %s\n", run->of.name, step, error);
            status = -1;
        } else {
            seconds += clock_seconds() - start;
            progress_tell(r->progress, step, steps, simulation_time(run->sim),
                          simulation_iterations(run->sim), seconds);
            status = write_frame(run, r->frames, step);
        }
    }
    run->account.step_seconds = seconds;
    run->account.interrupted = interrupted != 0;
    return status;
}

static int write_results(const cloth_run *run, const request *r) {
    char path[FILE_PATH_SIZE];
    const state s = state_of(run, STATE_VELOCITIES | STATE_TRIANGLES | STATE_ORIGINAL,
                             simulation_steps_taken(run->sim));
    if (files_join(path, run->folder, "final.state") != 0 || state_write(&s, path) != 0 ||
        files_join(path, run->folder, "summary.json") != 0 ||
        summary_write(&run->account, path) != 0)
        return -1;
    if (r->progress == PROGRESS_JSON || r->progress == PROGRESS_NONE)
        return 0;
    summary_print(&run->account);
    printf("results are in %s\n", run->folder);
    return 0;
}

static int simulate(cloth_run *run, const request *r) {
    char error[ERROR_SIZE] = "";
    if (prepare_folder(run, r) != 0 || make_mesh(run) != 0)
        return -1;
    const double start = clock_seconds();
    run->sim = simulation_new(&run->cloth, &run->of, error);
    if (!run->sim) {
        fprintf(stderr, "%s: %s\n", run->of.name, error);
        return -1;
    }
    run->account = (run_account){.program = program_name,
                                 .of = &run->of,
                                 .cloth = &run->cloth,
                                 .sim = run->sim,
                                 .threads = threads_in_use(),
                                 .mesh_seconds = run->account.mesh_seconds,
                                 .setup_seconds = clock_seconds() - start};
    return take_steps(run, r) == 0 ? write_results(run, r) : -1;
}

static int run(const command *self, int argc, char **argv) {
    request r = {.steps = -1, .frames = FRAMES};
    cloth_run all = {0};
    const int wrong = read_request(self, argc, argv, &r);
    if (wrong >= 0)
        return wrong;
    if (read_scene(&all.of, r.scene_name, &r.settings) != 0)
        return EXIT_FAILURE;
    if (r.steps >= 0)
        all.of.steps = (int)r.steps;
    r.progress = progress_resolve(r.progress);
    set_threads(r.threads);
    const struct sigaction noted = {.sa_handler = note_interrupt};
    sigaction(SIGINT, &noted, NULL);
    sigaction(SIGTERM, &noted, NULL);
    const int status = simulate(&all, &r);
    simulation_free(all.sim);
    mesh_free(&all.cloth);
    free(all.original);
    scene_free(&all.of);
    return status != 0 ? EXIT_FAILURE : interrupted ? EXIT_INTERRUPTED : EXIT_SUCCESS;
}

const command run_command = {"run", "SCENE [options]",
                             "Simulates a scene (a file, or a name in the scenes folder); writes "
                             "DIR/summary.json,\nDIR/final.state, DIR/scene.yaml and states for "
                             "pictures in DIR/frames.",
                             run_options, run};
