/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Whether a source means the same with OpenMP on. The translated text is compiled with -fopenmp;
 * where the user's command does not ask for it, no pragma and no #if may wake up by that.
 */
#ifndef DRIVER_OPENMP_H
#define DRIVER_OPENMP_H

#include "driver/session.h"

/** Why -fopenmp would give this source another meaning; NULL: it would not. The question is put to
 *  the compiler: both preprocessed texts must be the same but for line markers, without a `#pragma
 *  omp`, and without a name that begins with `omp_` outside the system's headers. `scratch_folder`
 *  takes the two texts. */
const char *openmp_would_change(session *s, const item *source, const char *scratch_folder);

/** Why a preprocessed text has to do with OpenMP, its line markers telling what is of the system's
 *  headers; NULL: it has not. */
const char *openmp_in_text(const char *text);

#endif
