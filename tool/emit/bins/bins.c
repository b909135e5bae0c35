/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes a loop's form for in-order binning (plan/bins.h explains records, streams, nests and
 * spans), with the macros of redcc/bins.h. */
#include "emit/bins/bins.h"

#include <assert.h>
#include <string.h>

#include "emit/base/names.h"
#include "emit/base/own.h"
#include "emit/bins/spans.h"
#include "emit/text/origin.h"
#include "emit/text/print.h"
#include "ir/ir_syntax.h"
#include "plan/execution.h"

const char *bins_kind_text(value_kind kind) {
    static const char *const names[] = {
        [VALUE_INT] = "int",        [VALUE_UNSIGNED] = "redcc_u32",
        [VALUE_LONG] = "redcc_int", [VALUE_UNSIGNED_LONG] = "redcc_word",
        [VALUE_FLOAT] = "float",    [VALUE_DOUBLE] = "double"};
    return names[kind];
}

static bool is_floating(value_kind kind) {
    return kind == VALUE_FLOAT || kind == VALUE_DOUBLE;
}

static const char *row_type(loop_text *loop, unsigned array) {
    const ir_type *element = loop->facts->arrays[array].element;
    const char *type = origin_type(loop->arena, element);
    return is_wide_row(loop->facts, loop->bins, array)
               ? arena_format(loop->arena, "__typeof__(%s[%lld])", type,
                              (long long)(loop->bins->row_bytes[array] / element->size))
               : type;
}

/** Does redcc/bins.h declare the record's type? It does if all values are doubles or all are
 * floats. */
static bool is_plain_record(const bins_stream *stream) {
    for (unsigned i = 1; i < stream_value_count(stream); i++)
        if (stream->kinds[i] != stream->kinds[0])
            return false;
    return is_floating(stream->kinds[0]);
}

const char *bins_record_name(loop_text *loop, unsigned stream) {
    const bins_stream *its = &loop->bins->streams[stream];
    const unsigned count = stream_value_count(its);
    if (span_of_stream(loop->bins, stream))
        return arena_format(loop->arena, "%s_%u", outlined_name(loop, "record"), stream);
    if (count < 2)
        return bins_kind_text(its->kinds[0]);
    return is_plain_record(its)
               ? arena_format(loop->arena, "redcc_%s_%u", bins_kind_text(its->kinds[0]), count)
               : arena_format(loop->arena, "%s_%u", outlined_name(loop, "record"), stream);
}

typedef struct spelling {
    const loop_text *loop;
    const bins_record *record;
    const reduction_update *update;
    unsigned part; /* the element's index in the nest */
} spelling;

/** The element of the current update, as the apply function names it. */
static const char *element_in_row(const spelling *its) {
    static const char *const rows[] = {"(*redcc__to)", "(*redcc__to_1)", "(*redcc__to_2)",
                                       "(*redcc__to_3)"};
    const bins_stream *stream = &its->loop->bins->streams[its->record->stream];
    unsigned array = 0;
    while (stream->arrays[array] != its->update->array)
        array++;
    return is_wide_row(its->loop->facts, its->loop->bins, its->update->array)
               ? arena_format(
                     its->loop->arena, "%s[%u]", rows[array],
                     part_of_row(its->loop->facts, its->loop->bins, its->update, its->part))
               : rows[array];
}

/** A printer hook for apply functions: spells the updated element and the record's values. */
static const char *name_in_record(const ir_node *node, void *context) {
    const spelling *its = context;
    if (!ir_is_expression(node))
        return NULL;
    if (is_updated_element(node, its->update->target))
        return element_in_row(its);
    const int number = operand_number(its->record, node);
    if (number < 0)
        return NULL;
    if (stream_value_count(&its->loop->bins->streams[its->record->stream]) == 1)
        return "redcc__e";
    const unsigned parts = nest_part_count(its->record->nest);
    return arena_format(its->loop->arena, "redcc__e.v%u", (unsigned)number * parts + its->part);
}

/** The statements that apply a record: its updates, with the record's values as operands. */
static const char *record_text(loop_text *loop, const bins_record *record) {
    const unsigned tag_count = loop->bins->streams[record->stream].tag_count;
    writer line = {.depth = 1 + (tag_count > 1)};
    spelling its = {.loop = loop, .record = record};
    printer p = {.arena = loop->arena, .out = &line, .rename = name_in_record, .context = &its};
    for (unsigned i = 0; i < record->update_count; i++) {
        its.update = record->updates[i];
        for (its.part = 0; its.part < nest_part_count(record->nest); its.part++)
            print_statement(&p, its.update->statement);
    }
    if (p.problem)
        loop_obstacle(loop, record->updates[0]->statement->range, "%s", p.problem);
    return writer_text(loop->arena, &line);
}

