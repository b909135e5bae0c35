/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* The reader of the text form: records, variables, functions and directives. */
#include <ctype.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "ir/ir_words.h"
#include "ir_reader/ir_read.h"
#include "ir_reader/ir_reader.h"

bool ir_reader_expected(ir_reader *r, const sexp *at, const char *what) {
    if (r->message == NULL)
        r->message = sexp_expected(r->arena, at, what);
    return false;
}

bool ir_read_integer(ir_reader *r, const sexp *atom, size_t skip, int64_t *value) {
    char *end;
    errno = 0;
    if (atom->kind == SEXP_ATOM && atom->text[skip] != 0) {
        *value = strtoll(atom->text + skip, &end, 10);
        if (*end == 0 && errno == 0)
            return true;
    }
    return ir_reader_expected(r, atom, "a number");
}

bool ir_read_range(ir_reader *r, const sexp *atom, size_t skip, ir_range *range) {
    const char *text = atom->text + skip;
    char *end;
    if (isdigit((unsigned char)*text)) {
        unsigned long long begin = strtoull(text, &end, 10);
        if (*end == '-' && isdigit((unsigned char)end[1])) {
            unsigned long long stop = strtoull(end + 1, &end, 10);
            if (*end == 0 && begin <= stop && stop <= UINT32_MAX) {
                *range = (ir_range){.begin = (uint32_t)begin, .end = (uint32_t)stop};
                return true;
            }
        }
    }
    return ir_reader_expected(r, atom, "a range: @begin-end");
}

const char *ir_key_name(arena *a, const char *key) {
    const char *dot = strrchr(key, '.');
    if (dot == NULL || dot[1] == 0 || dot[1 + strspn(dot + 1, "0123456789")] != 0)
        return key;
    return arena_copy(a, key, (size_t)(dot - key));
}

static bool is_word(const sexp *s, const char *word) {
    return s->kind == SEXP_ATOM && strcmp(s->text, word) == 0;
}

static bool has_word(const sexp *list, const char *word) {
    return list->kind == SEXP_LIST && list->count > 0 && is_word(list->items[0], word);
}

/* ---- records ------------------------------------------------------------------------------- */

static bool is_record(const sexp *s) {
    return has_word(s, "struct") || has_word(s, "union");
}

/* Sizes and spellings are read before any type, so that records may be in any order. */
static bool read_record_head(ir_reader *r, const sexp *s, unsigned *next, ir_record *record) {
    for (; *next < s->count && s->items[*next]->kind != SEXP_LIST; ++*next) {
        const sexp *item = s->items[*next];
        if (item->kind == SEXP_STRING)
            record->spelling = item->text;
        else if (is_word(item, "!incomplete"))
            record->is_complete = false;
        else if (is_word(item, "!unnamed"))
            record->spelling = NULL;
        else if (!is_word(item, "?") && !ir_read_integer(r, item, 0, &record->size))
            return false;
    }
    return true;
}

static bool declare_record(ir_reader *r, const sexp *s) {
    if (s->count < 2 || s->items[1]->kind != SEXP_ATOM)
        return ir_reader_expected(r, s, "the name of a struct or union");
    const char *key = s->items[1]->text;
    void **place = map_at(r->records, key, strlen(key));
    if (*place != NULL)
        return ir_reader_expected(r, s->items[1], "a name not used before (\"name.2\")");
    ir_record *record = ARENA_NEW(r->arena, ir_record);
    *place = record;
    record->name = ir_key_name(r->arena, key);
    record->is_union = is_word(s->items[0], "union");
    record->is_complete = true;
    record->size = -1;
    if (record->name[0] != 0)
        record->spelling = arena_format(r->arena, "%s %s", s->items[0]->text, record->name);
    unsigned next = 2;
    return read_record_head(r, s, &next, record);
}

