/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/*
 * fabric over MPI ranks. Rank 0, the leader, runs the unchanged program fabric. The linker
 * redirects its calls for forces and solutions to this file (--wrap), and all ranks take part in
 * them. The other ranks wait for the leader's next request.
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

#include "assembly.h"
#include "bits.h"
#include "part_layout.h"
#include "part_picture.h"
#include "petsc_options.h"
#include "solution.h"
#include "solver/solver_direct.h"
#include "solver/solver_fallback.h"
#include "solver/solver_parts.h"

/** The leader's requests; the function called for a request sends its arguments. */
enum request { MAKE, START, FORCES, MISSED, SOLVE, DEFECT, IMPULSES, FREE, END };

static bits_order bits;
static part mine;
/* Only the leader sets these. `current` is the simulation whose parts the ranks have. `started`: a
 * step has begun. `solved`: a system has been solved, so all of PETSc's options have been read. */
static simulation *current;
static int started, solved;

static void ask(enum request what) {
    int word = what;
    MPI_Bcast(&word, 1, MPI_INT, LEADER, MPI_COMM_WORLD);
}

/* ---- the other ranks ---- */

static int answer(int what) {
    double reference;
    long iterations = 0;
    switch (what) {
    case MAKE:
        part_make(&mine, bits, NULL, NULL);
        return 1;
    case START:
        assembly_start(&mine, NULL);
        return 1;
    case FORCES:
        assembly_forces(&mine, NULL, NULL);
        return 1;
    case MISSED:
        assembly_missed(&mine, NULL, NULL, NULL);
        return 1;
    case SOLVE:
        solution_solve(&mine, NULL, NULL, &iterations);
        return 1;
    case DEFECT:
        solution_defect(&mine, NULL, &reference);
        return 1;
    case IMPULSES:
        solution_impulses(&mine, NULL);
        return 1;
    case FREE:
        part_free(&mine);
        return 1;
    }
    return 0;
}

static void serve(void) {
    int what;
    /* Only the leader handles signals sent to all ranks: it ends the run after the current step. */
    signal(SIGINT, SIG_IGN);
    signal(SIGTERM, SIG_IGN);
    do
        MPI_Bcast(&what, 1, MPI_INT, LEADER, MPI_COMM_WORLD);
    while (answer(what));
}

/* ---- the leader: replacements of fabric's functions ---- */

int __real_main(int argc, char **argv);
int __wrap_main(int argc, char **argv);
simulation *__wrap_simulation_new(const mesh *m, const scene *s, char *error);
void __wrap_simulation_free(simulation *sim);
void __wrap_forces_assemble(simulation *sim, const expansion *at);
int __wrap_forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]);
int __wrap_solver_choose(solver *s, const block_matrix *A, const solver_options *options,
                         char *error);
solver_status __wrap_solver_fallback_solve(solver_fallback *f, solver *s,
                                           const linear_system *system, const constraints *c,
                                           const solver_limits *limits, double (*dv)[3],
                                           long *iterations);
double __wrap_solver_defect(solver *s, const linear_system *system, const constraints *c,
                            double (*dv)[3], double *reference);
void __wrap_solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]);

/* Returns the reason why the scene cannot be simulated over ranks, or NULL if it can. */
static const char *obstacle(const mesh *m, const scene *s, int ranks) {
    if (s->contact.method == CONTACT_BARRIER)
        return "contact: over ranks only constraints; barrier changes the matrix' layout in each "
               "iteration";
    if (s->solution.method != METHOD_CONJUGATE_GRADIENTS)
        return "solution.method: over ranks only conjugate-gradients, since CHOLMOD, which direct "
               "calls, factors on one machine";
    if (bits == BITS_SERIAL && s->solution.preconditioner != PRECONDITIONER_GAUSS_SEIDEL &&
        s->solution.preconditioner != PRECONDITIONER_BLOCK_JACOBI)
        return "solution.preconditioner: over ranks only gauss-seidel and block-jacobi; --bits=any "
               "has others";
    if (s->solution.precision != PRECISION_DOUBLE)
        return "solution.precision: over ranks only double; float and mixed go through all "
               "vertices in one order";
    if (part_block_count(s, bits, m->vertex_count) < ranks)
        return part_has_domains(s, bits)
                   ? "solution.preconditioner: gauss-seidel has fewer domains than there are "
                     "ranks; block-jacobi has more blocks"
                   : "fewer blocks of 64 vertices than ranks";
    return current ? "one simulation at a time over ranks" : NULL;
}

