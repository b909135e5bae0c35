/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads expressions and statements of the text form. */
#include <ctype.h>
#include <string.h>

#include "ir/ir_words.h"
#include "ir_reader/ir_reader.h"

/* ---- operands after the first word ----------------------------------------------------------- */

/* The items of a node's list that are no children, read from the left. */
typedef struct operands {
    const sexp *list;
    unsigned next;
} operands;

static const sexp *take(ir_reader *r, operands *o, const char *what) {
    if (o->next < o->list->count && o->list->items[o->next]->kind != SEXP_LIST)
        return o->list->items[o->next++];
    ir_reader_expected(r, o->next < o->list->count ? o->list->items[o->next] : o->list, what);
    return NULL;
}

static bool read_text(ir_reader *r, operands *o, ir_node *node, const char *what) {
    const sexp *text = take(r, o, what);
    node->text = text != NULL ? text->text : NULL;
    return text != NULL;
}

static ir_variable *find_variable(ir_reader *r, const char *key) {
    size_t length = strlen(key);
    ir_variable *v = r->local_names != NULL ? map_get(r->local_names, key, length) : NULL;
    return v != NULL ? v : map_get(r->file_names, key, length);
}

static bool read_variable(ir_reader *r, operands *o, ir_node *node) {
    const sexp *key = take(r, o, "a variable");
    if (key == NULL)
        return false;
    node->variable = find_variable(r, key->text);
    return node->variable != NULL || ir_reader_expected(r, key, "a variable declared before");
}

static bool read_function(ir_reader *r, operands *o, ir_node *node) {
    const sexp *name = take(r, o, "a function");
    if (name == NULL)
        return false;
    node->function = map_get(r->functions, name->text, strlen(name->text));
    return node->function != NULL || ir_reader_expected(r, name, "a function of this unit");
}

static bool is_attribute(const sexp *s) {
    return s->kind == SEXP_ATOM &&
           (s->text[0] == '@' || s->text[0] == '!' || s->text[0] == ':' || s->text[0] == '=');
}

static ir_storage declarator_storage(const sexp *list) {
    for (unsigned i = 1; i < list->count; i++) {
        const sexp *item = list->items[i];
        if (item->kind == SEXP_ATOM && strcmp(item->text, "!static-local") == 0)
            return IR_STATIC_LOCAL;
        if (item->kind == SEXP_ATOM && strcmp(item->text, "!thread-local") == 0)
            return IR_THREAD_LOCAL;
    }
    return IR_LOCAL;
}

/* Stands for the declarator's range until that is known. */
static const ir_range range_of_node = {.begin = 1, .end = 0};

/* Reads a declarator: with a type it makes a new variable, without one it refers to a variable
 * declared before. */
static bool read_declarator(ir_reader *r, operands *o, ir_node *node) {
    const sexp *list = o->list;
    bool has_type =
        list->count > 2 && list->items[2]->kind == SEXP_ATOM && !is_attribute(list->items[2]);
    if (!has_type)
        return read_variable(r, o, node);
    const sexp *key = take(r, o, "a variable's name");
    const ir_type *type = ir_read_type(r, list->items[o->next++], 0);
    if (key == NULL || type == NULL)
        return false;
    node->variable = ir_read_new_variable(r, key, declarator_storage(list));
    if (node->variable == NULL)
        return false;
    node->variable->type = type;
    node->variable->range = range_of_node;
    return true;
}

static bool read_operands(ir_reader *r, operands *o, ir_node *node) {
    switch (node->kind) {
    case IR_NUMBER:
        return read_text(r, o, node, "a number");
    case IR_STRING:
    case IR_SIZEOF:
    case IR_OPAQUE:
        return read_text(r, o, node, "a text");
    case IR_LABEL:
        return read_text(r, o, node, "a label");
    case IR_GOTO:
        return o->list->count < 2 || o->list->items[1]->kind == SEXP_LIST ||
               is_attribute(o->list->items[1]) || read_text(r, o, node, "a label");
    case IR_VARIABLE:
        return read_variable(r, o, node);
    case IR_FUNCTION:
        return read_function(r, o, node);
    case IR_DECLARATOR:
        return read_declarator(r, o, node);
    case IR_MEMBER: /* the field is found once the object's type is known */
        return read_text(r, o, node, "a field");
    default:
        return true;
    }
}

