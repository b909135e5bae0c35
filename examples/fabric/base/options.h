/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The command line: a table of options, used for reading and for --help. */
#ifndef FABRIC_OPTIONS_H
#define FABRIC_OPTIONS_H

#include <stddef.h>

typedef enum option_kind {
    OPTION_TEXT,   /* const char *, which points into argv */
    OPTION_FLAG,   /* int, set to 1 */
    OPTION_WHOLE,  /* long from `low` to `high` */
    OPTION_NUMBER, /* double, at least `low` */
    OPTION_CHOICE, /* int, the value's index in `choices` */
    OPTION_OWN     /* any type, stored by the function `take` */
} option_kind;

/** State of reading a command line. A word is an argument that is not an option. */
typedef struct options {
    const struct command *of;
    int argc;
    char **argv;
    int next;
    const char *value; /* the value of the option just read, or the word just read */
    int only_words;    /* "--" was read: all later arguments are words */
} options;

/** Stores o->value in *to. Returns 0, or nonzero after a message. */
typedef int option_taker(const options *o, void *to);

typedef struct option {
    const char *name;     /* "--steps" or "-o" */
    const char *argument; /* the name of its argument in --help; NULL: it takes none */
    const char *help;     /* one line */
    option_kind kind;
    size_t offset; /* offset of the value in the request struct that options_read fills */
    double low, high;
    const char *const *choices; /* the allowed values; NULL after the last */
    option_taker *take;
} option;

/** A command: `fabric NAME ...`. */
typedef struct command {
    const char *name;
    const char *synopsis;  /* printed after the name, such as "SCENE [options]" */
    const char *summary;   /* one line */
    const option *options; /* the last entry has no name; every command also accepts --help */
    int (*run)(const struct command *self, int argc, char **argv); /* argv: the arguments after the
                                                                    * command's name; returns the
                                                                    * exit status */
} command;

enum { EXIT_USAGE = 2, OPTIONS_READ = -1 };

/**
 * Reads the command line into *request. The table of->options describes where options are stored;
 * take_word, called with `to` = request, stores each word. Returns OPTIONS_READ, or the exit status
 * of a program that stops here: 0 after --help, EXIT_USAGE after a message.
 */
int options_read(const command *of, int argc, char **argv, void *request, option_taker *take_word);

/** Returns the index of o->value in `choices` (NULL after the last), or -1 after a message about
 *  option `name`. */
int options_choice(const options *o, const char *name, const char *const *choices);

/** Stores o->value in *text and returns 0. If *text is set already, returns EXIT_USAGE after a
 *  message in which `what`, such as "folder", names the word. */
int options_only_word(const options *o, const char **text, const char *what);

/** Prints a message after "PROGRAM COMMAND: " on standard error. Returns EXIT_USAGE. */
int options_complain(const command *of, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** The name by which the program was started, without folders. */
extern const char *program_name;

#endif
