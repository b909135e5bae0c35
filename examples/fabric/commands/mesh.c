/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* fabric mesh: generates meshes; renumbers and describes meshes from files. */
#include "mesh/mesh.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "commands/commands.h"
#include "input/mesh_file.h"
#include "output/obj.h"

enum { ERROR_SIZE = 256 };

static const char *const actions[] = {"generate", "reorder", "info", NULL};
enum { GENERATE, REORDER, INFO };

/** Arguments of the command line. */
typedef struct request {
    int action; /* -1: not given yet */
    const char *input;
    const char *output;
    long vertices, boundary, seed;
    double side;
    int order; /* mesh_order */
    const char *numbers, *restore;
} request;

#define VALUE(field) offsetof(request, field)
static const option mesh_options[] = {
    {"-o", "FILE.obj", "output file (generate, reorder)", .offset = VALUE(output)},
    {"--vertices", "N", "generate: vertices (default 2602)", OPTION_WHOLE, VALUE(vertices),
     .low = 5, .high = 2e7},
    {"--boundary", "N", "generate: vertices on the border (default 220)", OPTION_WHOLE,
     VALUE(boundary), .low = 4, .high = 1e7},
    {"--side", "M", "generate: the square's side in metres (default 1)", OPTION_NUMBER, VALUE(side),
     .low = 1e-9},
    {"--seed", "N", "generate, reorder: random seed (default 1)", OPTION_WHOLE, VALUE(seed),
     .low = 0, .high = 4294967295},
    {"--order", "ORDER", "generated, sorted (reverse Cuthill-McKee), shuffled, hilbert or metis",
     OPTION_CHOICE, VALUE(order), .choices = scene_orders},
    {"--numbers", "FILE", "output file for the new number of each vertex, one a line",
     .offset = VALUE(numbers)},
    {"--restore", "FILE", "reorder: undo a renumbering by such a file", .offset = VALUE(restore)},
    {.name = NULL}};

static int take_word(const options *o, void *to) {
    request *r = to;
    if (r->action < 0) {
        r->action = options_choice(o, "the action", actions);
        return r->action < 0;
    }
    if (r->action != GENERATE && !r->input) {
        r->input = o->value;
        return 0;
    }
    return options_complain(o->of, "what is '%s' for? %s", o->value, o->of->synopsis);
}

static int check_request(const command *self, const request *r) {
    if (r->action < 0)
        return options_complain(self, "generate, reorder or info? %s", self->synopsis);
    if (r->action != GENERATE && !r->input)
        return options_complain(self, "which mesh? %s", self->synopsis);
    if (r->restore && (r->action != REORDER || r->numbers || r->order != MESH_ORDER_GENERATED))
        return options_complain(self, "--restore is for reorder, without --order and --numbers");
    if (r->numbers && r->action == INFO)
        return options_complain(self, "--numbers is for generate and reorder");
    if (r->action != INFO && !r->output)
        return options_complain(self, "where to? -o FILE.obj");
    return 0;
}

/** Finds the smallest and largest angle of all triangles, degrees. */
static void angle_range(const mesh *m, double *least, double *greatest) {
    *least = 180.0;
    *greatest = 0.0;
    for (int t = 0; t < m->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const double *apex = m->material[m->triangle[t][k]];
            const double *b = m->material[m->triangle[t][(k + 1) % 3]];
            const double *c = m->material[m->triangle[t][(k + 2) % 3]];
            const double u[2] = {b[0] - apex[0], b[1] - apex[1]};
            const double v[2] = {c[0] - apex[0], c[1] - apex[1]};
            const double angle = atan2(fabs(u[0] * v[1] - u[1] * v[0]), u[0] * v[0] + u[1] * v[1]);
            *least = fmin(*least, angle * 57.29577951308232);
            *greatest = fmax(*greatest, angle * 57.29577951308232);
        }
}

/** Computes the largest and the mean difference between the numbers of an edge's two vertices. */
static void edge_spans(const mesh *m, int *longest, double *mean) {
    double sum = 0.0;
    *longest = 0;
    for (int e = 0; e < m->edge_count; e++) {
        const int span = abs(m->edge[e][1] - m->edge[e][0]);
        *longest = span > *longest ? span : *longest;
        sum += span;
    }
    *mean = m->edge_count > 0 ? sum / m->edge_count : 0.0;
}

