/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A form of the loop for in-order binning (redcc/bins.h), beside the others: an update becomes a
 * record, which holds what the update reads but for the element itself, and a function applies
 * records to the elements. Updates of one row (bins_row.c), or of several arrays at one subscript,
 * share a record (bins_group.c), and so does what a loop over constants does (bins_nest.c).
 *
 * The loop has no such form where an update cannot be taken apart so, or where its body may not be
 * executed before its reads are compared with what it writes (stale.c).
 */
#include "emit/bins.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "emit/bins_form.h"
#include "emit/print.h"
#include "ir/ir_syntax.h"
#include "plan/lookup.h"
#include "plan/unverified.h"

enum { MOST_TAGS = 16, MOST_SOURCES = 32 };

/* ---- operands ------------------------------------------------------------------------------ */

static bool contains(const ir_node *node, const ir_node *target) {
    if (syntax_same(node, target))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (contains(node->children[i], target))
            return true;
    return false;
}

static bool mentions_array(const loop_text *loop, const ir_node *node) {
    if (loop_array_of_base(loop->facts, node) >= 0)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (mentions_array(loop, node->children[i]))
            return true;
    return false;
}

static bool writes(const ir_node *node) {
    if (expression_written(node) || node->kind == IR_OPAQUE)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (writes(node->children[i]))
            return true;
    return false;
}

const char *kept_type(const ir_type *type) {
    if (!type || type->is_volatile || type->is_atomic)
        return NULL;
    if (type->kind == IR_BOOLEAN || (type->kind == IR_INTEGER && type->size < 4))
        return "int";
    if (type->kind == IR_INTEGER && type->size == 4)
        return type->is_signed ? "int" : "redcc_u32";
    if (type->kind == IR_INTEGER && type->size == 8)
        return type->is_signed ? "redcc_int" : "redcc_word";
    if (type->kind == IR_FLOATING)
        return type->size == 4 ? "float" : type->size == 8 ? "double" : NULL;
    return NULL;
}

static const char *record_type(const ir_node *operand) {
    return operand->kind == IR_MEMBER && operand->field && operand->field->is_bit_field
               ? NULL
               : kept_type(operand->type);
}

/** The number of the operand that this node is, or says again; -1: none. No two calls say the same.
 */
static int operand_number(const bins_record *record, const ir_node *node) {
    for (unsigned i = 0; i < record->operand_count; i++)
        if (record->operands[i] == node || syntax_same(record->operands[i], node))
            return (int)i;
    return -1;
}

/** A variable that has a value whatever the iteration does. */
static bool has_value_always(const loop_text *loop, const ir_node *node) {
    const loop_facts *facts = loop->facts;
    if (node->kind != IR_VARIABLE)
        return false;
    bool is_outer = node->variable == facts->counted.counter;
    for (unsigned i = 0; i < facts->variables.captured_count; i++)
        is_outer |= facts->variables.captured[i] == node->variable;
    const ir_node *declared = ir_declarator_in(facts->counted.body, node->variable);
    return is_outer || (declared && declared->child_count > 0);
}

/** An operand that is not evaluated each time may not fail where it is, nor lack a value. */
static bool add_operand(const loop_text *loop, bins_record *record, const ir_node *node,
                        bool is_certain) {
    if (operand_number(record, node) >= 0)
        return true;
    if (record->operand_count == MOST_RECORD_OPERANDS || writes(node) ||
        mentions_array(loop, node) || !record_type(node) ||
        (!is_certain && !has_value_always(loop, node)))
        return false;
    record->operands[record->operand_count++] = node;
    return true;
}

/** The functions that both kinds of copies of the text name alike: of two numbers, by the system.
 */
static bool is_extremum(const ir_node *callee) {
    return callee->kind == IR_FUNCTION && callee->function->is_from_system &&
           (strncmp(callee->function->name, "fmin", 4) == 0 ||
            strncmp(callee->function->name, "fmax", 4) == 0);
}

static bool may_hold_target(const ir_node *node) {
    switch (node->kind) {
    case IR_ASSIGN:
    case IR_BINARY:
    case IR_CONDITIONAL:
    case IR_CAST:
    case IR_IF:
    case IR_BLOCK:
    case IR_EXPRESSION:
        return true;
    case IR_UNARY:
        return node->op != IR_OP_ADDRESS && node->op != IR_OP_DEREFERENCE;
    case IR_CALL:
        return is_extremum(node->children[0]);
    default:
        return false;
    }
}

