/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/emit.h"

#include <string.h>

#include "emit/edit.h"
#include "emit/loop.h"
#include "ir/ir_position.h"

static const char byte_order_mark[] = "\xef\xbb\xbf";

/** Names that begin so are the generated text's own. */
static const char reserved_prefix[] = "redcc__";

/** The file's line ends are CR LF where those of its first line are. */
static bool has_crlf(const source *s) {
    const char *end = memchr(s->text, '\n', s->length);
    return end && end > s->text && end[-1] == '\r';
}

/** Each LF that has no CR gets one. */
static const char *with_crlf(arena *a, const char *text) {
    buffer out = {0};
    for (const char *c = text; *c; c++) {
        if (*c == '\n' && (c == text || c[-1] != '\r'))
            buffer_byte(&out, '\r');
        buffer_byte(&out, *c);
    }
    const char *result = arena_copy(a, out.data ? out.data : "", out.length);
    buffer_free(&out);
    return result;
}

static bool mentions(const source *s, const char *word) {
    const size_t length = strlen(word);
    const char *end = s->text + s->length, *at = s->text;
    for (; (size_t)(end - at) >= length && (at = memchr(at, word[0], (size_t)(end - at))); at++)
        if ((size_t)(end - at) >= length && memcmp(at, word, length) == 0)
            return true;
    return false;
}

/** May functions be compiled for processors that the file's head knows nothing of? */
static bool may_name_targets(const ir_unit *unit) {
    bool is_found = mentions(unit->source, "target");
    for (unsigned i = 0; i < unit->header_pragma_count; i++)
        is_found |= strstr(unit->header_pragmas[i], "target") != NULL;
    return is_found;
}

/** The head of the file. The serial and the parallel form of a loop give the same bits only where
 *  neither contracts a multiplication and an addition into one rounding; nor do inspector and
 *  executor. Free order without floating-point work in an inspector needs none of it. */
static const char *prelude(arena *a, const ir_unit *unit, bool may_contract) {
    const char *contraction =
        may_contract ? ""
                     : arena_format(a,
                                    "#if defined(__clang__)\n"
                                    "#pragma clang fp contract(off)\n"
                                    "#elif defined(%s)\n"
                                    "#pragma GCC optimize(\"fp-contract=off\")\n"
                                    "#endif\n",
                                    may_name_targets(unit) ? "__GNUC__" : "__FP_FAST_FMA");
    return arena_format(a,
                        "#ifdef _OPENMP\n"
                        "#include <redcc/runtime.h>\n"
                        "REDCC_REQUIRE_VERSION(1);\n"
                        "#endif\n"
                        "%s"
                        "#line 1 %s\n",
                        contraction, text_quoted(a, ir_position_of(unit, 0).file));
}

/** Why no loop of the file can be written; NULL: nothing forbids it. */
static const char *obstacle_of_file(arena *a, const ir_unit *unit) {
    if (mentions(unit->source, reserved_prefix))
        return "the file uses names that begin with redcc__, which are reserved for what redcc "
               "writes";
    const char *macro = macro_name_in_head(unit);
    if (macro)
        return arena_format(a,
                            "the macro '%s', defined before the file begins, would change the "
                            "runtime's header",
                            macro);
    const char *name = taken_name(unit);
    if (name)
        return arena_format(a, "the program uses the name '%s' for something of its own", name);
    return NULL;
}

/** Adds the edit for one loop; false, with *why set, where it cannot be written. */
static bool add_loop(arena *a, const ir_unit *unit, const loop_verdict *verdict,
                     const emit_options *options, const char *obstacle, edit_list *edits,
                     reason *why) {
    if (obstacle) {
        *why = (reason){.message = obstacle, .range = verdict->loop->range};
        return false;
    }
    ir_range replaced;
    const char *text = write_loop(a, unit, verdict->facts, options, &replaced, why);
    if (!text)
        return false;
    edit_replace(a, edits, replaced.begin, replaced.end,
                 has_crlf(unit->source) ? with_crlf(a, text) : text);
    return true;
}

static bool has_floating_slice(const analysis_result *analysis) {
    for (unsigned i = 0; i < analysis->verdict_count; i++)
        if (analysis->verdicts[i].kind == VERDICT_TRANSFORM &&
            analysis->verdicts[i].facts->slice_has_floating_work)
            return true;
    return false;
}

static void add_prelude(arena *a, const ir_unit *unit, bool may_contract, edit_list *edits) {
    const bool has_mark = strncmp(unit->source->text, byte_order_mark, 3) == 0;
    const char *text = prelude(a, unit, may_contract);
    edit_insert(a, edits, has_mark ? 3 : 0, has_crlf(unit->source) ? with_crlf(a, text) : text);
}

emit_result emit_file(arena *a, const ir_unit *unit, const analysis_result *analysis,
                      const emit_options *options) {
    const source *s = unit->source;
    reason *obstacles = ARENA_ARRAY(a, reason, analysis->verdict_count + 1);
    emit_result result = {.text = s->text, .length = s->length, .obstacles = obstacles};
    edit_list edits = {0};
    const char *obstacle = options->obstacle ? options->obstacle : obstacle_of_file(a, unit);
    for (unsigned i = 0; i < analysis->verdict_count; i++)
        if (analysis->verdicts[i].kind == VERDICT_TRANSFORM &&
            add_loop(a, unit, &analysis->verdicts[i], options, obstacle, &edits, &obstacles[i]))
            result.loop_count++;
    if (result.loop_count == 0)
        return result;
    const bool may_contract = options->order == EMIT_ORDER_ANY && !has_floating_slice(analysis);
    add_prelude(a, unit, may_contract, &edits);
    buffer out = {0};
    if (edit_apply(&out, s->text, 0, s->length, &edits)) {
        result.text = arena_copy(a, out.data, out.length);
        result.length = out.length;
    } else {
        result = (emit_result){.obstacles = obstacles};
    }
    buffer_free(&out);
    return result;
}
