/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Assigns blocks to ranks. The assignment determines the communication, not the bits. */
#include <stdlib.h>
#include <string.h>

#include <petscmat.h>

#include "part_layout.h"
#include "petsc_check.h"

/* Gives each rank an equal number of consecutive blocks. */
static void share_consecutively(int blocks, int ranks, int *owner) {
    for (int k = 0; k < blocks; k++)
        owner[k] = (int)((long long)k * ranks / blocks);
}

static int by_pair(const void *a, const void *b) {
    return memcmp(a, b, sizeof(int[2]));
}

/* Lists the pairs of different blocks that a triangle connects, in both directions, sorted and each
 * once. Returns their number. */
static int join_blocks(const mesh *whole, const int *block_of, int (*pair)[2]) {
    int count = 0, kept = 0;
    for (int t = 0; t < whole->triangle_count; t++)
        for (int k = 0; k < 3; k++) {
            const int a = block_of[whole->triangle[t][k]];
            const int b = block_of[whole->triangle[t][(k + 1) % 3]];
            if (a == b)
                continue;
            memcpy(pair[count++], (int[2]){a, b}, sizeof *pair);
            memcpy(pair[count++], (int[2]){b, a}, sizeof *pair);
        }
    qsort(pair, (size_t)count, sizeof *pair, by_pair);
    for (int n = 0; n < count; n++)
        if (n == 0 || memcmp(pair[n], pair[kept - 1], sizeof *pair) != 0)
            memmove(pair[kept++], pair[n], sizeof *pair);
    return kept;
}

/* Returns the blocks' graph as a PETSc adjacency matrix. */
static Mat block_graph(const mesh *whole, const division *d) {
    const int blocks = d->count;
    int(*pair)[2] = part_memory(6 * (size_t)whole->triangle_count, sizeof *pair);
    const int count = join_blocks(whole, d->of, pair);
    PetscInt *start, *to; /* the matrix takes ownership of these two arrays */
    Mat graph;
    CHECK(PetscCalloc1(blocks + 1, &start));
    CHECK(PetscMalloc1(count, &to));
    for (int n = 0; n < count; n++)
        start[pair[n][0] + 1]++;
    for (int k = 0; k < blocks; k++)
        start[k + 1] += start[k];
    int *next = part_memory((size_t)blocks, sizeof *next);
    for (int n = 0; n < count; n++)
        to[start[pair[n][0]] + next[pair[n][0]]++] = pair[n][1];
    CHECK(MatCreateMPIAdj(PETSC_COMM_SELF, blocks, blocks, start, to, NULL, &graph));
    free(next);
    free(pair);
    return graph;
}

/* Assigns blocks by one of PETSc's partitioners. */
static void share_by_graph(const mesh *whole, int ranks, division *d) {
    Mat graph = block_graph(whole, d);
    MatPartitioning partitioning;
    const PetscInt *of;
    IS parts;
    CHECK(MatPartitioningCreate(PETSC_COMM_SELF, &partitioning));
    CHECK(MatPartitioningSetAdjacency(partitioning, graph));
    CHECK(MatPartitioningSetNParts(partitioning, ranks));
    CHECK(MatPartitioningSetFromOptions(partitioning));
    CHECK(MatPartitioningApply(partitioning, &parts));
    CHECK(ISGetIndices(parts, &of));
    for (int k = 0; k < d->count; k++)
        d->owner[k] = (int)of[k];
    CHECK(ISRestoreIndices(parts, &of));
    CHECK(ISDestroy(&parts));
    CHECK(MatPartitioningDestroy(&partitioning));
    CHECK(MatDestroy(&graph));
}

/* Does every rank have a block? */
static int all_have(const int *owner, int blocks, int ranks) {
    int *has = part_memory((size_t)ranks, sizeof *has), count = 0;
    for (int k = 0; k < blocks; k++)
        has[owner[k]] = 1;
    for (int r = 0; r < ranks; r++)
        count += has[r];
    free(has);
    return count == ranks;
}

void part_share_blocks(const part *p, const mesh *whole, division *d) {
    PetscBool by_graph;
    CHECK(PetscOptionsHasName(NULL, NULL, "-mat_partitioning_type", &by_graph));
    if (p->rank == LEADER && by_graph && p->ranks > 1)
        share_by_graph(whole, p->ranks, d);
    if (!by_graph || p->ranks == 1 ||
        (p->rank == LEADER && !all_have(d->owner, d->count, p->ranks)))
        share_consecutively(d->count, p->ranks, d->owner);
    MPI_Bcast(d->owner, d->count, MPI_INT, LEADER, MPI_COMM_WORLD);
}
