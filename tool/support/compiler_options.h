/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The meaning of gcc's and clang's options, in one sorted table. Two programs use it: the
 * translator, which gets options after `--` and from compile_commands.json, and redcc-cc, the
 * compiler wrapper. */
#ifndef SUPPORT_COMPILER_OPTIONS_H
#define SUPPORT_COMPILER_OPTIONS_H

enum option_meaning {
    OPTION_ARGUMENT = 1 << 0,    /**< its argument is the next word, unless text is joined to it */
    OPTION_JOINED = 1 << 1,      /**< text may follow it in the same word */
    OPTION_PARSE = 1 << 2,       /**< the translator needs it to read the source as the compiler
                                  * does */
    OPTION_NO_OBJECT = 1 << 3,   /**< nothing is compiled to code (-E, -M, --version) */
    OPTION_NO_LINK = 1 << 4,     /**< stops before the linker (-c, -S) */
    OPTION_GIVE_UP = 1 << 5,     /**< redcc-cc translates no source */
    OPTION_DEPENDENCY = 1 << 6,  /**< requests a dependency file, or affects its contents */
    OPTION_LINKER = 1 << 7,      /**< has no effect if one source is compiled to an object */
    OPTION_AUXILIARY = 1 << 8,   /**< more files are written, named after the output */
    OPTION_NO_RUNTIME = 1 << 9,  /**< no library may be added to the link */
    OPTION_OPENMP = 1 << 10,     /**< the user's own OpenMP pragmas are on */
    OPTION_PREFIX_MAP = 1 << 11, /**< OLD=NEW, applied to file names in the object */
    OPTION_THREADS = 1 << 12,    /**< with gcc, _REENTRANT is defined as by -pthread */
    OPTION_MACROS = 1 << 13,     /**< defines or undefines macros, or includes a file that may */
    OPTION_CLANG = 1 << 14,      /**< passed to the translator's parser as well */
    OPTION_PATH = 1 << 15,       /**< its argument is a path, relative to the folder of the
                                  * command */
    OPTION_REFUSE = 1 << 16,     /**< makes the program differ from the one that is analysed: no
                                  * loop is translated */
    OPTION_INEXACT = 1 << 17, /**< floating-point bits depend on other code in the compilation: no
                               * loop of a file with such arithmetic is translated */
    OPTION_LIBERTY = 1 << 18  /**< permits the compiler to reorder or approximate arithmetic: the
                               * program is also correct without the option */
};

/** An entry of the table: one option, or the common beginning of several options ("--print-"). */
typedef struct option {
    const char *name;
    unsigned meaning; /**< bits of enum option_meaning */
} option;

/** Returns the entry for a word of the command line: the one with exactly this name, else the
 *  longest name that begins the word and has OPTION_JOINED. Returns NULL if there is none; such an
 *  option has no meaning here. An option -fsanitize= that reports unsigned arithmetic that wraps
 *  around has a separate entry. */
const option *option_find(const char *word);

/** The options to use in place of an OPTION_LIBERTY: its parts that change no bit of a result. The
 *  list ends with NULL. */
const char *const *option_without_liberty(const char *word);

/** Entry number `index` in the table's order, NULL after the last: for the test of the order. */
const option *option_at(unsigned index);

#endif
