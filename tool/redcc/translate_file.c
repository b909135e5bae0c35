/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "redcc/translate_file.h"

#include <stdio.h>
#include <string.h>

#include "analysis/base/dead_branches.h"
#include "analysis/base/loop_loads.h"
#include "analysis/base/reason.h"
#include "analysis/expanded.h"
#include "frontend/frontend.h"
#include "ir/ir_position.h"
#include "ir/ir_text.h"
#include "redcc/compile_commands.h"
#include "redcc/compilers.h"
#include "redcc/explain.h"
#include "redcc/headers_in_place.h"
#include "redcc/imports.h"
#include "redcc/inputs_list.h"
#include "redcc/output.h"
#include "redcc/records.h"
#include "redcc/self_check.h"
#include "redcc/translated.h"
#include "redcc/verify.h"

static file_outcome fail(const char *path, const char *message) {
    if (path)
        fprintf(stderr, "redcc: error: %s: %s\n", path, message);
    else
        fprintf(stderr, "redcc: error: %s\n", message);
    return (file_outcome){.status = FILE_FAILED};
}

/* ---- parsing ------------------------------------------------------------------------------- */

static const char *parser_flags(arena *a, const options *o, const char *input, string_list *flags) {
    if (o->database_folder) {
        const char *wrong = compile_commands_flags(a, o->database_folder, input, flags);
        if (wrong)
            return wrong;
    }
    for (unsigned i = 0; i < o->flags.count; i++)
        VECTOR_PUSH(a, flags, o->flags.items[i]);
    return NULL;
}

frontend_result translate_file_parse(arena *a, const source *file, const string_list *flags) {
    return frontend_parse(a, file, flags->count, flags->items);
}

static bool has_errors(const frontend_result *parsed) {
    for (unsigned i = 0; i < parsed->diagnostic_count; i++)
        if (parsed->diagnostics[i].is_error)
            return true;
    return !parsed->unit || parsed->unit->error_count > 0;
}

static void show_errors(const frontend_result *parsed) {
    enum { MOST = 20 };
    unsigned errors = 0;
    for (unsigned i = 0; i < parsed->diagnostic_count; i++)
        if (parsed->diagnostics[i].is_error && errors++ < MOST)
            fprintf(stderr, "%s\n", parsed->diagnostics[i].text);
    if (errors > MOST)
        fprintf(stderr, "redcc: note: %u more errors are not shown\n", errors - MOST);
}

static bool is_binary(const source *file) {
    return memchr(file->text, 0, file->length) != NULL;
}

/** Reports a file that cannot be parsed. */
static file_outcome fail_to_parse(const source *file, const frontend_result *parsed) {
    if (is_binary(file))
        return fail(file->path, "is a binary file, not C source; nothing was written");
    show_errors(parsed);
    return fail(file->path, "cannot be parsed; nothing was written");
}

/* ---- pragmas ------------------------------------------------------------------------------- */

/** Reports invalid redcc pragmas in the file. Returns whether there are any. */
static bool show_pragma_errors(arena *a, const ir_unit *unit) {
    const user_pragmas pragmas = pragmas_of_unit(a, unit);
    for (unsigned i = 0; i < pragmas.problem_count; i++) {
        const ir_position at = ir_position_of(unit, pragmas.problems[i].offset);
        fprintf(stderr, "%s:%u:%u: error: %s\n", at.file, at.line, at.column,
                pragmas.problems[i].message);
    }
    return pragmas.problem_count > 0;
}

/* ---- verdicts ------------------------------------------------------------------------------ */

static analysis_options options_of(arena *a, const options *o, const external_functions *external) {
    return (analysis_options){.external = external ? external_known(a, external) : NULL,
                              .pure_count = o->pure.count,
                              .pure = o->pure.items,
                              .assume_noalias = o->assume_noalias,
                              .report_all = o->report.all,
                              .any_order = o->order.word == ORDER_ANY};
}

static unsigned long long unknown_pure(const options *o, const ir_unit *unit) {
    unsigned long long unknown = 0;
    for (unsigned i = 0; unit->text.names && i < o->pure.count && i < 64; i++)
        if (!map_get(unit->text.names, o->pure.items[i], strlen(o->pure.items[i])))
            unknown |= 1ULL << i;
    return unknown;
}

