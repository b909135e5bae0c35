/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The intermediate representation: one translation unit as trees of one node type.
 *
 * The frontend builds it, in one arena. Later stages read it; they also add bodies of other files,
 * remove dead branches, and exchange parts of a loop while they analyse it. It represents the
 * source: implicit conversions (types show them) and parentheses (the printer restores the
 * necessary ones) are dropped, typedefs are resolved. Anything that the frontend cannot represent
 * exactly is an IR_OPAQUE node, about which nothing may be assumed.
 */
#ifndef IR_IR_H
#define IR_IR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "support/arena.h"
#include "support/map.h"
#include "support/source.h"

/** Bytes [begin, end) of the main file; begin == end: none (a header, a macro's body). */
typedef struct ir_range {
    uint32_t begin;
    uint32_t end;
} ir_range;

/** Identifies a declaration in all texts that are parsed: the original file, the output, other
 *  files of the program. */
typedef struct ir_declared {
    const char *name;
    const char *file;              /* NULL: the main file */
    uint32_t offset;               /* of its first declaration's name, outside of macro
                                    * expansions */
    bool is_external;              /* of external linkage: the same name elsewhere is the same
                                    * object */
    const struct ir_declared *tag; /* of a type name: the structure, union or enumeration that it
                                    * names, or points to; NULL: none */
} ir_declared;

/** A name in the text of a function, and the declaration it refers to. */
typedef struct ir_reference {
    uint32_t offset; /* in the main file; for a name made by a macro, the place of the expansion */
    bool is_type;    /* of a tag or a type name */
    const ir_declared *declared;
} ir_reference;

/** A name, an element by its subscript, or an expression in parentheses in the text of a function.
 */
typedef struct ir_typed_place {
    uint32_t offset; /* its first byte, as for references */
    const struct ir_type *type;
} ir_typed_place;

/* ---- types --------------------------------------------------------------------------------- */

typedef enum ir_type_kind {
    IR_VOID,
    IR_BOOLEAN,
    IR_INTEGER, /* enumerations too */
    IR_FLOATING,
    IR_COMPLEX,
    IR_POINTER,
    IR_ARRAY,
    IR_RECORD, /* struct and union */
    IR_FUNCTION_TYPE,
    IR_OTHER_TYPE /* vectors, __int128, _Float16, blocks, ...: nothing may be assumed */
} ir_type_kind;

typedef struct ir_type ir_type;
typedef struct ir_record ir_record;

typedef struct ir_field {
    const char *name; /* "" if anonymous */
    const ir_type *type;
    int64_t offset; /* bytes from the record's start; -1 for a bit-field */
    bool is_bit_field;
} ir_field;

struct ir_record {
    const char *name; /* tag or typedef name; "" if it has none and cannot be spelled */
    bool is_union;
    bool is_complete;
    int64_t size;         /* bytes; -1: unknown */
    int64_t alignment;    /* bytes; 0: unknown. Not in the text form */
    const char *spelling; /* of its type: "struct node", "vec"; NULL: cannot be spelled */
    unsigned field_count;
    const ir_field *fields;
};

/** A canonical type. Equal types may be different objects: ir_type_equal compares them. */
struct ir_type {
    ir_type_kind kind;
    bool is_signed;    /* integers */
    bool wraps;        /* signed, and overflow is defined (-fwrapv). Not in the text form */
    bool is_character; /* char, signed char, unsigned char: may alias anything */
    bool is_const, is_volatile, is_restrict, is_atomic;
    bool has_address_space; /* __seg_gs and the like. Not in the text form */
    int64_t size;           /* bytes; -1 unknown: incomplete, variable-length */
    int64_t count;          /* IR_ARRAY: elements; -1 unknown */
    const ir_type *target;  /* pointee, element, result */
    const ir_record *record;
    const char *spelling;   /* in C, as in a cast: "double (*)[3]"; NULL: cannot be spelled */
    const ir_declared *tag; /* of records and enumerations. Not in the text form */
};

/** Ignores qualifiers, also those of pointees and elements. An enumeration equals its integer type,
 *  long equals a long long of the same size. Function types and IR_OTHER_TYPE are compared by their
 *  spelling. */
bool ir_type_equal(const ir_type *a, const ir_type *b);
bool ir_type_is_scalar(const ir_type *type); /* arithmetic or pointer */
/** Real or complex; false for NULL. */
bool ir_type_is_floating(const ir_type *type);
/** An integer type whose overflow is undefined behaviour: signed, at least int, without -fwrapv.
 *  False for NULL. */