/* ---- positions ------------------------------------------------------------------------------ */

/** The position of the update's element in its row, as a C expression. */
static const char *part_of_row_text(const loop_text *loop, const reduction_update *update) {
    const loop_facts *facts = loop->facts;
    const bins_nest *nest = nest_of(facts, loop->bins, update);
    const int64_t size = facts->arrays[update->array].element->size;
    int64_t offset;
    const ir_node *row = row_in_bins(facts, loop->bins, update, &offset);
    const char *text =
        offset > 0 || !nest ? arena_format(loop->arena, "%lld", (long long)(offset / size)) : NULL;
    for (const ir_node *node = update->target; nest && node != row; node = node->children[0]) {
        if (node->kind != IR_INDEX || !nest_level_of(nest, node->children[1]))
            continue;
        const int64_t stride = node->type->size / size;
        const char *term = text_operand(loop->arena, node->children[1], NULL, NULL);
        if (value_kind_of(node->children[1]->type) != VALUE_INT)
            term = arena_format(loop->arena, "(int)%s", term);
        if (stride > 1)
            term = arena_format(loop->arena, "%lld * %s", (long long)stride, term);
        text = text ? arena_format(loop->arena, "%s + %s", term, text) : term;
    }
    return text;
}

/** Returns the value of a nest's counter in iteration `part`, as text of the counter's promoted
 * type. Returns NULL if the node is no such counter. */
static const char *nest_counter_text(const loop_text *loop, const bins_nest *nest,
                                     const ir_node *node, unsigned part) {
    const struct nest_level *level = nest_level_of(nest, node);
    if (!level)
        return NULL;
    const value_kind kind = value_kind_of(level->counter->type);
    const long long value = nest_counter_value(nest, level, part);
    return kind == VALUE_INT ? arena_format(loop->arena, "%lld", value)
                             : arena_format(loop->arena, "((%s)%lld)", bins_kind_text(kind), value);
}

/* ---- in the body ---------------------------------------------------------------------------- */

/** Context for spelling an operand in a nest, with the nest's counters replaced by their values at
 * element `part`. */
typedef struct nest_names {
    loop_text *loop;
    const bins_nest *nest;
    unsigned part;
    ir_c_rename others;
} nest_names;

static const char *name_in_part(const ir_node *node, void *context) {
    const nest_names *its = context;
    const char *counter = nest_counter_text(its->loop, its->nest, node, its->part);
    return counter ? counter : its->others(node, its->loop);
}

static const char *value_text(loop_text *loop, const bins_record *record, unsigned value,
                              value_kind kind, ir_c_rename name) {
    arena *a = loop->arena;
    const unsigned parts = nest_part_count(record->nest);
    if (value >= record->operand_count * parts)
        return "0"; /* only other records of the stream use this value */
    const ir_node *operand = record->operands[value / parts];
    nest_names names = {.loop = loop, .nest = record->nest, .part = value % parts, .others = name};
    const char *text = is_floating(kind) ? text_expression(a, operand, name_in_part, &names)
                                         : text_operand(a, operand, name_in_part, &names);
    if (!text) {
        loop_obstacle(loop, operand->range, "an operand cannot be spelled a second time");
        return "0";
    }
    return macro_argument(
        a, is_floating(kind) ? text : arena_format(a, "(%s)%s", bins_kind_text(kind), text));
}

/** The values of the record as one argument of a macro such as REDCC_UPDATE_BY, which appends the
 * record. */
static const char *values_text(loop_text *loop, const bins_record *record, ir_c_rename name) {
    const bins_stream *stream = &loop->bins->streams[record->stream];
    const unsigned count = stream_value_count(stream);
    buffer out = {0};
    if (count > 1)
        buffer_format(&out, "REDCC_VALUES_%u(", count);
    for (unsigned i = 0; i < count; i++)
        buffer_format(&out, "%s%s", i > 0 ? ", " : "",
                      value_text(loop, record, i, stream->kinds[i], name));
    if (count > 1)
        buffer_byte(&out, ')');
    return buffer_take(loop->arena, &out);
}

