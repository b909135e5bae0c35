/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric-view plot: the tables of `fabric accuracy` as pictures, by gnuplot. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/files.h"
#include "view/view.h"

static const option no_options[] = {{.name = NULL}};

static const char *const tables[] = {"dt",     "cg",         "newton",         "energy",
                                     "mesh",   "robustness", "preconditioner", "precision",
                                     "solver", "sum",        "horizon"};

/** Runs gnuplot in `folder`. Scripts find their own folder in gnuplot's variable `plots`. Returns
 *  gnuplot's exit status, 127 if it cannot be started, or -1 if it does not exit normally. */
static int run_gnuplot(const char *folder, const char *plots, const char *name) {
    char definition[FILE_PATH_SIZE + 16], common[FILE_PATH_SIZE + 32], script[FILE_PATH_SIZE + 32];
    snprintf(definition, sizeof definition, "plots = '%s/'", plots);
    snprintf(common, sizeof common, "%s/common.gnuplot", plots);
    snprintf(script, sizeof script, "%s/%s.gnuplot", plots, name);
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0)
            execlp("gnuplot", "gnuplot", "-e", definition, "study.gnuplot", common, script,
                   (char *)NULL);
        _exit(127);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

/** Draws the tables that exist. Returns 0, or -1 after a message. */
static int draw(const char *folder) {
    char plots[FILE_PATH_SIZE], name[64], path[FILE_PATH_SIZE];
    int drawn = 0;
    if (files_in_program_folder(plots, "../share/fabric/plots") != 0) {
        fprintf(stderr,
                "the folder of gnuplot's scripts cannot be found: this program's own folder "
                "is unknown, or its path too long\n");
        return -1;
    }
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++) {
        snprintf(name, sizeof name, "%s.csv", tables[k]);
        if (files_join(path, folder, name) != 0)
            return -1;
        if (access(path, R_OK) != 0)
            continue;
        const int status = run_gnuplot(folder, plots, tables[k]);
        if (status != 0) {
            fprintf(stderr, "%s: %s\n", path,
                    status == 127 ? "gnuplot cannot be started: is it installed?"
                                  : "gnuplot could not draw it");
            return -1;
        }
        drawn++;
    }
    if (drawn > 0)
        printf("%d tables drawn in %s\n", drawn, folder);
    else
        fprintf(stderr, "%s: no table of 'fabric accuracy' in it\n", folder);
    return drawn > 0 ? 0 : -1;
}

static int run(const command *self, int argc, char **argv) {
    view_request r;
    const int read = view_read_request(self, argc, argv, &r);
    if (read != OPTIONS_READ)
        return read;
    return draw(r.folder) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

const command plot_command = {"plot", "DIR", "Draws the tables of 'fabric accuracy' by gnuplot.",
                              no_options, run};