/** Prints the bounding box, which shows the unit and the vertical axis. */
static void print_extent(const mesh *m) {
    for (int a = 0; a < 3; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int v = 0; v < m->vertex_count; v++) {
            low = fmin(low, m->position[v][a]);
            high = fmax(high, m->position[v][a]);
        }
        printf(a == 0 ? "extent:    %c %.6g to %.6g m" : ", %c %.6g to %.6g m", "xyz"[a], low,
               high);
    }
    fputs(" (z is up)\n", stdout);
}

static void print_info(const mesh *m, int non_manifold) {
    int longest;
    double mean, least, greatest;
    edge_spans(m, &longest, &mean);
    angle_range(m, &least, &greatest);
    printf("vertices:  %d\n", m->vertex_count);
    printf("triangles: %d\n", m->triangle_count);
    print_extent(m);
    printf("edges:     %d, of which %d on the border and %d of more than two triangles\n",
           m->edge_count, m->edge_count - m->hinge_count, non_manifold);
    printf("hinges:    %d\n", m->hinge_count);
    printf("angles:    %.1f to %.1f degrees\n", least, greatest);
    printf("bandwidth: %d, neighbours are %.1f apart in the mean\n", longest, mean);
}

/** Writes the new number of each vertex, one a line. */
static int write_numbers(const char *name, const int *number, int count) {
    FILE *file = fopen(name, "w");
    for (int v = 0; file && v < count; v++)
        fprintf(file, "%d\n", number[v]);
    const int wrong = !file || ferror(file);
    if ((file && fclose(file) != 0) || wrong) {
        fprintf(stderr, "mesh: cannot write %s\n", name);
        return -1;
    }
    return 0;
}

/** Reads `count` numbers from a file that must contain exactly as many. Returns 0, or -1 with a
 *  message in error. */
static int read_numbers(const char *name, int *number, int count, char *error) {
    FILE *file = fopen(name, "r");
    int read = 0, more;
    while (file && read < count && fscanf(file, "%d", &number[read]) == 1)
        read++;
    const int whole = file && read == count && fscanf(file, "%d", &more) == EOF;
    if (file)
        fclose(file);
    if (!file)
        snprintf(error, ERROR_SIZE, "cannot read %s", name);
    else if (!whole)
        snprintf(error, ERROR_SIZE, "%s does not hold %d numbers, one for each vertex", name,
                 count);
    return whole ? 0 : -1;
}

/** Applies the requested order, or undoes an order. Returns 0, or -1 with a message printed or in
 *  error. */
static int change_order(const request *r, mesh *m, char *error) {
    int *number = malloc((size_t)m->vertex_count * sizeof *number);
    int status = -1;
    snprintf(error, ERROR_SIZE, "out of memory");
    if (number && r->restore)
        status = read_numbers(r->restore, number, m->vertex_count, error) == 0
                     ? mesh_renumber(m, number, 1, error)
                     : -1;
    else if (number)
        status = mesh_reorder(m, (mesh_order)r->order, (unsigned)r->seed, number, error);
    if (status == 0 && r->numbers && write_numbers(r->numbers, number, m->vertex_count) != 0) {
        error[0] = '\0';
        status = -1;
    }
    free(number);
    return status;
}

static int perform(const request *r) {
    char error[ERROR_SIZE] = "";
    mesh m = {0};
    mesh_problem found[MESH_PROBLEM_COUNT];
    int status = 0;
    if (r->action == GENERATE)
        status = mesh_generate(&m, (int)r->vertices, (int)r->boundary, r->side, (unsigned)r->seed,
                               error);
    else if (mesh_file_read(&m, r->input) != 0)
        return EXIT_FAILURE;
    if (status == 0)
        status = mesh_file_prepare(&m, "mesh", found, error);
    if (status == 0 && r->action != INFO)
        status = change_order(r, &m, error);
    if (status != 0 && error[0] != '\0')
        fprintf(stderr, "mesh: %s\n", error);
    if (status == 0 && r->action == INFO)
        print_info(&m, found[MESH_NON_MANIFOLD].count);
    else if (status == 0)
        status = obj_write(&m, r->output);
    mesh_free(&m);
    return status == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

static int run(const command *self, int argc, char **argv) {
    request r = {-1, NULL, NULL, 2602, 220, 1, 1.0, MESH_ORDER_GENERATED, NULL, NULL};
    const int read = options_read(self, argc, argv, &r, take_word);
    if (read != OPTIONS_READ)
        return read;
    const int wrong = check_request(self, &r);
    return wrong != 0 ? wrong : perform(&r);
}

const command mesh_command = {"mesh", "generate|reorder FILE|info FILE [options]",
                              "Generates, renumbers and describes meshes, which are OBJ files.",
                              mesh_options, run};
