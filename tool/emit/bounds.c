/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Writes the extent of a table from which a called function reads the elements between two bounds.
 * The table's address and the bounds are read before the loop, by loads that cannot fault, because
 * the program might not read them at all. */
#include "analysis/base/expression.h"

#include "emit/base/names.h"
#include "emit/call.h"
#include "emit/text/origin.h"
#include <assert.h>

bool reads_by_system(const loop_text *loop) {
    for (unsigned i = 0; i < loop->plan->source_count; i++)
        if (loop->plan->sources[i].fact->extent == EXTENT_BOUNDED)
            return true;
    return loop->facts->variables.loads != NULL;
}

/** The reads that one extent needs, in the order in which they are written. */
typedef struct bounds_text {
    loop_text *loop;
    writer *out;
    unsigned source, count;
    const char *all; /* the condition that performs the reads and is true if all succeed */
    VECTOR(const ir_node *) loads;
} bounds_text;

static const char *value_text(bounds_text *self, const ir_node *node);

static const char *load_name(const bounds_text *self, unsigned number) {
    return arena_format(self->loop->arena, "redcc__bound_%u_%u", self->source, number);
}

/** The type of the variable into which a value of this type is read. */
static const char *loaded_type(const ir_type *type) {
    if (type->kind == IR_POINTER)
        return "const void *";
    if (type->kind == IR_FLOATING)
        return type->size == 4 ? "float" : type->size == 8 ? "double" : "long double";
    switch (type->size) {
    case 1:
        return "signed char";
    case 2:
        return "short";
    case 4:
        return "int";
    default:
        return "redcc_int";
    }
}

/** Returns the name of the variable that holds the node's value, which is read before the loop. If
 * there is no such variable yet, writes the read. */
static const char *load_text(bounds_text *self, const ir_node *node) {
    arena *a = self->loop->arena;
    for (unsigned i = 0; i < self->loads.count; i++)
        if (expression_same(self->loads.items[i], node))
            return load_name(self, i);
    int64_t offset = node->field->offset;
    const ir_node *object = node;
    while (!(object->flags & IR_ARROW)) {
        object = object->children[0];
        if (object->kind != IR_MEMBER) {
            loop_obstacle(self->loop, node->range,
                          "an expression of the loop cannot be written as C outside of it");
            return "0";
        }
        offset += object->field->offset;
    }
    const char *through = value_text(self, object->children[0]);
    const char *name = load_name(self, self->loads.count);
    VECTOR_PUSH(a, &self->loads, node);
    writer_line(self->out, "%s %s;", loaded_type(node->type), name);
    self->all =
        arena_format(a, "%s%sREDCC_LOAD(%s, %s, %s, %lld)", self->all, *self->all ? " && " : "",
                     outlined_name(self->loop, "site"), name, through, (long long)offset);
    return name;
}

static const char *value_text(bounds_text *self, const ir_node *node) {
    if (node->kind == IR_MEMBER)
        return load_text(self, node);
    if (node->kind == IR_CAST)
        return arena_format(self->loop->arena, "((%s)%s)",
                            origin_type(self->loop->arena, node->type),
                            value_text(self, node->children[0]));
    return loop_operand(self->loop, node);
}

void fill_bounded_extent(loop_text *loop, writer *out, unsigned number) {
    const element_bounds *bounds = loop->plan->sources[number].fact->bounds;
    arena *a = loop->arena;
    bounds_text self = {.loop = loop, .out = out, .source = number, .all = ""};
    assert(bounds && number < loop->plan->source_count);
    const char *conditions = "";
    writer_line(out, "{");
    out->depth++;
    const char *base = value_text(&self, bounds->base);
    const char *terms[BOUNDS_MOST_TERMS];
    for (unsigned i = 0; i < bounds->term_count; i++)
        terms[i] = bounds->terms[i].value ? value_text(&self, bounds->terms[i].value) : "0";
    for (unsigned i = 0; i < bounds->condition_count; i++)
        conditions = arena_format(a, "%s%s%s >= 0", conditions, i ? " && " : "",
                                  value_text(&self, bounds->conditions[i]));
    const char *all =
        arena_format(a, "%s%s%s", self.all, *self.all && *conditions ? " && " : "", conditions);
    writer_line(out, "if (%s) {", *all ? all : "1");
    out->depth++;
    for (unsigned i = 0; i < bounds->term_count; i++)
        writer_line(out,
                    "redcc_known_element(&redcc__known[%u], %s, (redcc_int)%s, %lld, %lld, "
                    "&redcc__unknown);",
                    number, base, terms[i], (long long)bounds->terms[i].offset,
                    (long long)bounds->element->size);
    out->depth--;
    writer_line(out, "} else {");
    out->depth++;
    writer_line(out, "redcc__unknown = 1;");
    out->depth--;
    writer_line(out, "}");
    out->depth--;
    writer_line(out, "}");
}
