/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric compare: the differences of two saved states. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "commands/commands.h"
#include "output/state.h"

enum { EXIT_DIFFERENT = 1, EXIT_UNUSABLE = 2 };

typedef struct request {
    const char *path[2];
    int count;
    double tolerance; /* m; below 0: all bits must be equal */
} request;

static const option compare_options[] = {
    {"--tolerance", "T", "largest permitted difference in metres (default: 0 bits)", OPTION_NUMBER,
     .offset = offsetof(request, tolerance)},
    {.name = NULL}};

/** The largest difference of two arrays of numbers. */
typedef struct difference {
    long numbers;   /* how many numbers differ */
    double largest; /* infinite if one of the numbers is NaN */
    int vertex;     /* original number of the vertex with the largest difference */
    uint64_t ulps;  /* largest distance in units in the last place (ulps) */
} difference;

/** Returns the rank of a double among all doubles; both zeros have the same rank. */
static int64_t place_of(double value) {
    int64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits < 0 ? INT64_MIN - bits : bits;
}

static uint64_t ulps_between(double a, double b) {
    const int64_t first = place_of(a), second = place_of(b);
    return first > second ? (uint64_t)first - (uint64_t)second : (uint64_t)second - (uint64_t)first;
}

/** Compares two arrays of three numbers per vertex; vertex v of the generated mesh is at a_place[v]
 *  and b_place[v]. */
static difference differ(const double *a, const int *a_place, const double *b, const int *b_place,
                         int vertex_count) {
    difference d = {0, 0.0, -1, 0};
    for (int v = 0; v < vertex_count; v++)
        for (int k = 0; k < 3; k++) {
            const double *x = &a[3 * (size_t)a_place[v] + (size_t)k];
            const double *y = &b[3 * (size_t)b_place[v] + (size_t)k];
            if (memcmp(x, y, sizeof *x) == 0)
                continue;
            double distance = fabs(*x - *y);
            if (isnan(distance))
                distance = INFINITY;
            const uint64_t ulps = isinf(distance) ? UINT64_MAX : ulps_between(*x, *y);
            d.numbers++;
            d.ulps = ulps > d.ulps ? ulps : d.ulps;
            if (d.vertex < 0 || distance > d.largest) {
                d.largest = distance;
                d.vertex = v;
            }
        }
    return d;
}

/** Returns the index in the state of each vertex of the generated mesh, or NULL after a message. */
static int *places_of(const state *s, const char *path) {
    int *place = malloc((size_t)s->vertex_count * sizeof *place);
    if (!place) {
        fprintf(stderr, "out of memory\n");
        return NULL;
    }
    for (int v = 0; v < s->vertex_count; v++)
        place[v] = s->original ? -1 : v;
    for (int v = 0; s->original && v < s->vertex_count; v++)
        place[s->original[v]] = v;
    for (int v = 0; v < s->vertex_count; v++)
        if (place[v] < 0) {
            fprintf(stderr, "%s: damaged: it has vertex %d twice\n", path, v);
            free(place);
            return NULL;
        }
    return place;
}

static void tell(const char *what, const char *unit, difference d, int vertex_count) {
    if (d.numbers == 0)
        printf("%s: equal, every bit\n", what);
    else
        printf("%s: %ld of %ld numbers differ, by %.17g %s (vertex %d) and %llu ulps at most\n",
               what, d.numbers, 3 * (long)vertex_count, d.largest, unit, d.vertex,
               (unsigned long long)d.ulps);
}

static int same_mesh(const state *a, const state *b) {
    return a->vertex_count == b->vertex_count && a->triangle_count == b->triangle_count;
}

/** Prints the differences and returns the exit status. If `tolerance` (m) is negative, all bits of
 *  positions and velocities must be equal; otherwise it is the largest permitted difference of
 *  positions. */
static int compare(const state *a, const int *a_place, const state *b, const int *b_place,
                   double tolerance) {
    const int count = a->vertex_count;
    const difference x = differ(a->position, a_place, b->position, b_place, count);
    tell("positions", "m", x, count);
    difference v = {0};
    if (a->velocity && b->velocity) {
        v = differ(a->velocity, a_place, b->velocity, b_place, count);
        tell("velocities", "m/s", v, count);
    }
    if (a->time < b->time || a->time > b->time)
        printf("times differ: %.17g s and %.17g s\n", a->time, b->time);
    if (tolerance >= 0.0)
        return x.largest <= tolerance ? EXIT_SUCCESS : EXIT_DIFFERENT;
    return x.numbers == 0 && v.numbers == 0 ? EXIT_SUCCESS : EXIT_DIFFERENT;
}

static int compare_files(const char *const path[2], double tolerance) {
    state s[2] = {{0}, {0}};
    int *place[2] = {NULL, NULL};
    int status = EXIT_UNUSABLE;
    if (state_read(&s[0], path[0]) == 0 && state_read(&s[1], path[1]) == 0) {
        if (!same_mesh(&s[0], &s[1]))
            fprintf(stderr, "states of two meshes: %d vertices and %d triangles, %d and %d\n",
                    s[0].vertex_count, s[0].triangle_count, s[1].vertex_count, s[1].triangle_count);
        else if ((place[0] = places_of(&s[0], path[0])) && (place[1] = places_of(&s[1], path[1])))
            status = compare(&s[0], place[0], &s[1], place[1], tolerance);
    }
    for (int k = 0; k < 2; k++) {
        free(place[k]);
        state_free(&s[k]);
    }
    return status;
}

static int take_word(const options *o, void *to) {
    request *r = to;
    if (r->count == 2)
        return options_complain(o->of, "two states at a time, not '%s' as well", o->value);
    r->path[r->count++] = o->value;
    return 0;
}

static int run(const command *self, int argc, char **argv) {
    request r = {.tolerance = -1};
    const int read = options_read(self, argc, argv, &r, take_word);
    if (read != OPTIONS_READ)
        return read;
    if (r.count < 2)
        return options_complain(self, "which states? %s", self->synopsis);
    return compare_files(r.path, r.tolerance);
}

const command compare_command = {
    "compare", "A B [options]",
    "Prints the largest difference of two saved states, in metres and in units in the last place\n"
    "(ulps). Exit status: 0 equal, 1 different, 2 a file cannot be used.",
    compare_options, run};