bool ir_type_never_wraps(const ir_type *type);
/** An integer of at most 64 bits, neither volatile nor atomic; false for NULL. */
bool ir_type_is_plain_integer(const ir_type *type);
/** Is the type, or one that it points to, an array of variable or unknown length? */
bool ir_type_is_variably_modified(const ir_type *type);
/** The element of an array of arrays ..., or the type itself. */
const ir_type *ir_type_innermost(const ir_type *type);

/* ---- variables and functions --------------------------------------------------------------- */

typedef enum ir_storage {
    IR_LOCAL,
    IR_PARAMETER,
    IR_GLOBAL,       /* external linkage or extern */
    IR_STATIC,       /* static at file scope */
    IR_STATIC_LOCAL, /* static in a function */
    IR_THREAD_LOCAL
} ir_storage;

typedef struct ir_node ir_node;
typedef struct ir_function ir_function;

typedef struct ir_variable {
    const char *name;
    const ir_type *type;
    ir_storage storage;
    const ir_function *function; /* of locals and parameters */
    unsigned id;                 /* dense in the unit */
    ir_range range;              /* of its first declarator */
    bool address_taken;          /* by &, or by the decay of an array other than as a subscript's
                                  * base or an argument */
    bool has_other_name;         /* another variable may name the same object: alias, asm label */
    bool is_unnamed; /* of another file, or added by the translator: no text of this file can name
                      * it. Not in the text form */
    const ir_declared *declared; /* NULL: not known. Not in the text form */
    const ir_node *stands_for;   /* of a variable that the translator adds: the pointer it holds,
                                  * which the function's loops load through other pointers
                                  * (analysis/base/loop_loads.h). Not in the text form */
} ir_variable;

/** The origin of a body that another file defines. */
typedef struct ir_import {
    const char *file;
    uint64_t digest; /* of the definition (ir_digest.h); 0 for a static function: its callers'
                      * digests include it */
} ir_import;

/** A function's properties for the linker. */
typedef struct ir_linkage {
    bool is_static;
    bool is_weak;            /* the definition that runs may differ from the one in this unit */
    bool is_renamed;         /* it has another symbol name, so its C name identifies nothing */
    bool is_interposable;    /* is_weak, because a shared object exports it: the program may define
                              * the name, too. Not in the text form */
    bool is_hidden;          /* no other shared object can refer to it or replace it */
    const ir_import *import; /* another file defines the body (ir_adopt.h); NULL: this unit does.
                              * Not in the text form */
} ir_linkage;

struct ir_function {
    const char *name;
    const ir_type *type; /* IR_FUNCTION_TYPE; target is the result */
    unsigned parameter_count;
    ir_variable *const *parameters;
    ir_node *body;       /* IR_BLOCK; NULL if only declared */
    unsigned id;         /* dense in the unit */
    unsigned node_count; /* ids of the body's nodes are below it */
    ir_range range;
    bool is_variadic, is_noreturn;
    bool is_attribute_pure, is_attribute_const; /* __attribute__((pure)), ((const)) */
    ir_linkage linkage;
    bool is_from_system;       /* a system header declares it. Not in the text form */
    bool has_attributes;       /* other than pure and const. Not in the text form */
    bool has_other_attributes; /* some of these are not harmless (support/attributes.h) */
    unsigned reference_count;  /* how often the unit's bodies name it */
    bool has_errors;           /* the compiler reported an error inside it: analyse nothing in it */
    bool is_in_main_file;
    const ir_declared *declared; /* NULL: not known. Not in the text form */
};

/* ---- nodes --------------------------------------------------------------------------------- */

typedef enum ir_kind {
    /* expressions: `type` is set */
    IR_NUMBER,       /* text; value, if integer (enumerators and character constants too) */
    IR_STRING,       /* text */
    IR_VARIABLE,     /* variable */
    IR_FUNCTION,     /* function */
    IR_INDEX,        /* array, subscript (in this order, also for 3[a]) */
    IR_MEMBER,       /* object or pointer, field; flag IR_ARROW if the child is a pointer */
    IR_UNARY,        /* operand; op */
    IR_BINARY,       /* left, right; op; the comma and && || too */
    IR_ASSIGN,       /* target, value; op: IR_OP_NONE for =, IR_OP_ADD for +=, ... */
    IR_CONDITIONAL,  /* condition, then, else */
    IR_CALL,         /* callee, arguments */
    IR_CAST,         /* operand; type; written by the user */
    IR_SIZEOF,       /* text; value, if constant */
    IR_INITIALIZERS, /* { values } in source order; flag IR_DESIGNATED if any is designated */
    IR_OPAQUE,       /* text names the construct; children are the operands, if known. Also as a
                      * statement (statement expressions, inline assembly, ...) */
    /* statements */
    IR_BLOCK,       /* statements */
    IR_DECLARATION, /* IR_DECLARATORs */
    IR_DECLARATOR,  /* variable; initialiser, if any */
    IR_EXPRESSION,  /* an expression as a statement: the expression */
    IR_IF,          /* condition, then, [else] */
    IR_FOR,         /* always four: initialisation, condition, increment, body; IR_EMPTY for each
                     * omitted one; initialisation is a declaration or an expression */
    IR_WHILE,       /* condition, body */
    IR_DO,          /* body, condition */
    IR_SWITCH,      /* value, body */
    IR_CASE,        /* value, statement */
    IR_DEFAULT,     /* statement */
    IR_LABEL,       /* text; statement */
    IR_GOTO,        /* text; computed: [address], no text */
    IR_RETURN,      /* [value] */
    IR_BREAK,
    IR_CONTINUE,
    IR_EMPTY
} ir_kind;

