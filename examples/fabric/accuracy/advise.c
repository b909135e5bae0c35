/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "accuracy/advise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "accuracy/study.h"
#include "files.h"

enum { LINE_SIZE = 512, FIELDS = 19 };

/* Splits a line at its commas; fewer than FIELDS fields: 0. */
static int split(char *line, char *field[FIELDS]) {
    int count = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *at = line; at && count < FIELDS; count++) {
        field[count] = at;
        at = strchr(at, ',');
        if (at)
            *at++ = '\0';
    }
    return count == FIELDS;
}

/* Only runs without a rejected step and with an error are points of a curve. */
static int take(char *field[FIELDS], curve_point *p) {
    if (strcmp(field[0], "dt") != 0 || strtol(field[7], NULL, 10) != 0 || field[11][0] == '\0')
        return 0;
    *p = (curve_point){.vertices = (int)strtol(field[2], NULL, 10),
                       .step = strtod(field[4], NULL),
                       .tolerance = strtod(field[5], NULL),
                       .steps = strtol(field[6], NULL, 10),
                       .cpu_seconds = strtod(field[10], NULL),
                       .error = strtod(field[11], NULL),
                       .side = strtod(field[15], NULL),
                       .stiffness = strtod(field[16], NULL),
                       .contact = field[17][0] == '1',
                       .wind = field[18][0] == '1'};
    snprintf(p->scene, sizeof p->scene, "%s", field[1]);
    snprintf(p->integrator, sizeof p->integrator, "%s", field[3]);
    return p->step > 0 && p->error > 0 && p->cpu_seconds > 0 && p->steps > 0 && p->vertices > 0 &&
           p->side > 0;
}

int curves_read(const char *path, curve_point **points) {
    char line[LINE_SIZE], *field[FIELDS];
    int count = 0, room = 0;
    *points = NULL;
    FILE *file = files_open(path);
    if (!file)
        return -1;
    while (fgets(line, sizeof line, file)) {
        if (count == room) {
            room = 2 * room + 16;
            curve_point *more = realloc(*points, sizeof *more * (size_t)room);
            if (!more) {
                fprintf(stderr, "%s: out of memory\n", path);
                free(*points);
                fclose(file);
                return -1;
            }
            *points = more;
        }
        if (split(line, field))
            count += take(field, &(*points)[count]);
    }
    fclose(file);
    return count;
}

/* The two points of a curve to go by: around the error, or the nearest pair. Points stand in
 * descending order of step, as the experiment writes them. */
static int choose_pair(const curve_point *points, int count, const char *of, const char *integrator,
                       double error, const curve_point *pair[2]) {
    const curve_point *before = NULL;
    int found = 0;
    for (int k = 0; k < count; k++) {
        const curve_point *p = &points[k];
        if (strcmp(p->scene, of) != 0 || strcmp(p->integrator, integrator) != 0)
            continue;
        if (before && before->step > p->step && before->error > p->error) {
            pair[0] = before;
            pair[1] = p;
            found = 1;
            if (p->error <= error)
                return 1;
        }
        before = p;
    }
    return found;
}

/* Along a straight line in logarithms; steps go no longer than the longest measured. */
static advice along(const scene *s, const curve_point *pair[2], double wanted, int exact_scene) {
    const double larger = exact_scene ? 1 : s->side / pair[1]->side;
    const double error = wanted / larger; /* of the sheet that was measured */
    const double order = log(pair[0]->error / pair[1]->error) / log(pair[0]->step / pair[1]->step);
    const double growth =
        log(pair[1]->cpu_seconds / pair[0]->cpu_seconds) / log(pair[0]->step / pair[1]->step);
    const double duration = s->step * s->steps;
    const double measured_duration = pair[1]->step * (double)pair[1]->steps;
    /* Work a step grows with the vertices, and iterations with the vertices along an edge. */
    const double size = pow((double)s->vertices / pair[1]->vertices, 1.5);
    advice a = {.exact_scene = exact_scene,
                .within = error <= pair[0]->error && error >= pair[1]->error,
                .order = order,
                .tolerance = pair[1]->tolerance};
    a.step = pair[1]->step * pow(error / pair[1]->error, 1 / order);
    if (a.step > pair[0]->step)
        a.step = pair[0]->step;
    a.error = larger * pair[1]->error * pow(a.step / pair[1]->step, order);
    a.cpu_seconds = pair[1]->cpu_seconds * pow(pair[1]->step / a.step, growth) * size * duration /
                    measured_duration;
    snprintf(a.integrator, sizeof a.integrator, "%s", pair[1]->integrator);
    snprintf(a.measured_on, sizeof a.measured_on, "%s", pair[1]->scene);
    return a;
}

/* |log2(a / b)|; what is not above 0 is as unlike as anything. */
static double octaves(double a, double b) {
    if (!(a > 0) || !(b > 0))
        return a > 0 || b > 0 ? 10 : 0;
    return fabs(log2(a / b));
}

double curve_unlike(const scene *s, const curve_point *curve) {
    return octaves(s->vertices, curve->vertices) + octaves(s->side, curve->side) +
           octaves(scene_stiffness(s), curve->stiffness) +
           octaves(s->step * s->steps, curve->step * (double)curve->steps) +
           4 * abs((s->collider_count > 0) - curve->contact) +
           2 * abs(scene_has_wind(s) - curve->wind) + (strcmp(s->name, curve->scene) != 0 ? 3 : 0);
}

/* The scene to go by; own: it is s itself. */
static const curve_point *choose_scene(const scene *s, const curve_point *points, int count,
                                       int *own) {
    const curve_point *nearest = NULL;
    for (int k = 0; k < count; k++) {
        *own = strcmp(points[k].scene, s->name) == 0 && points[k].vertices == s->vertices;
        if (*own)
            return &points[k];
        if (!nearest || curve_unlike(s, &points[k]) < curve_unlike(s, nearest))
            nearest = &points[k];
    }
    return nearest;
}

int advise(const scene *s, double error, const curve_point *points, int count, advice *result) {
    int found = 0, own = 0;
    const curve_point *by = choose_scene(s, points, count, &own);
    const char *of = by ? by->scene : "";
    for (int kind = 0; integrator_names[kind]; kind++) {
        const curve_point *pair[2];
        if (!choose_pair(points, count, of, integrator_names[kind], error, pair))
            continue;
        advice a = along(s, pair, error, own);
        a.unlike = own ? 0 : curve_unlike(s, by);
        /* Between curves that were measured there and ones continued, the measured are believed. */
        if (!found || a.within > result->within ||
            (a.within == result->within && a.cpu_seconds < result->cpu_seconds))
            *result = a;
        found = 1;
    }
    return found ? 0 : -1;
}
