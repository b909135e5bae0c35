/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Solves the leader's system and returns its dv and residual. The product's bits are those of one
 * rank: a part has all blocks of its owned rows, in the order of the whole matrix. So half_product
 * computes these rows as in the sequential program. */
#include "solution.h"

#include <stdlib.h>
#include <string.h>

#include "assembly.h"
#include "base/vector.h"
#include "part_layout.h"
#include "solution_parts.h"
#include "solution_petsc.h"
#include "solver/solver_parts.h"

/* Receives the leader's constraints for the vertices of part_solved; other ghosts stay free. */
static void receive_constraints(part *p, const constraints *whole) {
    constraints *c = &p->sim->constraints;
    const size_t count = (size_t)p->mesh.vertex_count;
    int used = whole ? whole->used : 0;
    MPI_Bcast(&used, 1, MPI_INT, LEADER, MPI_COMM_WORLD);
    memset(c->given, 0, count);
    if (used == 0)
        return;
    if (used > c->room) {
        free(c->list);
        c->list = part_memory((size_t)used, sizeof *c->list);
        c->room = used;
    }
    if (!c->place)
        c->place = part_memory(count, sizeof *c->place);
    c->used = used;
    if (whole)
        memcpy(c->list, whole->list, (size_t)used * sizeof *c->list);
    MPI_Bcast(c->list, used * (int)(sizeof *c->list / sizeof(double)), MPI_DOUBLE, LEADER,
              MPI_COMM_WORLD);
    part_receive_bytes(part_solved(p), whole ? whole->given : NULL, c->given);
    part_receive_ints(part_solved(p), whole ? whole->place : NULL, c->place);
}

void solution_product(part *p, double (*x)[3], double (*y)[3]) {
    part_update_ghosts(p, x);
    memset(y, 0, (size_t)p->mesh.vertex_count * sizeof *y);
    half_product(&p->sim->system.A, (const double(*)[3])x, y);
}

void solution_residual(part *p, double (*x)[3]) {
    solver *s = &p->sim->solver;
    solution_product(p, x, s->product);
    for (int i = 0; i < p->mesh.vertex_count; i++)
        vector_subtract(p->sim->system.b[i], s->product[i], s->residual[i]);
}

void solution_reference(part *p, int which) {
    solver *s = &p->sim->solver;
    const constraints *c = &p->sim->constraints;
    if (which != DRIVEN) { /* z is 0 */
        memcpy(s->residual, p->sim->system.b, (size_t)s->count * sizeof *s->residual);
        return;
    }
    for (int i = 0; i < s->count; i++)
        memcpy(s->residual[i], constraint_change(c, i), sizeof *s->residual);
    solution_residual(p, s->residual);
}

/* Receives system, constraints and dv, and projects dv onto the constraints. Returns the result of
 * solver_apply for the whole cloth. */
static int receive(part *p, const whole_system *whole) {
    simulation *sim = p->sim;
    int which;
    assembly_receive(p, whole ? whole->system : NULL);
    receive_constraints(p, whole ? whole->given : NULL);
    part_receive(p->own, 3, whole ? whole->dv : NULL, sim->step.dv);
    const int mine = solver_apply(&sim->constraints, sim->step.dv);
    MPI_Allreduce(&mine, &which, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return which;
}

static void give_back(part *p, const whole_system *whole) {
    part_return(p, 3, p->sim->solver.residual, whole ? whole->residual : NULL);
    part_return(p, 3, p->sim->step.dv, whole ? whole->dv : NULL);
}

solver_status solution_solve(part *p, const whole_system *whole, const solver_limits *limits,
                             long *iterations) {
    solver_limits now = {0};
    part_stage_begin("solution");
    if (limits)
        now = *limits;
    MPI_Bcast(&now, (int)sizeof now, MPI_BYTE, LEADER, MPI_COMM_WORLD);
    const int which = receive(p, whole);
    const solver_status status = p->petsc     ? petsc_solve(p, &now, which, iterations)
                                 : p->domains ? domains_solve(p, &now, which, iterations)
                                              : jacobi_solve(p, &now, which, iterations);
    /* Without constraints, block-Jacobi's own residual needs no recomputation. */
    if (status != SOLVER_NOT_FINITE && (p->petsc || p->domains || which != UNCONSTRAINED))
        solution_residual(p, p->sim->step.dv);
    give_back(p, whole);
    part_stage_end();
    return status;
}

double solution_defect(part *p, const whole_system *whole, double *reference) {
    part_stage_begin("solution");
    const int which = receive(p, whole);
    const double defect = jacobi_defect(p, which, reference);
    give_back(p, whole);
    part_stage_end();
    return defect;
}

void solution_impulses(part *p, const whole_system *whole) {
    part_stage_begin("solution");
    assembly_receive(p, whole ? whole->system : NULL);
    part_receive(p->own, 3, whole ? whole->dv : NULL, p->sim->step.dv);
    solution_residual(p, p->sim->step.dv);
    part_return(p, 3, p->sim->solver.residual, whole ? whole->residual : NULL);
    part_stage_end();
}
