/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/bins.h"

#include <assert.h>
#include <string.h>

#include "analysis/base/expression.h"
#include "ir/ir_syntax.h"
#include "plan/bins_parts.h"
#include "plan/lookup.h"
#include "plan/unverified_uses.h"

enum { MOST_TAGS = 16, MOST_SOURCES = 32 };

/* ---- operands ------------------------------------------------------------------------------ */

bool is_updated_element(const ir_node *node, const ir_node *target) {
    return expression_same(node, target);
}

const ir_node *row_load_of(const loop_facts *facts, const reduction_update *update) {
    assert(update->array < facts->array_count);
    const ir_node *node = update->target;
    if (!facts->arrays[update->array].is_scattered)
        return NULL;
    while (node->child_count > 0 && !(node->type && node->type->kind == IR_POINTER))
        node = node->children[0];
    return node->kind == IR_INDEX || node->kind == IR_MEMBER ? node : NULL;
}

static bool contains(const ir_node *node, const ir_node *target) {
    if (is_updated_element(node, target))
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (contains(node->children[i], target))
            return true;
    return false;
}

static bool is_write(const ir_node *node) {
    return expression_written(node) || node->kind == IR_OPAQUE;
}

value_kind value_kind_of(const ir_type *type) {
    if (!type || type->is_volatile || type->is_atomic)
        return VALUE_NONE;
    if (type->kind == IR_BOOLEAN || (type->kind == IR_INTEGER && type->size < 4))
        return VALUE_INT;
    if (type->kind == IR_INTEGER && type->size == 4)
        return type->is_signed ? VALUE_INT : VALUE_UNSIGNED;
    if (type->kind == IR_INTEGER && type->size == 8)
        return type->is_signed ? VALUE_LONG : VALUE_UNSIGNED_LONG;
    if (type->kind == IR_FLOATING)
        return type->size == 4 ? VALUE_FLOAT : type->size == 8 ? VALUE_DOUBLE : VALUE_NONE;
    return VALUE_NONE;
}

static value_kind record_kind(const ir_node *operand) {
    return operand->kind == IR_MEMBER && operand->field && operand->field->is_bit_field
               ? VALUE_NONE
               : value_kind_of(operand->type);
}

int operand_number(const bins_record *record, const ir_node *node) {
    assert(record->operand_count <= MOST_RECORD_OPERANDS);
    for (unsigned i = 0; i < record->operand_count; i++)
        if (record->operands[i] == node || syntax_same(record->operands[i], node))
            return (int)i;
    return -1;
}

/** Is the node a variable that has a value on entry to the body, or from its declaration on? */
static bool has_value_always(const loop_facts *facts, const ir_node *node) {
    if (node->kind != IR_VARIABLE)
        return false;
    const bool is_outer =
        node->variable == facts->counted.counter || is_captured(facts, node->variable);
    const ir_node *declared = ir_declarator_in(facts->counted.body, node->variable);
    return is_outer || (declared && declared->child_count > 0);
}

/** Adds an operand to the record. The record stores all its operands whenever it is appended.
 * `is_certain`: the update then always evaluates the operand. If not, the operand must be a
 * variable that has a value, so that reading it is harmless. Returns false if the record cannot
 * store the operand. */
static bool add_operand(const loop_facts *facts, bins_record *record, const ir_node *node,
                        bool is_certain) {
    if (operand_number(record, node) >= 0)
        return true;
    if (record->operand_count == MOST_RECORD_OPERANDS || ir_any(node, is_write) ||
        record_kind(node) == VALUE_NONE || (!is_certain && !has_value_always(facts, node)))
        return false;
    record->operands[record->operand_count++] = node;
    return true;
}

/** Is the callee fmin, fmax or a variant of these in the C library? In R = fmin(R, v) one argument
 * is the target. */
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

/** Is a part of this node evaluated only under a condition? */
static bool decides(const ir_node *node) {
    return node->kind == IR_CONDITIONAL || node->kind == IR_IF ||
           (node->kind == IR_BINARY && (node->op == IR_OP_AND || node->op == IR_OP_OR));
}

