/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Inside the frontend: one conversion of a parsed translation unit to IR. */
#ifndef FRONTEND_CONVERT_H
#define FRONTEND_CONVERT_H

#include <clang-c/Index.h>

#include "frontend/frontend.h"
#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

/** Nodes may not be nested deeper; a function in which they are is marked has_errors. */
enum { DEEPEST_NODE = 2000 };

typedef struct function_body {
    ir_function *function;
    CXCursor definition;
} function_body;

typedef VECTOR(CXCursor) cursor_list;

/** clang computes an extent anew each time it is asked for, and an expression's is often asked for
 *  by what is around it first. */
typedef struct extent_memory {
    const void *tree; /* clang's expression or statement */
    CXSourceRange extent;
} extent_memory;

enum { EXTENTS_KEPT = 64 };

/** What of clang's was converted, and to what; each thing of clang's has one. */
struct converted {
    map *types;                 /* clang's type -> ir_type */
    map *records;               /* declaration -> ir_record */
    map *fields;                /* declaration -> ir_field */
    map *variables;             /* each of its declarations -> ir_variable */
    map *functions;             /* each of its declarations -> ir_function */
    map *functions_with_errors; /* canonical declaration -> anything */
    map *pointers;              /* target's ir_type -> pointer made for it */
    map *files;                 /* CXFile -> what location.c keeps of a header */
};

/** Where the main file has expansions of macros. */
struct expansions {
    map *ends;      /* an expansion's begin -> its end + 1 */
    map *begins;    /* end -> begin + 1 */
    bool are_known; /* the two are complete */
};

/** The compiler that clang stands for. */
struct compiler_facts {
    const struct parse_flags *flags; /* its options; `predefined`: its macros in place of clang's */
    map *parsers_own; /* then: names of the macros that clang has and that compiler has not */
};

