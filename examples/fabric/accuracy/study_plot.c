/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* gnuplot scripts for the tables, and their pictures where gnuplot is installed. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "accuracy/study.h"
#include "files.h"

static const char common[] =
    "set terminal pngcairo size 720,460 font ',11'\n"
    "set datafile separator ','\nset key outside right\nset grid\nset style data linespoints\n"
    "integrators = 'linear-euler euler bdf2 midpoint'\n"
    "preconditioners = 'none jacobi block-jacobi gauss-seidel incomplete-cholesky'\n"
    "precisions = 'double float mixed'\n";

/* The first run of some experiments is the exact one that the others are compared with: skipped. */
static const struct {
    const char *name, *text;
} plots[] = {
    {"dt", "set format x '10^{%L}'\nset format y '10^{%L}'\nset logscale xy\nset output "
           "'dt-step.png'\nset xlabel 'step, s'\n"
           "set ylabel 'error, m rms'\n"
           "plot for [k in integrators] 'dt.csv' skip 1 using 5:(strcol(4) eq k ? $12 : NaN) "
           "title k pt 7, [0.002:0.03] 0.4*x title 'slope 1' with lines dt 2 lc 'gray', "
           "8*x**2 title 'slope 2' with lines dt 3 lc 'gray'\n"
           "set output 'dt-time.png'\nset xlabel 'CPU time, s'\n"
           "plot for [k in integrators] 'dt.csv' skip 1 using 11:(strcol(4) eq k ? $12 : NaN) "
           "title k pt 7, '' skip 1 using ($15==1 ? $11 : NaN):12 title 'front' "
           "with points pt 6 ps 2 lc 'black'\n"},
    {"cg", "set format x '10^{%L}'\nset format y '10^{%L}'\nset logscale xy\nset output "
           "'cg.png'\nset xlabel 'tolerance of the linear system'\n"
           "set ylabel 'error, m rms'\n"
           "plot [1e-9:1] 'cg.csv' skip 2 using 6:14 title 'against exact algebra' pt 7, "
           "'' skip 2 using 6:12 title 'against the reference' pt 7\n"},
    {"newton",
     "set format x '10^{%L}'\nset format y '10^{%L}'\nset logscale xy\nset output 'newton.png'\n"
     "set xlabel 'tolerance of Newton'\nset ylabel 'error, m rms'\n"
     "plot [1e-9:1] for [k in integrators] 'newton.csv' skip 1 using "
     "6:(strcol(4) eq k && $14 > 0 ? $14 : NaN) title k.', exact algebra' pt 7, "
     "for [k in integrators] '' skip 1 using 6:(strcol(4) eq k && $14 > 0 ? $12 : NaN) "
     "title k.', reference' pt 6 dt 2\n"},
    {"integrator", "set output 'energy.png'\nset xlabel 'time, s'\n"
                   "set ylabel 'change of total energy, J'\n"
                   "plot for [k in integrators] 'energy.csv' skip 1 using "
                   "2:(strcol(1) eq k ? $3 : NaN) title k with lines lw 2\n"
                   "set output 'robustness.png'\nset logscale xy\nunset key\n"
                   "set xlabel 'step, s'\nset ylabel 'stretch, N/m'\n"
                   "set palette defined (0 'forest-green', 1 'orange', 2 'red')\n"
                   "set cbrange [0:2]\nunset colorbox\nset multiplot layout 2,2\n"
                   "do for [k in integrators] { set title k.': green finished, orange halved, red "
                   "gave up' font ',8'\n"
                   "plot [5e-4:0.2] [3:3e6] 'robustness.csv' skip 1 using "
                   "(strcol(1) eq k ? $2 : NaN):3:4 with points pt 5 ps 2.5 palette }\n"
                   "unset multiplot\n"},
    {"preconditioner",
     "set logscale xy\nset output 'preconditioner.png'\n"
     "set xlabel 'CPU time, s'\nset ylabel 'error of the algebra, m rms'\n"
     "plot for [k in preconditioners.' direct'] 'preconditioner.csv' skip 2 using "
     "11:(strcol(4) eq k ? $14 : NaN) title k pt 7\n"},
    {"precision",
     "set format x '10^{%L}'\nset format y '10^{%L}'\nset logscale xy\nset output 'precision.png'\n"
     "set xlabel 'CPU time, s'\nset ylabel 'error of the algebra, m rms'\n"
     "plot for [k in precisions] 'precision.csv' skip 2 using "
     "11:(strcol(4) eq k ? $14 : NaN) title k pt 7\n"},
    {"mesh", "set logscale x\nset output 'mesh.png'\nset xlabel 'vertices'\n"
             "set ylabel 'lowest point, m'\nset y2label 'CPU time, s'\nset y2tics\n"
             "set ytics nomirror\nset logscale y2\n"
             "plot 'mesh.csv' skip 1 using 1:5 title 'lowest point' pt 7, "
             "'' skip 1 using 1:4 axes x1y2 title 'CPU time' pt 6\n"},
    {"sum", "set output 'sum.png'\nset xtics rotate by -60\nset style data histograms\nset style "
            "fill solid 0.6\n"
            "set ylabel 'time, s'\nset yrange [0:*]\nunset key\n"
            "plot 'sum.csv' skip 1 using "
            "5:xtic(sprintf('%s %s %s', strcol(2), strcol(3), strcol(4)))\n"},
};

static int run_gnuplot(const char *folder, const char *script) {
    fflush(NULL);
    const pid_t child = fork();
    if (child == 0) {
        if (chdir(folder) == 0)
            execlp("gnuplot", "gnuplot", script, (char *)NULL);
        _exit(127);
    }
    int status;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        return -1;
    return WEXITSTATUS(status);
}

int study_plot(const study *of, const char *name) {
    char path[FILE_PATH_SIZE], script[64];
    for (size_t k = 0; k < sizeof plots / sizeof *plots; k++) {
        if (strcmp(plots[k].name, name) != 0)
            continue;
        snprintf(script, sizeof script, "%s.gnuplot", name);
        if (files_join(path, of->folder, script) != 0)
            return -1;
        FILE *file = fopen(path, "w");
        if (!file ||
            fprintf(file, "%sset title '%s, %d vertices'\n%s", common, of->base.name,
                    of->cloth.vertex_count, plots[k].text) < 0 ||
            fclose(file) != 0) {
            fprintf(stderr, "%s: cannot be written: %s\n", path, strerror(errno));
            return -1;
        }
        const int status = run_gnuplot(of->folder, script);
        if (status == 127)
            fprintf(stderr, "accuracy: gnuplot is not installed; its script is %s\n", path);
        else if (status != 0)
            fprintf(stderr, "accuracy: gnuplot could not draw %s\n", path);
    }
    return 0;
}