void translate_file_warn_pure(const options *o, unsigned long long unknown, const char *where) {
    for (unsigned i = 0; i < o->pure.count && i < 64; i++)
        if (unknown >> i & 1)
            fprintf(stderr,
                    "redcc: warning: --pure=%s: no function of this name is declared in %s\n",
                    o->pure.items[i], where);
}

/** Refuses all loops of the file if the build's compiler may see another program than clang's
 * parser, which redcc uses. */
static analysis_result of_both_compilers(arena *a, const source *file, const string_list *flags,
                                         const ir_unit *unit, bool knows_compiler,
                                         analysis_result analysed) {
    bool has_transformed = false;
    for (unsigned i = 0; i < analysed.verdict_count; i++)
        has_transformed |= verdict_is_written(&analysed.verdicts[i]);
    const char *word = unit->text.unseen_word;
    if (!word && has_transformed && !knows_compiler && !compilers_agree(a, file, flags, unit))
        word = unit->text.compiler_word;
    if (!word || !has_transformed)
        return analysed;
    loop_verdict *verdicts = ARENA_ARRAY(a, loop_verdict, analysed.verdict_count);
    for (unsigned i = 0; i < analysed.verdict_count; i++) {
        verdicts[i] = analysed.verdicts[i];
        if (!verdict_is_written(&verdicts[i]))
            continue;
        verdicts[i].kind = VERDICT_REFUSE;
        verdicts[i].why = reason_make(a, REASON_COMPILER, word, verdicts[i].loop->range);
    }
    return (analysis_result){analysed.verdict_count, verdicts};
}

/** The verdicts after writing, in which loops that could not be written are refused. */
static analysis_result after_writing(arena *a, const ir_unit *unit, const analysis_result *analysis,
                                     const emit_result *written, const analysis_options *how,
                                     const external_functions *external) {
    loop_verdict *verdicts = ARENA_ARRAY(a, loop_verdict, analysis->verdict_count + 1);
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        verdicts[i] = analysis->verdicts[i];
        const reason *obstacle = &written->obstacles[i];
        if (!obstacle->message)
            continue;
        verdicts[i].kind = VERDICT_REFUSE;
        if (obstacle->id != REASON_NONE) {
            verdicts[i].why = reason_make(a, obstacle->id, verdicts[i].facts->arrays[0].name,
                                          verdicts[i].loop->range);
            verdicts[i].why.message = arena_format(a, "%s, and they cannot be computed once: %s",
                                                   verdicts[i].why.message, obstacle->message);
            continue;
        }
        verdicts[i].why = *obstacle;
        verdicts[i].why.id = REASON_TEXT;
        verdicts[i].why.message =
            arena_format(a, "its parallel form cannot be written: %s", obstacle->message);
    }
    if (external)
        external_note(a, external, how, unit, analysis, verdicts);
    return (analysis_result){analysis->verdict_count, verdicts};
}

/** The result for each loop if lanes were requested; else NULL. */
static const lanes_remark *lanes_remarks(arena *a, const emit_result *written, unsigned count) {
    if (!written->lanes)
        return NULL;
    lanes_remark *remarks = ARENA_ARRAY(a, lanes_remark, count + 1);
    for (unsigned i = 0; i < count; i++) {
        const lanes_outcome *outcome = &written->lanes[i];
        remarks[i] = (lanes_remark){outcome->why != LANES_NOT_ASKED, lane_reason_slug(outcome->why),
                                    lane_reason_message(outcome->why), outcome->range};
    }
    return remarks;
}

static report_input report_on(const options *o, const ir_unit *unit,
                              const analysis_result *analysis, const lanes_remark *lanes,
                              const char *const *in_order) {
    return (report_input){.unit = unit,
                          .analysis = analysis,
                          .lanes = lanes,
                          .in_order = in_order,
                          .version = REDCC_VERSION,
                          .order = options_order_word(o->order.word),
                          .all = o->report.all,
                          .explain = explain_section,
                          .link = explain_link};
}