typedef enum ir_operator {
    IR_OP_NONE,
    IR_OP_ADD,
    IR_OP_SUBTRACT,
    IR_OP_MULTIPLY,
    IR_OP_DIVIDE,
    IR_OP_REMAINDER,
    IR_OP_SHIFT_LEFT,
    IR_OP_SHIFT_RIGHT,
    IR_OP_BIT_AND,
    IR_OP_BIT_OR,
    IR_OP_BIT_XOR,
    IR_OP_LESS,
    IR_OP_GREATER,
    IR_OP_LESS_EQUAL,
    IR_OP_GREATER_EQUAL,
    IR_OP_EQUAL,
    IR_OP_NOT_EQUAL,
    IR_OP_AND,
    IR_OP_OR,
    IR_OP_COMMA,
    /* unary */
    IR_OP_PLUS,
    IR_OP_MINUS,
    IR_OP_NOT,
    IR_OP_BIT_NOT,
    IR_OP_DEREFERENCE,
    IR_OP_ADDRESS,
    IR_OP_PRE_INCREMENT,
    IR_OP_PRE_DECREMENT,
    IR_OP_POST_INCREMENT,
    IR_OP_POST_DECREMENT,
    IR_OP_REAL,
    IR_OP_IMAG
} ir_operator;

enum {
    IR_ARROW = 1,
    IR_DESIGNATED = 2,
    IR_FROM_MACRO = 4, /* some of its tokens come from a macro's body: its bytes cannot be edited.
                        * (A macro's argument is the user's text, but counts as well.) Not set on a
                        * statement that contains the whole expansion at its end (or, except for
                        * loops, at its beginning): it may be replaced as a whole. */
    IR_HAS_VALUE = 8,  /* `value` is its constant integer value */
    IR_COMPOUND_LITERAL = 16, /* of IR_INITIALIZERS */
    IR_SEQUENCE = 64, /* of a block: it is a comma expression used as a statement. Its parts, all
                       * IR_FROM_MACRO, have its range, without the `;` */
    IR_DEAD = 128,    /* of an empty block (child_count is 0): it replaces a statement that is never
                       * executed (analysis/base/dead_branches.h). Copies of the text omit its
                       * bytes. children[0] is the statement, which the text form shows */
    IR_FROM_CALL = 32 /* it replaces a call that reaches variables which the call's text does not
                       * name (ir_accessors.h): the text cannot be copied to a place with other
                       * variables or other memory. IR_FROM_MACRO too */
};

struct ir_node {
    ir_kind kind;
    ir_operator op;
    unsigned flags;
    unsigned id; /* dense in its function, in preorder: the index of side tables */
    unsigned child_count;
    ir_node **children;
    ir_node *parent; /* NULL for a body, and for nodes outside of functions */
    const ir_type *type;
    ir_variable *variable;
    ir_function *function;
    const ir_field *field;
    const char *text;
    int64_t value;
    ir_range range; /* of the expression or statement, without the `;` of expression statements,
                     * return, break, continue, goto and do; with it for declarations; the
                     * expansion's range if macros are involved */
};

/* ---- the unit ------------------------------------------------------------------------------ */

typedef enum ir_directive_kind {
    IR_DIRECTIVE_IF,   /* also #ifdef, #ifndef */
    IR_DIRECTIVE_ELSE, /* also #elif, #elifdef, #elifndef */
    IR_DIRECTIVE_ENDIF,
    IR_DIRECTIVE_PRAGMA, /* also _Pragma */
    IR_DIRECTIVE_OTHER   /* #define, #include, #line, ... */
} ir_directive_kind;

