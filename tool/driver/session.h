/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What one call of redcc-cc knows and uses; the steps are in translate.h and build.h. */
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
    command command;     /**< the same, taken apart */
    word_list options;   /**< $REDCC_OPTS */
    bool contracts;      /**< order any: the compiler may fuse multiply and add */
    bool show;           /**< --redcc-show: print what would run, run nothing */
    bool only_reports;   /**< --redcc-report: translate and report, compile nothing */
    bool verbose;        /**< -v */
    bool strict;         /**< $REDCC_STRICT: a source that would be left alone ends the build */
    struct cache *cache; /**< where answers are kept (cache.h); NULL: nowhere */
    const char *report;  /**< where the build's report goes; NULL: nowhere */
    const char *folder;  /**< for temporaries; NULL before there is one */
    VECTOR(shared_folder) shared; /**< those that other calls may use at the same time */
    const char *input;   /**< what standard input held, in a file; NULL where it is no source */
    unsigned attempts;   /**< made so far: their files are numbered */
    word_list fallbacks; /**< sources whose translated text did not compile */
    word_list unlinked;  /**< sources whose translated objects did not link */
} session;

/** Reads $REDCC_OPTS into the session. */
void session_read_options(session *s);

/** Reads into the session where the build's report goes, and whether the build is strict. */
void session_read_environment(session *s);

/** Prints a command and returns 0 under --redcc-show; else runs it (process_run). A command line
 *  too long for the system goes through a response file. */
int session_run(session *s, const word_list *words, process_streams streams);

/** One line on standard error, "redcc-cc: LEVEL: ...". */
void session_warn(const session *s, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** The same, for what is worth telling only to who asked for it by -v. */
void session_explain(const session *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** An input is passed to the compiler as it is, for this reason, and rightly so: says so to who
 * asked for it by -v, and in the build's report. */
void session_pass_by(session *s, const char *file, const char *why);

/** A C source is compiled as it is, for this reason: says so to who asked for it by -v, and in the
 *  build's report. Under $REDCC_STRICT an error, which ends the process with status 1. */
void session_leave_alone(session *s, const char *file, const char *why);

/** Removes the temporaries and ends the process as `status` (process_run's) says, or as a signal
 *  that came in the meantime. Where all went well in the end, names the sources whose translated
 *  text did not compile. */
_Noreturn void session_end(session *s, int status);

/** Removes the temporaries and becomes the compiler, with the arguments given; runs it instead
 * where something is left to do after it. Under --redcc-report the process ends here. */
_Noreturn void session_become_compiler(session *s);

/** Adds the compiler and its arguments as they were given. */
void session_add_original(session *s, word_list *list);

#endif
