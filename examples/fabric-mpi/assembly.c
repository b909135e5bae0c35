/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "assembly.h"

#include <stdlib.h>
#include <string.h>

#include "part_layout.h"

/* fabric's own functions, which the linker renames (--wrap). */
void __real_forces_assemble(simulation *sim, const expansion *at);
int __real_forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]);

/* The parameters of an assembly other than positions and velocities, as the leader sends them. */
typedef struct present {
    double h;
    double wind[3];
    int on[EFFECT_COUNT];
    int lags; /* `lag` differs from v */
} present;

void assembly_thin(simulation *whole) {
    const int blocks = whole->system.A.block_count;
    const int rows = whole->system.A.row_count;
    system_free(&whole->system);
    if (system_init(&whole->system, rows, 0, NULL) != 0)
        part_give_up("out of memory");
    whole->system.A.block_count = blocks; /* the number of blocks of all ranks, for the run's
                                           * counts */
}

/* Copies the angles of the leader's hinges to angle [mesh hinges]. The leader's list lacks the
 * mesh's hinges without weight. */
static void spell_angles(const simulation *whole, double *angle) {
    const hinge_elements *e = &whole->cloth.hinges;
    int k = 0;
    for (int t = 0; t < whole->mesh->hinge_count && k < e->count; t++)
        if (memcmp(whole->mesh->hinge[t], e->corner[k], sizeof *e->corner) == 0)
            angle[t] = e->angle[k++];
}

void assembly_start(part *p, const simulation *whole) {
    const hinge_elements *e = &p->sim->cloth.hinges;
    int count = whole ? whole->mesh->hinge_count : 0, k = 0;
    MPI_Bcast(&count, 1, MPI_INT, LEADER, MPI_COMM_WORLD);
    double *angle = part_memory((size_t)count, sizeof *angle);
    if (whole)
        spell_angles(whole, angle);
    MPI_Bcast(angle, count, MPI_DOUBLE, LEADER, MPI_COMM_WORLD);
    for (int t = 0; t < p->mesh.hinge_count && k < e->count; t++)
        if (memcmp(p->mesh.hinge[t], e->corner[k], sizeof *e->corner) == 0)
            e->angle[k++] = angle[p->hinge[t]];
    free(angle);
}

static present present_of(const simulation *whole, const expansion *at) {
    present now = {.h = at->h, .lags = at->lag != at->v};
    memcpy(now.wind, whole->in_force.wind, sizeof now.wind);
    for (int k = 0; k < EFFECT_COUNT; k++)
        now.on[k] = whole->account.effects[k].on;
    return now;
}

/* Sends the rows that the parts own to the leader. */
static void give_back(part *p, linear_system *whole) {
    const linear_system *s = &p->sim->system;
    for (int i = 0; i < s->A.row_count; i++)
        memcpy(p->diagonal[i], s->A.value[s->A.row_start[i]], sizeof *p->diagonal);
    part_return(p, 9, p->diagonal, whole ? whole->A.value : NULL);
    part_return(p, 3, s->b, whole ? whole->b : NULL);
}

void assembly_receive(part *p, const linear_system *whole) {
    const linear_system *s = &p->sim->system;
    part_receive(part_solved(p), 9, whole ? whole->A.value : NULL, p->diagonal);
    part_receive(p->own, 3, whole ? whole->b : NULL, s->b);
    for (int i = 0; i < s->A.row_count; i++)
        memcpy(s->A.value[s->A.row_start[i]], p->diagonal[i], sizeof *p->diagonal);
}

/* Adds to the effects' counts and times: the elements processed, counted once for each part that
 * has them, and the seconds of the leader's part. */
static void account(const part *p, simulation *whole) {
    long visited[EFFECT_COUNT], all[EFFECT_COUNT];
    for (int k = 0; k < EFFECT_COUNT; k++) {
        effect_account *of = &p->sim->account.effects[k];
        visited[k] = of->visited;
        if (whole)
            whole->account.effects[k].seconds += of->seconds;
        of->visited = 0;
        of->seconds = 0;
    }
    MPI_Reduce(visited, all, EFFECT_COUNT, MPI_LONG, MPI_SUM, LEADER, MPI_COMM_WORLD);
    for (int k = 0; whole && k < EFFECT_COUNT; k++)
        whole->account.effects[k].visited += all[k];
}

static expansion own_expansion(const simulation *sim, double h, int lags) {
    const double(*v)[3] = (const double(*)[3])sim->state.v;
    return (expansion){h, (const double(*)[3])sim->state.x,
                       lags ? (const double(*)[3])sim->step.guess : v, v};
}

void assembly_forces(part *p, simulation *whole, const expansion *at) {
    simulation *sim = p->sim;
    present now = {0};
    part_stage_begin("forces");
    if (whole)
        now = present_of(whole, at);
    MPI_Bcast(&now, (int)sizeof now, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    part_receive(p->all, 3, at ? at->x : NULL, sim->state.x);
    part_receive(p->all, 3, at ? at->v : NULL, sim->state.v);
    if (now.lags)
        part_receive(p->all, 3, at ? at->lag : NULL, sim->step.guess);
    memcpy(sim->in_force.wind, now.wind, sizeof now.wind);
    for (int k = 0; k < EFFECT_COUNT; k++)
        sim->account.effects[k].on = now.on[k];
    const expansion own = own_expansion(sim, now.h, now.lags);
    sim->step.stage_h = now.h;
    __real_forces_assemble(sim, &own);
    give_back(p, whole ? &whole->system : NULL);
    account(p, whole);
    /* The leader computes the energy, so its angles must be current. */
    if (whole && whole->cloth.has_hinge_forces && BUILT_WITH(EFFECT_BEND))
        hinge_update_angles(&whole->cloth.hinges, at->x);
    part_stage_end();
}

int assembly_missed(part *p, simulation *whole, const expansion *at, const double (*dv)[3]) {
    simulation *sim = p->sim;
    double h = at ? at->h : 0;
    int any;
    part_stage_begin("forces");
    MPI_Bcast(&h, 1, MPI_DOUBLE, LEADER, MPI_COMM_WORLD);
    part_receive(p->all, 3, dv, sim->step.dv);
    const expansion own = own_expansion(sim, h, 0);
    const int found = __real_forces_add_missed(sim, &own, (const double(*)[3])sim->step.dv) > 0;
    MPI_Allreduce(&found, &any, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    if (any)
        give_back(p, whole ? &whole->system : NULL);
    account(p, whole);
    part_stage_end();
    return any;
}
