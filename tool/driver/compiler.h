/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Which real compiler to run, without ever running this program again. */
#ifndef DRIVER_COMPILER_H
#define DRIVER_COMPILER_H

#include <stdbool.h>

#include "driver/words.h"

typedef struct compiler {
    word_list words; /**< "gcc", or "ccache", "gcc": what stands before the arguments */
    word_list
        bare; /**< without launchers, for questions: a cache would only count them as misses */
    unsigned taken; /**< how many of the words given named the compiler (launcher form) */
    bool is_clang;
    bool is_cxx;          /**< takes a C file for C++ */
    bool is_foreign;      /**< compiles for another machine than this */
    const char *standard; /**< -std= that goes with the name (c99); NULL: none */
    bool found;           /**< false: nothing but this program itself goes by the name */
} compiler;

/** Chooses: the first of the words given, where it is a compiler's name (launcher form); $REDCC_CC;
 *  the name this program was called by, where a link of that name stands for it; cc. `self` is this
 *  program's path; what leads back to it is skipped. */
compiler compiler_choose(arena *a, const char *self, unsigned count, char *const *words);

/** Whether the compiler is run by a launcher (ccache), which may look up what it compiled before.
 */
bool compiler_has_launcher(const compiler *c);
/** Whether the program runs the compiler that is named after it (ccache, distcc). */
bool compiler_is_launcher(const char *word);

#endif
