/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Numbers the objects that have the same name, so that the text form can distinguish them. */
#include <stdint.h>
#include <string.h>

#include "ir/ir_printer.h"

/* ---- counting ------------------------------------------------------------------------------ */

static unsigned count_of(const map *m, const void *key, size_t length) {
    return (unsigned)(uintptr_t)map_get(m, key, length);
}

static unsigned count_up(map *m, const void *key, size_t length) {
    void **value = map_at(m, key, length);
    *value = (void *)((uintptr_t)*value + 1);
    return (unsigned)(uintptr_t)*value;
}

/* ---- locals without a declarator ----------------------------------------------------------- */

static bool mark_declared(ir_node *node, void *context) {
    if (node->kind == IR_DECLARATOR)
        ((bool *)context)[node->variable->id] = true;
    return true;
}

/* Returns, for each function id, a NULL-terminated list of the locals that have no declarator in
 * the function's body because they are declared inside an opaque node. */
static ir_variable ***undeclared_locals(const ir_printer *p) {
    const ir_unit *unit = p->unit;
    bool *declared = ARENA_ARRAY(p->scratch, bool, unit->variable_count + 1u);
    ir_variable ***lists = ARENA_ARRAY(p->scratch, ir_variable **, unit->function_count + 1u);
    unsigned *counts = ARENA_ARRAY(p->scratch, unsigned, unit->function_count + 1u);
    for (unsigned i = 0; i < unit->function_count; i++) {
        const ir_function *f = unit->functions[i];
        for (unsigned k = 0; k < f->parameter_count; k++)
            declared[f->parameters[k]->id] = true;
        if (f->body != NULL)
            ir_walk(f->body, mark_declared, declared);
    }
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function != NULL)
            counts[unit->variables[i]->function->id]++;
    for (unsigned i = 0; i < unit->function_count; i++) {
        lists[i] = ARENA_ARRAY(p->scratch, ir_variable *, counts[i] + 1u);
        counts[i] = 0;
    }
    for (unsigned i = 0; i < unit->variable_count; i++) {
        ir_variable *v = unit->variables[i];
        if (v->function != NULL && !declared[i] && v->stands_for == NULL)
            lists[v->function->id][counts[v->function->id]++] = v;
    }
    return lists;
}

/* ---- numbering, in the order of the text --------------------------------------------------- */

static void find_records(ir_printer *p, const ir_type *type) {
    for (; type != NULL; type = type->target) {
        if (count_up(p->seen_types, &type, sizeof type) > 1)
            return;
        const ir_record *record = type->record;
        if (record == NULL || map_get(p->record_numbers, &record, sizeof record) != NULL)
            continue;
        VECTOR_PUSH(p->scratch, &p->records, record);
        uintptr_t number = count_up(p->record_names, record->name, strlen(record->name));
        *map_at(p->record_numbers, &record, sizeof record) = (void *)number;
        for (unsigned i = 0; i < record->field_count; i++)
            find_records(p, record->fields[i].type);
    }
}

/* Assigns a number to a variable, unless it has one. Locals are numbered after the file's variable
 * of the same name: if the file has an `x`, a function's first `x` has number 2. */
static void meet_variable(ir_printer *p, const ir_variable *v) {
    if (p->variable_numbers[v->id] != 0)
        return;
    find_records(p, v->type);
    unsigned *number = &p->variable_numbers[v->id];
    if (v->function == NULL) {
        *number = count_up(p->variable_names, v->name, strlen(v->name));
        return;
    }
    const char *key = arena_format(p->scratch, "%u %s", v->function->id, v->name);
    *number = count_up(p->variable_names, key, strlen(key)) +
              count_of(p->variable_names, v->name, strlen(v->name));
}

static bool meet_node(ir_node *node, void *context) {
    find_records(context, node->type);
    if (node->kind == IR_DECLARATOR)
        meet_variable(context, node->variable);
    return true;
}

static void meet_function(ir_printer *p, const ir_function *f) {
    find_records(p, f->type);
    for (unsigned i = 0; i < f->parameter_count; i++)
        meet_variable(p, f->parameters[i]);
    for (ir_variable **local = p->undeclared[f->id]; *local != NULL; local++)
        meet_variable(p, *local);
    if (f->body != NULL)
        ir_walk(f->body, meet_node, p);
}

void ir_printer_begin(ir_printer *p, buffer *out, arena *scratch, const ir_unit *unit) {
    *p = (ir_printer){.out = out, .scratch = scratch, .unit = unit};
    p->record_numbers = map_new(scratch);
    p->record_names = map_new(scratch);
    p->variable_names = map_new(scratch);
    p->seen_types = map_new(scratch);
    if (unit == NULL)
        return;
    p->variable_numbers = ARENA_ARRAY(scratch, unsigned, unit->variable_count + 1u);
    p->undeclared = undeclared_locals(p);
    p->function_numbers = ARENA_ARRAY(scratch, unsigned, unit->function_count + 1u);
    map *function_names = map_new(scratch);
    for (unsigned i = 0; i < unit->function_count; i++) {
        const char *name = unit->functions[i]->name;
        p->function_numbers[i] = count_up(function_names, name, strlen(name));
    }
    for (unsigned i = 0; i < unit->variable_count; i++)
        if (unit->variables[i]->function == NULL)
            meet_variable(p, unit->variables[i]);
    for (unsigned i = 0; i < unit->function_count; i++)
        meet_function(p, unit->functions[i]);
}

/* ---- keys ---------------------------------------------------------------------------------- */

static void print_key(const ir_printer *p, const char *name, unsigned number) {
    buffer_text(p->out, name);
    if (number > 1 || name[0] == 0)
        buffer_format(p->out, ".%u", number);
}

void ir_print_variable_key(const ir_printer *p, const ir_variable *variable) {
    bool is_known = p->unit != NULL && variable->id < p->unit->variable_count;
    print_key(p, variable->name, is_known ? p->variable_numbers[variable->id] : 1);
}

void ir_print_function_key(const ir_printer *p, const ir_function *function) {
    bool is_known = p->unit != NULL && function->id < p->unit->function_count;
    print_key(p, function->name, is_known ? p->function_numbers[function->id] : 1);
}

void ir_print_record_key(const ir_printer *p, const ir_record *record) {
    unsigned number = count_of(p->record_numbers, &record, sizeof record);
    print_key(p, record->name, number > 0 ? number : 1);
}
