/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Prints the sizes of parts, to be read or to be used in models of the communication. */
#include <stdio.h>
#include <stdlib.h>

#include "part_layout.h"
#include "petsc_check.h"

enum { VERTICES, GHOSTS, SENT, NEIGHBOURS, TRIANGLES, HINGES, COLUMNS };

/* Counts the ranks to which this rank sends ghosts, and the values sent. */
static void count_sent(const part *p, long *row) {
    PetscInt ranks;
    const PetscInt *offset;
    CHECK(PetscSFGetLeafRanks(p->ghosts, &ranks, NULL, &offset, NULL));
    row[NEIGHBOURS] = ranks;
    row[SENT] = offset[ranks];
}

void part_view(const part *p) {
    PetscBool wanted = PETSC_FALSE;
    long row[COLUMNS] = {0};
    CHECK(PetscOptionsHasName(NULL, NULL, "-part_view", &wanted));
    if (!wanted)
        return;
    for (int n = 0; n < p->blocks; n++)
        row[VERTICES] += p->block[n].end - p->block[n].begin;
    row[GHOSTS] = p->mesh.vertex_count - row[VERTICES];
    row[TRIANGLES] = p->mesh.triangle_count;
    row[HINGES] = p->mesh.hinge_count;
    if (p->ranks > 1)
        count_sent(p, row);
    long *all = part_memory((size_t)p->ranks * COLUMNS, sizeof *all);
    MPI_Gather(row, COLUMNS, MPI_LONG, all, COLUMNS, MPI_LONG, LEADER, MPI_COMM_WORLD);
    if (p->rank == LEADER)
        fprintf(stderr, "rank vertices ghosts sent neighbours triangles hinges\n");
    for (int r = 0; p->rank == LEADER && r < p->ranks; r++) {
        fprintf(stderr, "%d", r);
        for (int k = 0; k < COLUMNS; k++)
            fprintf(stderr, " %ld", all[r * COLUMNS + k]);
        fprintf(stderr, "\n");
    }
    free(all);
}

void part_stage_begin(const char *name) {
    PetscLogStage stage;
    CHECK(PetscLogStageGetId(name, &stage));
    if (stage < 0)
        CHECK(PetscLogStageRegister(name, &stage));
    CHECK(PetscLogStagePush(stage));
}

void part_stage_end(void) {
    CHECK(PetscLogStagePop());
}
