/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The settings, which environment variables determine (variables.h). */
#ifndef REDCC_SETTINGS_H
#define REDCC_SETTINGS_H

#include "execute/lanes.h"
#include "execute/prefetch.h"
#include "plan/method.h"

struct settings {
    /* the named method, or the one that REDCC_VALIDATE implies; NULL: auto */
    const struct method *method;
    int parameter;                  /* the method's parameter */
    bool order_given;               /* REDCC_ORDER is set */
    redcc_order order;              /* the order that REDCC_ORDER names, if order_given */
    bool compensated;               /* REDCC_SUM */
    bool validate;                  /* REDCC_VALIDATE */
    bool watch;                     /* REDCC_WATCH: track writes if possible */
    enum prefetch_setting prefetch; /* REDCC_PREFETCH */
    enum lanes_setting lanes;       /* REDCC_LANES */
    size_t memory_limit;            /* bytes; 0: none */
    char *report;                   /* file name; NULL: none */
};

/** The settings; the first call reads the environment. Stops the program with a message and status
 *  2 if a value is invalid. Thread-safe. */
const struct settings *redcc_settings(void);

/** The settings for the loop: those of redcc_settings, but with the method that REDCC_METHOD names
 * for this loop, if it names one. */
const struct settings *redcc_settings_for(const redcc_loop *loop);

/** Records an error in the environment. redcc_settings stops with the first error. */
void redcc_complain(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** Records an error: the value of `variable` is not one of `count` names. The message lists all
 * names, and suggests the nearest one. */
void redcc_complain_of_unknown(const char *variable, const char *value, const char *const *names,
                               size_t count);

/** The order that the loop's sums must satisfy. */
static inline redcc_order redcc_order_of(const redcc_loop *loop, const struct settings *settings) {
    return settings->order_given ? settings->order : (redcc_order)loop->order;
}

/** Parses a size such as that of REDCC_MEMORY_LIMIT: digits, and optionally K, M or G. Returns
 * false if it is invalid. */
bool redcc_parse_bytes(const char *text, size_t *bytes);

/** The name of an order: "serial", "fixed" or "any". */
const char *redcc_order_name(redcc_order order);

/** Prints "redcc: " and a message to standard error and ends the program with status 2. */
_Noreturn void redcc_stop(const char *format, ...) __attribute__((format(printf, 1, 2)));

#endif