static const char *show_report(arena *a, const options *o, const report_input *input) {
    buffer text = {0};
    const char *wrong = NULL;
    report_write(a, &text, o->report.form, input);
    const char *data = text.data ? text.data : "";
    if (o->report.file)
        wrong = output_write(a, o->report.file, data, text.length);
    else if (o->report.form == REPORT_TEXT)
        fwrite(data, 1, text.length, stderr);
    else
        wrong = output_write(a, "-", data, text.length);
    buffer_free(&text);
    return wrong;
}

/** Counts the verdicts for the summary of many files. */
static file_outcome count_verdicts(const analysis_result *analysis) {
    file_outcome counts = {0};
    for (unsigned i = 0; i < analysis->verdict_count; i++) {
        counts.transformed += verdict_is_written(&analysis->verdicts[i]);
        counts.by_declarations += analysis->verdicts[i].external_call_count > 0;
    }
    return counts;
}

/* ---- one file ------------------------------------------------------------------------------ */

static void dump(const ir_unit *unit) {
    buffer text = {0};
    ir_print(&text, unit);
    fwrite(text.data ? text.data : "", 1, text.length, stdout);
    buffer_free(&text);
}

/** Refuses the loops whose text is wrong. A loop with lanes is not refused yet, but written again
 *  without them. */
static analysis_result without_wrong(arena *a, const analysis_result *analysed,
                                     const emit_result *written, const reason *found,
                                     unsigned char *no_lanes) {
    loop_verdict *verdicts = ARENA_ARRAY(a, loop_verdict, analysed->verdict_count + 1);
    for (unsigned i = 0; i < analysed->verdict_count; i++)
        verdicts[i] = analysed->verdicts[i];
    for (unsigned i = 0; i < written->loop_count; i++) {
        loop_verdict *verdict = &verdicts[written->loops[i].verdict];
        if (found[i].id == REASON_NONE)
            continue;
        if (written->loops[i].has_lanes) {
            no_lanes[written->loops[i].verdict]++;
            continue;
        }
        verdict->kind = VERDICT_REFUSE;
        verdict->why = found[i];
        verdict->why.range = verdict->loop->range;
    }
    return (analysis_result){analysed->verdict_count, verdicts};
}

/**
 * Writes the analysed file, and checks it. If the text of a loop is wrong, writes the file again,
 * with that loop without lanes or, if it had none, unchanged. If only a report is wanted, the file
 * is not checked, because parsing the output costs as much as parsing the input.
 */
static emit_result write_checked(arena *a, const ir_unit *unit, const string_list *flags,
                                 const plan_options *how, bool is_kept, analysis_result *analysed) {
    unsigned char *no_lanes = ARENA_ARRAY(a, unsigned char, analysed->verdict_count + 1);
    plan_options own = *how;
    own.no_lanes = no_lanes;
    for (;;) {
        const emit_result written = emit_file(a, unit, analysed, &own);
        reason *found = ARENA_ARRAY(a, reason, written.loop_count + 1);
        if (written.loop_count == 0 || !is_kept || self_check(a, unit, flags, &written, found))
            return written;
        *analysed = without_wrong(a, analysed, &written, found, no_lanes);
    }
}

/** Analyses the file. If a loop calls functions of other files, adds these and analyses again. */
static analysis_result analyse_with_imports(arena *a, ir_unit *unit, const string_list *flags,
                                            const project *around, const analysis_options *asked) {
    loop_loads_name(unit);
    dead_branches_take_out(unit);
    const analysis_result alone = analyse_expanding(a, unit, asked);
    if (!around || !imports_add(a, unit, around, flags, &alone))
        return alone;
    dead_branches_take_out(unit);
    return analyse_expanding(a, unit, asked);
}

/** The text followed by the records of the file's own functions. */
static emit_result with_records(arena *a, const emit_result *written, const char *records) {
    emit_result result = *written;
    if (!records)
        return result;
    const size_t more = strlen(records);
    char *text = arena_allocate(a, written->length + more + 1);
    memcpy(text, written->text, written->length);
    memcpy(text + written->length, records, more + 1);
    result.text = text;
    result.length = written->length + more;
    return result;
}

