/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* executions SEED executes a loop 20 to 119 times, translated and sequentially, each on a separate
 * world (world.h). From time to time both worlds get the same change of subscripts, values, lengths
 * or addresses. After each execution the worlds must be equal, byte for byte. Prints what the seed
 * selects. Exit status 1: the worlds differ, and the first difference is printed; 2: the seed is no
 * number, or memory is lacking. */
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "world.h"

#define KERNELS_NAME(name) {#name, parallel_##name, sequential_##name},
static const named_kernel kernels[] = {KERNELS(KERNELS_NAME)};
enum { KERNEL_COUNT = sizeof kernels / sizeof kernels[0] };

typedef struct plan {
    const named_kernel *kernel;
    world_shape shape;
    change changes[2];
    int every; /* number of executions between two changes */
    int executions;
    bool changes_threads;
} plan;

/* Returns a trip count of up to 2000, 80000 or 600000. `auto` does not run the shortest loops in
 * parallel. */
static int any_length(random_source *r) {
    static const int more[] = {2000, 80000, 80000, 600000};
    return 1 + random_below(r, more[random_below(r, 4)]);
}

static plan any_plan(random_source *r) {
    const int length = any_length(r);
    return (plan){.kernel = &kernels[random_below(r, KERNEL_COUNT)],
                  .shape = {.most = length,
                            .rows = 20 + random_below(r, random_chance(r, 25) ? 2000000 : 50000),
                            .order = random_below(r, SUBSCRIPTS_CROWDED + 1)},
                  .changes = {random_below(r, CHANGE_COUNT), random_below(r, CHANGE_COUNT)},
                  .every = 1 + random_below(r, random_chance(r, 50) ? 3 : 15),
                  .executions = 20 + random_below(r, length > 100000 ? 20 : 100),
                  .changes_threads = random_chance(r, 10)};
}

static void print_plan(const char *seed, const plan *p) {
    static const char *const orders[] = {"random", "sorted", "nearly-sorted", "crowded"};
    printf("%s: %s, %d iterations, %d rows, %s; each %d of %d executions %s or %s%s\n", seed,
           p->kernel->name, p->shape.most, p->shape.rows, orders[p->shape.order], p->every,
           p->executions, change_name(p->changes[0]), change_name(p->changes[1]),
           p->changes_threads ? ", other numbers of threads" : "");
}

/* Returns the name of the data that differ, or NULL if none do. */
static const char *difference(const world *a, const world *b) {
    if (memcmp(a->memory, b->memory, a->size) != 0)
        return "arrays";
    if (memcmp(&a->problem.sum, &b->problem.sum, sizeof a->problem.sum) != 0)
        return "sum";
    return a->problem.last != b->problem.last ? "last value" : NULL;
}

static int run(const plan *p, random_source *r, world *parallel, world *sequential) {
    const int threads = omp_get_max_threads();
    for (int execution = 0; execution < p->executions; execution++) {
        if (execution > 0 && execution % p->every == 0) {
            const change kind = p->changes[random_below(r, 2)];
            const uint64_t seed = random_next(r);
            world_change(parallel, kind, seed);
            world_change(sequential, kind, seed);
            if (p->changes_threads)
                omp_set_num_threads(1 + random_below(r, threads + 2));
        }
        p->kernel->parallel(&parallel->problem);
        p->kernel->sequential(&sequential->problem);
        const char *what = difference(parallel, sequential);
        if (what) {
            printf("differs in execution %d: %s\n", execution, what);
            return 1;
        }
    }
    return 0;
}

int main(int argc, char **argv) {
    char *end = NULL;
    random_source r = {argc == 2 ? strtoull(argv[1], &end, 10) : 0};
    if (!end || end == argv[1] || *end) {
        fprintf(stderr, "usage: executions SEED\n");
        return 2;
    }
    world parallel, sequential = {0};
    const plan p = any_plan(&r);
    const uint64_t seed = random_next(&r);
    print_plan(argv[1], &p);
    int status = 2;
    if (!world_make(&parallel, &p.shape, seed) || !world_make(&sequential, &p.shape, seed))
        fprintf(stderr, "executions: no memory for %d iterations and %d rows\n", p.shape.most,
                p.shape.rows);
    else
        status = run(&p, &r, &parallel, &sequential);
    world_free(&parallel);
    world_free(&sequential);
    return status;
}
