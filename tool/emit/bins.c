/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A form of the loop for in-order binning (redcc/bins.h), beside the others: an update becomes a
 * record, which holds what the update reads but for the element itself, and a function applies
 * records to the elements. Each array has a stream of its own, whose rows are its elements.
 *
 * The loop has no such form where an update cannot be taken apart so, or where its body may not be
 * executed before its reads are compared with what it writes (stale.c).
 */
#include <string.h>

#include "analysis/base/expression.h"
#include "emit/loop.h"
#include "emit/origin.h"
#include "emit/print.h"
#include "emit/syntax.h"

enum { MOST_OPERANDS = 3, MOST_SITES = 16, MOST_SOURCES = 32 };

/** One update, taken apart. */
typedef struct site {
    const reduction_update *update;
    unsigned operand_count;
    const ir_node *operands[MOST_OPERANDS];
    unsigned record_count; /* values in the record, of all updates of the array */
    unsigned tag;
    const char *text; /* of the update, on an element and a record */
} site;

struct bins_text {
    site *sites;               /* by update */
    const char **record_types; /* by array and operand; NULL: no more */
    unsigned *tag_counts;      /* by array */
    uint32_t told_sources;     /* bits, by number: their reads are told */
};

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
    if (loop_array_of_base(loop, node) >= 0)
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

