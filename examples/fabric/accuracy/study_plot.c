/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* gnuplot scripts for the tables, and their pictures where gnuplot is installed. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "accuracy/study.h"
#include "base/files.h"

/* Labels are next to their lines, in the same colours. Not formatted: the text is gnuplot. */
/* clang-format off */
static const char common[] =
    "set terminal pngcairo size 900,560 font 'sans,12'\n"
    "set datafile separator ','\nset datafile missing NaN\nunset key\nset grid lc rgb '#dddddd'\nset border 3\n"
    "set tics nomirror\nset format '%g'\n"
    "integrators = 'linear-euler euler bdf2 midpoint'\n"
    "preconditioners = 'none jacobi block-jacobi gauss-seidel incomplete-cholesky direct'\n"
    "precisions = 'double float mixed'\n"
    "color(n) = word('#0072b2 #d55e00 #009e73 #aa3399 #996600 #000000', n)\n"
    "say(k) = k eq 'linear-euler' ? 'linearised Euler' : k eq 'euler' ? \"Euler, Newton's method\" "
    ": k eq 'bdf2' ? 'BDF2' : k\n"
    "nice = '(1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, "
    "1000)'\n"
    "is(k) = strcol(4) eq k\n";

/* The first run of some experiments is the exact one that the others are compared with: skipped. */
static const char dt_plot[] =
    "stats 'dt.csv' skip 1 using (is('midpoint') ? $5 : NaN) nooutput\n"
    "fine = STATS_min\ncoarse = STATS_max\n"
    "stats 'dt.csv' skip 1 using 11 nooutput\nfast = STATS_min\nslow = STATS_max\n"
    "stats 'dt.csv' skip 1 using ($12 > 0 ? $12 * 1e3 : NaN) nooutput\n"
    "small = STATS_min\nlarge = STATS_max\nset logscale xy\n"
    "set output 'dt-time.png'\n"
    "set title 'Error against CPU time: '.scene.'; grey: the front; square: as the scene is'\n"
    "set xlabel 'CPU time of the run, s'\nset ylabel 'error at the end, mm (root mean square)'\n"
    "set xrange [fast / 1.5 : slow * 3]\nset yrange [small / 2 : large * 2]\n"
    "set xtics @nice\n"
    "plot 'dt.csv' skip 1 using ($15 == 1 ? $11 : NaN):($12 * 1e3) smooth unique with lines lw 12 "
    "lc rgb '#cccccc', "
    "for [n=1:4] '' skip 1 using (is(word(integrators, n)) ? $11 : NaN):($12 * 1e3) "
    "with linespoints lw 2 pt 7 lc rgb color(n), "
    "'' skip 1 using (is('linear-euler') && $5 == coarse ? $11 : NaN)"
    ":($12 * 1e3):(say('linear-euler')) with labels left offset 1,0.6 tc rgb color(1), "
    "'' skip 1 using (is('euler') && $5 == coarse ? $11 : NaN):($12 * 1e3):(say('euler')) "
    "with labels left offset 0.5,0.9 tc rgb color(2), "
    "for [n=3:4] '' skip 1 using (is(word(integrators, n)) && $5 == fine ? $11 : NaN)"
    ":($12 * 1e3):(say(word(integrators, n))) with labels left offset 1,(n == 3 ? 0.7 : 0) "
    "tc rgb color(n), "
    "'' skip 1 using (is('default') ? $11 : NaN):($12 * 1e3) with points pt 4 ps 2.5 lw 2 lc "
    "'black'\n"
    "set output 'dt-step.png'\nset title 'Error against step: '.scene\n"
    "set xlabel 'step, ms'\nset xrange [fine * 700 : coarse * 3000]\n"
    "slope(x, n, k) = large * k * (x / (1e3 * coarse))**n\n"
    "set label 1 'slope 1' at 1e3 * fine, slope(1e3 * fine, 1, 2) right offset -0.5,0 tc rgb '#777777'\n"
    "set label 2 'slope 2' at 1e3 * fine, slope(1e3 * fine, 2, 0.1) right offset -0.5,0 tc rgb '#777777'\n"
    "set yrange [small / 4 : large * 4]\n"
    "plot sample [1e3 * fine : 1e3 * coarse] '+' using 1:(slope($1, 1, 2)) with lines dt 2 lc rgb "
    "'#777777', [1e3 * fine : 1e3 * coarse] '+' using 1:(slope($1, 2, 0.1)) with lines dt 2 lc rgb "
    "'#777777', "
    "for [n=1:4] 'dt.csv' skip 1 using (is(word(integrators, n)) ? $5 * 1e3 : NaN):($12 * 1e3) "
    "with linespoints lw 2 pt 7 lc rgb color(n), "
    "for [n=1:4] '' skip 1 using (is(word(integrators, n)) && $5 == coarse ? $5 * 1e3 : NaN)"
    ":($12 * 1e3):(say(word(integrators, n))) with labels left offset 1,0 tc rgb color(n)\n"
    "unset label\n"
    "set terminal pngcairo size 1200,480 font 'sans,11'\nset output 'dt-measures.png'\n"
    "amount(p) = column(20 + p) > 0 ? column(20 + p) * 1e3**p : NaN\n"
    "set xrange [*:*]\nset yrange [*:*]\nmeasures = ''\n"
    "do for [p=0:2] {\n  undefine STATS_*\n  stats 'dt.csv' skip 1 using (amount(p)) nooutput\n"
    "  if (exists('STATS_records') && STATS_records > 0) { measures = measures.p.' ' }\n}\n"
    "panels = words(measures)\nset multiplot layout 1,panels title scene.': other errors at the end of the run, by CPU time'\n"
    "set xlabel 'CPU time, s'\nset xrange [fast / 3 : slow * 1.5]\n"
    "set format y '10^{%L}'\nunset title\n"
    "titles = '\"strain of the triangle stretched most\" \"energy, mJ\" \"depth in a body, um\"'\n"
    "do for [k in measures] {\n  p = int(k)\n  set ylabel word(titles, p + 1)\n"
    "  plot for [n=1:4] 'dt.csv' skip 1 using (is(word(integrators, n)) ? $11 : NaN)"
    ":(amount(p)) with linespoints lw 2 pt 7 lc rgb color(n), "
    "for [n=1:4] '' skip 1 using (is(word(integrators, n)) && $5 == coarse ? $11 : NaN)"
    ":(amount(p)):(word('\"linearised Euler\" Euler BDF2 midpoint', n)) with labels right offset -1,"
    "(n == 3 ? -0.6 : 0) tc rgb color(n)\n}\n"
    "unset multiplot\n";

