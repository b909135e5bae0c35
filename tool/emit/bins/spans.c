/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "emit/bins/spans.h"

#include "emit/base/names.h"
#include "emit/bins/bins.h"
#include "emit/text/origin.h"
#include "emit/text/print.h"

typedef struct span_names {
    loop_text *loop;
    const bins_span *span;
    ir_c_rename others;
} span_names;

/** A hook that replaces the span's counter by its first value. */
static const char *name_at_first(const ir_node *node, void *context) {
    const span_names *its = context;
    if (node->kind == IR_VARIABLE && node->variable == its->span->counted->counted.counter)
        return arena_format(its->loop->arena, "%lld", (long long)its->span->first);
    return its->others(node, its->loop);
}

static const char *span_text(loop_text *loop, const bins_record *record, const ir_node *node,
                             ir_c_rename name) {
    span_names names = {loop, record->span, name};
    const char *text = text_operand(loop->arena, node, name_at_first, &names);
    if (!text)
        loop_obstacle(loop, node->range, "an updated element cannot be spelled");
    return macro_argument(loop->arena, text ? text : "0");
}

const char *push_span_text(loop_text *loop, const bins_record *record, ir_c_rename name) {
    const bins_span *span = record->span;
    const reduction_update *update = record->updates[0];
    const counted_loop *counted = &span->counted->counted;
    const bool is_scattered = loop->facts->arrays[update->array].is_scattered;
    const ir_node *load = row_load_of(loop->facts, update);
    const char *from = load ? arena_format(loop->arena, "&%s", span_text(loop, record, load, name))
                       : is_scattered ? "0"
                                      : loop->arrays[update->array].local;
    buffer out = {0};
    buffer_format(&out, "REDCC_PUSH_SPAN%s(%u, %u, %s, &%s, (redcc_int)%s - %lld, %s",
                  is_scattered ? "_BEHIND" : "", update->array, record->stream, from,
                  span_text(loop, record, update->target, name),
                  span_text(loop, record, counted->bound, name),
                  (long long)span->first - (counted->comparison == IR_OP_LESS_EQUAL),
                  bins_record_name(loop, record->stream));
    buffer_text(&out, ", (");
    for (unsigned i = 0; i < span->variable_count; i++)
        buffer_format(&out, "redcc__e.v%u = (%s)%s, ", i,
                      bins_kind_text(value_kind_of(span->variables[i]->type)),
                      origin_variable(loop->arena, span->variables[i]));
    buffer_text(&out, "0)) else ");
    return buffer_take(loop->arena, &out);
}

static const char *name_in_span(const ir_node *node, void *context) {
    const bins_record *record = context;
    return ir_is_expression(node) && is_updated_element(node, record->updates[0]->target)
               ? "(*redcc__to)"
               : NULL;
}

/** A declaration for an apply function: a local copy of one of the context's variables. */
static const char *copy_declaration(loop_text *loop, const ir_variable *variable) {
    const char *name = origin_declarator(loop->arena, variable);
    return variable->type->kind == IR_ARRAY
               ? declaration_text(loop, variable->type->target,
                                  arena_format(loop->arena, "*%s", name))
               : declaration_text(loop, variable->type, name);
}

/** Declares copies of the context's variables that the update's operands name. */
static void declare_captured(loop_text *loop, const reduction_update *update, const ir_node *node,
                             bool *is_declared, writer *out) {
    if (is_updated_element(node, update->target))
        return;
    if (node->kind == IR_VARIABLE && !is_declared[node->variable->id] &&
        loop->outline.is_passed[node->variable->id]) {
        is_declared[node->variable->id] = true;
        writer_line(out, "%s = redcc__context->%s;", copy_declaration(loop, node->variable),
                    node->variable->name);
    }
    for (unsigned i = 0; i < node->child_count; i++)
        declare_captured(loop, update, node->children[i], is_declared, out);
}

void write_apply_span(loop_text *loop, const bins_record *record, writer *out) {
    const bins_span *span = record->span;
    const reduction_update *update = record->updates[0];
    const ir_variable *counter = span->counted->counted.counter;
    const char *element = origin_type(loop->arena, loop->facts->arrays[update->array].element);
    bool *is_declared = ARENA_ARRAY(loop->arena, bool, loop->unit->variable_count + 1);
    is_declared[counter->id] = true;
    for (unsigned i = 0; i < span->variable_count; i++)
        is_declared[span->variables[i]->id] = true;
    writer_line(out, "REDCC_APPLY_SPANS(%s_%u, %s)", outlined_name(loop, "apply"), record->stream,
                outlined_name(loop, "context"));
    out->depth++;
    declare_captured(loop, update, update->statement, is_declared, out);
    writer_line(out, "REDCC_EACH_SPAN(%s, %s)", element, bins_record_name(loop, record->stream));
    for (unsigned i = 0; i < span->variable_count; i++)
        writer_line(out, "%s %s = (%s)redcc__e.v%u;",
                    origin_type(loop->arena, span->variables[i]->type),
                    origin_declarator(loop->arena, span->variables[i]),
                    origin_type(loop->arena, span->variables[i]->type), i);
    const char *type = origin_type(loop->arena, counter->type);
    const char *name = origin_variable(loop->arena, counter);
    const long long first = (long long)span->first;
    writer_line(out, "%s %s = (%s)(redcc__from + %lld);", type,
                origin_declarator(loop->arena, counter), type, first);
    writer_line(out, "const %s redcc__behind = (%s)(redcc__end + %lld);", type, type, first);
    writer_line(out, "for (; %s < redcc__behind; %s++, redcc__to++) {", name, name);
    out->depth++;
    printer p = {.arena = loop->arena,
                 .out = out,
                 .rename = name_in_span,
                 .context = (void *)(uintptr_t)record};
    print_statement(&p, update->statement);
    if (p.problem)
        loop_obstacle(loop, update->statement->range, "%s", p.problem);
    out->depth--;
    writer_line(out, "}");
    out->depth--;
    writer_line(out, "REDCC_SPANS_END");
}

void write_span_record(loop_text *loop, const bins_record *record, writer *out) {
    buffer members = {0};
    for (unsigned i = 0; i < record->span->variable_count; i++)
        buffer_format(&members, "%s v%u; ",
                      bins_kind_text(value_kind_of(record->span->variables[i]->type)), i);
    writer_line(out, "typedef struct { redcc_size first; redcc_int count; %s} %s;",
                members.data ? members.data : "", bins_record_name(loop, record->stream));
    buffer_free(&members);
}