/* Returns the natural alignment under LP64, for offsets that the text omits. */
static int64_t alignment(const ir_type *type) {
    type = ir_type_innermost(type);
    if (type->kind == IR_COMPLEX)
        return type->size / 2;
    if (type->kind != IR_RECORD)
        return type->size > 0 ? type->size : 1;
    int64_t most = 1;
    for (unsigned i = 0; i < type->record->field_count; i++) {
        int64_t one = alignment(type->record->fields[i].type);
        most = one > most ? one : most;
    }
    return most;
}

static int64_t rounded_up(int64_t offset, int64_t to) {
    return (offset + to - 1) / to * to;
}

static bool read_field(ir_reader *r, const sexp *s, ir_field *field, int64_t natural_end) {
    bool is_bit_field = has_word(s, "bit-field");
    if (!is_bit_field && !has_word(s, "field"))
        return ir_reader_expected(r, s, "(field name type [offset]) or (bit-field name type)");
    if (s->count < 3 || s->items[1]->kind == SEXP_LIST)
        return ir_reader_expected(r, s, "a field's name and type");
    field->name = s->items[1]->text;
    field->type = ir_read_type(r, s->items[2], 0);
    if (field->type == NULL)
        return false;
    field->is_bit_field = is_bit_field;
    field->offset = is_bit_field ? -1 : rounded_up(natural_end, alignment(field->type));
    if (s->count > 4 || (s->count == 4 && is_bit_field))
        return ir_reader_expected(r, s->items[3], "nothing more of the field");
    return s->count < 4 || ir_read_integer(r, s->items[3], 0, &field->offset);
}

static bool size_is_given(const sexp *s) {
    return s->count > 2 && s->items[2]->kind == SEXP_ATOM && s->items[2]->text[0] != '!';
}

static bool read_record(ir_reader *r, const sexp *s) {
    const char *key = s->items[1]->text;
    ir_record *record = map_get(r->records, key, strlen(key));
    unsigned next = 2;
    while (next < s->count && s->items[next]->kind != SEXP_LIST)
        next++;
    ir_field *fields = ARENA_ARRAY(r->arena, ir_field, s->count - next + 1u);
    record->fields = fields;
    int64_t end = 0, widest = 1;
    for (; next < s->count; next++) {
        ir_field *field = &fields[record->field_count];
        if (!read_field(r, s->items[next], field, record->is_union ? 0 : end))
            return false;
        record->field_count++;
        int64_t size = field->type->size < 0 ? 0 : field->type->size;
        int64_t field_end = (field->is_bit_field ? end : field->offset) + size;
        end = field_end > end ? field_end : end;
        widest = alignment(field->type) > widest ? alignment(field->type) : widest;
    }
    if (record->is_complete && !size_is_given(s))
        record->size = rounded_up(end, widest);
    return true;
}

/* ---- variables ----------------------------------------------------------------------------- */

ir_variable *ir_read_new_variable(ir_reader *r, const sexp *key, ir_storage storage) {
    map *names = r->function != NULL ? r->local_names : r->file_names;
    size_t length = strlen(key->text);
    void **place = map_at(names, key->text, length);
    if (*place != NULL || map_get(r->file_names, key->text, length) != NULL) {
        ir_reader_expected(r, key, "a name not used before (\"name.2\")");
        return NULL;
    }
    ir_variable *v = ARENA_NEW(r->arena, ir_variable);
    v->name = ir_key_name(r->arena, key->text);
    v->storage = storage;
    v->function = r->function;
    v->id = r->variables.count;
    *map_at(names, key->text, length) = v;
    VECTOR_PUSH(r->arena, &r->variables, v);
    return v;
}

static bool read_variable_attributes(ir_reader *r, const sexp *s, ir_variable *v) {
    for (unsigned i = 3; i < s->count; i++) {
        const sexp *item = s->items[i];
        if (is_word(item, "!address-taken"))
            v->address_taken = true;
        else if (is_word(item, "!other-name"))
            v->has_other_name = true;
        else if (item->kind != SEXP_ATOM || item->text[0] != '@')
            return ir_reader_expected(r, item, "!address-taken, !other-name or @begin-end");
        else if (!ir_read_range(r, item, 1, &v->range))
            return false;
    }
    return true;
}

