/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Internals of the frontend, which converts one parsed translation unit to IR. */
#ifndef FRONTEND_CONVERT_H
#define FRONTEND_CONVERT_H

#include <clang-c/Index.h>

#include "frontend/frontend.h"
#include "ir/ir.h"
#include "support/map.h"
#include "support/vector.h"

/** Greatest depth of nested nodes. A function that exceeds it is marked has_errors. */
enum { DEEPEST_NODE = 2000 };

typedef struct function_body {
    ir_function *function;
    CXCursor definition;
} function_body;

typedef VECTOR(CXCursor) cursor_list;

/** An entry of the cache of extents. clang computes an extent in each query, and an expression's
 *  extent is queried again for its enclosing node. */
typedef struct cached_extent {
    const void *tree; /* clang's expression or statement */
    CXSourceRange extent;
} cached_extent;

enum { CACHED_EXTENTS = 64 };

/** Maps from clang's objects to their IR objects; each clang object has at most one. */
struct converted {
    map *types;                 /* clang's type -> ir_type */
    map *records;               /* declaration -> ir_record */
    map *fields;                /* declaration -> ir_field */
    map *variables;             /* any declaration of the variable -> ir_variable */
    map *functions;             /* any declaration of the function -> ir_function */
    map *functions_with_errors; /* the set of canonical declarations of functions with errors */
    map *pointers;              /* ir_type of the target -> the pointer type created for it */
    map *files;                 /* a file's unique identifier -> location.c's data about it */
};

/** Maps of the macro expansions in the main file. */
struct expansions {
    map *ends;      /* offset of an expansion's begin -> offset of its end + 1, because 0 means
                     * none */
    map *begins;    /* offset of an expansion's end -> offset of its begin + 1, because 0 means
                     * none */
    bool are_known; /* whether both maps are complete */
};

/** The compiler that builds the program, which libclang imitates. */
struct compiler_facts {
    const struct parse_flags *flags; /* its options. If `predefined` is set, its predefined macros
                                      * replace clang's */
    map *parsers_own; /* names of clang's macros that this compiler does not define; used only if
                       * flags->predefined is set */
};

/** Facts found in the program's own headers. */
struct header_facts {
    VECTOR(const char *) pragmas;
    VECTOR(ir_inclusion) inclusions;
    /* includes the names found in the main file and in options */
    VECTOR(const char *) runtime_names;
};

typedef struct converter {
    arena *arena;
    arena *scratch; /* for lists of cursors; valid while one body is converted */
    ir_unit *unit;
    CXTranslationUnit clang;
    CXFile main_file;
    struct converted converted;
    struct expansions expansions;
    bool has_begun; /* the visit of macro definitions has reached the main file. Macros visited
                     * earlier are defined before the main file begins */
    struct compiler_facts compiler;
    struct reference_table *references;
    bool has_assembler;           /* the file has `asm` outside of functions, which may define
                                   * names of objects */
    VECTOR(ir_function *) others; /* functions without a body in the main file */
    VECTOR(ir_function *) mains;
    VECTOR(ir_variable *) found;   /* variables, in order of discovery */
    VECTOR(function_body) pending; /* bodies still to be converted */
    struct header_facts headers;
    ir_function *function; /* the function being converted */
    unsigned depth;
    cursor_list collected; /* a stack of the children of the cursors being visited */
    cached_extent extents[CACHED_EXTENTS];
} converter;

/* ---- source locations (location.c) ----------------------------------------------------------- */

typedef struct file_text {
    const char *text;
    size_t length;
} file_text;

/** Adds a macro expansion to the tables. */
void note_expansion(converter *c, CXCursor expansion);
bool is_in_main_file(converter *c, CXSourceLocation location);
/** Same as clang_getCursorExtent, but cached. */
CXSourceRange extent_of(converter *c, CXCursor cursor);
/** The bytes of the main file that the extent covers. Sets *is_from_macro if a macro produces one
 *  of the extent's ends. */