/** A unit and the analysis of its loops: of the file itself, or of the file with
 *  headers in place. */
typedef struct analysed_file {
    ir_unit *unit;
    const char *records; /* NULL: none */
    analysis_result analysed;
    header_uses headers; /* headers whose text replaces their #include directives */
} analysed_file;

/** The inputs of a file's analysis. */
typedef struct analysing {
    arena *memory;
    const options *options;
    const string_list *flags;
    analysis_options asked;
    const project *around; /* NULL: unknown */
} analysing;

static analysed_file analyse_unit(const analysing *by, ir_unit *unit) {
    const options *o = by->options;
    unit->dialect.replaces_openmp = unit->dialect.has_openmp && !o->keeps_openmp;
    analysed_file result = {.unit = unit};
    if (by->around && o->output)
        result.records = records_write(by->memory, unit, by->around);
    result.analysed = of_both_compilers(
        by->memory, unit->source, by->flags, unit, o->compiler != COMPILER_ANY,
        analyse_with_imports(by->memory, unit, by->flags, by->around, &by->asked));
    return result;
}

static header_uses used_headers(arena *a, const analysed_file *file, const reason *obstacles) {
    header_uses used = {0};
    for (unsigned i = 0; i < file->headers.count; i++)
        if (header_is_used(file->unit, &file->analysed, obstacles, file->headers.items[i].name))
            VECTOR_PUSH(a, &used, file->headers.items[i]);
    return used;
}

/** May headers be put in place? The output then contains their text, and does not follow changes of
 * the headers. So this is done only for a report, or for redcc-cc, which translates again when a
 * header changes. */
static bool may_have_headers(const options *o) {
    return !o->output || o->compiler != COMPILER_ANY;
}

/** Returns the file with the text of some headers in place of their #include directives. These are
 * the headers with a loop that can run in parallel. If there are none, returns the file itself. */
static analysed_file with_headers(const analysing *by, analysed_file *file) {
    arena *a = by->memory;
    header_uses headers = headers_that_fit(a, file->unit, &file->analysed);
    const bool as_clang = by->options->compiler == COMPILER_CLANG;
    analysed_file first = {0};
    while (headers.count > 0) {
        const frontend_result parsed =
            translate_file_parse(a, headers_in_place(a, file->unit, &headers, as_clang), by->flags);
        if (has_errors(&parsed))
            return *file;
        analysed_file found = analyse_unit(by, parsed.unit);
        found.headers = headers;
        if (!first.unit) { /* here all such headers are in place: reasons come from this analysis */
            first = found;
            file->analysed =
                with_reasons_in_place(a, file->unit, &file->analysed, first.unit, &first.analysed);
        }
        headers = used_headers(a, &found, NULL);
        found.analysed =
            with_reasons_in_place(a, found.unit, &found.analysed, first.unit, &first.analysed);
        if (headers.count == found.headers.count)
            return found;
    }
    return *file;
}

static emit_result write_analysed(const analysing *by, analysed_file *file, plan_options *how) {
    arena *a = by->memory;
    const options *o = by->options;
    how->linked = imports_check(a, file->unit, &file->analysed, &how->obstacle);
    const emit_result loops =
        write_checked(a, file->unit, by->flags, how, o->output || o->verify, &file->analysed);
    return with_records(a, &loops, file->records);
}

