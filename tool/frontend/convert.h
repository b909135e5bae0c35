/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Internals of the frontend: the conversion of one parsed translation unit to IR. */
#ifndef FRONTEND_CONVERT_H
#define FRONTEND_CONVERT_H

#include <clang-c/Index.h>

#include "frontend/frontend.h"
#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

/** Nodes may not be nested deeper; a function that exceeds this is marked has_errors. */
enum { DEEPEST_NODE = 2000 };

typedef struct function_body {
    ir_function *function;
    CXCursor definition;
} function_body;

typedef VECTOR(CXCursor) cursor_list;

/** A cache entry: clang computes an extent in each query, and an expression's is queried for the
 *  enclosing node as well. */
typedef struct cached_extent {
    const void *tree; /* clang's expression or statement */
    CXSourceRange extent;
} cached_extent;

enum { CACHED_EXTENTS = 64 };

/** clang's objects that were converted, with the results; each object has one. */
struct converted {
    map *types;                 /* clang's type -> ir_type */
    map *records;               /* declaration -> ir_record */
    map *fields;                /* declaration -> ir_field */
    map *variables;             /* each of its declarations -> ir_variable */
    map *functions;             /* each of its declarations -> ir_function */
    map *functions_with_errors; /* canonical declaration -> not NULL */
    map *pointers;              /* target's ir_type -> pointer made for it */
    map *files;                 /* CXFile -> location.c's data about a header */
};

/** Positions of macro expansions in the main file. */
struct expansions {
    map *ends;      /* an expansion's begin -> its end + 1 */
    map *begins;    /* end -> begin + 1 */
    bool are_known; /* the two are complete */
};

/** The compiler that clang represents. */
struct compiler_facts {
    const struct parse_flags *flags; /* its options; `predefined`: its macros replace clang's */
    map *parsers_own; /* then: names of clang's macros that the compiler does not define */
};

/** Facts found in the program's headers. */
struct header_facts {
    VECTOR(const char *) pragmas;
    VECTOR(ir_inclusion) inclusions;
    VECTOR(const char *) runtime_names; /* also of the main file and of options */
};

typedef struct converter {
    arena *arena;
    arena *scratch; /* for lists of cursors; of the body being converted */
    ir_unit *unit;
    CXTranslationUnit clang;
    CXFile main_file;
    struct converted converted;
    struct expansions expansions;
    bool has_begun; /* the visit of macros has reached the main file: earlier ones precede it */
    struct compiler_facts compiler;
    struct reference_table *references;
    bool has_assembler;           /* `asm` between functions: it may define names of objects */
    VECTOR(ir_function *) others; /* functions without a body in the main file */
    VECTOR(ir_function *) mains;
    VECTOR(ir_variable *) found;   /* variables in order of discovery */
    VECTOR(function_body) pending; /* bodies to convert */
    struct header_facts headers;
    ir_function *function; /* being converted */
    unsigned depth;
    cursor_list collected; /* a stack: children of the cursors being visited */
    cached_extent extents[CACHED_EXTENTS];
} converter;

/* ---- places (location.c) ------------------------------------------------------------------- */

typedef struct file_text {
    const char *text;
    size_t length;
} file_text;

/** Fills in the tables of macro expansions. */
void note_expansion(converter *c, CXCursor expansion);
bool is_in_main_file(converter *c, CXSourceLocation location);
/** As clang_getCursorExtent. */
CXSourceRange extent_of(converter *c, CXCursor cursor);
/** Bytes of the main file; sets *is_from_macro if a macro makes one of its ends. */
ir_range range_of(converter *c, CXSourceRange extent, bool *is_from_macro);
/** Sets range and IR_FROM_MACRO. */
void place_node(converter *c, ir_node *node, CXCursor cursor);
file_text text_of_file(converter *c, CXFile file);
bool text_has(file_text file, const char *word);

typedef struct file_directives {
    const ir_directive *items;
    unsigned count;
} file_directives;

/** The file's directives, scanned once; for the main file only after find_directives. */
file_directives directives_of_file(converter *c, CXFile file);
/** Is the header the compiler's or the C library's? A library's header in a folder given by
 *  -isystem or the like counts as the program's own, unless it is in /usr outside of /usr/local. */
bool is_of_system(converter *c, CXFile file);
/** The text from the spelling of the location's token (perhaps in a macro's body or a header) to
 *  the end of its file; length 0 if there is none (pasted tokens, the command line). */
file_text text_at(converter *c, CXSourceLocation location);
/** The source text of a cursor without macros, in the arena; NULL if macros are involved. */
const char *plain_text(converter *c, CXCursor cursor);
/** A copy of clang's text. */
const char *take_string(converter *c, CXString string);

/* ---- types and declarations ---------------------------------------------------------------- */

const ir_type *convert_type(converter *c, CXType type);
const ir_type *pointer_to(converter *c, const ir_type *target);
/** libclang gives a parameter that is declared as an array or a function the declared type, also in
 *  expressions that use it: this returns the actual type, a pointer. Other types are unchanged. */
