/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the files of the frontend share: one translation of libclang's tree into IR. */
#ifndef FRONTEND_TRANSLATION_H
#define FRONTEND_TRANSLATION_H

#include <clang-c/Index.h>

#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

enum { DEEPEST_NESTING = 2000 };

typedef VECTOR(CXCursor) cursor_list;
typedef VECTOR(ir_node *) node_list;

typedef struct pending_body {
    ir_function *function;
    CXCursor definition;
} pending_body;

typedef struct translation {
    arena *arena;
    CXTranslationUnit clang;
    CXFile main_file;
    ir_unit *unit;
    map *types;     /* by libclang's type */
    map *records;   /* by declaration */
    map *fields;    /* by declaration */
    map *variables; /* by declaration */
    map *functions; /* by declaration */
    VECTOR(ir_variable *) variable_list;
    VECTOR(ir_function *) function_list;
    VECTOR(pending_body) pending; /* met, their bodies not yet translated */
    ir_function *current;
    unsigned depth;
    bool too_deep;
} translation;

/* place.c: where things stand */
ir_range place_range(const translation *t, CXCursor cursor);
bool place_is_plain(const translation *t, CXCursor cursor); /* no macro has a part in it */
bool place_is_in_main_file(const translation *t, CXCursor cursor);
/** The token at the cursor's start, as it was written (in a macro's body too); NULL: none. */
const char *place_token(translation *t, CXCursor cursor);
const char *take_string(translation *t, CXString string); /* copies and disposes */
cursor_list children_of(translation *t, CXCursor cursor);

/* type.c */
const ir_type *translate_type(translation *t, CXType type);
const ir_field *translate_field(translation *t, CXCursor field);

/* declaration.c */
ir_variable *translate_variable(translation *t, CXCursor declaration);
ir_function *translate_function(translation *t, CXCursor declaration);
/** Bodies of the functions met so far, and of those that they call. */
void translate_pending(translation *t);

/* expression.c, statement.c */
ir_node *translate_expression(translation *t, CXCursor cursor);
ir_node *translate_statement(translation *t, CXCursor cursor);
ir_node *node_new(translation *t, CXCursor cursor, ir_kind kind, unsigned child_count);
ir_node *node_opaque(translation *t, CXCursor cursor, const char *what);
ir_node *node_with_children(translation *t, CXCursor cursor, ir_kind kind, const cursor_list *list,
                            unsigned first);

/* directives.c, flags.c */
void scan_directives(arena *a, ir_unit *unit);
typedef VECTOR(const char *) flag_list;
flag_list frontend_flags(arena *a, unsigned count, const char *const *flags, bool *strict_aliasing);

#endif