/* ---- attributes ---------------------------------------------------------------------------- */

static bool read_flag(ir_reader *r, const sexp *s, ir_node *node) {
    static const struct {
        const char *word;
        unsigned flag;
    } flags[] = {{"!designated", IR_DESIGNATED},
                 {"!macro", IR_FROM_MACRO},
                 {"!literal", IR_COMPOUND_LITERAL},
                 {"!sequence", IR_SEQUENCE},
                 {"!static-local", 0},
                 {"!thread-local", 0}};
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (strcmp(s->text, flags[i].word) == 0) {
            node->flags |= flags[i].flag;
            return true;
        }
    if (node->variable != NULL && strcmp(s->text, "!address-taken") == 0) {
        node->variable->address_taken = true;
        return true;
    }
    return ir_reader_expected(r, s, "a flag of a node");
}

static bool read_value(ir_reader *r, const sexp *s, ir_node *node) {
    node->flags &= ~(unsigned)IR_HAS_VALUE;
    if (strcmp(s->text, "=?") == 0)
        return true;
    node->flags |= IR_HAS_VALUE;
    return ir_read_integer(r, s, 1, &node->value);
}

static bool read_attribute(ir_reader *r, const sexp *s, ir_node *node) {
    switch (s->text[0]) {
    case '@':
        if (s->text[1] == '@' && node->kind == IR_DECLARATOR)
            return ir_read_range(r, s, 2, &node->variable->range);
        return ir_read_range(r, s, 1, &node->range);
    case '!':
        return read_flag(r, s, node);
    case ':':
        node->type = ir_read_type(r, s, 1);
        return node->type != NULL;
    default:
        return read_value(r, s, node);
    }
}

static bool read_attributes(ir_reader *r, operands *o, ir_node *node) {
    if (node->kind == IR_NUMBER && ir_literal_value(node->text, &node->value))
        node->flags |= IR_HAS_VALUE;
    while (o->next < o->list->count && is_attribute(o->list->items[o->next]))
        if (!read_attribute(r, o->list->items[o->next++], node))
            return false;
    if (node->kind == IR_DECLARATOR && node->variable->range.begin > node->variable->range.end)
        node->variable->range = node->range;
    return true;
}

/* ---- children ------------------------------------------------------------------------------ */

/* Reads a name or number that is a whole expression. */
static ir_node *read_atom(ir_reader *r, const sexp *s) {
    if (isdigit((unsigned char)s->text[0])) {
        ir_node *number = ir_new(r->arena, IR_NUMBER, NULL, 0);
        number->text = s->text;
        if (ir_literal_value(s->text, &number->value))
            number->flags |= IR_HAS_VALUE;
        return number;
    }
    ir_node *node = ir_new(r->arena, IR_VARIABLE, NULL, 0);
    node->variable = find_variable(r, s->text);
    if (node->variable == NULL) {
        node->kind = IR_FUNCTION;
        node->function = map_get(r->functions, s->text, strlen(s->text));
        if (node->function == NULL) {
            ir_reader_expected(r, s, "a variable or function declared before");
            return NULL;
        }
    }
    return node;
}

static ir_node *as_statement(ir_reader *r, ir_node *expression) {
    ir_node *statement = ir_new(r->arena, IR_EXPRESSION, NULL, 1);
    statement->children[0] = expression;
    statement->range = expression->range;
    statement->flags = expression->flags & IR_FROM_MACRO;
    return statement;
}

