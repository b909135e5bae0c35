/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "petsc_options.h"

#include <petscsys.h>
#include <stdio.h>
#include <string.h>

#include "base/words.h"
#include "petsc_check.h"

/* The options among which the one nearest to a misspelt option is searched, because PETSc offers no
 * list of its options. */
static const char *const common[] = {"ksp_type",
                                     "ksp_rtol",
                                     "ksp_atol",
                                     "ksp_max_it",
                                     "ksp_norm_type",
                                     "ksp_monitor",
                                     "ksp_view",
                                     "ksp_converged_reason",
                                     "pc_type",
                                     "pc_hypre_type",
                                     "pc_gamg_type",
                                     "pc_gamg_threshold",
                                     "pc_sor_its",
                                     "sub_pc_type",
                                     "sub_ksp_type",
                                     "mat_type",
                                     "mat_partitioning_type",
                                     "part_view",
                                     "part_picture",
                                     "log_view",
                                     "options_left"};
enum { COMMON = sizeof common / sizeof *common };

/* Is the option read only at PETSc's end, or only with several ranks? */
static int is_read_elsewhere(const char *name) {
    static const char *const beginnings[] = {"log_", "options_", "objects_", "malloc_",
                                             "mat_partitioning_"};
    for (size_t k = 0; k < sizeof beginnings / sizeof *beginnings; k++)
        if (strncmp(name, beginnings[k], strlen(beginnings[k])) == 0)
            return 1;
    return 0;
}

static int is_of_solution(const char *name) {
    static const char *const beginnings[] = {"ksp_", "pc_", "sub_", "mat_", "mg_"};
    for (size_t k = 0; k < sizeof beginnings / sizeof *beginnings; k++)
        if (strncmp(name, beginnings[k], strlen(beginnings[k])) == 0)
            return 1;
    return 0;
}

static void complain(const char *name, bits_order bits) {
    const char *nearest = words_nearest(name, common, COMMON);
    fprintf(stderr, "fabric-mpi: PETSC_OPTIONS: nothing reads the option '-%s'", name);
    if (bits == BITS_SERIAL && is_of_solution(name))
        fprintf(stderr, ": PETSc solves the system with --bits=any alone");
    else if (nearest && strcmp(nearest, name) != 0)
        fprintf(stderr, ", did you mean '-%s'?", nearest);
    fputc('\n', stderr);
}

int petsc_options_unread(bits_order bits) {
    PetscInt count;
    char **names, **values;
    int found = 0;
    CHECK(PetscOptionsLeftGet(NULL, &count, &names, &values));
    for (PetscInt k = 0; k < count; k++)
        if (!is_read_elsewhere(names[k])) {
            complain(names[k], bits);
            found++;
        }
    CHECK(PetscOptionsLeftRestore(NULL, &count, &names, &values));
    return found;
}

/* An error handler, which PETSc calls for each function of the call stack. Prints only the first
 * message, which names the error. */
static PetscErrorCode say_first(MPI_Comm comm, int line, const char *function, const char *file,
                                PetscErrorCode code, PetscErrorType kind, const char *message,
                                void *context) {
    (void)comm, (void)line, (void)file, (void)context;
    if (kind == PETSC_ERROR_INITIAL)
        fprintf(stderr, "fabric-mpi: PETSc: %s (%s)\n", message ? message : "an error", function);
    return code;
}

void petsc_errors_short(void) {
    CHECK(PetscPushErrorHandler(say_first, NULL));
}
