/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the loop's description for the runtime: static objects, and the key of one execution. */
#include <assert.h>

#include "emit/base/names.h"
#include "emit/bins/bins.h"
#include "emit/call.h"
#include "emit/text/origin.h"
#include "ir/ir_position.h"
#include "ir/ir_syntax.h"
#include "plan/bins.h"
#include "plan/execution.h"
#include "plan/inner_iterations.h"
#include "plan/lookup.h"
#include "plan/sections.h"
#include "plan/tiles.h"
#include "plan/work.h"

/** The operator's name in the runtime. If the order of an array's updates is preserved, the runtime
 * makes no private copies and ignores the operator. */
static const char *operator_name(const reduction_array *array) {
    static const char *const names[] = {
#define X(NAME, SPELLING) [REDUCTION_##NAME] = "REDCC_" #NAME,
#include "analysis/base/operators.def"
#undef X
        [REDUCTION_NONE] = "REDCC_SUM"};
    assert(array->op <= REDUCTION_NONE && (array->order_is_kept || array->op != REDUCTION_NONE));
    return names[array->order_is_kept ? REDUCTION_NONE : array->op];
}

static const char *integer_name(const ir_type *type) {
    switch (type->size) {
    case 1:
        return type->is_signed ? "REDCC_INT8" : "REDCC_UINT8";
    case 2:
        return type->is_signed ? "REDCC_INT16" : "REDCC_UINT16";
    case 4:
        return type->is_signed ? "REDCC_INT32" : "REDCC_UINT32";
    case 8:
        return type->is_signed ? "REDCC_INT64" : "REDCC_UINT64";
    default:
        return "REDCC_OTHER_TYPE";
    }
}

static const char *element_name(const ir_type *type) {
    if (type->kind == IR_INTEGER)
        return integer_name(type);
    if (type->kind == IR_FLOATING)
        return type->size == 4   ? "REDCC_FLOAT"
               : type->size == 8 ? "REDCC_DOUBLE"
                                 : "REDCC_LONG_DOUBLE";
    if (type->kind == IR_COMPLEX)
        return type->size == 8    ? "REDCC_FLOAT_COMPLEX"
               : type->size == 16 ? "REDCC_DOUBLE_COMPLEX"
                                  : "REDCC_OTHER_TYPE";
    return "REDCC_OTHER_TYPE";
}

static const char *runtime_type(const loop_text *loop, const reduction_array *array) {
    return may_be_copied(loop->plan, array) ? element_name(array->element) : "REDCC_OTHER_TYPE";
}

/** The size of the array's rows as text, if possible as `sizeof(double[3])`. */
static const char *unit_text(loop_text *loop, unsigned number) {
    const reduction_array *array = &loop->facts->arrays[number];
    if (array->unit <= array->element->size)
        return arena_format(loop->arena, "sizeof(%s)", origin_type(loop->arena, array->element));
    for (unsigned i = 0; i < loop->facts->update_count; i++) {
        const reduction_update *update = &loop->facts->updates[i];
        if (update->array == number && update->row->type->size == array->unit &&
            update->row->type->spelling)
            return arena_format(loop->arena, "sizeof(%s)",
                                origin_type(loop->arena, update->row->type));
    }
    return arena_format(loop->arena, "%lld", (long long)array->unit);
}

/** The last initialiser of a redcc_array: the limit of a saturating counter; "" for other
 *  arrays. */
static const char *limit_text(loop_text *loop, const reduction_array *array) {
    return array->op == REDUCTION_SATURATING && !array->order_is_kept
               ? arena_format(loop->arena, ", %lluu", (unsigned long long)array->limit)
               : "";
}

static void write_arrays(loop_text *loop, writer *out) {
    writer_line(out, "static const redcc_array %s[] = {", outlined_name(loop, "arrays"));
    const unsigned count = loop->facts->array_count;
    for (unsigned i = 0; i < count; i++) {
        const reduction_array *array = &loop->facts->arrays[i];
        if (!array->element->spelling)
            loop_obstacle(loop, array->base->range, "the type of '%s' has no name", array->name);
        writer_line(out, "    {%s, %s, %s, sizeof(%s), %s%s},",
                    text_quoted(loop->arena, array->name), operator_name(array),
                    runtime_type(loop, array), origin_type(loop->arena, array->element),
                    unit_text(loop, i), limit_text(loop, array));
    }
    writer_line(out, "};");
}

static bool is_own_element(const logged_source *item) {
    return item->is_scalar && item->fact->extent == EXTENT_AFFINE;
}

