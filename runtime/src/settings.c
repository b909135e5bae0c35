/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "settings.h"

#include "base/memory.h"
#include "base/signals.h"
#include "base/spin.h"
#include "base/trace.h"
#include "report.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* 128 iterations at a memory access or two take some microseconds, as beginning and ending a
 * parallel region does. */
enum { LEAST_TRIP = 128 };

redcc_int redcc_least_trip;

static struct settings settings;
static char complaint[1024]; /* what the environment says that is unknown; "": nothing */

void redcc_stop(const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    fflush(stdout);
    fputs("redcc: ", stderr);
    vfprintf(stderr, format, arguments);
    fputc('\n', stderr);
    va_end(arguments);
    exit(2);
}

static const char *const order_names[] = {"serial", "fixed", "any"};

const char *redcc_order_name(redcc_order order) {
    return order_names[order];
}

/* How many letters to insert, remove or change to make one word of the other (Levenshtein). */
static size_t distance(const char *a, const char *b) {
    enum { LONGEST = 64 };
    size_t row[LONGEST + 1];
    const size_t width = strnlen(b, LONGEST);
    for (size_t j = 0; j <= width; j++)
        row[j] = j;
    for (size_t i = 1; i <= LONGEST && a[i - 1]; i++) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= width; j++) {
            const size_t changed = diagonal + (a[i - 1] != b[j - 1]);
            const size_t shorter = (row[j] < row[j - 1] ? row[j] : row[j - 1]) + 1;
            diagonal = row[j];
            row[j] = changed < shorter ? changed : shorter;
        }
    }
    return row[width];
}

/* Appends to a text of at most `size` bytes; what does not fit is left out. */
static void append(char *text, size_t size, const char *more) {
    const size_t used = strlen(text);
    snprintf(text + used, size - used, "%s", more);
}

static void complain_of_unknown(const char *variable, const char *value, const char *const *names,
                                size_t count) {
    char known[512] = "";
    const char *nearest = names[0];
    for (size_t i = 0; i < count; i++) {
        append(known, sizeof known, i ? " " : "");
        append(known, sizeof known, names[i]);
        if (distance(value, names[i]) < distance(value, nearest))
            nearest = names[i];
    }
    snprintf(complaint, sizeof complaint, "%s=%s is not known; did you mean %s? Known are: %s",
             variable, value, nearest, known);
}

static void complain_of_unknown_method(const char *value) {
    enum { MOST = 32, LONGEST = 64 };
    static char spelled[MOST][LONGEST];
    const char *names[MOST] = {"auto"};
    size_t count = 1;
    for (const struct method *const *method = redcc_methods; *method && count < MOST; method++) {
        const char *parameter = (*method)->parameter;
        snprintf(spelled[count], LONGEST, parameter ? "%s[:%s]" : "%s", (*method)->name, parameter);
        names[count] = spelled[count];
        count++;
    }
    complain_of_unknown("REDCC_METHOD", value, names, count);
}

static void read_method(const char *value) {
    if (!value || !*value || strcmp(value, "auto") == 0)
        return;
    const size_t length = strcspn(value, ":");
    for (const struct method *const *each = redcc_methods; *each; each++) {
        const struct method *method = *each;
        if (!redcc_method_is_named(method, value, length))
            continue;
        settings.method = method;
        settings.parameter = method->usual;
        if (value[length] == ':') {
            settings.parameter = method->parse ? method->parse(value + length + 1) : 0;
            if (!settings.parameter)
                complain_of_unknown_method(value);
        }
        return;
    }
    complain_of_unknown_method(value);
}

static void read_order(const char *value) {
    if (!value || !*value)
        return;
    for (int order = 0; order <= REDCC_ORDER_ANY; order++)
        if (strcmp(value, order_names[order]) == 0) {
            settings.order_given = true;
            settings.order = (redcc_order)order;
            return;
        }
    complain_of_unknown("REDCC_ORDER", value, order_names, 3);
}

static void read_sum(const char *value) {
    static const char *const names[] = {"plain", "compensated"};
    if (!value || !*value)
        return;
    settings.compensated = strcmp(value, names[1]) == 0;
    if (!settings.compensated && strcmp(value, names[0]) != 0)
        complain_of_unknown("REDCC_SUM", value, names, 2);
    const struct method *method = settings.method;
    if (settings.compensated && method && (method->keeps != REDCC_ORDER_SERIAL || !method->prepare))
        snprintf(
            complaint, sizeof complaint,
            "REDCC_METHOD=%s cannot give REDCC_SUM=compensated, which is added up in the order "
            "of the loop, element by element; localwrite can",
            method->name);
}

