/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric run: simulates a scene and writes the results. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef _OPENMP
#include <omp.h>
#endif

#include "base/clock.h"
#include "commands/run.h"
#include "step/doubts.h"

enum { ERROR_SIZE = 256, EXIT_INTERRUPTED = 130 };

#define VALUE(field) offsetof(run_request, field)
static const option run_options[] = {
    {"-o", "DIR", "output folder (default: the scene's name and -run)", .offset = VALUE(folder)},
    {"--steps", "N", "number of steps, instead of the scene's", OPTION_WHOLE, VALUE(steps),
     .low = 0, .high = 1e9},
    {"--threads", "N", "number of threads (default: the fastest, up to OMP_NUM_THREADS)",
     OPTION_WHOLE, VALUE(threads), .low = 1, .high = 4096},
    SETTING_OPTION(run_request, "material.bend=0.01"),
    {"--progress", "STYLE", "auto, bar, lines, json or none", OPTION_CHOICE, VALUE(progress),
     .choices = progress_styles},
    {"--frames", "N", "number of states kept for pictures (default 25; 0: none)", OPTION_WHOLE,
     VALUE(frames), .low = 0, .high = 1e6},
    {"--checkpoint-every", "N",
     "write DIR/checkpoint every N steps and after the last (default 0: none)", OPTION_WHOLE,
     VALUE(every), .low = 0, .high = 1e9},
    {"--stop-after", "N", "end after step N with a checkpoint, as Ctrl-C does", OPTION_WHOLE,
     VALUE(stop_after), .low = 0, .high = 1e9},
    {"--resume", "DIR", "resume the run in DIR, or from a checkpoint FILE",
     .offset = VALUE(resume)},
    {.name = NULL}};

static volatile sig_atomic_t interrupted, has_state;

/* Handles the first signal; a second one ends the program at once. So does the first one while the
 * simulation is made: there is no state to save, and nothing has been written. */
static void note_interrupt(int signal_number) {
    static const char said[] = "\nends after this step; at once with another Ctrl-C\n";
    (void)signal_number;
    if (!has_state)
        _exit(EXIT_INTERRUPTED);
    interrupted = 1;
    if (write(STDERR_FILENO, said, sizeof said - 1) < 0)
        return; /* standard error is closed */
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
    (void)threads; /* this program has one thread */
#endif
}

/** Checks combinations of options. Returns OPTIONS_READ, or the exit status. */
static int check_request(const command *self, const run_request *r) {
    if (!r->scene_name && !r->resume)
        return options_complain(self, "which scene? %s", self->synopsis);
    if (r->resume && r->folder)
        return options_complain(self, "-o is for a run that begins: --resume goes on in the folder "
                                      "of the checkpoint");
    if (r->resume && r->frames != NOT_GIVEN)
        return options_complain(self, "--frames is for a run that begins: --resume keeps to what "
                                      "it began with");
    return OPTIONS_READ;
}

static int take_word(const options *o, void *request) {
    return options_only_word(o, &((run_request *)request)->scene_name, "scene");
}

/** Reads the command line. Returns OPTIONS_READ, or the exit status. */
static int read_request(const command *self, int argc, char **argv, run_request *r) {
    const int status = options_read(self, argc, argv, r, take_word);
    return status == OPTIONS_READ ? check_request(self, r) : status;
}

int take_setting(const options *o, void *list) {
    setting_list *settings = list;
    if (settings->count == MOST_SETTINGS)
        return options_complain(o->of, "more than %d times --set", MOST_SETTINGS);
    settings->setting[settings->count++] = o->value;
    return 0;
}

int make_settings(scene *s, const setting_list *settings) {
    for (int k = 0; k < settings->count; k++)
        if (scene_set(s, settings->setting[k]) != 0) {
            scene_free(s);
            return -1;
        }
    return 0;
}

int read_scene(scene *s, const char *name, const setting_list *settings) {
    char path[FILE_PATH_SIZE];
    if (files_find_scene(name, path) != 0 || scene_read(s, path) != 0)
        return -1;
    return make_settings(s, settings);
}

/** Sets the scene and the state from which the run starts: the scene's beginning, or a checkpoint.
 *  Returns 0, or -1 after a message. */
static int begin(cloth_run *run, const run_request *r) {
    if (r->resume)
        return run_resume(run, r);
    run->record.frames = r->frames != NOT_GIVEN ? r->frames : FRAMES;
    run->record.every = r->every != NOT_GIVEN ? r->every : 0;
    if (read_scene(&run->of, r->scene_name, &r->settings) != 0)
        return -1;
    if (r->steps != NOT_GIVEN)
        run->of.time.steps = (int)r->steps;
    return 0;
}

static int make_mesh(cloth_run *run) {
    const double start = clock_seconds();
    int *new_of_old = malloc((size_t)run->of.mesh.vertices * sizeof *new_of_old), status = -1;
    run->original = malloc((size_t)run->of.mesh.vertices * sizeof *run->original);
    if (!new_of_old || !run->original)
        fprintf(stderr, "%s: mesh: out of memory\n", run->of.name);
    else
        status = scene_mesh(&run->of, &run->cloth, new_of_old);
    for (int v = 0; status == 0 && v < run->of.mesh.vertices; v++)
        run->original[new_of_old[v]] = v;
    free(new_of_old);
    if (status != 0)
        return -1;
    run->account.mesh_seconds = clock_seconds() - start;
    scene_doubts(&run->of, &run->cloth, stderr);
    return 0;
}