static const bins_record *record_of(const bins_plan *bins, const reduction_update *update) {
    for (const bins_record *record = bins->records;; record++)
        for (unsigned i = 0; i < record->update_count; i++)
            if (record->updates[i] == update)
                return record;
}

/** Returns the macro's arguments for an element of a scattered array, which has no base. They are
 * the address of the pointer to the element's row (0 if there is no such pointer), and the
 * element's address. The macro checks the pointer's address, because the pointer may be an
 * unverified value. */
static const char *place_behind(loop_text *loop, const reduction_update *update,
                                const char *address, ir_c_rename name) {
    const ir_node *load = row_load_of(loop->facts, update);
    const char *text = load ? text_operand(loop->arena, load, name, loop) : NULL;
    const char *pointer =
        text ? macro_argument(loop->arena, arena_format(loop->arena, "&%s", text)) : "0";
    if (load && !text)
        loop_obstacle(loop, load->range, "a pointer to a row cannot be spelled");
    return arena_format(loop->arena, "%s, %s", pointer, address);
}

/** Returns the macro's arguments for the updated element. With wide rows (is_wide_row) they also
 *  give the type of the row and the element's position in it. */
static const char *place_text(loop_text *loop, const reduction_update *update, const char *address,
                              ir_c_rename name) {
    const char *base = loop->arrays[update->array].local;
    if (loop->facts->arrays[update->array].is_scattered)
        return place_behind(loop, update, address, name);
    if (!is_wide_row(loop->facts, loop->bins, update->array))
        return arena_format(loop->arena, "%s, %s", base, address);
    return arena_format(loop->arena, "%s, %s, %s, %s", base, address, row_type(loop, update->array),
                        part_of_row_text(loop, update));
}

const char *bins_update(loop_text *loop, const reduction_update *update, const char *address,
                        ir_c_rename name) {
    assert(loop->bins && update->array < loop->facts->array_count);
    const bins_record *record = record_of(loop->bins, update);
    const bins_stream *stream = &loop->bins->streams[record->stream];
    const char *macro = loop->facts->arrays[update->array].is_scattered       ? "UPDATE_BEHIND"
                        : is_wide_row(loop->facts, loop->bins, update->array) ? "UPDATE_ROW"
                                                                              : "UPDATE";
    if (record->span)
        return arena_format(loop->arena, "REDCC_UPDATE(%u, %s)", update->array, address);
    const char *place = place_text(loop, update, address, name);
    if (record->updates[0] != update || record->nest)
        return arena_format(loop->arena, "REDCC_%s_WITH(%u, %s)", macro, update->array, place);
    if (stream_value_count(stream) == 0)
        return arena_format(loop->arena, "REDCC_%s_ALIKE(%u, %u, %u, %s)", macro, update->array,
                            record->stream, record->tag, place);
    return arena_format(loop->arena, "REDCC_%s_BY(%u, %u, %u, %s, %s, %s)", macro, update->array,
                        record->stream, record->tag, place, bins_record_name(loop, record->stream),
                        values_text(loop, record, name));
}

/** The text that appends the record of an update in a nest. */
static const char *append_text(loop_text *loop, const bins_record *record, ir_c_rename name) {
    const reduction_update *update = record->updates[0];
    const bool has_values = stream_value_count(&loop->bins->streams[record->stream]) > 0;
    nest_names names = {.loop = loop, .nest = record->nest, .others = name};
    const char *target = text_operand(loop->arena, update->target, name_in_part, &names);
    if (!target)
        loop_obstacle(loop, update->target->range, "an updated element cannot be spelled");
    const char *address =
        macro_argument(loop->arena, arena_format(loop->arena, "&%s", target ? target : "0"));
    const char *place = arena_format(loop->arena, "%u, %u, %u, %s, %s, %s, %u", update->array,
                                     record->stream, record->tag, loop->arrays[update->array].local,
                                     address, row_type(loop, update->array),
                                     part_of_row(loop->facts, loop->bins, update, 0));
    return has_values ? arena_format(loop->arena, "REDCC_APPEND_ROW_BY(%s, %s, %s)", place,
                                     bins_record_name(loop, record->stream),
                                     values_text(loop, record, name))
                      : arena_format(loop->arena, "REDCC_APPEND_ROW_ALIKE(%s)", place);
}