static bool gather_operands(const loop_facts *facts, bins_record *record, const ir_node *target,
                            const ir_node *node, bool is_certain) {
    if (is_updated_element(node, target) || (ir_is_expression(node) && is_constant(node)))
        return true;
    if (ir_is_expression(node) && !contains(node, target))
        return add_operand(facts, record, node, is_certain);
    if (!may_hold_target(node))
        return false;
    for (unsigned i = node->kind == IR_CALL; i < node->child_count; i++)
        if (!gather_operands(facts, record, target, node->children[i],
                             is_certain && (i == 0 || !decides(node))))
            return false;
    return true;
}

/* ---- records ------------------------------------------------------------------------------- */

unsigned stream_value_count(const bins_stream *stream) {
    unsigned count = 0;
    while (count < MOST_RECORD_VALUES && stream->kinds[count] != VALUE_NONE)
        count++;
    return count;
}

/** Sets the record's tag: records of a stream share a tag if the same statements can apply them. */
static void give_tag(const loop_facts *facts, bins_plan *bins, bins_record *record) {
    assert(record->stream < bins->stream_count);
    for (const bins_record *other = bins->records; other < record; other++)
        if (other->stream == record->stream && records_are_alike(facts, bins, other, record)) {
            record->tag = other->tag;
            return;
        }
    record->tag = bins->streams[record->stream].tag_count++;
}

/** Merges the types of the record's values into the types of its stream's values. Records with
 * fewer values use only the first of these. Returns false if the types differ, or there are too
 * many values. */
static bool fits_stream(bins_plan *bins, const bins_record *record) {
    assert(record->stream < bins->stream_count);
    value_kind *kinds = bins->streams[record->stream].kinds;
    const unsigned parts = nest_part_count(record->nest);
    const unsigned values = record->operand_count * parts;
    for (unsigned i = 0; i < values && values <= MOST_RECORD_VALUES; i++) {
        const value_kind kind = record_kind(record->operands[i / parts]);
        if (kinds[i] != VALUE_NONE && kinds[i] != kind)
            return false;
        kinds[i] = kind;
    }
    return values <= MOST_RECORD_VALUES;
}

/* ---- may the loop have the form? ----------------------------------------------------------- */

static bool is_power_of_two(int64_t size) {
    return size > 0 && (size & (size - 1)) == 0;
}

static bool can_be_stream(const loop_facts *facts, unsigned number) {
    assert(number < facts->array_count);
    const reduction_array *array = &facts->arrays[number];
    const ir_type *element = array->element;
    for (unsigned other = 0; other < number; other++) /* no two arrays have the same base */
        assert(array->is_scattered || facts->arrays[other].is_scattered ||
               !syntax_same(facts->arrays[other].base, array->base));
    return element->spelling && is_power_of_two(element->size) && element->size <= 8 &&
           (element->kind == IR_INTEGER || element->kind == IR_FLOATING);
}

/** Does the element's text begin at the array's base, and not at a pointer that the iteration
 * computes? Elements of scattered arrays need no base: they are counted from address 0. */
static bool is_spelled_from_base(const loop_facts *facts, const reduction_update *update) {
    const ir_node *node = update->target;
    if (facts->arrays[update->array].is_scattered)
        return true;
    while (loop_array_of_base(facts, node) != (int)update->array && node->child_count > 0)
        node = node->children[0];
    return loop_array_of_base(facts, node) == (int)update->array;
}

static bool split_updates(const loop_facts *facts, bins_plan *bins, bins_record *record) {
    if (record->span) /* the text of the inner loop applies the record */
        return record->update_count == 1 && is_in_step(facts, bins, record->updates[0]);
    for (unsigned i = 0; i < record->update_count; i++) {
        const reduction_update *update = record->updates[i];
        const ir_node *statement = update->statement;
        if (update->last || !is_in_step(facts, bins, update) ||
            (statement->kind != IR_EXPRESSION && statement->kind != IR_IF) ||
            !gather_operands(facts, record, update->target, statement, true))
            return false;
    }
    return fits_stream(bins, record);
}

static void find_guarded_sources(const loop_plan *plan, bins_plan *bins) {
    const bool *is_guarded = guarded_sources(plan);
    for (unsigned i = 0; i < plan->facts->source_count; i++) {
        const loop_source *read = &plan->facts->sources[i];
        if (!is_guarded[i] || read->extent != EXTENT_TOUCHED)
            continue;
        assert(plan->source_number[i] >= 0 && plan->source_number[i] < MOST_SOURCES);
        bins->guarded_sources |= (uint32_t)1 << plan->source_number[i];
        if (!read->is_repeated)
            bins->varied_sources |= (uint32_t)1 << plan->source_number[i];
    }
}