static bool expected_children(ir_reader *r, const sexp *list, const ir_kind_word *words) {
    const char *what =
        arena_format(r->arena, "%u to %u children", words->min_children, words->max_children);
    if (words->max_children == IR_ANY_NUMBER)
        what = arena_format(r->arena, "at least %u children", words->min_children);
    else if (words->max_children == words->min_children)
        what = arena_format(r->arena, "%u children", words->min_children);
    return ir_reader_expected(r, list, what);
}

static bool read_children(ir_reader *r, const operands *o, ir_node *node) {
    const ir_kind_word *words = ir_kind_words(node->kind);
    if (node->child_count < words->min_children || node->child_count > words->max_children)
        return expected_children(r, o->list, words);
    for (unsigned i = 0; i < node->child_count; i++) {
        ir_node *child = ir_read_node(r, o->list->items[o->next + i]);
        if (child == NULL)
            return false;
        if (ir_is_statement_place(node->kind, i) && ir_is_expression(child))
            child = as_statement(r, child);
        node->children[i] = child;
    }
    return true;
}

static const ir_field *field_at(const ir_record *record, const char *name) {
    for (unsigned i = 0; i < record->field_count; i++)
        if (record->fields[i].name[0] != 0 && strcmp(record->fields[i].name, name) == 0)
            return &record->fields[i];
    return NULL;
}

static bool read_field(ir_reader *r, const sexp *list, ir_node *node) {
    const ir_type *type = node->children[0]->type;
    if (type != NULL && (node->flags & IR_ARROW))
        type = type->target;
    const ir_record *record = type != NULL ? type->record : NULL;
    if (record == NULL)
        return ir_reader_expected(r, list,
                                  node->flags & IR_ARROW ? "a pointer to a struct or union"
                                                         : "an object of a struct or union");
    if (node->text[0] == '#') {
        int64_t index;
        if (!ir_read_integer(r, list->items[1], 1, &index))
            return false;
        if (index >= 0 && index < record->field_count)
            node->field = &record->fields[index];
    } else {
        node->field = field_at(record, node->text);
    }
    node->text = NULL;
    return node->field != NULL ||
           ir_reader_expected(r, list->items[1], "a field of this struct or union");
}

static bool find_type(ir_reader *r, const sexp *list, ir_node *node) {
    if (node->kind == IR_MEMBER && !read_field(r, list, node))
        return false;
    if (node->type == NULL)
        node->type = ir_infer_type(r->arena, node);
    if (node->type == NULL && node->kind != IR_OPAQUE && ir_is_expression(node))
        return ir_reader_expected(r, list, "a type (\":int\"), which cannot be inferred here");
    return true;
}

ir_node *ir_read_node(ir_reader *r, const sexp *s) {
    if (s->kind == SEXP_ATOM) {
        ir_node *leaf = read_atom(r, s);
        return leaf != NULL && find_type(r, s, leaf) ? leaf : NULL;
    }
    if (s->kind != SEXP_LIST || s->count == 0 || s->items[0]->kind != SEXP_ATOM) {
        ir_reader_expected(r, s, "a node: (kind ...)");
        return NULL;
    }
    ir_node *node = ir_new(r->arena, IR_EMPTY, NULL, 0);
    operands o = {.list = s, .next = 1};
    bool is_known = ir_word_node(s->items[0]->text, 2, node);
    if (is_known ? !read_operands(r, &o, node) || !read_attributes(r, &o, node)
                 : !read_attributes(r, &o, node))
        return NULL;
    unsigned child_count = s->count - o.next;
    if (child_count == 1 || !is_known) { /* "-" with one child is the unary operator */
        is_known = ir_word_node(s->items[0]->text, child_count, node);
        if (!is_known) {
            ir_reader_expected(r, s->items[0], "the word of a node");
            return NULL;
        }
    }
    node->child_count = child_count;
    node->children = child_count > 0 ? ARENA_ARRAY(r->arena, ir_node *, child_count) : NULL;
    return read_children(r, &o, node) && find_type(r, s, node) ? node : NULL;
}
