/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** A parsed compiler command line: the inputs, the last stage, and the words that belong
 *  together. */
#ifndef DRIVER_COMMAND_H
#define DRIVER_COMMAND_H

#include <stdbool.h>

#include "driver/words.h"
#include "support/compiler_options.h"

typedef enum input_kind {
    INPUT_NOT,     /**< an option */
    INPUT_C,       /**< C source */
    INPUT_COMPILE, /**< something else that is compiled: C++, assembler, preprocessed text */
    INPUT_LINK     /**< an object, a library, a linker script */
} input_kind;

/** One option with its argument, or one input. */
typedef struct item {
    const char *text;  /**< the word as written */
    const char *value; /**< the next word if the option takes one; else NULL */
    unsigned meaning;  /**< enum option_meaning; 0 for inputs and options not in the table */
    input_kind kind;
    /** for an input: the language set by -x; NULL: the file's name decides */
    const char *language;
} item;

typedef struct command {
    unsigned count;
    const item *items;
    unsigned meaning;     /**< union of the items' meanings */
    unsigned c_count;     /**< number of inputs of kind INPUT_C */
    unsigned compiled;    /**< number of inputs of kind INPUT_C or INPUT_COMPILE */
    unsigned linked;      /**< number of inputs of kind INPUT_LINK, and of -l options */
    const char *output;   /**< the argument of -o, or NULL */
    const char *language; /**< the language set by the last -x, or NULL */
    bool compiles;        /**< writes an object or assembler text for at least one input */
    bool links;
} command;

/** Parses the words after the compiler's name, with response files already expanded. `c_is_cxx`:
 *  the compiler treats C files as C++ (g++). */
command command_parse(arena *a, const word_list *words, bool c_is_cxx);

/** Returns whether the command seems to come from a configure script, CMake or Meson that tests the
 *  compiler. This is decided by the names of the folder, the inputs and the output. */
bool command_is_probe(const command *c, const char *folder);

/** The argument of an item's option, joined or as the next word: "x.o" of "-ox.o"; "" if none. */
const char *item_argument(const item *i);

/** Adds an item's words. */
void item_add(arena *a, word_list *list, const item *i);

/** Adds an item's words. If it has OPTION_LIBERTY, adds only what does not change results (-O3 for
 * -Ofast). */
void item_add_strict(arena *a, word_list *list, const item *i);

/** Adds every option whose meaning shares no bit with `without`, but not inputs, -o and -x. If
 * `without` contains OPTION_LIBERTY, options with it are added by item_add_strict. */
void command_add_options(arena *a, word_list *list, const command *c, unsigned without);

/** Adds the options that the translator's parser needs. If is_strict, they are added by
 * item_add_strict. */
void command_add_parse_options(arena *a, word_list *list, const command *c, bool is_strict);

/** Returns whether the word looks like a source, object or library by its ending. */
bool name_is_input(const char *word);

#endif