typedef struct converter {
    arena *arena;
    arena *scratch; /* for lists of cursors; of the body being converted */
    ir_unit *unit;
    CXTranslationUnit clang;
    CXFile main_file;
    struct converted converted;
    struct expansions expansions;
    bool has_begun; /* has anything of the main file been met among its macros? */
    struct compiler_facts compiler;
    struct reference_table *references;
    bool has_assembler;           /* between functions: it may give names to objects */
    VECTOR(ir_function *) others; /* functions without a body in the main file */
    VECTOR(ir_function *) mains;
    VECTOR(ir_variable *) found;   /* variables in order of discovery */
    VECTOR(function_body) pending; /* bodies to convert */
    VECTOR(const char *) header_pragmas;
    ir_function *function; /* being converted */
    unsigned depth;
    cursor_list collected; /* a stack: children of the cursors on the way down */
    extent_memory extents[EXTENTS_KEPT];
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
/** Bytes of the main file; sets *is_from_macro where an end of it is made by a macro. */
ir_range range_of(converter *c, CXSourceRange extent, bool *is_from_macro);
/** Sets range and IR_FROM_MACRO. */
void place_node(converter *c, ir_node *node, CXCursor cursor);
file_text text_of_file(converter *c, CXFile file);
bool text_has(file_text file, const char *word);

typedef struct file_directives {
    const ir_directive *items;
    unsigned count;
} file_directives;

/** The file's directives, scanned once; of the main file only after find_directives. */
file_directives directives_of_file(converter *c, CXFile file);
/** Is the header the compiler's or the C library's? A library's header that -isystem or a pragma
 *  makes a system header holds what its authors please, as the program's own do. */
bool is_of_system(converter *c, CXFile file);
/** The text from where the location's token is spelled (maybe in a macro's body or a header) to
 *  the end of its file; length 0 where there is none (pasted tokens, the command line). */
file_text text_at(converter *c, CXSourceLocation location);
/** The source text of a cursor without macros, in the arena; NULL where macros are concerned. */
const char *plain_text(converter *c, CXCursor cursor);
/** clang's text, kept. */
const char *take_string(converter *c, CXString string);

/* ---- types and declarations ---------------------------------------------------------------- */

const ir_type *convert_type(converter *c, CXType type);
const ir_type *pointer_to(converter *c, const ir_type *target);
/** libclang gives the type of a parameter that is written as an array or a function as it is
 *  written, there and wherever that type is handed on: this is what it is, a pointer. Other types
 *  as they are. */
const ir_type *decayed(converter *c, const ir_type *type);
/** Does the type hold an array whose length is computed at run time? */
bool has_variable_length(const ir_type *type);
const ir_record *convert_record(converter *c, CXType canonical);
/** NULL: no field known for it. */
const ir_field *convert_field(converter *c, CXCursor field);
/** Is the text clang's name for something without one? */
bool is_nameless(const char *spelling);
ir_variable *convert_variable(converter *c, CXCursor declaration);
ir_function *convert_function(converter *c, CXCursor declaration);
/** Adds what the attributes of this declaration say. */
void read_attributes(converter *c, CXCursor declaration, ir_function *function);
/** Does a function get the variable's address where its scope ends (GNU's cleanup attribute)? */
bool has_cleanup(CXCursor declaration);
/** May the variable be another name of an object: by an alias attribute, an asm label, assembler
 *  text in the file? */
bool has_other_name(const converter *c, CXCursor declaration);
/** What `#pragma weak a` or `#pragma weak a = b` names may be another function, has another name;
 *  what `#pragma omp threadprivate(a)` names is thread-local. clang's tree does not tell. */
void mark_names_in_pragmas(converter *c);
/** Has the typedef or record the attribute may_alias? */
bool is_under_may_alias(CXCursor declaration);
/** With KeepGoing clang calls a missing header an error like any other: its text tells. */
bool is_missing_header(CXDiagnostic diagnostic);
/** Adds a macro to the unit's macros; those that the main file's text defines in any branch. */
void note_macro(converter *c, CXCursor definition);
void note_macros_of_directives(converter *c);
/** In the text of a directive: behind `#define`, the macro's name; NULL: it is another one. */
const char *macro_name_defined(const char *at, const char *end);
/** Sets the unit's pragma_macros and may_make_fenv_access. */
void find_pragma_macros(converter *c);
/** Adds what is declared, in a record its members' tags too, to the unit's names. */
void note_name(converter *c, CXCursor declaration);
/** Sets the unit's compiler_word, unseen_word and names_optimize. */
void find_compiler_words(converter *c);

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

/* ---- what names mean (references.c) -------------------------------------------------------- */

struct reference_table *references_new(converter *c);
/** What this cursor declares; the same for all declarations of one thing. */
const ir_declared *declared_of(converter *c, CXCursor declaration);
/** Adds the names in a function's body to the unit's references. */
void note_references(converter *c, CXCursor body);
/** Sets the unit's references. */
void finish_references(converter *c);

/* ---- trees --------------------------------------------------------------------------------- */

/** Expressions and statements among the cursor's children; no references, types or attributes.
 *  The list lives in the scratch arena. */
cursor_list children_of(converter *c, CXCursor cursor);
/** Counts a level; false: too deep, *result is set and the level not to be left. */
bool enter_level(converter *c, CXCursor cursor, ir_node **result);

ir_node *convert_expression(converter *c, CXCursor cursor);
ir_node *convert_statement(converter *c, CXCursor cursor);
/** An expression, or a statement as it stands in a for's header or a statement expression. */
ir_node *convert_any(converter *c, CXCursor cursor);
ir_node *convert_literal(converter *c, CXCursor cursor);
/** sizeof and the like. */
ir_node *convert_sizeof(converter *c, CXCursor cursor);
/** With all that the cursor mentions as children; type NULL: a statement. */
ir_node *convert_opaque(converter *c, CXCursor cursor, const ir_type *type, const char *what);
/** An opaque statement that holds the expressions in a declaration and its type. */
ir_node *convert_lengths(converter *c, CXCursor declaration, const char *what);
/** Initialisers in braces. */
ir_node *convert_braces(converter *c, CXCursor cursor);

/* ---- after all ----------------------------------------------------------------------------- */

/** Takes IR_FROM_MACRO from statements that end (or, but for loops, also begin) in the expansion of
 *  a macro, where all of the expansion belongs to the statement: their bytes are their own. */
void find_own_bytes(converter *c, ir_node *body);

/** Orders and numbers functions and variables, finishes bodies, finds address_taken. */
void finish_unit(converter *c);

/** Does a finished unit compute with floating-point numbers, in what is compiled of it? */
bool has_floating_work(const ir_unit *unit);

#endif