ir_range range_of(converter *c, CXSourceRange extent, bool *is_from_macro);
/** Sets the node's range, and IR_FROM_MACRO if it applies. */
void place_node(converter *c, ir_node *node, CXCursor cursor);
file_text text_of_file(converter *c, CXFile file);
bool text_has(file_text file, const char *word);

typedef struct file_directives {
    const ir_directive *items;
    unsigned count;
} file_directives;

/** The file's directives. Each file is scanned once; for the main file, call find_directives
 *  first. */
file_directives directives_of_file(converter *c, CXFile file);
/** Does clang treat the file as a system header where it is included first? */
bool is_in_system_header(converter *c, CXFile file);
/** Does the header belong to the compiler or the C library? A library's header in a folder given by
 *  -isystem or the like counts as the program's own, unless it is in /usr outside of /usr/local. */
bool is_of_system(converter *c, CXFile file);
/** Returns the text from the location's token (possibly in a macro's body or a header) to the end
 *  of the file that contains it. The length is 0 if no file contains the token: it is pasted, or
 *  comes from the command line. */
file_text text_at(converter *c, CXSourceLocation location);
/** The cursor's source text, copied to the arena; NULL if macros are involved. */
const char *plain_text(converter *c, CXCursor cursor);
/** Copies clang's string to the arena and frees the original. */
const char *take_string(converter *c, CXString string);

/* ---- types and declarations ---------------------------------------------------------------- */

const ir_type *convert_type(converter *c, CXType type);
const ir_type *pointer_to(converter *c, const ir_type *target);
/** The type of a parameter as C adjusts it: arrays and functions become pointers. libclang gives
 *  such a parameter its declared type, also in expressions. Other types are returned unchanged. */
const ir_type *decayed(converter *c, const ir_type *type);
/** Does the type contain an array whose length is computed at run time? */
bool has_variable_length(const ir_type *type);
const ir_record *convert_record(converter *c, CXType canonical);
/** NULL if the field is unknown. */
const ir_field *convert_field(converter *c, CXCursor field);
/** Is the text the name that clang invents for an unnamed declaration? */
bool is_nameless(const char *spelling);
ir_variable *convert_variable(converter *c, CXCursor declaration);
ir_function *convert_function(converter *c, CXCursor declaration);
/** Adds the attributes of this declaration to the function. */
void read_attributes(converter *c, CXCursor declaration, ir_function *function);
/** Does GNU's cleanup attribute pass the variable's address to a function at the end of its
 *  scope? */
bool has_cleanup(CXCursor declaration);
/** May the variable be another name for an object? An alias attribute, an asm label, or assembler
 *  text in the file can cause this. */
bool has_other_name(const converter *c, CXCursor declaration);
/** Applies pragmas that clang's tree does not show. A name in `#pragma weak a` or
 *  `#pragma weak a = b` may be replaced or have another name. A variable in
 *  `#pragma omp threadprivate(a)` is thread-local. */
void mark_names_in_pragmas(converter *c);
/** Does the typedef or record have the attribute may_alias? */
bool has_may_alias(CXCursor declaration);
/** Does the diagnostic report a missing header? With KeepGoing clang reports it like any other
 *  error, so only its text identifies it. */
bool is_missing_header(CXDiagnostic diagnostic);
/** Adds a macro to the unit's macros. */
void note_macro(converter *c, CXCursor definition);
/** Adds the macros that the main file defines, including those in branches that are not
 *  compiled. */
void note_macros_of_directives(converter *c);
/** The name that a directive `#define` defines, if the text [at, end) is one; otherwise NULL. */
const char *macro_name_defined(const char *at, const char *end);
/** Sets the unit's pragma_macros and may_make_fenv_access. */
void find_pragma_macros(converter *c);
/** Adds the declaration's name to the unit's names. For a record, also adds the tags of its
 *  members. */
