/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "ir/ir_adopt.h"

#include <assert.h>
#include <ctype.h>
#include <string.h>

#include "ir/ir_digest.h"
#include "support/vector.h"

typedef struct adoption {
    ir_unit *unit;
    ir_unit *from;
    ir_adoptable may_be;
    void *context;
    map *functions, *variables, *types, *records; /* maps from objects of `from` to the unit's */
    uint64_t *digests; /* digests of the functions of `from`, by id, computed before any of their
                        * nodes change */
    map *own_records;  /* a record's spelling -> a type of the unit */
    VECTOR(ir_function *) added;
    VECTOR(ir_function *) bodies; /* functions whose bodies are still to be processed */
    VECTOR(ir_variable *) more;   /* variables to be added to the unit */
} adoption;

/* ---- records --------------------------------------------------------------------------------- */

static void note_record(adoption *d, const ir_type *type) {
    for (; type; type = type->target) {
        const ir_record *record = type->record;
        if (!record || !record->spelling || !record->is_complete)
            continue;
        void **known = map_at(d->own_records, record->spelling, strlen(record->spelling));
        if (*known)
            return;
        *known = (void *)type;
        for (unsigned i = 0; i < record->field_count; i++)
            note_record(d, record->fields[i].type);
    }
}

static bool note_node(ir_node *node, void *context) {
    note_record(context, node->type);
    return true;
}

static void note_records(adoption *d) {
    for (unsigned i = 0; i < d->unit->variable_count; i++)
        note_record(d, d->unit->variables[i]->type);
    for (unsigned i = 0; i < d->unit->function_count; i++) {
        note_record(d, d->unit->functions[i]->type);
        if (d->unit->functions[i]->body)
            ir_walk(d->unit->functions[i]->body, note_node, d);
    }
}

static bool records_alike(const ir_record *a, const ir_record *b, unsigned depth);

/* Are types of two parses equal? Records behind pointers are compared by name, other records by
 * their contents. `depth` is the number of enclosing records. */
static bool types_alike(const ir_type *a, const ir_type *b, unsigned depth) {
    bool is_pointee = false;
    while (a && b && a->kind == b->kind && (a->kind == IR_POINTER || a->kind == IR_ARRAY)) {
        if (a->count != b->count || a->is_volatile != b->is_volatile)
            return false;
        is_pointee |= a->kind == IR_POINTER;
        a = a->target;
        b = b->target;
    }
    if (!a || !b || a->kind != b->kind || a->is_volatile != b->is_volatile ||
        a->is_atomic != b->is_atomic)
        return a == b;
    if (a->kind != IR_RECORD)
        return ir_type_equal(a, b);
    return is_pointee ? source_same_text(a->record->spelling, b->record->spelling)
                      : records_alike(a->record, b->record, depth + 1);
}

static bool records_alike(const ir_record *a, const ir_record *b, unsigned depth) {
    if (depth > 8 || !source_same_text(a->spelling, b->spelling) || a->is_union != b->is_union ||
        a->size != b->size || a->alignment != b->alignment || a->field_count != b->field_count ||
        a->is_complete != b->is_complete)
        return false;
    for (unsigned i = 0; i < a->field_count; i++) {
        const ir_field *x = &a->fields[i], *y = &b->fields[i];
        if (strcmp(x->name, y->name) != 0 || x->offset != y->offset ||
            x->is_bit_field != y->is_bit_field || !types_alike(x->type, y->type, depth))
            return false;
    }
    return true;
}

static const ir_type *adopt_type(adoption *d, const ir_type *type);

/* Returns the unit's own record if it has an equal one. Otherwise returns a copy, which the unit's
 * text cannot name. */
