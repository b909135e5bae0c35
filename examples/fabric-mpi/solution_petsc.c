/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "solution_petsc.h"

#include <math.h>
#include <petscksp.h>
#include <stdlib.h>
#include <string.h>

#include "part_layout.h"
#include "petsc_check.h"
#include "petsc_system.h"
#include "solution_parts.h"
#include "solver/solver_parts.h"

typedef struct petsc_solver {
    petsc_system system;
    KSP ksp;
    /* were PETSc's options -ksp_rtol, -ksp_atol, -ksp_max_it given? */
    PetscBool has_rtol, has_atol, has_most;
} petsc_solver;

/* Aggregation multigrid and hypre need scalar rows, and PETSc's incomplete Cholesky has a shift
 * only with them; all other preconditioners are faster with blocks. */
static MatType default_type(preconditioner_kind kind) {
    static const char *const scalar[] = {PCGAMG, PCHYPRE, PCML};
    char name[64];
    PetscBool given;
    CHECK(PetscOptionsGetString(NULL, NULL, "-pc_type", name, sizeof name, &given));
    for (size_t k = 0; given && k < sizeof scalar / sizeof *scalar; k++)
        if (strcmp(name, scalar[k]) == 0)
            return MATAIJ;
    return !given && kind == PRECONDITIONER_INCOMPLETE_CHOLESKY ? MATAIJ : MATBAIJ;
}

static void set_unless_given(const char *name, const char *value) {
    PetscBool given;
    CHECK(PetscOptionsHasName(NULL, NULL, name, &given));
    if (!given)
        CHECK(PetscOptionsSetValue(NULL, name, value));
}

static void set_default(PC pc, preconditioner_kind kind) {
    static const PCType nearest[] = {[PRECONDITIONER_GAUSS_SEIDEL] = PCSOR,
                                     [PRECONDITIONER_BLOCK_JACOBI] = PCPBJACOBI,
                                     [PRECONDITIONER_NONE] = PCNONE,
                                     [PRECONDITIONER_JACOBI] = PCJACOBI,
                                     [PRECONDITIONER_INCOMPLETE_CHOLESKY] = PCBJACOBI};
    PetscBool given;
    CHECK(PCSetType(pc, nearest[kind]));
    CHECK(PetscOptionsHasName(NULL, NULL, "-pc_type", &given));
    if (given)
        return;
    if (kind == PRECONDITIONER_GAUSS_SEIDEL) /* conjugate gradients require symmetry */
        CHECK(PCSORSetSymmetric(pc, SOR_LOCAL_SYMMETRIC_SWEEP));
    if (kind == PRECONDITIONER_INCOMPLETE_CHOLESKY) {
        set_unless_given("-sub_pc_type", PCICC);
        /* As in solver_factor.c, because some matrices cannot be factored without a shift. */
        set_unless_given("-sub_pc_factor_shift_type", "positive_definite");
    }
}

/* Uses the preconditioner's norm; methods that do not support it keep their own norm. */
static void set_norm(KSP ksp) {
    PetscBool has, given;
    CHECK(PetscOptionsHasName(NULL, NULL, "-ksp_norm_type", &given));
    CHECK(PetscObjectTypeCompareAny((PetscObject)ksp, &has, KSPCG, KSPGROPPCG, KSPPIPECG, KSPFCG,
                                    KSPPIPEFCG, ""));
    if (has && !given)
        CHECK(KSPSetNormType(ksp, KSP_NORM_NATURAL));
}

petsc_solver *petsc_solver_new(const part *p) {
    petsc_solver *s = part_memory(1, sizeof *s);
    PC pc;
    petsc_system_init(&s->system, p, default_type(p->scene.solution.preconditioner));
    CHECK(PetscOptionsHasName(NULL, NULL, "-ksp_rtol", &s->has_rtol));
    CHECK(PetscOptionsHasName(NULL, NULL, "-ksp_atol", &s->has_atol));
    CHECK(PetscOptionsHasName(NULL, NULL, "-ksp_max_it", &s->has_most));
    CHECK(KSPCreate(PETSC_COMM_WORLD, &s->ksp));
    CHECK(KSPSetType(s->ksp, KSPCG));
    CHECK(KSPSetInitialGuessNonzero(s->ksp, PETSC_TRUE));
    CHECK(KSPGetPC(s->ksp, &pc));
    set_default(pc, p->scene.solution.preconditioner);
    CHECK(KSPSetFromOptions(s->ksp));
    set_norm(s->ksp);
    return s;
}

void petsc_solver_free(petsc_solver *s) {
    if (!s)
        return;
    CHECK(KSPDestroy(&s->ksp));
    petsc_system_free(&s->system);
    free(s);
}

/* Converts PETSc's reason. A failed preconditioner counts as too many iterations, which ends the
 * program: a shorter step would not help. */
static solver_status status_of(KSP ksp) {
    KSPConvergedReason reason;
    CHECK(KSPGetConvergedReason(ksp, &reason));
    if (reason > 0)
        return SOLVER_CONVERGED;
    switch (reason) {
    case KSP_DIVERGED_NANORINF:
        return SOLVER_NOT_FINITE;
    case KSP_DIVERGED_INDEFINITE_MAT:
    case KSP_DIVERGED_BREAKDOWN:
        return SOLVER_BREAKDOWN;
    default:
        return SOLVER_TOO_MANY_ITERATIONS;
    }
}

/* Sets b = S (b - A z) and the guess y = S dv. Returns |b|. */
static double put(part *p, int which) {
    const petsc_system *of = &p->petsc->system;
    solver *s = &p->sim->solver;
    PetscReal norm;
    solution_reference(p, which);
    solver_filter(&p->sim->constraints, s->residual);
    petsc_system_put(of, (const double(*)[3])s->residual, of->b);
    solver_filter(&p->sim->constraints, p->sim->step.dv);
    petsc_system_put(of, (const double(*)[3])p->sim->step.dv, of->y);
    CHECK(VecNorm(of->b, NORM_2, &norm));
    return norm;
}

solver_status petsc_solve(part *p, const solver_limits *limits, int which, long *iterations) {
    petsc_solver *s = p->petsc;
    PetscInt taken;
    if (!isfinite(put(p, which)))
        return SOLVER_NOT_FINITE;
    petsc_system_fill(&s->system, p);
    CHECK(KSPSetOperators(s->ksp, s->system.A, s->system.A));
    /* The tolerance is relative to the right-hand side's norm, as in fabric. */
    CHECK(KSPSetTolerances(s->ksp, s->has_rtol ? PETSC_DEFAULT : limits->tolerance,
                           s->has_atol ? PETSC_DEFAULT : limits->floor, PETSC_DEFAULT,
                           s->has_most ? PETSC_DEFAULT : limits->max_iterations));
    CHECK(KSPSolve(s->ksp, s->system.b, s->system.y));
    CHECK(KSPGetIterationNumber(s->ksp, &taken));
    *iterations += taken;
    petsc_system_get(&s->system, s->system.y, p->sim->step.dv);
    solver_apply(&p->sim->constraints, p->sim->step.dv);
    return status_of(s->ksp);
}