/** The promoted type, by a name that needs no declaration; NULL: values of it are not kept. */
static const char *record_type(const ir_node *operand) {
    const ir_type *type = operand->type;
    if (!type || type->is_volatile || type->is_atomic ||
        (operand->kind == IR_MEMBER && operand->field && operand->field->is_bit_field))
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

/** The number of the operand that this node is, or says again; -1: none. No two calls say the same.
 */
static int operand_number(const site *self, const ir_node *node) {
    for (unsigned i = 0; i < self->operand_count; i++)
        if (self->operands[i] == node || syntax_same(self->operands[i], node))
            return (int)i;
    return -1;
}

/** An operand that is not evaluated each time may not fail where it is. */
static bool add_operand(const loop_text *loop, site *self, const ir_node *node, bool is_certain) {
    if (operand_number(self, node) >= 0)
        return true;
    if (self->operand_count == MOST_OPERANDS || writes(node) || mentions_array(loop, node) ||
        !record_type(node) || (!is_certain && node->kind != IR_VARIABLE))
        return false;
    self->operands[self->operand_count++] = node;
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

static bool gather(const loop_text *loop, site *self, const ir_node *node, bool is_certain) {
    const ir_node *target = self->update->target;
    if (syntax_same(node, target) || (ir_is_expression(node) && is_constant(node)))
        return true;
    if (ir_is_expression(node) && !contains(node, target))
        return add_operand(loop, self, node, is_certain);
    if (!may_hold_target(node))
        return false;
    for (unsigned i = node->kind == IR_CALL; i < node->child_count; i++)
        if (!gather(loop, self, node->children[i], is_certain && (i == 0 || !decides(node))))
            return false;
    return true;
}

/* ---- the update's text --------------------------------------------------------------------- */

/** The printer's hook: the element, and what the record holds. */
static const char *name_in_record(const ir_node *node, void *context) {
    static const char *const values[] = {"redcc__e.v0", "redcc__e.v1", "redcc__e.v2"};
    const site *self = context;
    if (!ir_is_expression(node))
        return NULL;
    if (syntax_same(node, self->update->target))
        return "(*redcc__to)";
    const int number = operand_number(self, node);
    return number < 0 ? NULL : self->record_count == 1 ? "redcc__e" : values[number];
}

static bool spell_update(loop_text *loop, site *self) {
    writer line = {.on_one_line = true};
    printer p = {.arena = loop->arena, .out = &line, .rename = name_in_record, .context = self};
    print_statement(&p, self->update->statement);
    self->text = writer_text(loop->arena, &line);
    return p.problem == NULL;
}

/** Equal updates of an array have one tag. */
static void give_tag(struct bins_text *bins, unsigned number) {
    site *self = &bins->sites[number];
    for (unsigned i = 0; i < number; i++)
        if (bins->sites[i].update->array == self->update->array &&
            strcmp(bins->sites[i].text, self->text) == 0) {
            self->tag = bins->sites[i].tag;
            return;
        }
    self->tag = bins->tag_counts[self->update->array]++;
}

/** One type of record for all updates of an array, of which some use the first values only. */
static bool fits_record(struct bins_text *bins, const site *self) {
    const char **types = &bins->record_types[self->update->array * MOST_OPERANDS];
    for (unsigned i = 0; i < self->operand_count; i++) {
        const char *type = record_type(self->operands[i]);
        if (types[i] && strcmp(types[i], type) != 0)
            return false;
        types[i] = type;
    }
    return true;
}

/* ---- may it have the form? ----------------------------------------------------------------- */

/** Is each element a multiple of its own size away from the base? */
static bool is_in_step(const loop_text *loop, const ir_node *target, unsigned array) {
    const int64_t size = loop->facts->arrays[array].element->size;
    for (; loop_array_of_base(loop, target) != (int)array; target = target->children[0]) {
        const bool is_step = target->kind == IR_INDEX || target->kind == IR_MEMBER ||
                             (target->kind == IR_UNARY && target->op == IR_OP_DEREFERENCE);
        if (!is_step || target->type->size <= 0 || target->type->size % size != 0 ||
            (target->kind == IR_MEMBER &&
             (target->field->offset < 0 || target->field->offset % size != 0)))
            return false;
    }
    return true;
}

static bool is_power_of_two(int64_t size) {
    return size > 0 && (size & (size - 1)) == 0;
}

static bool can_be_stream(const loop_text *loop, unsigned number) {
    const reduction_array *array = &loop->facts->arrays[number];
    const ir_type *element = array->element;
    for (unsigned other = 0; other < number; other++)
        if (syntax_same(loop->facts->arrays[other].base, array->base))
            return false; /* elements of two kinds side by side */
    return !array->is_scattered && element->spelling && is_power_of_two(element->size) &&
           element->size <= 8 && (element->kind == IR_INTEGER || element->kind == IR_FLOATING);
}

/** Do the arrays stand nowhere but in their updates? */
static bool is_read_elsewhere(const loop_text *loop, const ir_node *node) {
    for (unsigned i = 0; i < loop->facts->update_count; i++)
        if (loop->facts->updates[i].statement == node)
            return false;
    if (ir_is_expression(node) && loop_array_of_base(loop, node) >= 0)
        return true;
    for (unsigned i = 0; i < node->child_count; i++)
        if (is_read_elsewhere(loop, node->children[i]))
            return true;
    return false;
}

static bool take_apart(loop_text *loop, struct bins_text *bins, unsigned number) {
    site *self = &bins->sites[number];
    self->update = &loop->facts->updates[number];
    return !self->update->last && is_in_step(loop, self->update->target, self->update->array) &&
           (self->update->statement->kind == IR_EXPRESSION ||
            self->update->statement->kind == IR_IF) &&
           gather(loop, self, self->update->statement, true) && fits_record(bins, self);
}

static bool find_told_sources(const loop_text *loop, struct bins_text *bins) {
    if (loop->source_count > MOST_SOURCES)
        return false;
    for (unsigned i = 0; i < loop->facts->source_count; i++) {
        const loop_source *read = &loop->facts->sources[i];
        if (read->needs_guard && read->extent == EXTENT_TOUCHED)
            bins->told_sources |= (uint32_t)1 << loop->source_number[i];
    }
    return true;
}

static unsigned record_count(const struct bins_text *bins, unsigned array) {
    unsigned count = 0;
    while (count < MOST_OPERANDS && bins->record_types[array * MOST_OPERANDS + count])
        count++;
    return count;
}

static bool write_sites(loop_text *loop, struct bins_text *bins) {
    for (unsigned i = 0; i < loop->facts->update_count; i++) {
        site *self = &bins->sites[i];
        self->record_count = record_count(bins, self->update->array);
        if (!spell_update(loop, self))
            return false;
        give_tag(bins, i);
        if (bins->tag_counts[self->update->array] > MOST_SITES)
            return false;
    }
    return true;
}

void find_bins(loop_text *loop) {
    const loop_facts *facts = loop->facts;
    struct bins_text *bins = ARENA_ARRAY(loop->arena, struct bins_text, 1);
    bins->sites = ARENA_ARRAY(loop->arena, site, facts->update_count + 1);
    bins->tag_counts = ARENA_ARRAY(loop->arena, unsigned, facts->array_count + 1);
    bins->record_types =
        ARENA_ARRAY(loop->arena, const char *, facts->array_count *MOST_OPERANDS + 1);
    if (facts->forward_count > 0 || facts->scalar_count > 0 ||
        is_read_elsewhere(loop, facts->counted.body) || !find_told_sources(loop, bins) ||
        !is_harmless_when_stale(loop))
        return;
    for (unsigned i = 0; i < facts->array_count; i++)
        if (!can_be_stream(loop, i))
            return;
    for (unsigned i = 0; i < facts->update_count; i++)
        if (!take_apart(loop, bins, i))
            return;
    if (write_sites(loop, bins))
        loop->bins = bins;
}

/* ---- what is written ----------------------------------------------------------------------- */

static const char *record_name(loop_text *loop, unsigned array) {
    const char *const *types = &loop->bins->record_types[array * MOST_OPERANDS];
    return record_count(loop->bins, array) < 2
               ? types[0]
               : arena_format(loop->arena, "%s_%u", outlined_name(loop, "record"), array);
}

/** The values that the record of this update holds; those that others use are 0. */
static const char *values_text(loop_text *loop, const site *self) {
    arena *a = loop->arena;
    const char *const *types = &loop->bins->record_types[self->update->array * MOST_OPERANDS];
    const char *texts[MOST_OPERANDS];
    for (unsigned i = 0; i < self->record_count; i++) {
        const bool is_floating = strcmp(types[i], "float") == 0 || strcmp(types[i], "double") == 0;
        texts[i] = "0";
        if (i >= self->operand_count)
            continue;
        const char *text = is_floating ? text_expression(a, self->operands[i], NULL, NULL)
                                       : text_operand(a, self->operands[i], NULL, NULL);
        if (!text)
            loop_obstacle(loop, self->operands[i]->range,
                          "an operand cannot be spelled a second time");
        else
            texts[i] =
                macro_argument(a, is_floating ? text : arena_format(a, "(%s)%s", types[i], text));
    }
    return self->record_count == 1 ? texts[0]
           : self->record_count == 2
               ? arena_format(a, "REDCC_VALUES_2(%s, %s)", texts[0], texts[1])
               : arena_format(a, "REDCC_VALUES_3(%s, %s, %s)", texts[0], texts[1], texts[2]);
}

const char *bins_update(loop_text *loop, const reduction_update *update, const char *address) {
    const site *self = loop->bins->sites;
    while (self->update != update)
        self++;
    const unsigned array = update->array;
    const char *base = loop->arrays[array].local;
    if (self->record_count == 0)
        return arena_format(loop->arena, "REDCC_UPDATE_ALIKE(%u, %u, %s, %s)", array, self->tag,
                            base, address);
    return arena_format(loop->arena, "REDCC_UPDATE_BY(%u, %u, %s, %s, %s, %s)", array, self->tag,
                        base, address, record_name(loop, array), values_text(loop, self));
}

static unsigned tag_bits(unsigned tags) {
    unsigned bits = 0;
    while (1u << bits < tags)
        bits++;
    return bits;
}

/** Updates that differ follow their tags. */
static const char *updates_text(loop_text *loop, unsigned array) {
    const struct bins_text *bins = loop->bins;
    buffer out = {0};
    unsigned tag = 0;
    for (unsigned i = 0; i < loop->facts->update_count; i++) {
        const site *self = &bins->sites[i];
        if (self->update->array != array || self->tag != tag)
            continue;
        tag++;
        if (tag < bins->tag_counts[array])
            buffer_format(&out, "if (redcc__tag == %u) { %s} else ", self->tag, self->text);
        else
            buffer_format(&out, tag > 1 ? "{ %s}" : "%s", self->text);
    }
    const char *text = arena_copy(loop->arena, out.data ? out.data : "", out.length);
    buffer_free(&out);
    return text;
}

static void write_record(loop_text *loop, writer *out, unsigned array) {
    const unsigned count = record_count(loop->bins, array);
    const char *const *types = &loop->bins->record_types[array * MOST_OPERANDS];
    if (count < 2)
        return;
    buffer members = {0};
    for (unsigned i = 0; i < count; i++)
        buffer_format(&members, "%s v%u; ", types[i], i);
    writer_line(out, "typedef struct { %s} %s;", members.data, record_name(loop, array));
    buffer_free(&members);
}

static bool is_exact(const loop_text *loop, unsigned number) {
    const reduction_array *array = &loop->facts->arrays[number];
    if (array->order_is_kept || array->is_interleaved || array->element->kind != IR_INTEGER)
        return false;
    for (unsigned i = 0; i < MOST_OPERANDS; i++) {
        const char *type = loop->bins->record_types[number * MOST_OPERANDS + i];
        if (type && (strcmp(type, "float") == 0 || strcmp(type, "double") == 0))
            return false;
    }
    return true;
}

void write_bins(loop_text *loop, writer *out) {
    const struct bins_text *bins = loop->bins;
    const unsigned count = loop->facts->array_count;
    writer_fill(out, true);
    for (unsigned i = 0; i < count; i++) {
        const char *element = origin_type(loop->arena, loop->facts->arrays[i].element);
        const unsigned bits = tag_bits(bins->tag_counts[i]);
        write_record(loop, out, i);
        if (record_count(bins, i) == 0)
            writer_line(out, "REDCC_APPLY_ALIKE(%s_%u, %s, %u, %s)", outlined_name(loop, "apply"),
                        i, element, bits, updates_text(loop, i));
        else
            writer_line(out, "REDCC_APPLY(%s_%u, %s, %s, %u, %s)", outlined_name(loop, "apply"), i,
                        element, record_name(loop, i), bits, updates_text(loop, i));
    }
    writer_fill(out, false);
}

void write_streams(loop_text *loop, writer *out) {
    const unsigned count = loop->facts->array_count;
    for (unsigned i = 0; i < count; i++) {
        const char *record = record_name(loop, i);
        writer_line(out, "%sREDCC_STREAM(%s_%u, %u, %s, %s, %u, %d)%s",
                    i == 0 ? "static const redcc_stream redcc__streams[] = {" : "",
                    outlined_name(loop, "apply"), i, i,
                    origin_type(loop->arena, loop->facts->arrays[i].element),
                    record ? arena_format(loop->arena, "sizeof(%s)", record) : "0",
                    tag_bits(loop->bins->tag_counts[i]), is_exact(loop, i),
                    i + 1 < count ? "," : "};");
    }
}

/** May all updates be made on private copies? */
static bool are_all_exact(const loop_text *loop) {
    for (unsigned i = 0; i < loop->facts->array_count; i++)
        if (!is_exact(loop, i))
            return false;
    return true;
}

const char *bins_phase(loop_text *loop) {
    return arena_format(loop->arena, "REDCC_BINS_%u, %uu, %d", loop->facts->array_count,
                        loop->bins->told_sources, are_all_exact(loop));
}
