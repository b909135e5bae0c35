/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Selects the real compiler, and never this program itself. */
#ifndef DRIVER_COMPILER_H
#define DRIVER_COMPILER_H

#include <stdbool.h>

#include "driver/words.h"

typedef struct compiler {
    word_list words; /**< the command before the arguments: "gcc", or "ccache", "gcc" */
    word_list bare;  /**< the command without launchers, for queries: ccache would count a query as
                      * a miss */
    unsigned taken;  /**< number of given words that name the compiler (launcher form) */
    bool is_clang;
    bool is_cxx;          /**< treats a C file as C++ */
    bool is_cross;        /**< compiles for another machine */
    const char *standard; /**< -std= implied by the name (c99), or NULL */
    bool found;           /**< whether there is a compiler other than this program itself */
} compiler;

/** Chooses in this order: the given words, as far as they name launchers and then a compiler
 *  (launcher form); $REDCC_CC; the name by which this program was called, if it is not redcc-cc and
 *  another program has it; the first of cc, gcc and clang that exists. `self` is this program's
 *  path; paths that lead back to it are skipped. */
compiler compiler_choose(arena *a, const char *self, unsigned count, char *const *words);

/** Returns whether a launcher (ccache), which may reuse earlier compilations, runs the compiler. */
bool compiler_has_launcher(const compiler *c);
/** Returns whether the program runs the compiler given after its name (ccache, distcc). */
bool compiler_is_launcher(const char *word);

#endif