typedef struct ir_directive {
    ir_directive_kind kind;
    ir_range range; /* the logical line */
    const char *text;
    bool is_skipped; /* the text after it is not compiled: true for a pragma in such a branch, and
                      * for an #if or #else that begins one */
} ir_directive;

/** The language that the compiler's options choose. Only strict_aliasing is in the text form. */
typedef struct ir_dialect {
    bool strict_aliasing; /* strict aliasing: objects of different types do not overlap */
    bool is_c89;          /* C89: the program may use names that C99 reserved */
    bool math_errno;      /* mathematical functions set errno */
    bool is_sanitized;    /* undefined arithmetic may end the program */
    bool wraps;           /* signed arithmetic wraps around (-fwrapv) */
    bool has_openmp;      /* OpenMP directives are enabled; otherwise compilers ignore them */
    bool replaces_openmp; /* a loop's OpenMP directives may be dropped: redcc parallelises the loop
                             itself */
    const char *refusing_option; /* an option that makes the program differ from this tree. NULL:
                                  * none */
    const char *inexact_option;  /* an option by which the bits of the file's floating-point
                                  * operations depend on other code in the same compilation. NULL:
                                  * none */
} ir_dialect;

/** An #include directive that names one of the program's own headers. */
typedef struct ir_inclusion {
    const char *file; /* as it was found */
    bool is_in_main_file;
    uint32_t offset; /* that of a byte of the directive's line in the main file */
} ir_inclusion;

/** Properties of the text of the file and its headers, in addition to the tree. Not in the text
 *  form. */
typedef struct ir_text {
    bool includes_itself;      /* the file's text may be compiled several times */
    const char *compiler_word; /* a name in the program's own text that may test for the compiler:
                                * "__clang"; NULL: none */
    const char *unseen_word;   /* a name or construct that a compiler may read differently than the
                                * parser, so that it compiles another tree. NULL: none */
    bool names_optimize;       /* the attribute may occur in the program's own text, or a macro of
                                * the options: no declaration in the tree shows it */
    bool names_target;         /* the same for the attributes target and target_clones */
    bool names_counter; /* __COUNTER__ occurs in a file of the program or an option: macros may
                         * expand to it */
    unsigned runtime_name_count; /* names in texts and options that begin as the runtime's */
    const char **runtime_names;
    unsigned header_pragma_count; /* of the program's own headers, as text */
    const char **header_pragmas;
    map *macros; /* the name of each macro defined anywhere -> IR_MACRO_AS_OBJECT or, if all its
                  * definitions have parameters, IR_MACRO_AS_FUNCTION; excludes macros found to
                  * expand to their own name. NULL: none */
    map *macros_before; /* the same for macros defined by the command line, or by a file it
                         * includes, before the main file begins; without the compiler's predefined
                         * ones */
    map *pragma_macros; /* the name of each macro of the program that may expand to a pragma -> not
                         * NULL. NULL: none */
    bool may_make_fenv_access; /* pragma_macros is set, and FENV_ACCESS occurs somewhere */
    map *names;       /* each name that the program or its headers declare as a function, type, tag,
                       * enumerator or file-scope variable -> IR_NAME_AS_QUERY or IR_NAME_AS_OTHER.
                       * NULL: none */
    map *inner_names; /* each name that a function's body declares as an enumerator, type or tag ->
                       * not NULL. NULL: none */
    map *header_loops; /* each loop whose text is in one of the program's own headers (a pointer to
                          its node) -> its ir_position. NULL: none */
    unsigned inclusion_count; /* in order; a header that is included twice occurs twice */
    const ir_inclusion *inclusions;
} ir_text;

typedef struct ir_unit {
    arena *arena;
    const source *source;
    unsigned function_count; /* those with a body in the main file, in source order, then others */
    ir_function **functions;
    unsigned variable_count; /* all, indexed by id */
    ir_variable **variables;
    unsigned directive_count; /* of the main file, in order */
    ir_directive *directives;
    ir_dialect dialect;
    ir_text text;
    unsigned error_count;     /* compiler errors anywhere */
    unsigned reference_count; /* the names in the bodies of the main file's functions, in order of
                               * their offsets; in any order at equal offsets. Not in the text
                               * form */
    const ir_reference *references;
    unsigned typed_place_count; /* the typed places in the same bodies, in the same order */
    const ir_typed_place *typed_places;
} ir_unit;

#define IR_MACRO_AS_OBJECT ((void *)1)
#define IR_MACRO_AS_FUNCTION ((void *)2)
#define IR_NAME_AS_QUERY ((void *)1) /* declared only as `int name(void)`, not static */
#define IR_NAME_AS_OTHER ((void *)2)