static void read_validate(const char *value) {
    static const char *const names[] = {"0", "1"};
    if (!value || !*value)
        return;
    settings.validate = strcmp(value, names[1]) == 0;
    if (!settings.validate && strcmp(value, names[0]) != 0)
        complain_of_unknown("REDCC_VALIDATE", value, names, 2);
}

static void read_watch(const char *value) {
    static const char *const names[] = {"off", "auto"};
    settings.watch = true;
    if (!value || !*value)
        return;
    settings.watch = strcmp(value, names[1]) == 0;
    if (!settings.watch && strcmp(value, names[0]) != 0)
        complain_of_unknown("REDCC_WATCH", value, names, 2);
}

/* Names with commas between them. */
static void read_trace(const char *value) {
    while (value && *value) {
        char name[32];
        const size_t length = strcspn(value, ",");
        snprintf(name, sizeof name, "%.*s", length < sizeof name ? (int)length : 31, value);
        unsigned subject = 0;
        while (subject < TRACES && strcmp(name, redcc_trace_names[subject]) != 0)
            subject++;
        if (subject == TRACES && length > 0)
            complain_of_unknown("REDCC_TRACE", name, redcc_trace_names, TRACES);
        redcc_traced |= subject < TRACES ? 1u << subject : 0;
        value += length + (value[length] == ',');
    }
}

bool redcc_parse_bytes(const char *text, size_t *bytes) {
    if (*text < '0' || *text > '9')
        return false;
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    if (errno)
        return false;
    static const char units[] = "KMG";
    const char *unit = *end ? strchr(units, *end) : NULL;
    if (*end && (!unit || end[1]))
        return false;
    const int shift = unit ? 10 * (int)(unit - units + 1) : 0;
    if (value > (SIZE_MAX >> shift))
        return false;
    *bytes = (size_t)value << shift;
    return true;
}

static void read_memory_limit(const char *value) {
    if (!value || !*value)
        return;
    if (!redcc_parse_bytes(value, &settings.memory_limit))
        snprintf(complaint, sizeof complaint,
                 "REDCC_MEMORY_LIMIT=%s is no size; write digits, and K, M or G", value);
    if (settings.memory_limit == 0)
        settings.memory_limit = 1; /* nothing at all, not: no limit */
    redcc_memory_limit(settings.memory_limit);
}

/* Who starts a program that has more rights than himself may not tell it what to write where. */
const char *redcc_environment(const char *name) {
    return redcc_system_is_privileged() ? NULL : getenv(name);
}

static char *copy_of(const char *text) {
    const size_t bytes = strlen(text) + 1;
    char *copy = redcc_memory_take(bytes);
    return copy ? memcpy(copy, text, bytes) : NULL;
}

static void read_environment(void) {
    read_method(redcc_environment("REDCC_METHOD"));
    read_order(redcc_environment("REDCC_ORDER"));
    read_sum(redcc_environment("REDCC_SUM"));
    read_validate(redcc_environment("REDCC_VALIDATE"));
    read_watch(redcc_environment("REDCC_WATCH"));
    read_trace(redcc_environment("REDCC_TRACE"));
    read_memory_limit(redcc_environment("REDCC_MEMORY_LIMIT"));
    if (!settings.method && !settings.compensated && !settings.validate)
        __atomic_store_n(&redcc_least_trip, LEAST_TRIP, __ATOMIC_RELAXED);
    const char *report = redcc_environment("REDCC_REPORT");
    if (report && *report && (settings.report = copy_of(report)) != NULL)
        atexit(redcc_report_write);
}

/* Of several threads that come first, one reads. */
static void read_once(atomic_int *done) {
    static struct spin lock;
    const uint64_t signals = redcc_signals_hold();
    redcc_spin_lock(&lock);
    if (!atomic_load(done))
        read_environment();
    atomic_store(done, 1);
    redcc_spin_unlock(&lock);
    redcc_signals_release(signals);
}

const struct settings *redcc_settings(void) {
    static atomic_int done;
    if (!atomic_load_explicit(&done, memory_order_acquire))
        read_once(&done);
    if (complaint[0])
        redcc_stop("%s", complaint);
    return &settings;
}
