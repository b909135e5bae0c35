/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The command line: options in a table that reading and --help go by. */
#ifndef FABRIC_OPTIONS_H
#define FABRIC_OPTIONS_H

typedef struct option {
    const char *name;     /* "--steps" or "-o" */
    const char *argument; /* what follows it, as --help names it; NULL: nothing */
    const char *help;     /* one line */
} option;

/** A command: `fabric NAME ...`. */
typedef struct command {
    const char *name;
    const char *synopsis;  /* after the name: "SCENE [options]" */
    const char *summary;   /* one line */
    const option *options; /* no name after the last; --help is understood everywhere */
    int (*run)(const struct command *self, int argc, char **argv); /* its words; the exit status */
} command;

enum { EXIT_USAGE = 2 };

enum { OPTIONS_END = -1, OPTIONS_WORD = -2, OPTIONS_HELP = -3, OPTIONS_WRONG = -4 };

/** Position in a command line. Start with {command, argc, argv, 0, NULL, 0}. */
typedef struct options {
    const command *of;
    int argc;
    char **argv;
    int next;
    const char *value; /* of the option just read, or the word */
    int only_words;    /* "--" was read */
} options;

/**
 * Reads the next word of the command line: the option's number in the table, OPTIONS_WORD for a
 * word that is none, OPTIONS_END after the last, OPTIONS_HELP (the help was printed),
 * OPTIONS_WRONG (a message was printed: exit with EXIT_USAGE).
 */
int options_next(options *o);

/** The value as a whole number from low to high, or as a number from low up. 0, or -1 after a
 *  message. `name`: the option's. */
int options_whole(const options *o, const char *name, long low, long high, long *value);
int options_number(const options *o, const char *name, double low, double *value);

/** The word as the number of one of `choices` (NULL after the last); -1 after a message. */
int options_choice(const options *o, const char *name, const char *const *choices);

/** "fabric run: ..." on standard error. Returns EXIT_USAGE. */
int options_complain(const command *of, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** The name the program was started by, without folders. */
extern const char *program_name;

#endif