/** Returns the flag with the number that identifies the base of an own element. Own elements of an
 * iteration that have the same base are disjoint, so the guard need not compare them. Returns ""
 * if the source is not an own element. */
static const char *base_text(loop_text *loop, unsigned number) {
    const logged_source *all = loop->plan->sources;
    for (unsigned i = 0; is_own_element(&all[number]) && i < loop->plan->source_count; i++)
        if (is_own_element(&all[i]) && syntax_same(all[i].fact->base, all[number].fact->base))
            return arena_format(loop->arena, " | REDCC_SCALAR_BASE(%u)", i + 1);
    return "";
}

static void write_sources(loop_text *loop, writer *out) {
    if (loop->plan->source_count == 0)
        return;
    writer_line(out, "static const redcc_source %s[] = {", outlined_name(loop, "sources"));
    for (unsigned i = 0; i < loop->plan->source_count; i++) {
        const logged_source *item = &loop->plan->sources[i];
        const bool meets_no_array = !item->is_subscript && !item->meets_arrays;
        const char *scalar = item->is_scalar        ? " | REDCC_IS_SCALAR"
                             : !item->meets_scalars ? ""
                             : meets_no_array
                                 ? " | REDCC_MAY_OVERLAP_SCALARS | REDCC_OVERLAPS_NO_ARRAY"
                                 : " | REDCC_MAY_OVERLAP_SCALARS";
        writer_line(out, "    {%s, %d%s%s},", text_quoted(loop->arena, item->fact->name),
                    item->is_subscript, scalar, base_text(loop, i));
    }
    writer_line(out, "};");
}

/* ---- the key ------------------------------------------------------------------------------- */

void fill_key(loop_text *loop, writer *out) {
    const loop_facts *facts = loop->facts;
    if (!loop->plan->execution.keeps_plan)
        return;
    unsigned number = 1 + facts->inspector.key_count;
    if (facts->counted.stride)
        writer_line(out, "redcc__key[%u] = (redcc_word)redcc__stride;", number++);
    for (unsigned i = 0; i < facts->variables.private_count; i++)
        if (facts->variables.privates[i].is_stepped && facts->variables.privates[i].is_in_slice) {
            writer_line(out, "redcc__key[%u] = redcc__from_%u;", number++, i);
            if (facts->variables.privates[i].stride_count)
                writer_line(out, "redcc__key[%u] = redcc__by_%u;", number++, i);
            if (facts->variables.privates[i].inner.loop)
                writer_line(out, "redcc__key[%u] = (redcc_word)redcc__inner_trips_%u;", number++,
                            i);
        }
    for (unsigned i = 0; i < facts->inspector.key_count; i++) {
        const ir_node *key = facts->inspector.key[i];
        const char *text = loop_operand(loop, key);
        switch (form_of_key(key->type)) {
        case KEY_INTEGER:
            writer_line(out, "REDCC_KEY(%u, %s);", i + 1, macro_argument(loop->arena, text));
            break;
        case KEY_POINTER:
            writer_line(out, "REDCC_KEY(%u, (redcc_size)%s);", i + 1, text);
            break;
        default: /* a floating value: its bits, not the value converted to an integer */
            writer_line(out, "{");
            writer_line(out, "%s%s redcc__value = %s;", key->type->is_const ? "" : "const ",
                        origin_type(loop->arena, key->type), text);
            writer_line(out, "redcc__key[%u] = 0;", i + 1);
            writer_line(out,
                        "__builtin_memcpy(&redcc__key[%u], &redcc__value, "
                        "sizeof redcc__value);",
                        i + 1);
            writer_line(out, "}");
            break;
        }
    }
}

static bool skips_inner_iterations(const loop_plan *plan) {
    for (unsigned i = 0; i < plan->skip_count; i++)
        if (!plan->skips[i].declined)
            return true;
    return false;
}

/** May the runtime execute the first iterations in order and time them? False for a loop with
 * tiles, because the runtime tries tiles without a sample. False with sections, or copies in a
 * fixed order, because these give the results of another order. */
static bool may_time_first_iterations(loop_text *loop) {
    return loop->plan->execution.may_begin && !loop->outline.tile_call && !is_reordered(loop->plan);
}

