// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Graphviz's layout program sfdp without input and drawing: its sparse matrices, clusterings,
// coarsening and a layout, on a mesh with random chords. Prints the result of each part.
//   graphviz SIDE   the mesh has SIDE * SIDE nodes
#include <stdio.h>
#include <stdlib.h>

#include "Multilevel.h"
#include "SparseMatrix.h"
#include "clustering.h"
#include "mq.h"
#include "spring_electrical.h"

unsigned char Verbose;
static unsigned seed = 12345;

static int random_below(int n) {
    seed = seed * 1103515245u + 12345u;
    return (int)(seed / 65536 % (unsigned)n);
}

static SparseMatrix mesh(int side) {
    int n = side * side, count = 0, most = 3 * n + n / 8;
    int *row = malloc((size_t)most * 2 * sizeof *row),
        *column = malloc((size_t)most * 2 * sizeof *column);
    double *value = malloc((size_t)most * 2 * sizeof *value);
    for (int k = 0; k < most; k++) {
        int from = k < 3 * n ? k / 3 : random_below(n), to = random_below(n);
        if (k < 3 * n && k % 3 == 0)
            to = from + 1;
        if (k < 3 * n && k % 3 == 1)
            to = from + side;
        if (k < 3 * n && k % 3 == 2)
            to = from + side + 1;
        if (to >= n || to == from)
            continue;
        row[count] = column[count + 1] = from;
        column[count] = row[count + 1] = to;
        value[count] = value[count + 1] = 1 + random_below(9) / 7.0;
        count += 2;
    }
    SparseMatrix a = SparseMatrix_from_coordinate_arrays(count, n, n, row, column, value,
                                                         MATRIX_TYPE_REAL, sizeof(double));
    free(row), free(column), free(value);
    return a;
}

static double sum(const double *v, int n) {
    double s = 0;
    for (int k = 0; k < n; k++)
        s += v[k] * (1 + k % 17);
    return s;
}

static void describe(const char *name, SparseMatrix a) {
    long places = 0;
    for (int k = 0; k < a->nz; k++)
        places += (long)a->ja[k] * (k % 31);
    printf("%s: %d by %d, %d entries, %ld, %a\n", name, a->m, a->n, a->nz, places,
           a->type == MATRIX_TYPE_REAL ? sum(a->a, a->nz) : 0);
}

static void matrices(SparseMatrix a) {
    SparseMatrix t = SparseMatrix_transpose(a), p = SparseMatrix_multiply(a, t),
                 q = SparseMatrix_multiply3(t, a, t);
    describe("A", a), describe("A'", t), describe("A A'", p), describe("A' A A'", q);
    describe("A + A A'", SparseMatrix_add(a, p));
    describe("symmetric", SparseMatrix_symmetrize(p, 0));
    describe("rows scaled", SparseMatrix_divide_row_by_degree(SparseMatrix_copy(p)));
    double *x = calloc((size_t)a->n, sizeof *x), *y = NULL, *z = NULL, *rank = NULL;
    for (int k = 0; k < a->n; k++)
        x[k] = random_below(1000) / 999.0;
    SparseMatrix_multiply_vector(a, x, &y, 0);
    SparseMatrix_multiply_vector(a, y, &z, 1);
    printf("A x %a, A' A x %a\n", sum(y, a->m), sum(z, a->n));
    SparseMatrix_page_rank(a, 0.1, 1, 1e-8, &rank);
    printf("page rank %a\n", sum(rank, a->n));
}

static void graph_parts(SparseMatrix a) {
    int count, *list = NULL, *start = NULL, flag = 0, *cluster = NULL;
    double quality, *distance = NULL;
    SparseMatrix_weakly_connected_components(a, &count, &list, &start);
    printf("%d components\n", count);
    SparseMatrix_decompose_to_supervariables(a, &count, &list, &start);
    printf("%d supervariables\n", count);
    int levels, *level_start = NULL, *level_nodes = NULL, *mask = NULL;
    SparseMatrix_level_sets(a, 0, &levels, &level_start, &level_nodes, &mask, 1);
    printf("%d levels, %d nodes\n", levels, level_start[levels]);
    list = NULL;
    if (SparseMatrix_k_centers(a, 0, 12, 0, &list, 1, &distance) == 0)
        printf("centres %a\n", sum(distance, a->n * 12));
    modularity_clustering(a, 0, 0, 1, &count, &cluster, &quality, &flag);
    printf("%d clusters, modularity %a\n", count, quality);
    mq_clustering(a, 0, 0, 1, &count, &cluster, &quality, &flag);
    printf("%d clusters, quality %a\n", count, quality);
}

static void layout(SparseMatrix a) {
    for (int scheme = EDGE_BASED_STA + 1; scheme < COARSEN_HYBRID; scheme++) {
        if (scheme == EDGE_BASED_STO || scheme == VERTEX_BASED_STA || scheme == VERTEX_BASED_STO)
            continue;
        int level = 0;
        srand(99);
        printf("coarsening %d:", scheme);
        for (Multilevel m = Multilevel_new(SparseMatrix_copy(a), NULL, NULL,
                                           Multilevel_control_new(scheme, COARSEN_MODE_FORCEFUL));
             m; m = m->next)
            printf(" %d:%d", level++, m->n);
        printf("\n");
    }
    int flag = 0;
    double *x = calloc((size_t)a->n * 2, sizeof *x);
    spring_electrical_control control = spring_electrical_control_new();
    control->random_seed = 7;
    control->maxiter = 40;
    spring_electrical_embedding(2, a, control, NULL, x, &flag);
    printf("layout %a\n", sum(x, a->n * 2));
}

int main(int argc, char **argv) {
    int side = argc > 1 ? atoi(argv[1]) : 20;
    SparseMatrix a = mesh(side < 2 ? 2 : side);
    matrices(a);
    graph_parts(SparseMatrix_get_real_adjacency_matrix_symmetrized(a));
    layout(SparseMatrix_get_real_adjacency_matrix_symmetrized(a));
}