const ir_type *decayed(converter *c, const ir_type *type);
/** Does the type contain an array whose length is computed at run time? */
bool has_variable_length(const ir_type *type);
const ir_record *convert_record(converter *c, CXType canonical);
/** NULL: no known field. */
const ir_field *convert_field(converter *c, CXCursor field);
/** Is the text clang's name for an unnamed declaration? */
bool is_nameless(const char *spelling);
ir_variable *convert_variable(converter *c, CXCursor declaration);
ir_function *convert_function(converter *c, CXCursor declaration);
/** Adds the attributes of this declaration. */
void read_attributes(converter *c, CXCursor declaration, ir_function *function);
/** Is the variable's address passed to a function at the end of its scope (GNU's cleanup
 *  attribute)? */
bool has_cleanup(CXCursor declaration);
/** May the variable be another name of an object: by an alias attribute, an asm label, assembler
 *  text in the file? */
bool has_other_name(const converter *c, CXCursor declaration);
/** A function named in `#pragma weak a` or `#pragma weak a = b` may be replaced or have another
 *  name; a variable named in `#pragma omp threadprivate(a)` is thread-local. clang's tree does not
 *  show it. */
void mark_names_in_pragmas(converter *c);
/** Does the typedef or record have the attribute may_alias? */
bool has_may_alias(CXCursor declaration);
/** With KeepGoing clang reports a missing header as any other error: its text identifies it. */
bool is_missing_header(CXDiagnostic diagnostic);
/** Adds a macro to the unit's macros. */
void note_macro(converter *c, CXCursor definition);
/** Adds the macros that the main file defines, including branches that are not compiled. */
void note_macros_of_directives(converter *c);
/** In the text of a directive: the macro's name after `#define`; NULL: another directive. */
const char *macro_name_defined(const char *at, const char *end);
/** Sets the unit's pragma_macros and may_make_fenv_access. */
void find_pragma_macros(converter *c);
/** Adds a declaration's name to the unit's names, for a record also its members' tags. */
void note_name(converter *c, CXCursor declaration);
/** Sets the unit's compiler_word and unseen_word, names_optimize, names_target, names_counter. */
void find_compiler_words(converter *c);
/** Sets the unit's runtime_names. */
void find_runtime_names(converter *c);

/** Is the function's body in one of the program's own headers, used, and may it have a loop? */
bool is_wanted_of_header(converter *c, CXCursor definition);
/** Adds a loop that is in such a header to the unit's header_loops. */
void note_header_loop(converter *c, const ir_node *loop, CXCursor cursor);
/** Adds an #include directive to the inclusions if it names one of the program's own headers. */
void note_inclusion(converter *c, CXCursor directive);
/** Sets the unit's header_pragmas. */
void find_header_pragmas(converter *c);
/** Sets the result's files, in the arena. */
void list_inclusions(arena *a, CXTranslationUnit clang, frontend_result *result);
/** Sets the unit's includes_itself. */
void find_own_inclusion(converter *c);
/** Sets is_skipped of the unit's directives. */
void mark_skipped_directives(converter *c);
/** Fills in functions_with_errors and the unit's error_count. */
void mark_functions_with_errors(converter *c);

/* ---- meanings of names (references.c) ------------------------------------------------------ */

struct reference_table *references_new(converter *c);
/** The declaration of this cursor; the same for all declarations of one object. */
const ir_declared *declared_of(converter *c, CXCursor declaration);
/** The header's name as it was found; NULL for the main file. */
const char *name_of_file(converter *c, CXFile file);
/** Adds the names in a function's body to the unit's references. */
void note_references(converter *c, CXCursor body);
/** Sets the unit's references. */
void finish_references(converter *c);

/* ---- trees --------------------------------------------------------------------------------- */

/** Expressions and statements among the cursor's children; no references, types or attributes.
 *  The list lives in the scratch arena. */
cursor_list children_of(converter *c, CXCursor cursor);
/** Enters a level of nesting: increments c->depth, which the caller decrements. False: too deep;
 *  c->depth is unchanged, and *result is an opaque node. */
bool enter_level(converter *c, CXCursor cursor, ir_node **result);

ir_node *convert_expression(converter *c, CXCursor cursor);
ir_node *convert_statement(converter *c, CXCursor cursor);
/** An expression, or a statement in a for's header or a statement expression. */
ir_node *convert_any(converter *c, CXCursor cursor);
ir_node *convert_literal(converter *c, CXCursor cursor);
/** An integer that is compared with 1e6 is compared with 1000000. */
void compare_as_integers(converter *c, ir_node *comparison);
/** sizeof and the like. */
ir_node *convert_sizeof(converter *c, CXCursor cursor);
/** An opaque node with all expressions and statements of the cursor as children; type NULL: a
 *  statement. */
ir_node *convert_opaque(converter *c, CXCursor cursor, const ir_type *type, const char *what);
/** An opaque statement that contains the expressions in a declaration and its type. */
ir_node *convert_lengths(converter *c, CXCursor declaration, const char *what);
/** Initialisers in braces. */
ir_node *convert_braces(converter *c, CXCursor cursor);

/* ---- finishing ----------------------------------------------------------------------------- */

/** Clears IR_FROM_MACRO in statements that end (or, except for loops, also begin) in the expansion
 *  of a macro, if the whole expansion belongs to the statement: then no other node shares their
 *  bytes. */
void find_own_bytes(converter *c, ir_node *body);

/** Orders and numbers functions and variables, finishes bodies, finds address_taken. */
void finish_unit(converter *c);

/** May the compiled part of a finished unit have floating-point arithmetic? */
bool has_floating_work(const ir_unit *unit);

#endif
