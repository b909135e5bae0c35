/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "settings.h"

#include "base/memory.h"
#include "base/signals.h"
#include "base/spin.h"
#include "base/team.h"
#include "base/trace.h"
#include "named.h"
#include "report.h"
#include "spelling.h"
#include "variables.h"

#include <assert.h>
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The trip count from which a loop with short iterations calls the runtime. Such an iteration takes
 * some nanoseconds, so fewer iterations are too short for a state (unmade.h). A call costs 20 to 30
 * nanoseconds, as much as a tenth of 200 iterations. */
enum { LEAST_TRIP = 1024 };

/* The number of short iterations that the program executes before it calls the runtime for the
 * first time. The first call costs 2 microseconds, for page faults. Iterations take at least 0.3 ns
 * each, so it costs at most a twentieth of the time of these iterations. If an iteration takes 0.3
 * microseconds (mathematical functions), they take 0.04 s. */
enum { EXEMPT_ITERATIONS = 1 << 17 };

redcc_int redcc_least_trip;
redcc_int redcc_exempt_iterations;

static struct settings settings;
static struct named named;
static char complaint[1024]; /* message about the first error in the environment; "": no error */

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
    assert(order <= REDCC_ORDER_ANY);
    return order_names[order];
}

void redcc_complain(const char *format, ...) {
    va_list arguments;
    if (complaint[0]) /* only the first error is reported */
        return;
    va_start(arguments, format);
    vsnprintf(complaint, sizeof complaint, format, arguments);
    va_end(arguments);
}

/* Appends to a text of at most `size` bytes; the part that does not fit is dropped. */
static void append(char *text, size_t size, const char *more) {
    const size_t used = strlen(text);
    snprintf(text + used, size - used, "%s", more);
}

void redcc_complain_of_unknown(const char *variable, const char *value, const char *const *names,
                               size_t count) {
    assert(count > 0); /* otherwise there is no nearest name */
    char known[512] = "";
    for (size_t i = 0; i < count; i++) {
        append(known, sizeof known, i ? " " : "");
        append(known, sizeof known, names[i]);
    }
    redcc_complain("%s=%s is not known; did you mean %s? Known are: %s", variable, value,
                   names[redcc_spelling_nearest(value, names, count)], known);
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
    redcc_complain_of_unknown("REDCC_ORDER", value, order_names, 3);
}

/* The index of the value among the names. Returns `otherwise` if the variable is unset, or if its
 * value is not among the names; then an error is recorded. */
static unsigned read_named(const char *variable, const char *value, const char *const *names,
                           unsigned count, unsigned otherwise) {
    if (!value || !*value)
        return otherwise;
    for (unsigned i = 0; i < count; i++)
        if (strcmp(value, names[i]) == 0)
            return i;
    redcc_complain_of_unknown(variable, value, names, count);
    return otherwise;
}

static void read_sum(const char *value) {
    static const char *const names[] = {"plain", "compensated"};
    settings.compensated = read_named("REDCC_SUM", value, names, 2, false);
}

static void stop_at_uncompensated(const struct method *method) {
    if (settings.compensated && method && (method->keeps != REDCC_ORDER_SERIAL || !method->prepare))
        redcc_complain(
            "REDCC_METHOD=%s cannot give REDCC_SUM=compensated, which is added up in the "
            "order of the loop, element by element; localwrite can",
            method->name);
}

static void read_validate(const char *value) {
    static const char *const names[] = {"0", "1"};
    settings.validate = read_named("REDCC_VALIDATE", value, names, 2, false);
}

static void read_watch(const char *value) {
    static const char *const names[] = {"off", "auto"};
    settings.watch = read_named("REDCC_WATCH", value, names, 2, true);
}

static void read_prefetch(const char *value) {
    static const char *const names[] = {"off", "auto", "on"};
    settings.prefetch =
        (enum prefetch_setting)read_named("REDCC_PREFETCH", value, names, 3, PREFETCH_AUTO);
}

static void read_lanes(const char *value) {
    static const char *const names[] = {"off", "auto"};
    settings.lanes = (enum lanes_setting)read_named("REDCC_LANES", value, names, 2, LANES_AUTO);
}