static bool give_tags(const loop_facts *facts, bins_plan *bins) {
    for (unsigned i = 0; i < bins->record_count; i++) {
        bins_record *record = &bins->records[i];
        give_tag(facts, bins, record);
        if (bins->streams[record->stream].tag_count > MOST_TAGS)
            return false;
    }
    return true;
}

static bool can_be_grouped(const loop_plan *plan, bins_plan *bins, bool wide, bool together) {
    if (!group_updates(plan->arena, plan->facts, bins, wide, together))
        return false;
    for (unsigned i = 0; i < bins->record_count; i++)
        if (!split_updates(plan->facts, bins, &bins->records[i]))
            return false;
    return give_tags(plan->facts, bins);
}

/** Tries the groupings that need the fewest records first. */
static bool choose_records(const loop_plan *plan, bins_plan *bins) {
    find_nests(plan->facts, bins);
    find_bins_spans(plan, bins);
    for (unsigned i = 0; i < plan->facts->update_count; i++)
        bins->has_nests |= bins->nests[i].outermost != NULL;
    for (;; bins->has_nests = false) {
        if (can_be_grouped(plan, bins, true, true) || can_be_grouped(plan, bins, true, false))
            return true;
        if (!bins->has_nests)
            break;
    }
    return can_be_grouped(plan, bins, false, true) || can_be_grouped(plan, bins, false, false);
}

/** May a read whose address is known only during execution overlap an own element or a scalar in
 * memory? These are stored after the last round, so the guard may find the overlap too late. */
static bool may_meet_kept(const loop_facts *facts) {
    for (unsigned i = 0; i < facts->source_count; i++)
        if (facts->sources[i].meets_scalars && facts->sources[i].extent == EXTENT_TOUCHED)
            return true;
    return false;
}

/** Must the body use only verified values? An execution that is aborted leaves operands of scalars,
 * values of own elements, and series. The next execution overwrites the former two, but not the
 * series. */
static bool needs_check(const loop_plan *plan) {
    return !is_harmless_when_unverified(plan) ||
           (has_series(plan->facts) && unverified_has_suspects(plan, guarded_sources(plan))) ||
           may_meet_kept(plan->facts);
}

/** The reason why updates may not be deferred, or NULL if they may. */
static const char *why_not_later(const loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    if (plan->unit->dialect.is_sanitized)
        return "a sanitizer would see values that the program does not compute";
    if (facts->forward_count > 0)
        return "an iteration reads what it updates";
    if (plan->source_count > MOST_SOURCES)
        return "it reads too many arrays that may overlap those it updates";
    if (needs_check(plan) && (!facts->inspector.exists || plan->precheck != PRECHECK_NONE))
        return "its body may fail with values that are not verified";
    if (facts->slice.exits)
        return "an iteration may leave the loop";
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!can_be_stream(facts, i))
            return "an updated element is no integer or floating value of at most 8 bytes";
    for (unsigned i = 0; i < facts->update_count; i++)
        if (!is_spelled_from_base(facts, &facts->updates[i]))
            return "an update goes through a pointer that the iteration computes";
    return NULL;
}

void plan_bins(loop_plan *plan) {
    const loop_facts *facts = plan->facts;
    plan->no_bins = why_not_later(plan);
    if (plan->no_bins)
        return;
    bins_plan *bins = ARENA_ARRAY(plan->arena, bins_plan, 1);
    bins->records = ARENA_ARRAY(plan->arena, bins_record, facts->update_count + 1);
    bins->streams = ARENA_ARRAY(plan->arena, bins_stream, facts->array_count + 1);
    bins->row_bytes = ARENA_ARRAY(plan->arena, int64_t, facts->array_count + 1);
    bins->nests = ARENA_ARRAY(plan->arena, bins_nest, facts->update_count + 1);
    bins->spans = ARENA_ARRAY(plan->arena, bins_span, facts->update_count + 1);
    bins->is_checked = needs_check(plan);
    if (!bins->is_checked)
        find_guarded_sources(plan, bins);
    assert((bins->varied_sources & ~bins->guarded_sources) == 0);
    if (choose_records(plan, bins))
        plan->bins = bins;
    else
        plan->no_bins = "an update needs more than a record can hold";
    assert((plan->bins == NULL) == (plan->no_bins != NULL));
}