/** Takes one step. Returns 0, or 1 if interrupted (the step is undone), or -1 after a message. */
static int take_step(cloth_run *run) {
    char error[ERROR_SIZE] = "";
    const double start = clock_seconds();
    const int status = simulation_step(run->sim, error);
    if (status != 0) {
        if (status < 0)
            fprintf(stderr, "%s: step %ld: %s\n", run->of.name, run->record.step + 1, error);
        return status;
    }
    run->record.seconds += clock_seconds() - start;
    run->record.step++;
    return 0;
}

/** Writes the step's frame if it is one, and a checkpoint if one is due or if the process ends
 *  before the run's last step. `ends` is true after the last step of this process. Returns 0, or -1
 *  after a message. */
static int keep_step(cloth_run *run, int ends) {
    const long every = run->record.every;
    const int done = run->record.step == run->of.time.steps;
    const int is_due = every > 0 && run->record.step > 0 && (run->record.step % every == 0 || done);
    if (run_write_frame(run) != 0)
        return -1;
    return is_due || (ends && !done) ? run_save(run) : 0;
}

/** Takes the remaining steps and reports progress. Returns 0, or -1 after a message. */
static int take_steps(cloth_run *run, const run_request *r) {
    const long steps = run->of.time.steps;
    const long last = r->stop_after != NOT_GIVEN && r->stop_after < steps ? r->stop_after : steps;
    const double before = run->record.seconds;
    progress told;
    int ends = interrupted || run->record.step >= last;
    int status = run->record.step == 0 || ends ? keep_step(run, ends) : 0;
    progress_begin(&told, (progress_style)r->progress, run->record.step, steps);
    while (status == 0 && !ends) {
        const int taken = take_step(run);
        status = taken < 0 ? -1 : 0;
        ends = interrupted || run->record.step >= last;
        if (taken == 0)
            progress_report(&told, run->record.step, simulation_time(run->sim),
                            simulation_counts(run->sim).iterations, run->record.seconds - before);
        if (status == 0)
            status = keep_step(run, ends);
    }
    progress_end(&told);
    return status;
}

/** Reports the result of the run, and how to resume it if it was interrupted. */
static void print_results(const cloth_run *run, const run_request *r) {
    const char *quote = strpbrk(run->folder, " \t!\"#$&()*;<>?[\\]`{|}~") ? "'" : "";
    if (run->account.interrupted)
        fprintf(stderr, "ended after step %ld of %d; to go on: %s run --resume %s%s%s\n",
                run->record.step, run->of.time.steps, program_name, quote, run->folder, quote);
    if (r->progress == PROGRESS_JSON || r->progress == PROGRESS_NONE)
        return;
    summary_print(&run->account);
    printf("results are in %s\n", run->folder);
}

static int finish(cloth_run *run, const run_request *r) {
    run->account.step_seconds = run->record.seconds;
    run->account.interrupted = run->record.step < run->of.time.steps;
    if (run_write_results(run) != 0)
        return -1;
    if (!run->account.interrupted && run->record.every == 0)
        run_forget(run);
    print_results(run, r);
    return 0;
}

static int make_simulation(cloth_run *run, const run_request *r) {
    char error[ERROR_SIZE] = "";
    const double start = clock_seconds();
    run->sim = simulation_new(&run->cloth, &run->of, error);
    if (!run->sim) {
        fprintf(stderr, "%s: %s\n", run->of.name, error);
        return -1;
    }
    if (r->threads == 0) /* threads were not given */
        simulation_choose_threads(run->sim);
    run->account = (run_account){.program = program_name,
                                 .of = &run->of,
                                 .cloth = &run->cloth,
                                 .sim = run->sim,
                                 .threads = threads_in_use(),
                                 .mesh_seconds = run->account.mesh_seconds,
                                 .setup_seconds = clock_seconds() - start};
    if (run->from.memory && run_restore(run) != 0)
        return -1;
    simulation_stop_when(run->sim, &interrupted);
    return 0;
}

/** Makes and runs the simulation. Removes and writes nothing before the simulation has been made
 *  without errors. */
static int simulate(cloth_run *run, const run_request *r) {
    if (begin(run, r) != 0 || make_mesh(run) != 0 || make_simulation(run, r) != 0)
        return -1;
    has_state = 1;
    return run_prepare_folder(run, r) == 0 && take_steps(run, r) == 0 ? finish(run, r) : -1;
}

static int run(const command *self, int argc, char **argv) {
    run_request r = {
        .steps = NOT_GIVEN, .stop_after = NOT_GIVEN, .frames = NOT_GIVEN, .every = NOT_GIVEN};
    const int read = read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    cloth_run *all = calloc(1, sizeof *all);
    if (!all) {
        fprintf(stderr, "out of memory\n");
        return EXIT_FAILURE;
    }
    r.progress = (int)progress_resolve((progress_style)r.progress);
    set_threads(r.threads);
    const struct sigaction noted = {.sa_handler = note_interrupt, .sa_flags = (int)SA_RESETHAND};
    sigaction(SIGINT, &noted, NULL);
    sigaction(SIGTERM, &noted, NULL);
    const int status = simulate(all, &r), ended_early = interrupted && all->account.interrupted;
    simulation_free(all->sim);
    mesh_free(&all->cloth);
    free(all->original);
    scene_free(&all->of);
    checkpoint_free(&all->from);
    free(all);
    return status != 0 ? EXIT_FAILURE : ended_early ? EXIT_INTERRUPTED : EXIT_SUCCESS;
}

const command run_command = {
    "run", "SCENE [options], or --resume DIR [options]",
    "Simulates a scene (a file, or a name in the scenes folder); writes "
    "DIR/summary.json,\nDIR/final.state, DIR/scene.yaml and states for "
    "pictures in DIR/frames.\nCtrl-C ends it after the current step; "
    "--resume DIR continues with the same bits as an\nuninterrupted run, and "
    "needs no SCENE.",
    run_options, run};
