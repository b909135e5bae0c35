/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Reads types of the text form: "const(ptr(array(3,double)))". */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "ir/ir_words.h"
#include "ir_reader/ir_reader.h"

typedef struct type_reader {
    ir_reader *reader;
    const sexp *atom;
    const char *at;
} type_reader;

static ir_type *read(type_reader *t);

static void *expected(type_reader *t, const char *what) {
    sexp here = *t->atom;
    here.column += (unsigned)(t->at - t->atom->text);
    ir_reader_expected(t->reader, &here, what);
    return NULL;
}

static bool read_byte(type_reader *t, char c, const char *what) {
    if (*t->at != c)
        return expected(t, what) != NULL;
    t->at++;
    return true;
}

static ir_type *new_type(type_reader *t, ir_type_kind kind) {
    ir_type *type = ARENA_NEW(t->reader->arena, ir_type);
    type->kind = kind;
    type->count = -1;
    return type;
}

/* Sets the size and spelling that follow from the rest of the type. */
static ir_type *finished(type_reader *t, ir_type *type) {
    if (type != NULL) {
        type->size = ir_type_default_size(type);
        type->spelling = ir_type_default_spelling(t->reader->arena, type);
    }
    return type;
}

static bool read_count(type_reader *t, int64_t *count) {
    *count = -1;
    if (*t->at == '?') {
        t->at++;
    } else {
        char *end;
        errno = 0;
        *count = strtoll(t->at, &end, 10);
        if (end == t->at || errno != 0)
            return expected(t, "a number or '?'") != NULL;
        t->at = end;
    }
    return true;
}

static ir_type *read_target(type_reader *t, ir_type_kind kind) {
    ir_type *type = new_type(t, kind);
    type->target = read(t);
    return type->target != NULL ? finished(t, type) : NULL;
}

static ir_type *read_array(type_reader *t) {
    int64_t count;
    if (!read_count(t, &count) || !read_byte(t, ',', "','"))
        return NULL;
    ir_type *type = new_type(t, IR_ARRAY);
    type->count = count;
    type->target = read(t);
    return type->target != NULL ? finished(t, type) : NULL;
}

static ir_type *read_record(type_reader *t) {
    size_t length = strcspn(t->at, ")");
    ir_type *type = new_type(t, IR_RECORD);
    type->record = map_get(t->reader->records, t->at, length);
    if (type->record == NULL)
        return expected(t, "the name of a struct or union of this unit");
    t->at += length;
    return finished(t, type);
}

static ir_type *read_other(type_reader *t) {
    return finished(t, new_type(t, IR_OTHER_TYPE));
}

static ir_type *read_sized(type_reader *t) {
    int64_t size;
    if (!read_count(t, &size) || !read_byte(t, ',', "','"))
        return NULL;
    ir_type *type = read(t);
    if (type != NULL)
        type->size = size;
    return type;
}

static ir_type *read_named(type_reader *t) {
    if (*t->at != '"')
        return expected(t, "a spelling in quotes");
    buffer spelling = {0};
    const char *after = sexp_unquote(&spelling, t->at, t->at + strlen(t->at));
    const char *kept =
        after != NULL ? arena_copy(t->reader->arena, spelling.data, spelling.length) : NULL;
    buffer_free(&spelling);
    if (after == NULL)
        return expected(t, "a spelling in quotes");
    t->at = after;
    if (!read_byte(t, ',', "','"))
        return NULL;
    ir_type *type = read(t);
    if (type != NULL)
        type->spelling = kept;
    return type;
}

static ir_type *read_unnamed(type_reader *t) {
    ir_type *type = read(t);
    if (type != NULL)
        type->spelling = NULL;
    return type;
}

static ir_type *read_qualified(type_reader *t, const char *word) {
    ir_type *type = read(t);
    if (type == NULL)
        return NULL;
    type->is_const |= strcmp(word, "const") == 0;
    type->is_volatile |= strcmp(word, "volatile") == 0;
    type->is_restrict |= strcmp(word, "restrict") == 0;
    type->is_atomic |= strcmp(word, "atomic") == 0;
    type->spelling = ir_type_default_spelling(t->reader->arena, type);
    return type;
}

static ir_type *read_constructed(type_reader *t, const char *word) {
    if (strcmp(word, "ptr") == 0)
        return read_target(t, IR_POINTER);
    if (strcmp(word, "function") == 0)
        return read_target(t, IR_FUNCTION_TYPE);
    if (strcmp(word, "array") == 0)
        return read_array(t);
    if (strcmp(word, "struct") == 0 || strcmp(word, "union") == 0)
        return read_record(t);
    if (strcmp(word, "other") == 0)
        return read_other(t);
    if (strcmp(word, "sized") == 0)
        return read_sized(t);
    if (strcmp(word, "named") == 0)
        return read_named(t);
    if (strcmp(word, "unnamed") == 0)
        return read_unnamed(t);
    return read_qualified(t, word);
}

static bool is_constructor(const char *word, size_t length) {
    static const char *const words[] = {"ptr",      "function", "array", "struct",  "union",
                                        "other",    "sized",    "named", "unnamed", "const",
                                        "volatile", "restrict", "atomic"};
    for (unsigned i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strlen(words[i]) == length && strncmp(words[i], word, length) == 0)
            return true;
    return false;
}

static ir_type *read(type_reader *t) {
    size_t length = strcspn(t->at, "(),\"");
    if (t->at[length] != '(' || !is_constructor(t->at, length)) {
        const ir_scalar *scalar = ir_scalar_named(t->at, length);
        if (scalar == NULL)
            return expected(t, "a type");
        t->at += length;
        ir_type *type = ARENA_NEW(t->reader->arena, ir_type);
        ir_scalar_type(type, scalar);
        return type;
    }
    const char *word = arena_copy(t->reader->arena, t->at, length);
    t->at += length + 1;
    ir_type *type = read_constructed(t, word);
    return type != NULL && read_byte(t, ')', "')'") ? type : NULL;
}

const ir_type *ir_read_type(ir_reader *r, const sexp *atom, size_t skip) {
    if (atom->kind != SEXP_ATOM) {
        ir_reader_expected(r, atom, "a type");
        return NULL;
    }
    type_reader t = {.reader = r, .atom = atom, .at = atom->text + skip};
    ir_type *type = read(&t);
    if (type != NULL && *t.at != 0)
        return expected(&t, "nothing behind the type");
    return type;
}
