/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The contents of a report, as JSON and as a table. docs/report.md describes both. */
#include "report.h"

#include "base/clock.h"
#include "base/region.h"
#include "base/system.h"
#include "settings.h"
#include "variables.h"
#include "why.h"

#include <assert.h>
#include <string.h>

/* ---- shared by both formats ------------------------------------------------------------------ */

static const char *rule_slug(const struct statistics *statistics) {
    static const char *const slugs[] = {"named",
#define REDCC_RULE(id, slug, known, done) slug,
                                        REDCC_RULE_LIST(REDCC_RULE)
#undef REDCC_RULE
    };
    return slugs[atomic_load(&statistics->rule)];
}

static const char *mode_slug(const struct statistics *statistics) {
    static const char *const slugs[] = {
#define REDCC_MODE(id, slug, text) slug,
        REDCC_MODE_LIST(REDCC_MODE)
#undef REDCC_MODE
    };
    return slugs[atomic_load(&statistics->last.mode)];
}

enum { LONGEST_METHOD = 64 };

static void spell_method(char name[LONGEST_METHOD], const struct statistics *statistics) {
    const struct method *method = statistics->method ? statistics->method : &redcc_method_serial;
    if (method->parameter && method->parameter[0] == 'N')
        snprintf(name, LONGEST_METHOD, "%s:%d", method->name, statistics->parameter);
    else if (method->spell && statistics->parameter != method->usual)
        snprintf(name, LONGEST_METHOD, "%s:%s", method->name, method->spell(statistics->parameter));
    else if (method->parameter && statistics->parameter != method->usual)
        snprintf(name, LONGEST_METHOD, "%s:%c", method->name, statistics->parameter);
    else
        snprintf(name, LONGEST_METHOD, "%s", method->name);
}

/* Speed-up per iteration: the sequential loop's seconds divided by the seconds of parallel
 * executions, which include all inspections and plan constructions. 0 if one of these times was not
 * measured. */
static double speedup_of(const struct statistics *it) {
    const double parallel = it->inspect_seconds + it->execute_seconds;
    if (it->in_loops == 0 || it->sequential.iterations == 0 || parallel <= 0)
        return 0;
    return it->sequential.seconds / (double)it->sequential.iterations /
           (parallel / (double)it->in_loops);
}

/* ---- JSON ------------------------------------------------------------------------------------ */

static void write_string(FILE *out, const char *text) {
    putc('"', out);
    for (; *text; text++) {
        const unsigned char letter = (unsigned char)*text;
        if (letter == '"' || letter == '\\')
            fprintf(out, "\\%c", letter);
        else if (letter < 0x20)
            fprintf(out, "\\u%04x", letter);
        else
            putc(letter, out);
    }
    putc('"', out);
}

/* Writes a decimal number without printf's %f, whose decimal point depends on the locale. */
static void write_decimal(FILE *out, const char *key, double value, int digits) {
    long long unit = 1;
    for (int i = 0; i < digits; i++)
        unit *= 10;
    const long long rounded = (long long)(value * (double)unit + 0.5);
    fprintf(out, ", \"%s\": %lld.%0*lld", key, rounded / unit, digits, rounded % unit);
}

static void write_text(FILE *out, const char *key, const char *text) {
    fprintf(out, ", \"%s\": ", key);
    write_string(out, text);
}

static void write_fallback(FILE *out, const char **separator, enum reason reason, const char *text,
                           long count) {
    if (count == 0)
        return;
    fprintf(out, "%s{\"slug\": \"%s\"", *separator, redcc_reason_slug(reason));
    write_text(out, "reason", text);
    fprintf(out, ", \"count\": %ld}", count);
    *separator = ", ";
}

/* Writes the number of lanes of the last parallel execution (1: one by one), with the reason. */
static void write_lanes(FILE *out, const struct statistics *it) {
    fprintf(out, ", \"lanes\": %d", it->last.lanes > 0 ? it->last.lanes : 1);
    write_text(out, "lanes_why", redcc_lanes_slug(it->last.lanes_reason));
}

static void write_why(FILE *out, const struct statistics *it) {
    char why[REDCC_WHY];
    redcc_why_sequential(it, why);
    if (why[0])
        write_text(out, "why_sequential", why);
    else
        fputs(", \"why_sequential\": null", out);
}