static ir_variable *read_variable(ir_reader *r, const sexp *s, ir_storage storage) {
    if (s->count < 3 || s->items[1]->kind != SEXP_ATOM) {
        ir_reader_expected(r, s, "a variable's name and type");
        return NULL;
    }
    const ir_type *type = ir_read_type(r, s->items[2], 0);
    if (type == NULL)
        return NULL;
    ir_variable *v = ir_read_new_variable(r, s->items[1], storage);
    if (v == NULL || !read_variable_attributes(r, s, v))
        return NULL;
    v->type = type;
    return v;
}

/* Is `s` a declaration of a variable with a storage permitted here? Sets *storage. */
static bool is_variable(const sexp *s, bool is_in_function, ir_storage *storage) {
    static const ir_storage of_file[] = {IR_GLOBAL, IR_STATIC, IR_THREAD_LOCAL};
    static const ir_storage of_function[] = {IR_PARAMETER, IR_LOCAL, IR_STATIC_LOCAL,
                                             IR_THREAD_LOCAL};
    const ir_storage *list = is_in_function ? of_function : of_file;
    for (unsigned i = 0; i < (is_in_function ? 4u : 3u); i++)
        if (has_word(s, ir_storage_word(list[i]))) {
            *storage = list[i];
            return true;
        }
    return false;
}

/* ---- functions ----------------------------------------------------------------------------- */

static bool read_function_flag(ir_reader *r, const sexp *item, ir_function *f) {
    const struct {
        const char *word;
        bool *flag;
    } flags[] = {{"!static", &f->linkage.is_static}, {"!variadic", &f->is_variadic},
                 {"!noreturn", &f->is_noreturn},     {"!pure", &f->is_attribute_pure},
                 {"!const", &f->is_attribute_const}, {"!attributes", &f->has_other_attributes},
                 {"!weak", &f->linkage.is_weak},     {"!renamed", &f->linkage.is_renamed},
                 {"!errors", &f->has_errors}};
    for (unsigned i = 0; i < sizeof flags / sizeof flags[0]; i++)
        if (is_word(item, flags[i].word)) {
            *flags[i].flag = true;
            return true;
        }
    if (!is_word(item, "!header"))
        return ir_reader_expected(r, item, "a flag of a function");
    f->is_in_main_file = false;
    return true;
}

/* Reads parameters, and locals without a declarator. Afterwards `next` is the index of the first
 * item behind them. */
static bool read_function_variables(ir_reader *r, const sexp *s, unsigned *next, ir_function *f) {
    VECTOR(ir_variable *) parameters = {0};
    ir_storage storage;
    for (; *next < s->count && is_variable(s->items[*next], true, &storage); ++*next) {
        ir_variable *v = read_variable(r, s->items[*next], storage);
        if (v == NULL)
            return false;
        if (storage == IR_PARAMETER)
            VECTOR_PUSH(r->arena, &parameters, v);
    }
    f->parameter_count = parameters.count;
    f->parameters = parameters.items;
    return true;
}

static bool read_function_head(ir_reader *r, const sexp *s, ir_function *f, unsigned *next,
                               const ir_type **type) {
    for (; *next < s->count && s->items[*next]->kind == SEXP_ATOM; ++*next) {
        const sexp *item = s->items[*next];
        bool is_good;
        if (item->text[0] == ':')
            is_good = (*type = ir_read_type(r, item, 1)) != NULL;
        else if (item->text[0] == '@')
            is_good = ir_read_range(r, item, 1, &f->range);
        else
            is_good = read_function_flag(r, item, f);
        if (!is_good)
            return false;
    }
    return true;
}