static bool is_constant(const ir_node *node) {
    return node->kind == IR_NUMBER || (node->flags & IR_HAS_VALUE);
}

/** Is a part of this node evaluated only where another one says so? */
static bool decides(const ir_node *node) {
    return node->kind == IR_CONDITIONAL || node->kind == IR_IF ||
           (node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR));
}

static bool gather_operands(const loop_text *loop, bins_record *record, const ir_node *target,
                            const ir_node *node, bool is_certain) {
    if (syntax_same(node, target) || (ir_is_expression(node) && is_constant(node)))
        return true;
    if (ir_is_expression(node) && !contains(node, target))
        return add_operand(loop, record, node, is_certain);
    if (!may_hold_target(node))
        return false;
    for (unsigned i = node->kind == IR_CALL; i < node->child_count; i++)
        if (!gather_operands(loop, record, target, node->children[i],
                             is_certain && (i == 0 || !decides(node))))
            return false;
    return true;
}

/* ---- the updates' text --------------------------------------------------------------------- */

unsigned stream_value_count(const bins_stream *stream) {
    unsigned count = 0;
    while (count < MOST_RECORD_VALUES && stream->types[count])
        count++;
    return count;
}

typedef struct spelling {
    const loop_text *loop;
    const struct bins_text *bins;
    const bins_record *record;
    const reduction_update *update;
    unsigned part; /* of the nest's elements */
} spelling;

/** The element that the update at hand goes to. */
static const char *element_in_row(const spelling *its) {
    static const char *const rows[] = {"(*redcc__to)", "(*redcc__to_1)", "(*redcc__to_2)",
                                       "(*redcc__to_3)"};
    const bins_stream *stream = &its->bins->streams[its->record->stream];
    unsigned array = 0;
    while (stream->arrays[array] != its->update->array)
        array++;
    return is_wide_row(its->loop, its->bins, its->update->array)
               ? arena_format(its->loop->arena, "%s[%u]", rows[array],
                              part_of_row(its->loop, its->bins, its->update, its->part))
               : rows[array];
}

/** The printer's hook: the element, and what the record holds. */
static const char *name_in_record(const ir_node *node, void *context) {
    const spelling *its = context;
    if (!ir_is_expression(node))
        return NULL;
    if (syntax_same(node, its->update->target))
        return element_in_row(its);
    const int number = operand_number(its->record, node);
    if (number < 0)
        return NULL;
    if (stream_value_count(&its->bins->streams[its->record->stream]) == 1)
        return "redcc__e";
    const unsigned parts = nest_part_count(its->record->nest);
    return arena_format(its->loop->arena, "redcc__e.v%u", (unsigned)number * parts + its->part);
}

static bool spell_updates(loop_text *loop, const struct bins_text *bins, bins_record *record) {
    writer line = {.on_one_line = true};
    spelling its = {.loop = loop, .bins = bins, .record = record};
    printer p = {.arena = loop->arena, .out = &line, .rename = name_in_record, .context = &its};
    for (unsigned i = 0; i < record->update_count; i++) {
        its.update = record->updates[i];
        for (its.part = 0; its.part < nest_part_count(record->nest); its.part++)
            print_statement(&p, its.update->statement);
    }
    record->text = writer_text(loop->arena, &line);
    return p.problem == NULL;
}

/** Records of a stream with equal updates have one tag. */
static void give_tag(struct bins_text *bins, bins_record *record) {
    for (const bins_record *other = bins->records; other < record; other++)
        if (other->stream == record->stream && strcmp(other->text, record->text) == 0) {
            record->tag = other->tag;
            return;
        }
    record->tag = bins->streams[record->stream].tag_count++;
}

/** One type of record for all updates of a stream, of which some use the first values only. */
static bool fits_stream(struct bins_text *bins, const bins_record *record) {
    const char **types = bins->streams[record->stream].types;
    const unsigned parts = nest_part_count(record->nest);
    const unsigned values = record->operand_count * parts;
    for (unsigned i = 0; i < values && values <= MOST_RECORD_VALUES; i++) {
        const char *type = record_type(record->operands[i / parts]);
        if (types[i] && strcmp(types[i], type) != 0)
            return false;
        types[i] = type;
    }
    return values <= MOST_RECORD_VALUES;
}