static void write_fallbacks(FILE *out, const struct statistics *it) {
    const char *separator = "";
    fputs(", \"fallbacks\": [", out);
    for (enum reason reason = REASON_NONE + 1; reason < REASON_COUNT; reason++)
        write_fallback(out, &separator, reason, redcc_report_reason(it, reason),
                       atomic_load(&it->fallback[reason]));
    for (int i = 0; i < REDCC_TEXTS; i++)
        write_fallback(out, &separator, REASON_OVERLAP, it->why.overlap[i].text,
                       it->why.overlap[i].count);
    putc(']', out);
}

static void write_plans(FILE *out, const struct statistics *it) {
    fprintf(out, ", \"plans_built\": %ld, \"plans_reused\": %ld, \"watched\": %ld", it->plans_built,
            it->plans_reused, it->watched);
    fprintf(out, ", \"plans_lost\": %ld, \"changed\": [", it->lost.count);
    for (int i = 0; i < REDCC_LOST && it->lost.array[i].count > 0; i++) {
        fputs(i ? ", {\"array\": " : "{\"array\": ", out);
        write_string(out, it->lost.array[i].name);
        fprintf(out, ", \"count\": %ld}", it->lost.array[i].count);
    }
    putc(']', out);
}

static void write_times(FILE *out, const struct statistics *it) {
    write_decimal(out, "inspect_seconds", it->inspect_seconds, 6);
    write_decimal(out, "execute_seconds", it->execute_seconds, 6);
    write_decimal(out, "sequential_seconds", it->sequential.seconds, 6);
    fprintf(out, ", \"sequential_calls\": %ld", it->sequential.calls);
    const double speedup = speedup_of(it);
    if (speedup > 0)
        write_decimal(out, "speedup", speedup, 3);
    else
        fputs(", \"speedup\": null", out);
}

static void write_work(FILE *out, const struct statistics *it) {
    fprintf(out, ", \"extra_bytes\": %zu, \"iterations\": %lld, \"stages\": %lld", it->extra.bytes,
            it->extra.executed, it->last.stages);
    write_decimal(out, "replication",
                  it->in_loops ? (double)it->extra.executed / (double)it->in_loops : 1, 4);
    const redcc_int modelled = it->last.length ? it->last.trip * 100 / it->last.length : 100;
    write_decimal(out, "modelled_speedup", (double)modelled / 100, 2);
}

static void write_loop(FILE *out, const struct reported *loop) {
    const struct statistics *it = &loop->statistics;
    char method[LONGEST_METHOD];
    spell_method(method, it);
    fputs("{\"file\": ", out);
    write_string(out, loop->file);
    fprintf(out, ", \"line\": %d", loop->line);
    write_text(out, "function", loop->function);
    write_text(out, "method", method);
    write_text(out, "mode", mode_slug(it));
    write_text(out, "rule", rule_slug(it));
    write_text(out, "order", redcc_order_name(it->order));
    write_text(out, "sum", it->last.compensated ? "compensated" : "plain");
    fprintf(out, ", \"threads\": %d, \"calls\": %ld", it->threads, atomic_load(&it->calls));
    fprintf(out, ", \"nodes\": %d, \"moves\": %ld", it->placement.nodes, it->placement.moves);
    if (it->validated.executions > 0)
        fprintf(out, ", \"validated\": %ld, \"promises_broken\": %ld", it->validated.executions,
                it->validated.broken);
    write_lanes(out, it);
    write_why(out, it);
    write_plans(out, it);
    write_times(out, it);
    write_work(out, it);
    write_fallbacks(out, it);
    putc('}', out);
}

/* Writes the value of an environment variable that sets OpenMP's thread affinity or wait policy. */
static void write_variable(FILE *out, const char *key, const char *variable) {
    const char *value = redcc_environment(variable);
    fprintf(out, "\"%s\": ", key);
    if (value)
        write_string(out, value);
    else
        fputs("null", out);
    fputs(", ", out);
}

/* The time, and the number of preemptions so far, when the first loop began. */
static double began_at;
static long lost_before;

void redcc_report_begin(void) {
    began_at = redcc_seconds();
    lost_before = redcc_system_preemptions();
}

void redcc_report_head(char head[REDCC_REPORT_HEAD]) {
    snprintf(head, REDCC_REPORT_HEAD, "{\"process\": %ld, \"started\": %llu, ",
             redcc_system_process(), redcc_system_started());
}