static const char cg_plot[] =
    "stats 'cg.csv' skip 1 every ::0::0 using ($12 * 1e3) nooutput\nfloor = STATS_min\n"
    "stats 'cg.csv' skip 2 using ($14 * 1e3 < 0.1 * floor ? $6 : NaN) nooutput\n"
    "worth = STATS_max\n"
    "set terminal pngcairo size 900,760 font 'sans,12'\nset output 'cg.png'\nset logscale xy\n"
    "set multiplot layout 2,1 title 'What the tolerance of the linear systems costs and buys: '"
    ".scene\n"
    "set xrange [0.2 : 5e-9]\nset ytics @nice\nset lmargin 11\nset format x '10^{%L}'\n"
    "set object 1 rectangle from worth, graph 0 to 5e-9, graph 1 behind fc rgb '#eeeeee' fs "
    "noborder\n"
    "set label 1 'wasted: the algebra is below a tenth of the error of the step' at 6e-9, graph "
    "0.08 "
    "right tc rgb '#777777'\n"
    "set ylabel 'CPU time of the run, s'\n"
    "plot 'cg.csv' skip 2 using 6:11 with linespoints lw 2 pt 7 lc rgb color(1)\n"
    "unset label 1\nunset object 1\n"
    "set object 2 rectangle from graph 0, graph 0 to graph 1, first floor behind fc rgb '#eeeeee' "
    "fs noborder\n"
    "set label 2 sprintf('the error of the step, %.3g mm: no tolerance gets below', floor) "
    "at 6e-9, floor right offset 0,-0.9 tc rgb '#777777'\n"
    "set xlabel 'tolerance'\nset ytics autofreq\nset ylabel 'error at the end, mm (root mean square)'\n"
    "plot 'cg.csv' skip 2 using 6:($12 * 1e3) with linespoints lw 2 pt 7 lc rgb color(1), "
    "'' skip 2 using 6:($14 * 1e3) with linespoints lw 2 pt 7 lc rgb color(2), "
    "'' skip 2 using ($6 == 1e-2 ? $6 : NaN):($12 * 1e3):('of the whole') with labels left "
    "offset 1,0.9 tc rgb color(1), "
    "'' skip 2 using ($6 == 1e-4 ? $6 : NaN):($14 * 1e3):('of the algebra alone') with labels left "
    "offset 2,0.5 tc rgb color(2)\nunset multiplot\n";