void note_name(converter *c, CXCursor declaration);
/** Sets the unit's compiler_word and unseen_word, names_optimize, names_target, names_counter. */
void find_compiler_words(converter *c);
/** Sets the unit's runtime_names. */
void find_runtime_names(converter *c);

/** Is the function's body in one of the program's own headers and used, and may it contain a
 *  loop? */
bool is_wanted_of_header(converter *c, CXCursor definition);
/** Adds a loop in one of the program's own headers to the unit's header_loops. */
void note_header_loop(converter *c, const ir_node *loop, CXCursor cursor);
/** Adds an #include directive to the inclusions if it names one of the program's own headers. */
void note_inclusion(converter *c, CXCursor directive);
/** Sets the unit's header_pragmas. */
void find_header_pragmas(converter *c);
/** Stores the list of included files in the result; its strings are in the arena. */
void list_inclusions(arena *a, CXTranslationUnit clang, frontend_result *result);
/** Sets the unit's includes_itself. */
void find_own_inclusion(converter *c);
/** Sets is_skipped of the unit's directives. */
void mark_skipped_directives(converter *c);
/** Fills in functions_with_errors and the unit's error_count. */
void mark_functions_with_errors(converter *c);

/* ---- which declaration a name refers to (references.c) --------------------------------------- */

struct reference_table *references_new(converter *c);
/** The declaration of this cursor. All declarations of one object have the same result. */
const ir_declared *declared_of(converter *c, CXCursor declaration);
/** The header's path as the search found it; NULL for the main file. */
const char *name_of_file(converter *c, CXFile file);
/** Adds the names in a function's body to the unit's references. */
void note_references(converter *c, CXCursor body);
/** Sets the unit's references. */
void finish_references(converter *c);

/* ---- trees --------------------------------------------------------------------------------- */

/** The expressions and statements among the cursor's children, without references, types and
 *  attributes. The list is in the scratch arena. */
cursor_list children_of(converter *c, CXCursor cursor);
/** Enters a level of nesting: increments c->depth, which the caller decrements later. If the
 *  nesting is too deep, returns false, leaves c->depth unchanged, and stores an opaque node in
 *  *result. */
bool enter_level(converter *c, CXCursor cursor, ir_node **result);

ir_node *convert_expression(converter *c, CXCursor cursor);
ir_node *convert_statement(converter *c, CXCursor cursor);
/** Converts an expression, or a statement in a place where either may occur: a for's header or a
 *  statement expression. */
ir_node *convert_any(converter *c, CXCursor cursor);
ir_node *convert_literal(converter *c, CXCursor cursor);
/** Makes a literal such as 1e6 an integer if it is compared with an integer. */
void compare_as_integers(converter *c, ir_node *comparison);
/** Converts sizeof and similar operators. */
ir_node *convert_sizeof(converter *c, CXCursor cursor);
/** Creates an opaque node with all expressions and statements of the cursor as its children. If
 *  `type` is NULL, the node is a statement. */
ir_node *convert_opaque(converter *c, CXCursor cursor, const ir_type *type, const char *what);
/** Creates an opaque statement with the expressions that the declaration and its type contain. */
ir_node *convert_lengths(converter *c, CXCursor declaration, const char *what);
/** Converts an initialiser in braces. */
ir_node *convert_braces(converter *c, CXCursor cursor);

/* ---- finishing ----------------------------------------------------------------------------- */

/** Clears IR_FROM_MACRO in statements that end (or, except for loops, begin) in a macro's
 *  expansion. It does so only if no other node shares the bytes of this expansion, because the
 *  whole expansion belongs to the statement. */
void find_own_bytes(converter *c, ir_node *body);

/** Orders and numbers functions and variables, finishes bodies, and sets address_taken. */
void finish_unit(converter *c);

/** May the compiled part of a finished unit contain floating-point arithmetic? */
bool has_floating_work(const ir_unit *unit);

#endif
