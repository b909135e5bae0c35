/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The state of one call of redcc-cc; translate.h and build.h have the steps. */
#ifndef DRIVER_SESSION_H
#define DRIVER_SESSION_H

#include "driver/command.h"
#include "driver/compiler.h"
#include "driver/installation.h"
#include "driver/process.h"
#include "driver/temporary.h"

typedef struct session {
    arena *memory;
    installation tools;
    compiler real;       /**< the compiler */
    word_list given;     /**< its arguments as given */
    command command;     /**< these arguments, parsed */
    word_list options;   /**< $REDCC_OPTS */
    bool contracts;      /**< --order=any: the compiler may contract multiply and add */
    bool show;           /**< --redcc-show: print the commands, run nothing */
    bool only_reports;   /**< --redcc-report: translate and report, compile nothing */
    bool verbose;        /**< -v */
    bool remarks;        /**< -Rredcc: print remarks on the loops of each source */
    bool strict;         /**< $REDCC_STRICT: a source that cannot be translated ends the build */
    struct cache *cache; /**< the cache (cache.h), or NULL */
    const char *report;  /**< the file for the build's report, or NULL */
    const char *folder;  /**< the folder for temporaries; NULL before there is one */
    VECTOR(shared_folder) shared; /**< folders shared with other processes (temporary.h) */
    const char *input;   /**< a file with the contents of standard input; NULL if it is no source */
    unsigned attempts;   /**< the number of compiler runs so far, by which their files are named */
    word_list fallbacks; /**< sources whose translated text did not compile */
    word_list unlinked;  /**< sources whose translated objects did not link */
} session;

/** Reads $REDCC_OPTS into the session, and what -Rredcc adds to it. */
void session_read_options(session *s);

/** Reads the file name of the build's report, and whether the build is strict, into the session. */
void session_read_environment(session *s);

/** The command's option by which the compiler may reorder or approximate arithmetic (-Ofast).
 * Returns NULL if there is none, or if --order=any allows it. Translated texts are compiled without
 * it. */
const char *session_liberty(const session *s);

/** Returns OPTION_LIBERTY if session_liberty names an option, else 0. */
unsigned session_liberties(const session *s);

/** Runs a command (process_run) or, under --redcc-show, prints it and returns 0. A command line
 *  that is too long for the system is passed in a response file. */
int session_run(session *s, const word_list *words, process_streams streams);

/** Prints one line on standard error, "redcc-cc: warning: ...". */
void session_warn(const session *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Like session_warn, but prints "redcc-cc: note: ...". */
void session_note(const session *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Like session_note, but prints only with -v. */
void session_explain(const session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Reports, under -v or -Rredcc and in the build's report, why an input is passed to the compiler
 * unchanged. Unlike session_leave_alone, this is never an error. */
void session_pass_by(session *s, const char *file, const char *why);

/** Reports, under -v or -Rredcc and in the build's report, why a C source is compiled unchanged.
 * With $REDCC_STRICT this is an error, which ends the process with status 1. */
void session_leave_alone(session *s, const char *file, const char *why);

/** Removes the temporaries and ends the process with `status`, a result of process_run, or by a
 * signal that was caught. If `status` is 0, first warns of the sources whose translated text did
 * not compile or did not link. */
_Noreturn void session_end(session *s, int status);

/** Removes the temporaries and replaces this process by the compiler, with the given arguments. If
 *  standard input has already been read, or messages follow, the compiler runs as a child instead,
 *  and session_end ends this process. With --redcc-report this process ends without compiling. */
_Noreturn void session_become_compiler(session *s);

/** Adds the compiler and its arguments as they were given. */
void session_add_original(session *s, word_list *list);

#endif