simulation *__wrap_simulation_new(const mesh *m, const scene *s, char *error) {
    int ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    const char *why = obstacle(m, s, ranks);
    if (why) {
        snprintf(error, 256, "%s", why);
        return NULL;
    }
    simulation *sim = __real_simulation_new(m, s, error);
    if (!sim)
        return NULL;
    assembly_thin(sim);
    ask(MAKE);
    part_make(&mine, bits, m, s);
    current = sim;
    started = 0;
    return sim;
}

void __wrap_simulation_free(simulation *sim) {
    if (sim && sim == current) {
        part_picture_write(mine.picture, (const double(*)[3])sim->state.x);
        ask(FREE);
        part_free(&mine);
        current = NULL;
    }
    __real_simulation_free(sim);
}

/* Sends the hinges' angles, at the first step, because restoring a checkpoint may have set them. */
static void start(const simulation *sim) {
    if (started)
        return;
    ask(START);
    assembly_start(&mine, sim);
    started = 1;
}

void __wrap_forces_assemble(simulation *sim, const expansion *at) {
    start(sim);
    ask(FORCES);
    assembly_forces(&mine, sim, at);
}

int __wrap_forces_add_missed(simulation *sim, const expansion *at, const double (*dv)[3]) {
    if (!effect_is_on(sim, EFFECT_STRAIN_LIMIT))
        return 0;
    ask(MISSED);
    return assembly_missed(&mine, sim, at, dv);
}

/* The parts have their own preconditioners (part_make); the leader's solver stays as solver_init
 * made it. */
int __wrap_solver_choose(solver *s, const block_matrix *A, const solver_options *options,
                         char *error) {
    (void)A, (void)error;
    s->options = *options;
    return 0;
}

/* Ends the program if the sequential program would fall back to a direct solution, which is not
 * available over ranks. */
static void check_iterations(solver_status status, long iterations) {
    if (bits == BITS_ANY) {
        if (status == SOLVER_TOO_MANY_ITERATIONS)
            part_give_up("PETSc's solver does not converge, or its preconditioner fails "
                         "(-ksp_converged_reason in PETSC_OPTIONS says why): raise "
                         "solution.max_iterations, or choose another -pc_type");
        return;
    }
    if (!direct_solver_available())
        return;
    if (status == SOLVER_TOO_MANY_ITERATIONS)
        part_give_up("the conjugate gradients do not converge; a direct solution is not done over "
                     "ranks");
    if (status == SOLVER_CONVERGED && iterations >= SOLVER_MANY_ITERATIONS)
        part_give_up("the conjugate gradients take 1000 iterations or more: fabric would weigh a "
                     "direct solution, which is not done over ranks");
}

solver_status __wrap_solver_fallback_solve(solver_fallback *f, solver *s,
                                           const linear_system *system, const constraints *c,
                                           const solver_limits *limits, double (*dv)[3],
                                           long *iterations) {
    const whole_system whole = {system, c, dv, s->residual};
    const long before = *iterations;
    (void)f;
    ask(SOLVE);
    const solver_status status = solution_solve(&mine, &whole, limits, iterations);
    if (!solved && petsc_options_unread(bits) > 0)
        part_give_up("an option of PETSc has no effect: take it out of PETSC_OPTIONS");
    solved = 1;
    check_iterations(status, *iterations - before);
    return status;
}

double __wrap_solver_defect(solver *s, const linear_system *system, const constraints *c,
                            double (*dv)[3], double *reference) {
    const whole_system whole = {system, c, dv, s->residual};
    ask(DEFECT);
    return solution_defect(&mine, &whole, reference);
}

void __wrap_solver_impulses(solver *s, const linear_system *system, const double (*dv)[3]) {
    const whole_system whole = {system, NULL, (double(*)[3])dv, s->residual};
    ask(IMPULSES);
    solution_impulses(&mine, &whole);
}

int __wrap_main(int argc, char **argv) {
    int rank, status = EXIT_SUCCESS;
    /* The command line is fabric's, so PETSc's options come from the environment (PETSC_OPTIONS).
     */
    if (PetscInitializeNoArguments() != 0)
        return EXIT_FAILURE;
    PetscPopSignalHandler();
    petsc_errors_short();
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    const int wrong = bits_take(&argc, argv, rank == LEADER, &bits);
    if (wrong != 0)
        status = wrong;
    else if (rank == LEADER) {
        status = __real_main(argc, argv);
        bits_help(argc, argv);
        ask(END);
    } else
        serve();
    return PetscFinalize() == 0 ? status : EXIT_FAILURE;
}
