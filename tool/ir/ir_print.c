/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Prints the text form of the IR; tool/ir/text_form.md has the grammar. */
#include <ctype.h>
#include <string.h>

#include "ir/ir_printer.h"
#include "ir/ir_text.h"
#include "ir/ir_words.h"

/* The deepest indentation. Without a limit, the text's size would be quadratic in the depth of
 * nesting. */
enum { DEEPEST_INDENTATION = 40 };

static void print_line(const ir_printer *p, unsigned depth) {
    buffer_byte(p->out, '\n');
    for (unsigned i = 0; i < depth && i < DEEPEST_INDENTATION; i++)
        buffer_text(p->out, "  ");
}

/** Prints " @begin-end", or nothing for the empty range. */
static void print_range(const ir_printer *p, ir_range range) {
    if (range.begin != range.end)
        buffer_format(p->out, " @%u-%u", range.begin, range.end);
}

static void print_quoted(const ir_printer *p, const char *text) {
    ir_print_quoted(p->out, text, strlen(text));
}

/* Is the text one atom that cannot be mistaken for an attribute? */
static bool is_word(const char *text) {
    if (text[0] == 0 || (text[0] == '.' && !isdigit((unsigned char)text[1])))
        return false;
    for (; *text != 0; text++)
        if (!isalnum((unsigned char)*text) && *text != '_' && *text != '.' && *text != '$' &&
            (unsigned char)*text < 128)
            return false;
    return true;
}

/** Appends the text, in quotes unless it is one atom. */
static void print_word(const ir_printer *p, const char *text) {
    if (is_word(text))
        buffer_text(p->out, text);
    else
        print_quoted(p, text);
}

/* ---- nodes --------------------------------------------------------------------------------- */

static const char *printable(const char *text) {
    return text != NULL ? text : "";
}

static void print_declarator(const ir_printer *p, const ir_variable *v, ir_range range) {
    buffer_byte(p->out, ' ');
    ir_print_variable_key(p, v);
    if (v->function == NULL) /* an extern declaration in a function: the unit's list of variables
                              * has its other properties */
        return;
    buffer_byte(p->out, ' ');
    ir_print_type(p, v->type);
    if (v->storage != IR_LOCAL)
        buffer_format(p->out, " !%s", ir_storage_word(v->storage));
    if (v->address_taken)
        buffer_text(p->out, " !address-taken");
    if (v->range.begin != range.begin || v->range.end != range.end)
        buffer_format(p->out, " @@%u-%u", v->range.begin, v->range.end);
}

static void print_field(const ir_printer *p, const ir_node *node) {
    const ir_record *record = NULL;
    const ir_type *type = node->children[0]->type;
    if (type != NULL && (node->flags & IR_ARROW))
        type = type->target;
    if (type != NULL)
        record = type->record;
    if (node->field->name[0] != 0 || record == NULL)
        buffer_format(p->out, " %s", node->field->name);
    else
        buffer_format(p->out, " #%u", (unsigned)(node->field - record->fields));
}

/* Prints what follows a node's first word: names and texts. */
static void print_operands(const ir_printer *p, const ir_node *node) {
    switch (node->kind) {
    case IR_NUMBER:
        buffer_byte(p->out, ' ');
        print_word(p, printable(node->text));
        break;
    case IR_STRING:
    case IR_SIZEOF:
    case IR_OPAQUE:
        buffer_byte(p->out, ' ');
        print_quoted(p, printable(node->text));
        break;
    case IR_GOTO:
    case IR_LABEL:
        if (node->text != NULL)
            buffer_format(p->out, " %s", node->text);
        break;
    case IR_VARIABLE:
        buffer_byte(p->out, ' ');
        ir_print_variable_key(p, node->variable);
        break;
    case IR_FUNCTION:
        buffer_byte(p->out, ' ');
        ir_print_function_key(p, node->function);
        break;
    case IR_MEMBER:
        print_field(p, node);
        break;
    case IR_DECLARATOR:
        print_declarator(p, node->variable, node->range);
        break;
    default:
        break;
    }
}

