/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The command line: a table of options, used for reading and for --help. */
#ifndef FABRIC_OPTIONS_H
#define FABRIC_OPTIONS_H

#include <stddef.h>

typedef enum option_kind {
    OPTION_TEXT,   /* const char *, by reference */
    OPTION_FLAG,   /* int: 1 */
    OPTION_WHOLE,  /* long, from low to high */
    OPTION_NUMBER, /* double, low or more */
    OPTION_CHOICE, /* int: the word's index in `choices` */
    OPTION_OWN     /* read by `take` */
} option_kind;

/** Position in a command line. */
typedef struct options {
    const struct command *of;
    int argc;
    char **argv;
    int next;
    const char *value; /* of the option just read, or the word */
    int only_words;    /* "--" was read */
} options;

/** Takes o->value into *to. 0, or another number after a message. */
typedef int option_taker(const options *o, void *to);

typedef struct option {
    const char *name;     /* "--steps" or "-o" */
    const char *argument; /* the name of its argument in --help; NULL: it takes none */
    const char *help;     /* one line */
    option_kind kind;
    size_t offset; /* of the value in the request that options_read fills */
    double low, high;
    const char *const *choices; /* NULL after the last */
    option_taker *take;
} option;

/** A command: `fabric NAME ...`. */
typedef struct command {
    const char *name;
    const char *synopsis;  /* after the name: "SCENE [options]" */
    const char *summary;   /* one line */
    const option *options; /* no name after the last; --help is understood everywhere */
    int (*run)(const struct command *self, int argc, char **argv); /* argv holds the command's
                                                                    * words; returns the exit
                                                                    * status */
} command;

enum { EXIT_USAGE = 2, OPTIONS_READ = -1 };

/**
 * Reads the command line into *request: options as the table says, words by `take_word`, whose `to`
 * is the request. OPTIONS_READ, or the exit status: 0 after --help, EXIT_USAGE after a message.
 */
int options_read(const command *of, int argc, char **argv, void *request, option_taker *take_word);

/** The word's index in `choices` (NULL after the last); -1 after a message. */
int options_choice(const options *o, const char *name, const char *const *choices);

/** Takes the only word into *text; `what` describes it in messages: "a folder". */
int options_only_word(const options *o, const char **text, const char *what);

/** "fabric run: ..." on standard error. Returns EXIT_USAGE. */
int options_complain(const command *of, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** The program's name as it was started, without folders. */
extern const char *program_name;

#endif