/* ---- queries ------------------------------------------------------------------------------- */

static inline ir_node *ir_child(const ir_node *node, unsigned index) {
    return index < node->child_count ? node->children[index] : NULL;
}
bool ir_is_expression(const ir_node *node);
/** An element, a member or a pointer's target: a[i], s.m, p->m, *p. */
bool ir_is_access(const ir_node *node);
/** Is it such an expression, and no array? For an array only the address is computed. */
bool ir_reads_memory(const ir_node *node);
/** Is it &operand? */
bool ir_is_address_of(const ir_node *node);
/** The function that a call names; NULL: it calls through a pointer. */
ir_function *ir_called_function(const ir_node *call);
/** Is it an expression of array, or of pointer type? */
bool ir_is_array(const ir_node *node);
bool ir_is_pointer(const ir_node *node);
/** The loop kinds: IR_FOR, IR_WHILE, IR_DO. */
bool ir_is_loop(const ir_node *node);
/** break, continue, goto, return. */
bool ir_is_jump(const ir_node *node);
/** The statement that a loop repeats. */
const ir_node *ir_loop_body(const ir_node *loop);
/** A question about one node. ir_any: is the answer yes for `node` or for a node below it? */
typedef bool (*ir_question)(const ir_node *node);
bool ir_any(const ir_node *node, ir_question question);
/** Does the tree below `node`, including itself, contain that kind? */
bool ir_has_kind(const ir_node *node, ir_kind kind);
/** Does it contain a label, `case` or `default`, by which a jump may enter it? */
bool ir_may_be_entered(const ir_node *node);
/** Does it contain a `case` or `default` of a switch around it? */
bool ir_holds_case(const ir_node *node);
/** ++ or --, before or after its operand. */
bool ir_is_increment(const ir_node *node);
/** The real or the imaginary part of its operand. */
bool ir_is_complex_part(const ir_node *node);
/** Does a loop's body contain a `continue` of that loop? */
bool ir_continues(const ir_node *node);
/** Does a loop's body contain a return, a goto, or a break of that loop? */
bool ir_leaves_loop(const ir_node *body);
/** ({ ... }): opaque, but the block below it is complete. */
bool ir_is_statement_expression(const ir_node *node);

/** Is it the node for the lengths of a variable length array at its declaration? The lengths are
 * its children. */
bool ir_is_lengths(const ir_node *node);
/** May evaluating the expression have a side effect: an assignment, a call, or an opaque part? */
bool ir_has_effect(const ir_node *node);
/** Does the parent use the value of this expression? (not: an expression statement, the left side
 *  of a comma, the header's initialisation and increment, a cast to void) */
bool ir_value_is_used(const ir_node *node);
/** The variable's declarator in the tree, or NULL. Offsets cannot decide this: everything that one
 *  macro expands to has one range. */
const ir_node *ir_declarator_in(const ir_node *tree, const ir_variable *variable);
bool ir_contains(const ir_node *outer, const ir_node *inner); /* by parent links; true if both are
                                                               * the same */
/** The variable at the bottom of an access path a, a[i], a.b, a->b, *a, &a[i], (T)a; or NULL. */
ir_variable *ir_root_variable(const ir_node *node);
const ir_function *ir_function_named(const ir_unit *unit, const char *name);

/** Calls `visit` for node and all below it in preorder, children in their order; if it returns
 *  false, that node's children are skipped. */
typedef bool (*ir_visitor)(ir_node *node, void *context);
void ir_walk(ir_node *node, ir_visitor visit, void *context);

/* ---- building: for the frontend, the text reader, and expressions made by substitution ------ */

ir_node *ir_new(arena *a, ir_kind kind, const ir_type *type, unsigned child_count);
/** Sets parents, ids and node_count of a finished function. */
void ir_finish_function(ir_function *function);
/** Sets reference_count of all functions of a finished unit. */
void ir_count_references(ir_unit *unit);
/** A copy of an expression with each parameter of `function` replaced by a copy of the argument
 *  given (NULL: left as it is); p->m with &x for p becomes x.m. An argument of another scalar type
 *  than the parameter's is wrapped in an IR_CAST to it, as the call would convert it. The copy's
 *  nodes have no ids and belong to no function; its root has no parent. */
ir_node *ir_substitute(arena *a, const ir_node *expression, const ir_function *function,
                       ir_node *const *arguments);

/** How C spells a type of this kind, target and qualifiers, as clang does ("const double *");
 *  records and enumerations by the spelling they were given. NULL: cannot be spelled. */
const char *ir_type_default_spelling(arena *a, const ir_type *type);

#endif