static const char newton_plot[] =
    "set logscale xy\nset output 'newton.png'\nset yrange [*:100]\nset format xy '10^{%L}'\n"
    "set title \"Error of Newton's method alone (solid), and of the whole (dashed): \".scene\n"
    "set xlabel \"tolerance of Newton's method\"\nset ylabel 'error at the end, mm (root mean "
    "square)'\n"
    "set xrange [0.3 : 2e-9]\n"
    "plot for [n=2:4] 'newton.csv' skip 1 using "
    "6:(is(word(integrators, n)) && $14 > 0 ? $14 * 1e3 : NaN) with linespoints lw 2 pt 7 "
    "lc rgb color(n), "
    "for [n=2:4] '' skip 1 using 6:(is(word(integrators, n)) && $14 > 0 ? $12 * 1e3 : NaN) "
    "with linespoints lw 2 dt 2 pt 6 lc rgb color(n), "
    "for [n=2:4] '' skip 1 using ($6 == 1e-6 ? $6 : NaN):"
    "(is(word(integrators, n)) ? $12 * 1e3 : NaN):(say(word(integrators, n))) "
    "with labels center offset 0,(n == 4 ? -0.9 : 0.7) tc rgb color(n)\n";

static const char integrator_plot[] =
    "stats 'energy.csv' skip 1 using 2 nooutput\nend = STATS_max\n"
    "set output 'energy.png'\nset xlabel 'time, s'\nset ylabel 'change of total energy, mJ'\n"
    "set title 'Energy without damping and drag: '.scene\nset xrange [0 : end * 1.4]\n"
    "set offsets 0, 0, graph 0.05, graph 0.1\n"
    "plot for [n=1:4] 'energy.csv' skip 1 using 2:"
    "(strcol(1) eq word(integrators, n) ? $3 * 1e3 : NaN) with lines lw 2 lc rgb color(n), "
    "for [n=1:4] '' skip 1 using (strcol(1) eq word(integrators, n) && $2 == end ? $2 : NaN)"
    ":($3 * 1e3):(say(word(integrators, n))) with labels left offset 1,"
    "(n == 1 ? -0.7 : n == 2 ? 0.4 : n == 3 ? -0.4 : 0.4) tc rgb color(n)\n"
    "unset offsets\nset terminal pngcairo size 900,760 font 'sans,11'\n"
    "set output 'robustness.png'\n"
    "set logscale xy\nset palette defined (0 '#009e73', 1 '#e69f00', 2 '#d50000')\n"
    "set cbrange [0:2]\nunset colorbox\n"
    "set multiplot layout 2,2 title 'What step and stiffness each survives: '.scene\n"
    "set label 1 'finished' at screen 0.32, 0.955 tc rgb '#009e73'\n"
    "set label 2 'steps halved' at screen 0.45, 0.955 tc rgb '#b87f00'\n"
    "set label 3 'gave up' at screen 0.62, 0.955 tc rgb '#d50000'\n"
    "set xlabel 'step, ms'\nset ylabel 'stretch, N/m'\nset format y '10^{%L}'\n"
    "do for [k in integrators] { set title say(k) offset 0,-0.7\n"
    "plot [0.5:200] [3:3e6] 'robustness.csv' skip 1 using "
    "(strcol(1) eq k ? $2 * 1e3 : NaN):3:4 with points pt 5 ps 3 palette }\nunset multiplot\n";