static file_outcome translate(arena *a, const options *o, const source *file,
                              const string_list *flags, ir_unit *unit,
                              const external_functions *external) {
    const analysing by = {.memory = a,
                          .options = o,
                          .flags = flags,
                          .asked = options_of(a, o, external),
                          .around = o->sees_project ? project_around(a, file->path) : NULL};
    analysed_file alone = analyse_unit(&by, unit);
    analysed_file in = may_have_headers(o) ? with_headers(&by, &alone) : alone;
    const bool is_kept = o->output || o->verify;
    const bool is_written = count_verdicts(&in.analysed).transformed > 0;
    if (is_kept && is_written && !own_runtime_header_exists(a))
        return fail(file->path,
                    "redcc's own header redcc/runtime.h, without which the output cannot "
                    "be checked, is neither next to this program (PREFIX/bin/redcc and "
                    "PREFIX/include) nor below $REDCC_ROOT; nothing was written");
    plan_options how = {.order = o->order.word,
                        .order_is_explicit = o->order.is_given,
                        .lanes = o->lanes,
                        .obstacle = is_written ? other_runtime_header(a, flags) : NULL};
    const char *obstacle = how.obstacle;
    emit_result written = write_analysed(&by, &in, &how);
    if (used_headers(a, &in, written.obstacles).count < in.headers.count) {
        in = alone;
        how.obstacle = obstacle;
        written = write_analysed(&by, &in, &how);
    }
    const analysis_result final =
        after_writing(a, in.unit, &in.analysed, &written, &by.asked, external);
    const report_input input = report_on(
        o, in.unit, &final, lanes_remarks(a, &written, final.verdict_count), written.in_order);
    const char *wrong = show_report(a, o, &input);
    if (!wrong && o->verify) {
        wrong = verify_output(a, file, flags, written.text, written.length);
        if (!wrong)
            fprintf(stderr, "redcc: verified: %s prints the same in both forms\n", file->path);
    }
    if (!wrong && o->output)
        wrong = output_write(a, o->output, written.text, written.length);
    if (wrong)
        return fail(NULL, wrong);
    return count_verdicts(&final);
}

static file_outcome leave_translated(arena *a, const options *o, const source *file) {
    fprintf(stderr, "%s: note: already translated by redcc: left as it is\n", file->path);
    const ir_unit unit = {.arena = a, .source = file};
    const analysis_result nothing = {0};
    const report_input input = report_on(o, &unit, &nothing, NULL, NULL);
    const char *wrong = show_report(a, o, &input);
    if (!wrong && o->output)
        wrong = output_write(a, o->output, file->text, file->length);
    return wrong ? fail(NULL, wrong) : (file_outcome){0};
}

/** Reads the input. Standard input is named as compilers name it, "<stdin>". */
static const source *read_input(arena *a, const char *path, const char **wrong) {
    const source *file = source_read(a, path, wrong);
    if (!file || strcmp(path, "-") != 0)
        return file;
    return source_from_text(a, "<stdin>", file->text, file->length);
}

file_outcome translate_file(arena *a, const options *o, const char *path,
                            const external_functions *external) {
    const char *wrong = NULL;
    const source *file = read_input(a, path, &wrong);
    if (!file)
        return fail(NULL, wrong);
    if (!is_binary(file) && is_translated(file))
        return leave_translated(a, o, file);
    string_list flags = {0};
    wrong = parser_flags(a, o, path, &flags);
    if (wrong)
        return fail(NULL, wrong);
    const frontend_result parsed = translate_file_parse(a, file, &flags);
    wrong = o->report.inputs_file ? inputs_list_write(a, o->report.inputs_file, &parsed) : NULL;
    if (wrong)
        return fail(NULL, wrong);
    if (has_errors(&parsed))
        return fail_to_parse(file, &parsed);
    if (o->dump_ir)
        dump(parsed.unit);
    if (!o->analyze && !o->output && !o->verify)
        return (file_outcome){0};
    if (show_pragma_errors(a, parsed.unit))
        return (file_outcome){.status = FILE_WRONG_PRAGMA};
    file_outcome outcome = translate(a, o, file, &flags, parsed.unit, external);
    outcome.unknown_pure = unknown_pure(o, parsed.unit);
    return outcome;
}

void translate_file_exports(arena *a, const options *o, const char *path, buffer *out) {
    const char *wrong = NULL;
    const source *file = read_input(a, path, &wrong);
    string_list flags = {0};
    if (!file || parser_flags(a, o, path, &flags))
        return;
    const frontend_result parsed = translate_file_parse(a, file, &flags);
    if (has_errors(&parsed))
        return;
    const analysis_options own = options_of(a, o, NULL);
    const exported_functions functions = exported_of_unit(a, parsed.unit, &own);
    external_write(out, &functions);
}