static bool declare_function(ir_reader *r, const sexp *s) {
    if (s->count < 3 || s->items[1]->kind != SEXP_ATOM)
        return ir_reader_expected(r, s, "a function's name and result type");
    void **place = map_at(r->functions, s->items[1]->text, strlen(s->items[1]->text));
    if (*place != NULL)
        return ir_reader_expected(r, s->items[1], "a function not declared before");
    ir_function *f = ARENA_NEW(r->arena, ir_function);
    *place = f;
    f->name = ir_key_name(r->arena, s->items[1]->text);
    f->is_in_main_file = true;
    f->id = r->unit->function_count;
    r->unit->functions[r->unit->function_count++] = f;
    return true;
}

/* The function's type must be known before any body is read. So parameters are read twice, here
 * only for their types. */
static bool read_function_type(ir_reader *r, const sexp *s, ir_function *f) {
    const ir_type *result = ir_read_type(r, s->items[2], 0), *type = NULL;
    unsigned next = 3;
    if (result == NULL || !read_function_head(r, s, f, &next, &type))
        return false;
    ir_reader once = *r;
    once.local_names = map_new(r->arena);
    once.function = f;
    bool is_good = read_function_variables(&once, s, &next, f);
    r->message = once.message;
    if (!is_good)
        return false;
    f->type = type != NULL ? type : ir_function_default_type(r->arena, f, result);
    return f->type->kind == IR_FUNCTION_TYPE ||
           ir_reader_expected(r, s, "a function type: function(result)");
}

static bool read_body(ir_reader *r, const sexp *s, ir_function *f) {
    f->body = ir_read_node(r, s);
    if (f->body == NULL)
        return false;
    if (f->body->kind != IR_BLOCK)
        return ir_reader_expected(r, s, "a block as the function's body");
    ir_finish_function(f);
    return true;
}

static bool read_function(ir_reader *r, const sexp *s) {
    ir_function *f = map_get(r->functions, s->items[1]->text, strlen(s->items[1]->text));
    unsigned next = 3;
    while (next < s->count && s->items[next]->kind == SEXP_ATOM)
        next++;
    r->function = f;
    r->local_names = map_new(r->arena);
    bool is_good = read_function_variables(r, s, &next, f);
    if (is_good && next < s->count)
        is_good = read_body(r, s->items[next++], f);
    if (is_good && next < s->count)
        is_good = ir_reader_expected(r, s->items[next], "nothing behind the function's body");
    r->function = NULL;
    r->local_names = NULL;
    return is_good;
}

/* ---- the unit ------------------------------------------------------------------------------ */

static bool is_directive(const sexp *s, ir_directive_kind *kind) {
    static const char *const words[] = {"if", "else", "endif", "pragma", "directive"};
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        if (has_word(s, words[i])) {
            *kind = (ir_directive_kind)i;
            return true;
        }
    return false;
}

static bool read_directive(ir_reader *r, const sexp *s, ir_directive *directive) {
    if (s->count < 2 || s->items[1]->kind != SEXP_STRING)
        return ir_reader_expected(r, s, "a directive's text in quotes");
    directive->text = s->items[1]->text;
    const sexp *flag = s->count > 2 ? s->items[2] : NULL;
    directive->is_skipped = flag && flag->kind == SEXP_ATOM && strcmp(flag->text, "!skipped") == 0;
    const unsigned next = directive->is_skipped ? 3 : 2;
    if (s->count > next + 1)
        return ir_reader_expected(r, s->items[next + 1], "nothing more of the directive");
    return s->count <= next || ir_read_range(r, s->items[next], 1, &directive->range);
}

/* Returns blanks as the file's text if only its length is known. */
static const char *blanks(arena *a, size_t length) {
    char *text = arena_allocate(a, length + 1);
    memset(text, ' ', length);
    return text;
}