void redcc_report_list(FILE *out) {
    const char *separator = "\n ";
    for (const struct reported *loop = redcc_report_loops(); loop; loop = loop->next) {
        fputs(separator, out);
        write_loop(out, loop);
        separator = ",\n ";
    }
}

void redcc_report_body(FILE *out) {
    write_variable(out, "proc_bind", "OMP_PROC_BIND");
    write_variable(out, "places", "OMP_PLACES");
    write_variable(out, "wait_policy", "OMP_WAIT_POLICY");
    fprintf(out, "\"cores_lost\": %ld", redcc_system_preemptions() - lost_before);
    write_decimal(out, "seconds", redcc_seconds() - began_at, 6);
    fputs(", \"loops\": [", out);
    redcc_report_list(out);
    fputs("]}\n", out);
}

/* ---- a table --------------------------------------------------------------------------------- */

static void write_notes(FILE *out, const struct statistics *it) {
    char why[REDCC_WHY];
    redcc_why_sequential(it, why);
    if (why[0])
        fprintf(out, "redcc:       why sequential: %s\n", why);
    for (enum reason reason = REASON_NONE + 1; reason < REASON_COUNT; reason++)
        if (atomic_load(&it->fallback[reason]) > 0)
            fprintf(out, "redcc:       sequential %ld times: %s\n",
                    atomic_load(&it->fallback[reason]), redcc_report_reason(it, reason));
    for (int i = 0; i < REDCC_TEXTS; i++)
        if (it->why.overlap[i].count > 0)
            fprintf(out, "redcc:       sequential %ld times: %s\n", it->why.overlap[i].count,
                    it->why.overlap[i].text);
    for (int i = 0; i < REDCC_LOST; i++)
        if (it->lost.array[i].count > 0)
            fprintf(out, "redcc:       a plan lost %ld times: '%s' had changed\n",
                    it->lost.array[i].count, it->lost.array[i].name);
}

/* If other processes are busy, cores are preempted some 50 to 200 times a second (docs/report.md).
 * On an idle machine they are rarely preempted. */
bool redcc_advises_sleep(long lost, double seconds, const char *policy, bool has_spin_time) {
    assert(seconds >= 0);
    const long many = 10, a_second = 20;
    const bool sleeps = policy && (policy[0] == 'p' || policy[0] == 'P');
    return !sleeps && !has_spin_time && lost >= many && (double)lost >= (double)a_second * seconds;
}

static void write_advice(FILE *out) {
    const long lost = redcc_system_preemptions() - lost_before;
    const double seconds = redcc_seconds() - began_at;
    const bool has_spin_time = redcc_region_is_own() || redcc_environment("GOMP_SPINCOUNT") ||
                               redcc_environment("KMP_BLOCKTIME");
    if (redcc_advises_sleep(lost, seconds, redcc_environment("OMP_WAIT_POLICY"), has_spin_time))
        fprintf(
            out,
            "redcc: other programs took this one's cores %ld times in %.1f s. Its waiting threads "
            "spin meanwhile: OMP_WAIT_POLICY=passive lets them sleep, and may be faster\n",
            lost, seconds);
}

void redcc_report_table(FILE *out) {
    fputs(
        "redcc: calls threads  built reused lost inspecting executing sequential speed-up method, "
        "mode, rule; loop\n",
        out);
    for (const struct reported *loop = redcc_report_loops(); loop; loop = loop->next) {
        const struct statistics *it = &loop->statistics;
        char method[LONGEST_METHOD], speedup[16] = "-";
        spell_method(method, it);
        if (speedup_of(it) > 0)
            snprintf(speedup, sizeof speedup, "%.2f", speedup_of(it));
        fprintf(
            out, "redcc: %5ld %7d %6ld %6ld %4ld %9.4fs %8.4fs %9.4fs %8s %s, %s, %s; %s:%d (%s)\n",
            atomic_load(&it->calls), it->threads, it->plans_built, it->plans_reused, it->lost.count,
            it->inspect_seconds, it->execute_seconds, it->sequential.seconds, speedup, method,
            mode_slug(it), rule_slug(it), loop->file, loop->line, loop->function);
        write_notes(out, it);
    }
    if (redcc_report_loops())
        write_advice(out);
}