/* Parses REDCC_TRACE: names separated by commas. */
static void read_trace(const char *value) {
    while (value && *value) {
        char name[32];
        const size_t length = strcspn(value, ",");
        snprintf(name, sizeof name, "%.*s", length < sizeof name ? (int)length : 31, value);
        unsigned subject = 0;
        while (subject < TRACES && strcmp(name, redcc_trace_names[subject]) != 0)
            subject++;
        if (subject == TRACES && length > 0)
            redcc_complain_of_unknown("REDCC_TRACE", name, redcc_trace_names, TRACES);
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
        redcc_complain("REDCC_MEMORY_LIMIT=%s is no size; write digits, and K, M or G", value);
    if (settings.memory_limit == 0)
        settings.memory_limit = 1; /* a limit that permits nothing, since 0 would mean no limit */
}

/* The method in force if `said` was named. Under validation, it is LOCALWRITE if no method is
 * named, because every loop must run in parallel if possible, from its first call on. Auto would
 * begin with the sequential loop and, in a short program, never execute it in parallel. */
static struct named_method in_force(struct named_method said) {
    if (!said.method && settings.validate)
        said.method = &redcc_method_localwrite;
    return said;
}

static void take_methods(void) {
    redcc_named_read(&named, redcc_environment("REDCC_METHOD"));
    named.all = in_force(named.all);
    settings.method = named.all.method;
    settings.parameter = named.all.parameter;
    stop_at_uncompensated(settings.method);
    for (struct named_loop *loop = named.loops; loop; loop = loop->next) {
        loop->as = in_force(loop->as);
        stop_at_uncompensated(loop->as.method);
    }
}

/* Creates the settings of a loop for which REDCC_METHOD names a method. All other settings are
 * copied from the common ones. */
static void copy_settings(struct named_loop *loop) {
    loop->settings = redcc_memory_alloc(sizeof *loop->settings);
    if (!loop->settings)
        return;
    *loop->settings = settings;
    loop->settings->method = loop->as.method;
    loop->settings->parameter = loop->as.parameter;
}

static void end_program(void) {
    redcc_report_write();
    redcc_named_note_unmet(&named, redcc_report_loops());
}

static void read_environment(void) {
    read_order(redcc_environment("REDCC_ORDER"));
    read_sum(redcc_environment("REDCC_SUM"));
    read_validate(redcc_environment("REDCC_VALIDATE"));
    take_methods();
    read_watch(redcc_environment("REDCC_WATCH"));
    read_prefetch(redcc_environment("REDCC_PREFETCH"));
    read_lanes(redcc_environment("REDCC_LANES"));
    read_trace(redcc_environment("REDCC_TRACE"));
    read_memory_limit(redcc_environment("REDCC_MEMORY_LIMIT"));
    if (!settings.method && !named.loops && !settings.compensated)
        __atomic_store_n(&redcc_least_trip, LEAST_TRIP, __ATOMIC_RELAXED);
    const char *report = redcc_environment("REDCC_REPORT");
    if (report && *report)
        settings.report = redcc_memory_copy_text(report);
    if (settings.report || named.loops)
        atexit(end_program);
    for (struct named_loop *loop = named.loops; loop; loop = loop->next)
        copy_settings(loop);
    redcc_note_unknown_variables();
    redcc_report_begin();
    redcc_memory_limit(settings.memory_limit); /* memory allocated so far is counted as well */
}

/* Reads the settings once, even if several threads call this at the same time. */
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

/* Reads the settings before main, if no REDCC_... variable is set, except those that only a build
 * reads. If they were read later, the first execution of a loop of some microseconds would take
 * three times as long. */
__attribute__((constructor)) static void read_early(void) {
    redcc_team_bind();
    if (redcc_any_variable())
        return;
    redcc_settings();
    __atomic_store_n(&redcc_exempt_iterations, EXEMPT_ITERATIONS, __ATOMIC_RELAXED);
}

const struct settings *redcc_settings_for(const redcc_loop *loop) {
    const struct settings *all = redcc_settings();
    const struct named_loop *one = named.loops ? redcc_named_find(&named, loop) : NULL;
    return one && one->settings ? one->settings : all;
}