/* ---- before a statement ---------------------------------------------------------------------- */

bool bins_have_spans(const loop_text *loop) {
    for (unsigned i = 0; loop->bins && i < loop->bins->record_count; i++)
        if (loop->bins->records[i].span)
            return true;
    return false;
}

const char *bins_appends(loop_text *loop, const ir_node *statement, ir_c_rename name) {
    const char *text = NULL;
    for (unsigned i = 0; loop->bins && i < loop->bins->record_count; i++) {
        const bins_record *record = &loop->bins->records[i];
        if (record->span && record->span->loop == statement)
            return push_span_text(loop, record, name);
        if (record->nest && record->nest->outermost == statement)
            text = arena_format(loop->arena, "%s%s ", text ? text : "",
                                append_text(loop, record, name));
    }
    return text;
}

/* ---- before the function --------------------------------------------------------------------- */

static unsigned tag_bits(const bins_stream *stream) {
    unsigned bits = 0;
    while (1u << bits < stream->tag_count)
        bits++;
    return bits;
}

/** Returns the part of an apply function that makes the updates. It declares the elements of the
 * stream's arrays after the first. Then it makes the updates that the record's tag selects. */
static const char *updates_text(loop_text *loop, unsigned stream) {
    const bins_plan *bins = loop->bins;
    const bins_stream *its = &bins->streams[stream];
    buffer out = {0};
    for (unsigned part = 1; part < its->array_count; part++)
        buffer_format(&out, "\n    REDCC_APPLY_ALSO(%u, %s, %u)", part,
                      row_type(loop, its->arrays[part]), tag_bits(its));
    unsigned tag = 0;
    for (unsigned i = 0; i < bins->record_count; i++) {
        const bins_record *record = &bins->records[i];
        if (record->stream != stream || record->tag != tag)
            continue;
        const char *text = record_text(loop, record);
        tag++;
        if (tag < its->tag_count)
            buffer_format(&out, "%sif (redcc__tag == %u) {\n%s    } else ", tag > 1 ? "" : "\n    ",
                          record->tag, text);
        else
            buffer_format(&out, tag > 1 ? "{\n%s    }" : "\n%s", text);
    }
    return buffer_take(loop->arena, &out);
}

static void write_record(loop_text *loop, writer *out, unsigned stream) {
    const bins_stream *its = &loop->bins->streams[stream];
    const unsigned count = stream_value_count(its);
    if (count < 2 || is_plain_record(its))
        return;
    buffer members = {0};
    for (unsigned i = 0; i < count; i++)
        buffer_format(&members, "%s v%u; ", bins_kind_text(its->kinds[i]), i);
    writer_line(out, "typedef struct { %s} %s;", members.data, bins_record_name(loop, stream));
    buffer_free(&members);
}

/** Can a record stand for several updates of a float, each of which rounds to float? */
static bool rounds_in_between(const loop_text *loop, const bins_stream *stream) {
    bool has_floats = false;
    for (unsigned i = 0; i < stream->array_count; i++) {
        const ir_type *element = loop->facts->arrays[stream->arrays[i]].element;
        has_floats |= element->kind == IR_FLOATING && element->size == (int64_t)sizeof(float);
    }
    return has_floats && stream_value_count(stream) > 1;
}

void write_bins(loop_text *loop, writer *out) {
    const bins_plan *bins = loop->bins;
    assert(bins && bins->stream_count > 0);
    for (unsigned i = 0; i < bins->record_count; i++)
        if (bins->records[i].span) {
            write_span_record(loop, &bins->records[i], out);
            write_apply_span(loop, &bins->records[i], out);
        }
    for (unsigned i = 0; i < bins->stream_count; i++) {
        if (span_of_stream(bins, i))
            continue;
        const bins_stream *its = &bins->streams[i];
        const char *row = row_type(loop, its->arrays[0]);
        write_record(loop, out, i);
        if (stream_value_count(its) == 0)
            writer_line(out, "REDCC_APPLY_ALIKE(%s_%u, %s, %u,%s)", outlined_name(loop, "apply"), i,
                        row, tag_bits(its), updates_text(loop, i));
        else
            writer_line(out, "%sREDCC_APPLY(%s_%u, %s, %s, %u,%s)",
                        rounds_in_between(loop, its) ? "REDCC_ROUNDED " : "",
                        outlined_name(loop, "apply"), i, row, bins_record_name(loop, i),
                        tag_bits(its), updates_text(loop, i));
    }
}

