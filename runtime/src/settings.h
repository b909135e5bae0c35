/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the environment says: REDCC_METHOD, REDCC_ORDER, REDCC_MEMORY_LIMIT, REDCC_REPORT. */
#ifndef REDCC_SETTINGS_H
#define REDCC_SETTINGS_H

#include "plan/method.h"

struct settings {
    const struct method *method; /* NULL: auto */
    int parameter;               /* the method's */
    bool order_given;
    redcc_order order;   /* where given */
    bool compensated;    /* REDCC_SUM */
    bool validate;       /* REDCC_VALIDATE */
    bool watch;          /* REDCC_WATCH: where it can be done */
    size_t memory_limit; /* bytes; 0: none */
    char *report;        /* file name; NULL: none */
};

/** The settings; the environment is read at the first call. Stops the program with a message and
 *  status 2 where it says something unknown. Thread-safe. */
const struct settings *redcc_settings(void);

/** A variable of the environment; NULL: it is not set, or the program has more rights than who
 *  started it (setuid), who must not tell it anything then. */
const char *redcc_environment(const char *name);

/** The sizes that REDCC_MEMORY_LIMIT may name: digits and K, M or G. False: it is none. */
bool redcc_parse_bytes(const char *text, size_t *bytes);

/** "serial", "fixed", "any". */
const char *redcc_order_name(redcc_order order);

/** Prints "redcc: " and a message to standard error and ends the program with status 2. */
_Noreturn void redcc_stop(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