static bool read_unit_fact(ir_reader *r, const sexp *s) {
    ir_unit *unit = r->unit;
    int64_t number = 0;
    if (s->count == 2 && has_word(s, "source") && s->items[1]->kind == SEXP_STRING) {
        const char *text = s->items[1]->text;
        unit->source = source_from_text(r->arena, unit->source->path, text, strlen(text));
        return true;
    }
    if (s->count != 2 || (!has_word(s, "bytes") && !has_word(s, "errors")))
        return ir_reader_expected(r, s, "a part of the unit (struct, global, function, ...)");
    if (!ir_read_integer(r, s->items[1], 0, &number))
        return false;
    if (number < 0 || number > INT32_MAX)
        return ir_reader_expected(r, s->items[1], "a number from 0 to 2147483647");
    if (has_word(s, "errors"))
        unit->error_count = (unsigned)number;
    else
        unit->source = source_from_text(r->arena, unit->source->path,
                                        blanks(r->arena, (size_t)number), (size_t)number);
    return true;
}

/* Reads the declarations to which later parts refer: records and functions by name, then fields and
 * variables, then the functions' types. */
static bool read_declarations(ir_reader *r, const sexp *s) {
    ir_storage storage;
    for (unsigned i = 2; i < s->count; i++)
        if (is_record(s->items[i]) && !declare_record(r, s->items[i]))
            return false;
    for (unsigned i = 2; i < s->count; i++) {
        const sexp *item = s->items[i];
        if (is_record(item) && !read_record(r, item))
            return false;
        if (is_variable(item, false, &storage) && read_variable(r, item, storage) == NULL)
            return false;
        if (has_word(item, "function") && !declare_function(r, item))
            return false;
    }
    for (unsigned i = 2; i < s->count; i++)
        if (has_word(s->items[i], "function")) {
            const char *name = s->items[i]->items[1]->text;
            if (!read_function_type(r, s->items[i], map_get(r->functions, name, strlen(name))))
                return false;
        }
    return true;
}

static bool read_rest(ir_reader *r, const sexp *s) {
    VECTOR(ir_directive) directives = {0};
    for (unsigned i = 2; i < s->count; i++) {
        const sexp *item = s->items[i];
        ir_directive directive = {0};
        ir_storage storage;
        if (is_record(item) || is_variable(item, false, &storage) ||
            is_word(item, "!no-strict-aliasing"))
            continue;
        if (is_directive(item, &directive.kind)) {
            if (!read_directive(r, item, &directive))
                return false;
            VECTOR_PUSH(r->arena, &directives, directive);
        } else if (!(has_word(item, "function") ? read_function(r, item)
                                                : read_unit_fact(r, item))) {
            return false;
        }
    }
    r->unit->directives = directives.items;
    r->unit->directive_count = directives.count;
    return true;
}

static bool read_unit(ir_reader *r, const sexp *s) {
    ir_unit *unit = r->unit;
    if (!has_word(s, "unit") || s->count < 2 || s->items[1]->kind != SEXP_STRING)
        return ir_reader_expected(r, s, "(unit \"file name\" ...)");
    unit->arena = r->arena;
    unit->source = source_from_text(r->arena, s->items[1]->text, "", 0);
    unit->functions = ARENA_ARRAY(r->arena, ir_function *, s->count);
    unit->dialect.strict_aliasing = s->count < 3 || !is_word(s->items[2], "!no-strict-aliasing");
    r->records = map_new(r->arena);
    r->file_names = map_new(r->arena);
    r->functions = map_new(r->arena);
    if (!read_declarations(r, s) || !read_rest(r, s))
        return false;
    unit->variables = r->variables.items;
    unit->variable_count = r->variables.count;
    ir_count_references(unit);
    return true;
}

ir_unit *ir_read(arena *a, const char *text, size_t length, const char **message) {
    sexp *s = sexp_read(a, text, length, message);
    if (s == NULL)
        return NULL;
    ir_reader r = {.arena = a, .unit = ARENA_NEW(a, ir_unit)};
    if (read_unit(&r, s))
        return r.unit;
    *message = r.message;
    return NULL;
}