static const ir_record *adopt_record(adoption *d, const ir_record *record) {
    void **known = map_at(d->records, &record, sizeof record);
    if (*known)
        return *known;
    const ir_type *own = record->spelling
                             ? map_get(d->own_records, record->spelling, strlen(record->spelling))
                             : NULL;
    if (own && records_alike(own->record, record, 0)) {
        *known = (void *)own->record;
        return own->record;
    }
    ir_record *copy = ARENA_NEW(d->unit->arena, ir_record);
    *known = copy;
    *copy = *record;
    copy->spelling = NULL;
    ir_field *fields = ARENA_ARRAY(d->unit->arena, ir_field, record->field_count + 1u);
    copy->fields = fields;
    for (unsigned i = 0; i < record->field_count; i++) {
        fields[i] = record->fields[i];
        fields[i].type = adopt_type(d, fields[i].type);
    }
    return copy;
}

static const ir_field *adopt_field(adoption *d, const ir_record *record, const ir_field *field) {
    if (!record || field < record->fields || field >= record->fields + record->field_count)
        return NULL;
    return &adopt_record(d, record)->fields[field - record->fields];
}

/* ---- types ----------------------------------------------------------------------------------- */

static const ir_type *adopt_type(adoption *d, const ir_type *type) {
    if (!type)
        return NULL;
    void **known = map_at(d->types, &type, sizeof type);
    if (*known)
        return *known;
    ir_type *copy = ARENA_NEW(d->unit->arena, ir_type);
    *known = copy;
    *copy = *type;
    copy->target = adopt_type(d, type->target);
    copy->record = type->record ? adopt_record(d, type->record) : NULL;
    copy->tag = NULL;
    if (copy->record && copy->record != type->record && copy->record->spelling) {
        const ir_type *own =
            map_get(d->own_records, copy->record->spelling, strlen(copy->record->spelling));
        copy->tag = own ? own->tag : NULL;
    }
    if (type->kind != IR_FUNCTION_TYPE && type->kind != IR_OTHER_TYPE)
        copy->spelling = ir_type_default_spelling(d->unit->arena, copy);
    return copy;
}

/* ---- variables ------------------------------------------------------------------------------- */

static ir_variable *own_variable(const adoption *d, const ir_variable *v, const ir_type *type) {
    for (unsigned i = 0; i < d->unit->variable_count; i++) {
        ir_variable *own = d->unit->variables[i];
        if (!own->function && own->storage == v->storage && strcmp(own->name, v->name) == 0 &&
            (own->storage == IR_GLOBAL || own->storage == IR_THREAD_LOCAL) &&
            ir_type_equal(own->type, type))
            return own;
    }
    return NULL;
}

static ir_function *adopt_function(adoption *d, ir_function *function);

static ir_variable *adopt_variable(adoption *d, ir_variable *v) {
    void **known = map_at(d->variables, &v, sizeof v);
    if (*known)
        return *known;
    v->type = adopt_type(d, v->type);
    ir_variable *own = v->function ? NULL : own_variable(d, v, v->type);
    if (own) {
        own->address_taken |= v->address_taken;
        own->has_other_name |= v->has_other_name;
        *known = own;
        return own;
    }
    *known = v;
    v->range = (ir_range){0};
    v->declared = NULL;
    v->is_unnamed = true;
    if (v->storage == IR_STATIC) { /* functions of the other file may change it, as if it were
                                    * external */
        v->storage = IR_GLOBAL;
        v->name = arena_format(d->unit->arena, "%s of %s", v->name, d->from->source->path);
    }
    VECTOR_PUSH(d->unit->arena, &d->more, v);
    v->id = d->unit->variable_count + d->more.count - 1;
    return v;
}

/* ---- functions ------------------------------------------------------------------------------- */

static ir_function *own_function(const adoption *d, const char *name) {
    for (unsigned i = 0; i < d->unit->function_count; i++)
        if (!d->unit->functions[i]->linkage.is_static &&
            strcmp(d->unit->functions[i]->name, name) == 0)
            return d->unit->functions[i];
    for (unsigned i = 0; i < d->added.count; i++)
        if (!d->added.items[i]->linkage.is_static && strcmp(d->added.items[i]->name, name) == 0)
            return d->added.items[i];
    return NULL;
}