/* ---- may it have the form? ----------------------------------------------------------------- */

static bool is_power_of_two(int64_t size) {
    return size > 0 && (size & (size - 1)) == 0;
}

static bool can_be_stream(const loop_text *loop, unsigned number) {
    const reduction_array *array = &loop->facts->arrays[number];
    const ir_type *element = array->element;
    for (unsigned other = 0; other < number; other++) /* one base is one array */
        assert(array->is_scattered || loop->facts->arrays[other].is_scattered ||
               !syntax_same(loop->facts->arrays[other].base, array->base));
    return !array->is_scattered && element->spelling && is_power_of_two(element->size) &&
           element->size <= 8 && (element->kind == IR_INTEGER || element->kind == IR_FLOATING);
}

/** Do the arrays stand nowhere but in their updates? */
static bool is_read_elsewhere(const loop_text *loop, const ir_node *node) {
    if (loop_update_at(loop->facts, node))
        return false;
    if (ir_is_expression(node) && loop_array_of_base(loop->facts, node) >= 0)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_read_elsewhere(loop, node->children[i]))
            return true;
    return false;
}

static bool take_apart(loop_text *loop, struct bins_text *bins, bins_record *record) {
    for (unsigned i = 0; i < record->update_count; i++) {
        const reduction_update *update = record->updates[i];
        const ir_node *statement = update->statement;
        if (update->last || !is_in_step(loop, bins, update) ||
            (statement->kind != IR_EXPRESSION && statement->kind != IR_IF) ||
            !gather_operands(loop, record, update->target, statement, true))
            return false;
    }
    return fits_stream(bins, record);
}

static bool find_told_sources(const loop_text *loop, struct bins_text *bins) {
    if (loop->plan->source_count > MOST_SOURCES)
        return false;
    for (unsigned i = 0; i < loop->facts->source_count; i++) {
        const loop_source *read = &loop->facts->sources[i];
        if (read->needs_guard && read->extent == EXTENT_TOUCHED)
            bins->told_sources |= (uint32_t)1 << loop->plan->source_number[i];
    }
    return true;
}

static bool write_records(loop_text *loop, struct bins_text *bins) {
    for (unsigned i = 0; i < bins->record_count; i++) {
        bins_record *record = &bins->records[i];
        if (!spell_updates(loop, bins, record))
            return false;
        give_tag(bins, record);
        if (bins->streams[record->stream].tag_count > MOST_TAGS)
            return false;
    }
    return true;
}

static bool can_be_grouped(loop_text *loop, struct bins_text *bins, bool wide, bool together) {
    if (!group_updates(loop, bins, wide, together))
        return false;
    for (unsigned i = 0; i < bins->record_count; i++)
        if (!take_apart(loop, bins, &bins->records[i]))
            return false;
    return write_records(loop, bins);
}

/** As few records as can be. */
static bool choose_records(loop_text *loop, struct bins_text *bins) {
    find_nests(loop, bins);
    for (unsigned i = 0; i < loop->facts->update_count; i++)
        bins->has_nests |= bins->nests[i].outermost != NULL;
    for (;; bins->has_nests = false) {
        if (can_be_grouped(loop, bins, true, true) || can_be_grouped(loop, bins, true, false))
            return true;
        if (!bins->has_nests)
            break;
    }
    return can_be_grouped(loop, bins, false, true) || can_be_grouped(loop, bins, false, false);
}

void find_bins(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    struct bins_text *bins = ARENA_ARRAY(loop->arena, struct bins_text, 1);
    bins->records = ARENA_ARRAY(loop->arena, bins_record, facts->update_count + 1);
    bins->streams = ARENA_ARRAY(loop->arena, bins_stream, facts->array_count + 1);
    bins->row_bytes = ARENA_ARRAY(loop->arena, int64_t, facts->array_count + 1);
    bins->nests = ARENA_ARRAY(loop->arena, bins_nest, facts->update_count + 1);
    if (loop->unit->dialect.is_sanitized || facts->forward_count > 0 || facts->scalar_count > 0 ||
        is_read_elsewhere(loop, facts->counted.body) || !find_told_sources(loop, bins) ||
        !is_harmless_when_unverified(loop->plan))
        return;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!can_be_stream(loop, i))
            return;
    if (choose_records(loop, bins))
        loop->bins = bins;
}