/* Error of the algebra against time, for names in the fourth column. */
#define AGAINST_TIME(NAME, TITLE, NAMES) \
    "names = " NAMES "\n" \
    "hue(k) = strstrt(names, k) ? color(words(names[1:strstrt(names, k)])) : color(1)\n" \
    "stats '" NAME ".csv' skip 2 using 11 nooutput\nfast = STATS_min\nslow = STATS_max\n" \
    "set logscale xy\nset output '" NAME ".png'\nset title '" TITLE ": '.scene\n" \
    "set xlabel 'CPU time of the run, s'\nset xtics @nice\n" \
    "set ylabel 'error of the algebra alone, mm (root mean square)'\nset format y '10^{%L}'\n" \
    "set xrange [fast / 1.5 : slow * 2]\n" \
    "stats '" NAME ".csv' skip 2 using ($6 > 0 ? $6 : NaN) nooutput\nfinest = STATS_min\n" \
    "stats '" NAME ".csv' skip 2 using ($14 > 0 ? $14 * 1e3 : NaN) nooutput\n" \
    "set yrange [STATS_min / 10 : STATS_max * 10]\n" \
    "at(k) = k eq 'gauss-seidel' ? 1e-4 : strstrt('none double float', k) ? 1e-6 : 1e-8\n" \
    "named(k) = is(k) && $6 == (at(k) < finest ? finest : at(k))\n" \
    "plot for [k in names] '" NAME ".csv' skip 2 using 11:(is(k) ? $14 * 1e3 : NaN) " \
    "with linespoints lw 2 pt 7 lc rgb hue(k), " \
    "for [k in 'none jacobi double'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) " \
    "with labels left offset 1,(k eq 'jacobi' ? -0.9 : 0.4) tc rgb hue(k), " \
    "for [k in 'gauss-seidel float mixed'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) " \
    "with labels right offset -0.7,-0.7 tc rgb hue(k), " \
    "for [k in 'block-jacobi incomplete-cholesky'] '' skip 2 using (named(k) ? $11 : NaN):($14 * 1e3):(k) " \
    "with labels center offset (k eq 'block-jacobi' ? 3 : 0),(k eq 'block-jacobi' ? -2.2 : -0.9) tc rgb hue(k), " \
    "'' skip 2 using (is('direct') ? $11 : NaN):($14 * 1e3):('direct') with labels left offset 1,0\n"

static const char mesh_plot[] =
    "set terminal pngcairo size 1200,480 font 'sans,11'\nset logscale x\nset output 'mesh.png'\n"
    "stats 'mesh.csv' skip 1 using 1 nooutput\nset xrange [STATS_min / 1.5 : STATS_max * 1.5]\n"
    "set multiplot layout 1,2 title 'Finer meshes: '.scene\nset xlabel 'vertices'\n"
    "set offsets 0, 0, graph 0.1, graph 0.1\n"
    "set ylabel 'lowest point at the end, mm'\n"
    "plot 'mesh.csv' skip 1 using 1:($5 * 1e3):xtic(1) with linespoints lw 2 pt 7 lc rgb color(1)\n"
    "set logscale y\nset ylabel 'CPU time of the run, s'\n"
    "plot 'mesh.csv' skip 1 using 1:4:xtic(1) with linespoints lw 2 pt 7 lc rgb color(2)\n"
    "unset multiplot\n";

static const char sum_plot[] =
    "set terminal pngcairo size 1200,480 font 'sans,11'\nset output 'sum.png'\n"
    "set multiplot layout 1,2 title 'Orders of reduction, at 1, 2 and 3 threads: '.scene\n"
    "row(n) = 6 - floor(n / 3)\nline(n, k) = row(n) + 0.25 * (2 - k)\n"
    "way(n) = strcol(1).', '.strcol(2).(strcol(3) eq 'plain' ? '' : ', '.strcol(3))\n"
    "set yrange [0.4:6.6]\nset lmargin at screen 0.26\nset rmargin at screen 0.58\n"
    "set xlabel 'CPU time of the run, s'\nset logscale x\nset offsets graph 0.1, graph 0.1, 0, 0\n"
    "set xtics @nice\n"
    "plot 'sum.csv' skip 1 using 6:(row($0)):ytic(way(0)) with points pt 0 lc rgb 'white', "
    "'' skip 1 using 6:(line($0, $4)) with points pt 7 ps 1.5 lc rgb color(1), "
    "'' skip 1 using 6:(line($0, $4)):4 with labels left offset 1,0\n"
    "set lmargin at screen 0.64\nset rmargin at screen 0.97\nset format x '10^{%L}'\n"
    "set xtics autofreq\nset xlabel 'largest distance from the first, m (left: none)'\n"
    "set ytics ('' 1, '' 2, '' 3, '' 4, '' 5, '' 6)\ndistance(d) = d > 1e-17 ? d : 1e-17\n"
    "plot 'sum.csv' skip 1 using (distance($7)):(line($0, $4)) with points pt 7 ps 1.5 lc rgb color(2), "
    "'' skip 1 using (distance($7)):(line($0, $4)):4 with labels left offset 1,0\n"
    "unset multiplot\n";