static bool is_taken(const adoption *d, const ir_function *function) {
    return function->body &&
           (function->linkage.is_static || d->may_be(d->from, function, d->context));
}

/* May a value of type `other` be passed as `own`? True for equal types, and for pointers to
 * structures of the same name that `own` leaves incomplete. */
static bool is_passed_as(const ir_type *own, const ir_type *other) {
    if (ir_type_equal(own, other))
        return true;
    const ir_record *x = own->kind == IR_POINTER ? own->target->record : NULL;
    const ir_record *y = other->kind == IR_POINTER ? other->target->record : NULL;
    return x && y && !x->is_complete && x->name[0] && strcmp(x->name, y->name) == 0;
}

static bool agrees(adoption *d, const ir_function *own, const ir_function *other) {
    if (own->parameter_count != other->parameter_count || own->is_variadic || own->is_noreturn ||
        other->is_noreturn || own->has_other_attributes || own->linkage.is_renamed ||
        own->linkage.is_weak || own->has_errors ||
        !is_passed_as(own->type->target, adopt_type(d, other->type->target)))
        return false;
    for (unsigned i = 0; i < own->parameter_count; i++)
        if (!is_passed_as(own->parameters[i]->type, adopt_type(d, other->parameters[i]->type)))
            return false;
    return true;
}

static void take_body(adoption *d, ir_function *own, ir_function *other, uint64_t digest) {
    assert(other->body && (own == other || !own->body));
    arena *a = d->unit->arena;
    ir_import *import = ARENA_NEW(a, ir_import);
    *import = (ir_import){d->from->source->path, digest};
    own->linkage.import = import;
    own->body = other->body;
    own->is_in_main_file = false;
    own->linkage.is_weak = own->linkage.is_interposable = false;
    if (own != other) {
        own->parameters = other->parameters;
        own->range = (ir_range){0};
    }
    VECTOR_PUSH(a, &d->bodies, own);
}

static ir_function *adopt_function(adoption *d, ir_function *function) {
    void **known = map_at(d->functions, &function, sizeof function);
    if (*known)
        return *known;
    ir_function *own = function->linkage.is_static ? NULL : own_function(d, function->name);
    const bool is_body_taken = is_taken(d, function);
    assert(d->from->functions[function->id] == function);
    const uint64_t digest = d->digests[function->id];
    if (own && ((!own->body && agrees(d, own, function)) || !function->body)) {
        *known = own;
        if (is_body_taken && !own->body)
            take_body(d, own, function, digest);
        return own;
    }
    *known = function;
    VECTOR_PUSH(d->unit->arena, &d->added, function);
    function->id = d->unit->function_count + d->added.count - 1;
    function->type = adopt_type(d, function->type);
    function->range = (ir_range){0};
    function->declared = NULL;
    function->is_in_main_file = false;
    for (unsigned i = 0; i < function->parameter_count; i++)
        adopt_variable(d, function->parameters[i]);
    if (is_body_taken && !own)
        take_body(d, function, function, digest);
    else
        function->body = NULL; /* its body stays unknown */
    return function;
}

/* ---- bodies ---------------------------------------------------------------------------------- */

/* Replaces the name of a constant, which has no meaning in this file, by its value. */
static void spell_number(arena *a, ir_node *node) {
    if (!(node->flags & IR_HAS_VALUE) ||
        (node->kind == IR_NUMBER && node->text && isdigit((unsigned char)node->text[0])))
        return;
    const char *spelling = node->type ? node->type->spelling : NULL;
    node->kind = IR_NUMBER;
    node->text =
        arena_format(a, "((%s)%lldLL)", spelling ? spelling : "int", (long long)node->value);
}