static void print_value(const ir_printer *p, const ir_node *node) {
    int64_t implied = 0;
    bool is_implied = node->kind == IR_NUMBER && ir_literal_value(node->text, &implied);
    bool has_value = (node->flags & IR_HAS_VALUE) != 0;
    if (has_value && !(is_implied && implied == node->value))
        buffer_format(p->out, " =%lld", (long long)node->value);
    if (!has_value && is_implied)
        buffer_text(p->out, " =?");
}

static void print_attributes(const ir_printer *p, const ir_node *node) {
    static const struct {
        unsigned flag;
        const char *word;
    } flags[] = {{IR_DESIGNATED, "designated"},
                 {IR_FROM_MACRO, "macro"},
                 {IR_COMPOUND_LITERAL, "literal"},
                 {IR_FROM_CALL, "call"},
                 {IR_SEQUENCE, "sequence"}};
    print_value(p, node);
    if (node->type != NULL && !ir_type_identical(node->type, ir_infer_type(p->scratch, node))) {
        buffer_text(p->out, " :");
        ir_print_type(p, node->type);
    }
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (node->flags & flags[i].flag)
            buffer_format(p->out, " !%s", flags[i].word);
    print_range(p, node->range);
}

/* Can a reader restore this IR_EXPRESSION node from the expression below it? If so, the node is not
 * printed. */
static bool is_implied_statement(const ir_node *node) {
    if (node->kind != IR_EXPRESSION)
        return false;
    const ir_node *e = node->children[0];
    return node->range.begin == e->range.begin && node->range.end == e->range.end &&
           ((node->flags ^ e->flags) & IR_FROM_MACRO) == 0;
}

static void print_tree(const ir_printer *p, const ir_node *node, unsigned depth) {
    if (node->flags & IR_DEAD)
        node = node->children[0];
    char word[16];
    buffer_format(p->out, "(%s", ir_node_word(node, word) ? word : "?");
    print_operands(p, node);
    print_attributes(p, node);
    for (unsigned i = 0; i < node->child_count; i++) {
        const ir_node *child = node->children[i];
        print_line(p, depth + 1);
        print_tree(p, is_implied_statement(child) ? child->children[0] : child, depth + 1);
    }
    buffer_byte(p->out, ')');
}

void ir_print_node(buffer *out, const ir_node *node) {
    ir_printer p;
    arena *scratch = arena_new();
    ir_printer_begin(&p, out, scratch, NULL);
    print_tree(&p, node, 0);
    buffer_byte(out, '\n');
    arena_free(scratch);
}

/* ---- records, variables, functions --------------------------------------------------------- */

static void print_field_declaration(const ir_printer *p, const ir_field *field) {
    print_line(p, 2);
    buffer_format(p->out, "(%s ", field->is_bit_field ? "bit-field" : "field");
    buffer_text(p->out, field->name[0] != 0 ? field->name : "\"\"");
    buffer_byte(p->out, ' ');
    ir_print_type(p, field->type);
    if (!field->is_bit_field)
        buffer_format(p->out, " %lld", (long long)field->offset);
    buffer_byte(p->out, ')');
}

static void print_record(const ir_printer *p, const ir_record *record) {
    const char *word = record->is_union ? "union" : "struct";
    print_line(p, 1);
    buffer_format(p->out, "(%s ", word);
    ir_print_record_key(p, record);
    if (record->size >= 0)
        buffer_format(p->out, " %lld", (long long)record->size);
    else if (record->is_complete)
        buffer_text(p->out, " ?");
    if (!record->is_complete)
        buffer_text(p->out, " !incomplete");
    const char *usual =
        record->name[0] != 0 ? arena_format(p->scratch, "%s %s", word, record->name) : NULL;
    if (record->spelling == NULL && usual != NULL)
        buffer_text(p->out, " !unnamed");
    if (record->spelling != NULL && (usual == NULL || strcmp(usual, record->spelling) != 0)) {
        buffer_byte(p->out, ' ');
        print_quoted(p, record->spelling);
    }
    for (unsigned i = 0; i < record->field_count; i++)
        print_field_declaration(p, &record->fields[i]);
    buffer_byte(p->out, ')');
}

