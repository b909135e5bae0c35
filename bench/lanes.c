/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Measures how much lanes (several iterations computed at once by vector instructions) and
 * prefetches speed up the parallel loops, for each kernel (lanes_kernels.c), order of the data and
 * number of threads. Each round executes the original loop, the translated loop in each variant,
 * and the translated loop as the runtime decides. Each of these is run twice in a row and the
 * second run is timed; the bits are compared each time.
 *
 *     OMP_NUM_THREADS=2 lanes [ROUNDS [SIDE [KERNEL]]]
 *
 * The method is that of REDCC_METHOD. Without it, it is the one that auto would choose: LOCALWRITE
 * with owners by index on sorted data, and by the access graph on shuffled data. SIDE is the number
 * of nodes along each side of the square mesh. With KERNEL only that kernel is measured. Prints
 * lines: kernel,order,threads,serial_seconds, then for each variant speed-up,low,high: median, 5th
 * and 95th percentile of the rounds' speed-ups over the original loop.
 */
#include "lanes_data.h"

#include "plan/method.h"
#include "settings.h"

#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_ROUNDS = 999 };

enum kernel {
    CLOTH,
    MEMBRANE,
    FLOAT_MEMBRANE,
    CONTACTS,
    TOUCHING,
    LENNARD_JONES,
    SPRINGS,
    TETRAHEDRA,
    PRODUCT,
    KERNELS
};
static const char *const names[] = {"cloth",    "membrane",   "float_membrane",
                                    "contacts", "touching",   "lennard_jones",
                                    "springs",  "tetrahedra", "half_product"};

enum course { SERIAL, PLAIN, PREFETCH, LANES, BOTH, AUTO, COURSES };

struct arrays {
    double (*b)[3], (*a)[3][3];
    size_t b_bytes, a_bytes;
};

typedef const double (*points)[3];
typedef const int (*pairs)[2];

static double run(enum kernel kernel, int translated, const struct mesh *m, struct arrays to) {
    const points x = (points)m->x, v = (points)m->v;
    const pairs edge = (pairs)m->edge;
    const double began = omp_get_wtime();
    switch (kernel) {
    case CLOTH:
        (translated ? cloth : serial_cloth)(m->triangles, m->cloth, x, v, to.b, to.a);
        break;
    case MEMBRANE:
        (translated ? membrane : serial_membrane)(m->triangles, m->element, x, to.b, to.a);
        break;
    case FLOAT_MEMBRANE:
        (translated ? float_membrane : serial_float_membrane)(
            m->triangles, m->element, (const float(*)[3])m->float_x, (float(*)[3])(void *)to.b);
        break;
    case CONTACTS:
        (translated ? contacts : serial_contacts)(m->edges, edge, x, v, m->radius, to.b);
        break;
    case TOUCHING:
        (translated ? touching : serial_touching)(m->edges, edge, x, m->radius, to.b);
        break;
    case LENNARD_JONES:
        (translated ? lennard_jones : serial_lennard_jones)(m->edges, edge, x, to.b);
        break;
    case SPRINGS:
        (translated ? springs : serial_springs)(m->edges, edge, m->rest, x, to.b);
        break;
    case TETRAHEDRA:
        (translated ? tetrahedra : serial_tetrahedra)(m->tetrahedra, (const int(*)[4])m->corner, x,
                                                      m->blocks.start, m->blocks.column, to.a);
        break;
    default:
        (translated ? half_product : serial_half_product)(m->nodes, m->upper.start, m->upper.column,
                                                          m->value, m->single, &to.b[0][0]);
        break;
    }
    return omp_get_wtime() - began;
}

static double timed(enum course course, enum kernel kernel, const struct mesh *m,
                    struct arrays to) {
    struct settings *settings = (struct settings *)redcc_settings();
    settings->prefetch = course == AUTO                         ? PREFETCH_AUTO
                         : course == PREFETCH || course == BOTH ? PREFETCH_ON
                                                                : PREFETCH_OFF;
    settings->lanes = course < LANES ? LANES_OFF : LANES_AUTO;
    double seconds = 0;
    for (int i = 0; i < 2; i++) {
        memset(to.b, 0, to.b_bytes);
        memset(to.a, 0, to.a_bytes);
        seconds = run(kernel, course != SERIAL, m, to);
    }
    return seconds;
}