static bool adopt_node(ir_node *node, void *context) {
    adoption *d = context;
    if (node->field) {
        const ir_type *object = node->child_count ? node->children[0]->type : NULL;
        if (object && (node->flags & IR_ARROW))
            object = object->target;
        const ir_field *field = adopt_field(d, object ? object->record : NULL, node->field);
        if (field)
            node->field = field;
    }
    if (node->variable)
        node->variable = adopt_variable(d, node->variable);
    if (node->function)
        node->function = adopt_function(d, node->function);
    node->range = (ir_range){0};
    if (node->kind == IR_NUMBER || node->kind == IR_SIZEOF)
        spell_number(d->unit->arena, node);
    return true;
}

/* Runs after adopt_node, which finds a field by its object's type in `from`. */
static bool adopt_node_type(ir_node *node, void *context) {
    node->type = adopt_type(context, node->type);
    return true;
}

static void adopt_bodies(adoption *d) {
    for (unsigned i = 0; i < d->bodies.count; i++) { /* the list grows during the loop */
        ir_function *function = d->bodies.items[i];
        for (unsigned k = 0; k < function->parameter_count; k++)
            adopt_variable(d, function->parameters[k]);
        ir_walk(function->body, adopt_node, d);
        ir_walk(function->body, adopt_node_type, d);
        for (unsigned k = 0; k < d->from->variable_count; k++) {
            ir_variable *v = d->from->variables[k];
            const void *of = v->function;
            if (of && map_get(d->functions, &of, sizeof of) == function)
                v->function = function;
        }
        ir_finish_function(function);
    }
}

static void note_digests(adoption *d) {
    d->digests = ARENA_ARRAY(d->unit->arena, uint64_t, d->from->function_count + 1u);
    for (unsigned i = 0; i < d->from->function_count; i++) {
        const ir_function *function = d->from->functions[i];
        if (function->body && !function->linkage.is_static)
            d->digests[function->id] = ir_digest(d->from, function);
    }
}

/* ---- the unit -------------------------------------------------------------------------------- */

static void *joined(arena *a, const void *old, unsigned count, const void *more, unsigned added) {
    void **all = ARENA_ARRAY(a, void *, count + added + 1u);
    if (count)
        memcpy(all, old, count * sizeof *all);
    if (added)
        memcpy(all + count, more, added * sizeof *all);
    return all;
}

static void extend_unit(adoption *d) {
    ir_unit *unit = d->unit;
    unit->functions =
        joined(unit->arena, unit->functions, unit->function_count, d->added.items, d->added.count);
    unit->function_count += d->added.count;
    unit->variables =
        joined(unit->arena, unit->variables, unit->variable_count, d->more.items, d->more.count);
    unit->variable_count += d->more.count;
    assert(d->added.count == 0 ||
           unit->functions[unit->function_count - 1]->id == unit->function_count - 1);
    assert(d->more.count == 0 ||
           unit->variables[unit->variable_count - 1]->id == unit->variable_count - 1);
    ir_count_references(unit);
}

static ir_function *defined_by(const ir_unit *unit, const char *name) {
    for (unsigned i = 0; i < unit->function_count; i++)
        if (unit->functions[i]->body && !unit->functions[i]->linkage.is_static &&
            strcmp(unit->functions[i]->name, name) == 0)
            return unit->functions[i];
    return NULL;
}

unsigned ir_adopt(ir_unit *unit, ir_unit *from, unsigned count, const char *const *names,
                  ir_adoptable may_be, void *context) {
    arena *a = unit->arena;
    adoption d = {.unit = unit,
                  .from = from,
                  .may_be = may_be,
                  .context = context,
                  .functions = map_new(a),
                  .variables = map_new(a),
                  .types = map_new(a),
                  .records = map_new(a),
                  .own_records = map_new(a)};
    assert(unit != from && (names || count == 0));
    unsigned found = 0;
    note_records(&d);
    note_digests(&d);
    for (unsigned i = 0; i < count; i++) {
        ir_function *definition = defined_by(from, names[i]);
        ir_function *own = own_function(&d, names[i]);
        if (!own || own->body || !definition || !is_taken(&d, definition))
            continue;
        found += adopt_function(&d, definition) == own && own->body != NULL;
    }
    adopt_bodies(&d);
    extend_unit(&d);
    return found;
}