static void print_variable(const ir_printer *p, const ir_variable *v, unsigned depth) {
    print_line(p, depth);
    buffer_format(p->out, "(%s ", ir_storage_word(v->storage));
    ir_print_variable_key(p, v);
    buffer_byte(p->out, ' ');
    ir_print_type(p, v->type);
    if (v->address_taken)
        buffer_text(p->out, " !address-taken");
    if (v->has_other_name)
        buffer_text(p->out, " !other-name");
    print_range(p, v->range);
    buffer_byte(p->out, ')');
}

static void print_function_flags(const ir_printer *p, const ir_function *f) {
    const struct {
        bool is_set;
        const char *word;
    } flags[] = {{f->linkage.is_static, "static"}, {f->is_variadic, "variadic"},
                 {f->is_noreturn, "noreturn"},     {f->is_attribute_pure, "pure"},
                 {f->is_attribute_const, "const"}, {f->has_other_attributes, "attributes"},
                 {f->linkage.is_weak, "weak"},     {f->linkage.is_renamed, "renamed"},
                 {f->has_errors, "errors"},        {!f->is_in_main_file, "header"}};
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (flags[i].is_set)
            buffer_format(p->out, " !%s", flags[i].word);
}

static void print_function(const ir_printer *p, const ir_function *f, ir_variable *const *locals) {
    print_line(p, 1);
    buffer_text(p->out, "(function ");
    ir_print_function_key(p, f);
    buffer_byte(p->out, ' ');
    ir_print_type(p, f->type->target);
    if (!ir_type_identical(f->type, ir_function_default_type(p->scratch, f, f->type->target))) {
        buffer_text(p->out, " :");
        ir_print_type(p, f->type);
    }
    print_function_flags(p, f);
    print_range(p, f->range);
    for (unsigned i = 0; i < f->parameter_count; i++)
        print_variable(p, f->parameters[i], 2);
    for (; *locals != NULL; locals++)
        print_variable(p, *locals, 2);
    if (f->body != NULL) {
        print_line(p, 2);
        print_tree(p, f->body, 2);
    }
    buffer_byte(p->out, ')');
}

static void print_directive(const ir_printer *p, const ir_directive *directive) {
    static const char *const words[] = {[IR_DIRECTIVE_IF] = "if",
                                        [IR_DIRECTIVE_ELSE] = "else",
                                        [IR_DIRECTIVE_ENDIF] = "endif",
                                        [IR_DIRECTIVE_PRAGMA] = "pragma",
                                        [IR_DIRECTIVE_OTHER] = "directive"};
    print_line(p, 1);
    buffer_format(p->out, "(%s ", words[directive->kind]);
    print_quoted(p, printable(directive->text));
    if (directive->is_skipped)
        buffer_text(p->out, " !skipped");
    print_range(p, directive->range);
    buffer_byte(p->out, ')');
}

void ir_print(buffer *out, const ir_unit *unit) {
    ir_printer p;
    arena *scratch = arena_new();
    ir_printer_begin(&p, out, scratch, unit);
    buffer_text(out, "(unit ");
    print_quoted(&p, unit->source->path);
    if (!unit->dialect.strict_aliasing)
        buffer_text(out, " !no-strict-aliasing");
    buffer_format(out, "\n  (bytes %u)", unit->source->length);
    if (unit->error_count > 0)
        buffer_format(out, "\n  (errors %u)", unit->error_count);
    for (unsigned i = 0; i < p.records.count; i++)
        print_record(&p, p.records.items[i]);
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function == NULL)
            print_variable(&p, unit->variables[i], 1);
    for (unsigned i = 0; i < unit->function_count; i++)
        print_function(&p, unit->functions[i], p.undeclared[i]);
    for (unsigned i = 0; i < unit->directive_count; i++)
        print_directive(&p, &unit->directives[i]);
    buffer_text(out, ")\n");
    arena_free(scratch);
}