static int ascending(const void *p, const void *q) {
    const double x = *(const double *)p, y = *(const double *)q;
    return (x > y) - (x < y);
}

/* Prints median, 5th and 95th percentile of above[] / below[]. */
static void print_ratio(const double *above, const double *below, int rounds) {
    double ratio[MOST_ROUNDS];
    for (int r = 0; r < rounds; r++)
        ratio[r] = above[r] / below[r];
    qsort(ratio, (size_t)rounds, sizeof *ratio, ascending);
    printf(",%.3f,%.3f,%.3f", ratio[rounds / 2], ratio[rounds / 20],
           ratio[rounds - 1 - rounds / 20]);
}

static struct arrays make_arrays(enum kernel kernel, const struct mesh *m) {
    struct arrays to = {.b_bytes = sizeof(double[3]) * (size_t)m->nodes};
    const size_t blocks = kernel == MEMBRANE ? 4 * (size_t)m->nodes
                          : kernel == TETRAHEDRA || kernel == CLOTH
                              ? (size_t)m->blocks.start[m->nodes]
                              : 0;
    to.a_bytes = sizeof(double[3][3]) * blocks;
    to.b = malloc(to.b_bytes);
    to.a = malloc(to.a_bytes + 1);
    return to;
}

static int measure(enum kernel kernel, const char *order, const struct mesh *m, int rounds) {
    static double seconds[COURSES][MOST_ROUNDS], sorted[MOST_ROUNDS];
    const struct arrays of[2] = {make_arrays(kernel, m), make_arrays(kernel, m)};
    int differ = 0;
    for (int r = 0; r < rounds; r++)
        for (enum course course = SERIAL; course < COURSES; course++) {
            seconds[course][r] = timed(course, kernel, m, of[course != SERIAL]);
            differ |= course != SERIAL && (memcmp(of[0].b, of[1].b, of[0].b_bytes) != 0 ||
                                           memcmp(of[0].a, of[1].a, of[0].a_bytes) != 0);
        }
    memcpy(sorted, seconds[SERIAL], sizeof sorted);
    qsort(sorted, (size_t)rounds, sizeof *sorted, ascending);
    printf("%s,%s,%d,%.5f", names[kernel], order, omp_get_max_threads(), sorted[rounds / 2]);
    for (enum course course = PLAIN; course < COURSES; course++)
        print_ratio(seconds[SERIAL], seconds[course], rounds);
    printf("%s\n", differ ? ",BITS DIFFER" : "");
    fflush(stdout);
    for (int i = 0; i < 2; i++) {
        free(of[i].b);
        free(of[i].a);
    }
    return differ;
}

/* Measures in a child process, so that the runtime does not reuse variants that it chose for other
 * data. */
static int measure_in_child(enum kernel kernel, const char *order, const struct mesh *m,
                            int rounds) {
    const pid_t child = fork();
    int status = 1;
    if (child == 0)
        exit(measure(kernel, order, m, rounds));
    if (child < 0 || waitpid(child, &status, 0) != child)
        perror("lanes");
    return status != 0;
}

int main(int argc, char **argv) {
    int rounds = argc > 1 ? atoi(argv[1]) : 15, differ = 0;
    const int side = argc > 2 ? atoi(argv[2]) : 467;
    rounds = rounds < 1 ? 1 : rounds > MOST_ROUNDS ? MOST_ROUNDS : rounds;
    struct settings *settings = (struct settings *)redcc_settings();
    const int is_named = settings->method != NULL;
    for (int shuffled = 0; shuffled < 2; shuffled++) {
        if (!is_named)
            settings->method = shuffled ? &redcc_method_graph_localwrite : &redcc_method_localwrite;
        struct mesh m = make_mesh(side < 3 ? 3 : side, shuffled);
        for (enum kernel kernel = 0; kernel < KERNELS; kernel++)
            if (argc <= 3 || strcmp(argv[3], names[kernel]) == 0)
                differ |= measure_in_child(kernel, shuffled ? "shuffled" : "sorted", &m, rounds);
        free_mesh(&m);
    }
    return differ;
}