static const char solver_plot[] =
    "set terminal pngcairo size 1200,520 font 'sans,11'\nset output 'solver.png'\n"
    "set logscale xy\nset multiplot layout 1,3 title 'Direct against iterative: '.scene\n"
    "stats 'solver.csv' skip 1 using ($11 / $7 * 1e3) nooutput\n"
    "least = STATS_min / 2\nmost = STATS_max * 2\nset xrange [0.7:300]\nset xtics (1, 3.3, 10, 33)\n"
    "set xlabel 'step, ms'\nset ylabel 'CPU time of a step, ms'\n"
    "ways = '\"gauss-seidel to 1e-2\" \"gauss-seidel to 1e-6\" direct'\n"
    "do for [p=0:2] {\n"
    "  undefine STATS_*\n"
    "  set autoscale\n  stats 'solver.csv' skip 1 using (floor($0 / 12) == p ? $3 : 1/0) nooutput\n"
    "  if (exists('STATS_records') && STATS_records > 0) {\n    size = STATS_max\n    set xrange [0.7:300]\n    set yrange [least:most]\n"
    "    set title sprintf('%d vertices', size)\n"
    "    plot for [n=1:3] 'solver.csv' skip 1 using ($3 == size && is(word(ways, n)) ? $5 * 1e3 : "
    "NaN)"
    ":($11 / $7 * 1e3) with linespoints lw 2 pt 7 lc rgb color(n), "
    "for [n=1:3] '' skip 1 using ($3 == size && $5 > 0.03 && is(word(ways, n)) ? $5 * 1e3 : NaN)"
    ":($11 / $7 * 1e3):(word('\"to 1e-2\" \"to 1e-6\" direct', n)) with labels left offset 1,(n == 3 ? 0.5 : -0.4) "
    "tc rgb color(n)\n  }\n}\nunset multiplot\n";

static const char horizon_plot[] =
    "stats 'horizon.csv' skip 1 using 1 nooutput\nend = STATS_max\n"
    "set output 'horizon.png'\nset logscale y\nset format y '10^{%L}'\n"
    "set title 'Where chaos ends what accuracy buys: '.scene\n"
    "set xlabel 'time, s'\nset ylabel 'distance from the run that was not moved, mm'\n"
    "set xrange [0 : end]\nset yrange [* : 1e3]\n"
    "set arrow 1 from graph 0, first 1 to graph 1, first 1 nohead dt 2 lc 'black'\n"
    "set label 1 '1 mm' at graph 0.99, first 1 right offset 0,0.7\n"
    "set label 2 'each of 16 runs whose starts are 1e-6 mm apart' at graph 0.98, graph 0.08 right "
    "tc rgb '#777777'\n"
    "set label 3 'mean of all' at graph 0.98, graph 0.15 right tc rgb color(2)\n"
    "plot for [r=1:16] 'horizon.csv' skip 1 every 17::r using ($3 > 0 ? $1 : NaN):($3 * 1e3) with lines "
    "lc rgb '#bbbbbb', "
    "'' skip 1 using ($2 > 0 && $3 > 0 ? $1 : NaN):($3 * 1e3) smooth unique with lines lw 4 lc rgb "
    "color(2)\n";

static const struct {
    const char *name, *text;
} plots[] = {
    {"dt", dt_plot},
    {"cg", cg_plot},
    {"newton", newton_plot},
    {"integrator", integrator_plot},
    {"preconditioner", AGAINST_TIME("preconditioner", "Preconditioners, to 1e-2, 1e-4, 1e-6, 1e-8",
                                    "preconditioners")},
    {"precision",
     AGAINST_TIME("precision", "Precision of the solver, to 1e-2, 1e-4, 1e-6, 1e-8", "precisions")},
    {"mesh", mesh_plot},
    {"sum", sum_plot},
    {"solver", solver_plot},
    {"horizon", horizon_plot},
};

/* clang-format on */
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
            fprintf(file, "%sscene = '%s, %d vertices'\n%s", common, of->base.name,
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