static const char *flags_text(loop_text *loop) {
    const bool prefetches = loop->plan->prefetch.ahead > 0;
    const bool is_fenced = loop->plan->execution.may_end_in_order;
    const struct {
        bool is_set;
        const char *name;
    } flags[] = {{loop->plan->execution.keeps_plan, "REDCC_VERIFIABLE"},
                 {loop->options->order_is_explicit, "REDCC_ORDER_EXPLICIT"},
                 {loop->plan->execution.needs_order, "REDCC_ORDER_NEEDED"},
                 {loop->plan->execution.needs_every_iteration, "REDCC_EVERY_ITERATION"},
                 {loop->plan->precheck != PRECHECK_NONE, "REDCC_DRY_RUN"},
                 {loop->plan->precheck == PRECHECK_OF_ALL, "REDCC_DRY_RUN_OF_READS"},
                 {loop->facts->slice.may_abort, "REDCC_MAY_ABORT"},
                 {loop->facts->inspector.exists, "REDCC_SELECTS"},
                 {is_fenced && !has_series(loop->facts), "REDCC_FENCED"},
                 {is_fenced && has_series(loop->facts), "REDCC_FENCED_SERIES"},
                 {loop->continues, "REDCC_CONTINUES"},
                 {!loop->facts->inspector.exists, "REDCC_NO_INSPECTOR"},
                 {loop->outline.tile_call, "REDCC_TILES"},
                 {loop->outline.tile_call && tiles_of(loop->plan)->is_below, "REDCC_TILES_BELOW"},
                 {skips_inner_iterations(loop->plan), "REDCC_PARTS"},
                 {loop->plan->execution.is_over_blocks, "REDCC_BLOCKS"},
                 {loop->bins != NULL, "REDCC_BINS_FLAG"},
                 {loop->bins && loop->bins->is_checked, "REDCC_BINS_CHECKED"},
                 {loop->plan->execution.needs_whole, "REDCC_WHOLE"},
                 {may_time_first_iterations(loop), "REDCC_BEGINS"},
                 {prefetches && !loop->plan->prefetch.is_light, "REDCC_PREFETCHES"},
                 {prefetches && loop->plan->prefetch.is_light, "REDCC_LIGHT"},
                 {loop->facts->has_short_iterations, "REDCC_SHORT"},
                 {is_reordered(loop->plan) && !loop->facts->has_short_iterations &&
                      loop->plan->execution.work >= WORK_LONG,
                  "REDCC_LONG"},
                 {loop->facts->variables.openmp != NULL, "REDCC_TEAM"},
                 {loop->plan->execution.sections != NULL, "REDCC_SECTIONED"},
                 {loop->lanes.name != NULL, "REDCC_LANES"}};
    const char *text = NULL;
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (flags[i].is_set)
            text = text ? arena_format(loop->arena, "%s | %s", text, flags[i].name) : flags[i].name;
    return text ? text : "0";
}

/** Writes the static object for the loop. It contains the file's name as __FILE__, which compiler
 * options can map, so that packages built in different folders are identical. */
static void write_loop_object(loop_text *loop, writer *out) {
    static const char *const orders[] = {"REDCC_ORDER_SERIAL", "REDCC_ORDER_FIXED",
                                         "REDCC_ORDER_ANY"};
    _Static_assert(sizeof orders / sizeof *orders == ORDER_ANY + 1, "all orders");
    const ir_position place = ir_position_of(loop->unit, loop->facts->loop->range.begin);
    writer_line(out, "static redcc_site %s = {", outlined_name(loop, "site"));
    out->depth++;
    writer_line(out, "{{__FILE__, %u, %s, %s,", place.line,
                text_quoted(loop->arena, loop->facts->function->name),
                orders[loop->plan->execution.order]);
    writer_line(out, "  %s,", flags_text(loop));
    writer_line(out, "  %u, %s,", loop->facts->array_count, outlined_name(loop, "arrays"));
    writer_line(out, "  %u, %s,", loop->plan->source_count,
                loop->plan->source_count > 0 ? outlined_name(loop, "sources") : "0");
    writer_line(out, "  %u, 0},", loop->plan->execution.key_count);
    writer_line(out, " %u, %d, %s},", loop->bins ? bins_stream_count(loop) : 0,
                loop->bins && loop->plan->execution.is_unordered,
                loop->bins ? outlined_name(loop, "streams") : "0");
    writer_line(out, "0");
    out->depth--;
    writer_line(out, "};");
}

void write_description(loop_text *loop, writer *out) {
    if (reads_by_system(loop))
        writer_line(out, "static redcc_word %s;", outlined_name(loop, "loaded"));
    write_arrays(loop, out);
    write_sources(loop, out);
    if (loop->bins)
        write_streams(loop, out);
    write_loop_object(loop, out);
}