/* ---- the loop's description ------------------------------------------------------------------ */

/** Are the stream's updates exact in any order, so that they may be made on private copies? */
static bool is_exact(const loop_text *loop, const bins_stream *stream) {
    for (unsigned part = 0; part < stream->array_count; part++) {
        const reduction_array *array = &loop->facts->arrays[stream->arrays[part]];
        if (!may_be_copied(loop->plan, array) || array->element->kind != IR_INTEGER)
            return false;
    }
    for (unsigned i = 0; i < stream_value_count(stream); i++)
        assert(!is_floating(stream->kinds[i])); /* may_be_copied: the order does not matter, so no
                                                 * operand is floating */
    return true;
}

/** The initialiser of a stream's description: a macro call or, with several arrays, a list. */
static const char *stream_text(loop_text *loop, unsigned stream) {
    const bins_stream *its = &loop->bins->streams[stream];
    const char *apply = arena_format(loop->arena, "%s_%u", outlined_name(loop, "apply"), stream);
    const char *record = bins_record_name(loop, stream);
    const char *rest = arena_format(loop->arena, "%s, %u, %d",
                                    record ? arena_format(loop->arena, "sizeof(%s)", record) : "0",
                                    tag_bits(its), is_exact(loop, its));
    if (span_of_stream(loop->bins, stream))
        return arena_format(loop->arena, "REDCC_STREAM_OF_SPANS(%s, %u, %s, sizeof(%s))", apply,
                            its->arrays[0], row_type(loop, its->arrays[0]), record);
    if (its->array_count == 1)
        return arena_format(loop->arena, "REDCC_STREAM(%s, %u, %s, %s)", apply, its->arrays[0],
                            row_type(loop, its->arrays[0]), rest);
    buffer numbers = {0}, rows = {0};
    for (unsigned part = 0; part < its->array_count; part++) {
        const char *comma = part > 0 ? ", " : "";
        buffer_format(&numbers, "%s%u", comma, its->arrays[part]);
        buffer_format(&rows, "%ssizeof(%s)", comma, row_type(loop, its->arrays[part]));
    }
    const char *text = arena_format(loop->arena, "{%s, %u, {%s}, {%s}, %s}", apply,
                                    its->array_count, numbers.data, rows.data, rest);
    buffer_free(&numbers);
    buffer_free(&rows);
    return text;
}

unsigned bins_stream_count(const loop_text *loop) {
    assert(loop->bins);
    return loop->bins->stream_count;
}

void write_streams(loop_text *loop, writer *out) {
    const unsigned count = bins_stream_count(loop);
    writer_line(out, "static const redcc_stream %s[] = {", outlined_name(loop, "streams"));
    for (unsigned i = 0; i < count; i++)
        writer_line(out, "    %s,", stream_text(loop, i));
    writer_line(out, "};");
}

/** Are all updates exact, so that private copies may be made in any order? */
static bool are_all_exact(const loop_text *loop) {
    for (unsigned i = 0; i < bins_stream_count(loop); i++)
        if (!is_exact(loop, &loop->bins->streams[i]))
            return false;
    return true;
}

bool bins_have_copier(const loop_text *loop) {
    return loop->bins && loop->plan->execution.is_unordered;
}

const char *bins_phase(loop_text *loop) {
    assert(loop->bins);
    const char *varied = loop->outline.reads_call
                             ? arena_format(loop->arena, " %uu,", loop->bins->varied_sources)
                             : "";
    const char *copies = bins_have_copier(loop) ? arena_format(loop->arena, "REDCC_COPIED_BY(%s)",
                                                               outlined_name(loop, "copies"))
                         : are_all_exact(loop)  ? "1"
                                                : "0";
    return arena_format(loop->arena, "REDCC_BINS_%u, %uu,%s %s", loop->facts->array_count,
                        loop->bins->guarded_sources, varied, copies);
}

const char *bins_copied(const loop_text *loop) {
    const unsigned first = loop->bins->guarded_sources;
    const unsigned later = loop->outline.reads_call ? loop->bins->varied_sources : first;
    return arena_format(loop->arena, "REDCC_BINS_%u, %uu, %uu", loop->facts->array_count, first,
                        later);
}

const char *streams_argument(loop_text *loop) {
    return arena_format(loop->arena, "%s, ", outlined_name(loop, "streams"));
}
