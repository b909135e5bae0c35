/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The intermediate representation (IR): one translation unit as trees of one node type.
 *
 *  The frontend builds the IR in one arena. Later stages read it. They also add bodies of functions
 *  from other files, remove dead branches, and replace parts of a loop while they analyse that
 *  loop.
 *
 *  The trees represent the source, without implicit conversions (the nodes' types show them) and
 *  without parentheses (the printer restores those that are needed). Typedefs are resolved.
 *  Whatever the frontend cannot represent exactly becomes an IR_OPAQUE node, about which nothing
 *  may be assumed.
 *
 *  "Not in the text form" means that ir_print omits the field, so tests that read the IR as text do
 *  not see it. */
#ifndef IR_IR_H
#define IR_IR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "support/arena.h"
#include "support/map.h"
#include "support/source.h"

/** Bytes [begin, end) of the main file. An empty range (begin == end) belongs to text that is not
 *  in the main file: a header or a macro's body. */
typedef struct ir_range {
    uint32_t begin;
    uint32_t end;
} ir_range;

/** Identifies a declaration in every text that redcc parses: the original file, redcc's output, and
 *  other files of the program. */
typedef struct ir_declared {
    const char *name;
    const char *file;              /* NULL if it is in the main file */
    uint32_t offset;               /* offset of the name in the first declaration; if a macro
                                    * produces it, of the macro's expansion */
    bool is_external;              /* has external linkage, so the same name in another file is
                                    * the same object */
    const struct ir_declared *tag; /* if this is a type name: the structure, union or enumeration
                                    * that it names or points to; NULL if none */
} ir_declared;

/** A name in the text of a function, and the declaration it refers to. */
typedef struct ir_reference {
    uint32_t offset; /* offset in the main file; for a name that a macro produces, offset of the
                      * macro's expansion */
    bool is_type;    /* the name is a tag or a type name */
    const ir_declared *declared;
} ir_reference;

/** A place in a function's text with the type of its expression: a name, a subscripted element, or
 *  an expression in parentheses. */
typedef struct ir_typed_place {
    uint32_t offset; /* offset of its first byte, defined as in ir_reference */
    const struct ir_type *type;
} ir_typed_place;

/* ---- types --------------------------------------------------------------------------------- */

typedef enum ir_type_kind {
    IR_VOID,
    IR_BOOLEAN,
    IR_INTEGER, /* includes enumerations */
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
    int64_t offset; /* in bytes from the record's start; -1 for a bit-field */
    bool is_bit_field;
} ir_field;

struct ir_record {
    const char *name; /* the tag or the typedef name; "" if it has neither */
    bool is_union;
    bool is_complete;
    int64_t size;         /* in bytes; -1 if unknown */
    int64_t alignment;    /* in bytes; 0 if unknown. Not in the text form */
    const char *spelling; /* how C names the type: "struct node", "vec"; NULL if C cannot name
                           * it */
    unsigned field_count;
    const ir_field *fields;
};

/** A canonical type (typedefs resolved). Two objects may describe the same type, so compare types
 *  with ir_type_equal. */
struct ir_type {
    ir_type_kind kind;
    bool is_signed;    /* of an integer */
    bool wraps;        /* the type is signed and its overflow is defined (-fwrapv). Not in the
                        * text form */
    bool is_character; /* char, signed char or unsigned char: an lvalue of this type may alias any
                        * object */
    bool is_const, is_volatile, is_restrict, is_atomic;
    bool has_address_space; /* __seg_gs and the like. Not in the text form */
    int64_t size;           /* in bytes; -1 if unknown (incomplete type, variable-length array) */
    int64_t count;          /* number of elements of an IR_ARRAY; -1 if unknown */
    const ir_type *target;  /* the type pointed to, the element's type, or the function's result
                             * type */
    const ir_record *record;
    const char *spelling;   /* the type as C writes it in a cast: "double (*)[3]"; NULL if C
                             * cannot name it */
    const ir_declared *tag; /* declaration of the record or enumeration. Not in the text form */
};

/** Are the types equal? Qualifiers are ignored, also those of pointees and elements. An enumeration
 *  equals its integer type, and long equals long long if their sizes are equal. Function types and
 *  IR_OTHER_TYPE are compared by their spelling. */
bool ir_type_equal(const ir_type *a, const ir_type *b);
bool ir_type_is_scalar(const ir_type *type); /* arithmetic or pointer */
/** Real or complex; false for NULL. */
bool ir_type_is_floating(const ir_type *type);
/** Is the type an integer type whose overflow is undefined behaviour (signed, at least as wide as
 *  int, no -fwrapv)? False for NULL. */
bool ir_type_never_wraps(const ir_type *type);
/** Is the type an integer type of at most 64 bits that is neither volatile nor atomic? False for
 *  NULL. */
bool ir_type_is_plain_integer(const ir_type *type);
/** Is the type, or a type that it points to, an array of variable or unknown length? */
bool ir_type_is_variably_modified(const ir_type *type);
/** The element type that remains when all array dimensions are removed: double for double[2][3].
 *  The type itself if it is no array. */
const ir_type *ir_type_innermost(const ir_type *type);

/* ---- variables and functions --------------------------------------------------------------- */

typedef enum ir_storage {
    IR_LOCAL,
    IR_PARAMETER,
    IR_GLOBAL,       /* has external linkage or is declared extern */
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
    const ir_function *function; /* the function that declares it, for locals and parameters;
                                  * otherwise NULL */
    unsigned id;                 /* index in the unit's variables */
    ir_range range;              /* range of its first declarator */
    bool address_taken;          /* its address is taken by &, or it is an array that decays to a
                                  * pointer other than as a subscript's base, an operand of *, or
                                  * an argument */
    bool has_other_name;         /* another variable may name the same object: alias, asm label */
    bool is_unnamed; /* this file's text cannot name it: it comes from another file, or redcc has
                      * added it. Not in the text form */
    const ir_declared *declared; /* NULL if unknown. Not in the text form */
    const ir_node *stands_for;   /* for a variable that redcc adds: the pointer expression whose
                                  * value it holds (analysis/base/loop_loads.h); NULL for all
                                  * others. Not in the text form */
} ir_variable;

/** The origin of a function's body that another file defines. */
typedef struct ir_import {
    const char *file;
    uint64_t digest; /* digest of the definition (ir_digest.h); 0 for a static function, whose
                      * callers' digests include it */
} ir_import;

/** A function's properties for the linker. */
typedef struct ir_linkage {
    bool is_static;
    bool is_weak;            /* the definition that runs may differ from the one in this unit */
    bool is_renamed;         /* its symbol name differs from its C name, so the C name identifies
                              * nothing */
    bool is_interposable;    /* is_weak is set only because a shared object exports the function:
                              * the program may define the same name. Not in the text form */
    bool is_hidden;          /* no other shared object can refer to it or replace it */
    const ir_import *import; /* NULL if this unit defines the body; otherwise another file does
                              * (ir_adopt.h). Not in the text form */
} ir_linkage;

struct ir_function {
    const char *name;
    const ir_type *type; /* an IR_FUNCTION_TYPE; its target is the result's type */
    unsigned parameter_count;
    ir_variable *const *parameters;
    ir_node *body;       /* an IR_BLOCK; NULL if the function is only declared */
    unsigned id;         /* index in the unit's functions */
    unsigned node_count; /* number of nodes in the body; their ids are 0 to node_count - 1 */
    ir_range range;
    bool is_variadic, is_noreturn;
    bool is_attribute_pure, is_attribute_const; /* __attribute__((pure)), ((const)) */
    ir_linkage linkage;
    bool is_from_system;       /* a system header declares the function. Not in the text form */
    bool has_attributes;       /* it has attributes other than pure and const. Not in the text
                                * form */
    bool has_other_attributes; /* some of these attributes are not known to be harmless
                                * (support/attributes.h) */
    unsigned reference_count;  /* number of IR_FUNCTION nodes in the unit's bodies that name it */
    bool has_errors;           /* the compiler reported an error inside it, so it must not be
                                * analysed */
    bool is_in_main_file;
    const ir_declared *declared; /* NULL if unknown. Not in the text form */
};

/* ---- nodes --------------------------------------------------------------------------------- */

typedef enum ir_kind {
    /* Expressions, which have a `type`. Each comment lists the children in order, then the other
     * fields that are set. */
    IR_NUMBER,       /* text; value if it is an integer (also for enumerators and character
                      * constants) */
    IR_STRING,       /* text */
    IR_VARIABLE,     /* variable */
    IR_FUNCTION,     /* function */
    IR_INDEX,        /* array, subscript (in this order, also if the source has 3[a]) */
    IR_MEMBER,       /* object or pointer; field; flag IR_ARROW if the child is a pointer */
    IR_UNARY,        /* operand; op */
    IR_BINARY,       /* left, right; op (includes the comma, && and ||) */
    IR_ASSIGN,       /* target, value; op: IR_OP_NONE for =, IR_OP_ADD for +=, and so on */
    IR_CONDITIONAL,  /* condition, then, else */
    IR_CALL,         /* callee, arguments */
    IR_CAST,         /* operand; type. Only casts that the source contains */
    IR_SIZEOF,       /* text; value if it is constant */
    IR_INITIALIZERS, /* the values between braces, in source order; flag IR_DESIGNATED if any has
                      * a designator */
    IR_OPAQUE,       /* text names the construct; the children are its operands, if known. It may
                      * also be a statement (statement expression, inline assembly, ...) */
    /* Statements, which have no `type`. */
    IR_BLOCK,       /* statements */
    IR_DECLARATION, /* one IR_DECLARATOR or more */
    IR_DECLARATOR,  /* initialiser, if any; variable */
    IR_EXPRESSION,  /* the expression that forms the statement */
    IR_IF,          /* condition, then, [else] */
    IR_FOR,         /* always four children: initialisation (a declaration or an expression),
                     * condition, increment, body; IR_EMPTY for each that is omitted */
    IR_WHILE,       /* condition, body */
    IR_DO,          /* body, condition */
    IR_SWITCH,      /* value, body */
    IR_CASE,        /* value, statement */
    IR_DEFAULT,     /* statement */
    IR_LABEL,       /* statement; text (the label's name) */
    IR_GOTO,        /* text (the label's name); a computed goto has the address as its child
                     * instead */
    IR_RETURN,      /* value, if any */
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
    IR_FROM_MACRO = 4, /* some of its tokens come from a macro's body or a macro's argument, so its
                        * bytes cannot be edited. Not set on a statement that contains the whole
                        * expansion at its end (or, except for loops, at its beginning), because the
                        * statement may then be replaced as a whole */
    IR_HAS_VALUE = 8,  /* `value` is its constant integer value */
    IR_COMPOUND_LITERAL = 16, /* the IR_INITIALIZERS node is a compound literal */
    IR_SEQUENCE = 64,         /* the block is a comma expression used as a statement. Its parts are
                               * IR_FROM_MACRO and have the block's range, which excludes the `;` */
    IR_DEAD = 128,    /* an empty block (child_count is 0) that replaces a statement which is
                       * never executed (analysis/base/dead_branches.h). Copies of the text omit
                       * its bytes. children[0] is the replaced statement, which the text form
                       * shows */
    IR_LEAVES = 256,  /* an IR_CONTINUE that stands for leaving the analysed loop
                       * (analysis/base/loop_exits.h), so it skips no step of the counter */
    IR_OPENED = 512,  /* a loop whose condition was moved into its body
                       * (analysis/base/inner_conditions.h), so parts of its text must not be
                       * replaced by themselves */
    IR_FROM_CALL = 32 /* the node replaces a call and reads file-scope variables that the call's
                       * text does not name (ir_accessors.h). The call's text therefore must not
                       * be copied to a place with other variables or other memory. IR_FROM_MACRO
                       * is set too */
};

struct ir_node {
    ir_kind kind;
    ir_operator op;
    unsigned flags;
    unsigned id; /* position in its function in preorder, from 0; index of arrays with one entry
                  * per node */
    unsigned child_count;
    ir_node **children;
    ir_node *parent; /* NULL for a body, and for nodes outside of functions */
    const ir_type *type;
    ir_variable *variable;
    ir_function *function;
    const ir_field *field;
    const char *text;
    int64_t value;
    ir_range range; /* the text of the expression or statement. Excludes the `;` of expression
                     * statements, return, break, continue, goto and do; includes it for
                     * declarations. If macros are involved, the range of the outermost
                     * expansion */
};

/* ---- the unit ------------------------------------------------------------------------------ */

typedef enum ir_directive_kind {
    IR_DIRECTIVE_IF,   /* includes #ifdef and #ifndef */
    IR_DIRECTIVE_ELSE, /* includes #elif, #elifdef and #elifndef */
    IR_DIRECTIVE_ENDIF,
    IR_DIRECTIVE_PRAGMA, /* includes _Pragma */
    IR_DIRECTIVE_OTHER   /* #define, #include, #line, ... */
} ir_directive_kind;

typedef struct ir_directive {
    ir_directive_kind kind;
    ir_range range; /* range of the logical line (after joining lines that end in a backslash) */
    const char *text;
    bool is_skipped; /* the text after the directive is not compiled. Set for a pragma in a
                      * skipped branch, and for an #if or #else that begins one */
} ir_directive;

/** The C dialect that the compiler's options select. Only strict_aliasing is in the text form. */
typedef struct ir_dialect {
    bool strict_aliasing; /* -fstrict-aliasing: accesses by incompatible types do not overlap */
    bool is_c89;          /* -std=c89 or the like: the program may use names that C99 reserved */
    bool math_errno;      /* mathematical functions may set errno */
    bool is_sanitized;    /* a sanitizer is enabled: undefined arithmetic may end the program */
    bool wraps;           /* signed arithmetic wraps around (-fwrapv) */
    bool has_openmp;      /* OpenMP directives are enabled; otherwise compilers ignore them */
    bool replaces_openmp; /* a loop's OpenMP directives may be dropped, because redcc parallelises
                           * the loop itself */
    const char *refusing_option; /* an option that makes the compiled program differ from this
                                  * tree; NULL if there is none */
    const char *inexact_option;  /* an option that lets the bits of floating-point results depend
                                  * on other code in the same compilation; NULL if there is
                                  * none */
} ir_dialect;

/** An #include directive that names one of the program's own headers. */
typedef struct ir_inclusion {
    const char *file; /* its path, as the search for the header gave it */
    bool is_in_main_file;
    uint32_t offset; /* offset in the main file of a byte of the directive's line */
} ir_inclusion;

/** Properties of the text of the file and its headers that the trees do not show. Not in the text
 *  form. */
typedef struct ir_text {
    bool includes_itself;      /* the file includes itself, so its text may be compiled several
                                * times */
    const char *compiler_word; /* a name in the program's own text that may test which compiler is
                                * used, such as "__clang"; NULL if there is none */
    const char *unseen_word;   /* a name or construct that another compiler may read differently
                                * than libclang, so that this tree would not be the program
                                * compiled; NULL if there is none */
    bool names_optimize;       /* the attribute optimize may occur in the program's own text or in
                                * a macro of the options, although no declaration in the tree
                                * shows it */
    bool names_target;         /* likewise, the attribute target or target_clones may occur */
    bool names_counter; /* __COUNTER__ occurs in a file of the program or an option: macros may
                         * expand to it */
    unsigned runtime_name_count; /* number of `runtime_names`: names in the program's texts or
                                  * options with a prefix that the runtime reserves */
    const char **runtime_names;
    unsigned header_pragma_count; /* number of pragmas in the program's own headers;
                                   * header_pragmas has their texts */
    const char **header_pragmas;
    map *macros;        /* name of each macro defined anywhere -> IR_MACRO_AS_OBJECT, or
                         * IR_MACRO_AS_FUNCTION if every definition has parameters. Macros known to
                         * expand to their own name are left out. NULL if there are none */
    map *macros_before; /* like `macros`, but only those that are defined before the main file
                         * begins (by the command line, or by a file that it includes), without the
                         * compiler's predefined ones */
    map *pragma_macros; /* the set of the program's macros that may expand to a pragma, by name.
                         * NULL if there are none */
    bool may_make_fenv_access; /* pragma_macros is set, and FENV_ACCESS occurs somewhere */
    map *names;        /* name of each function, type, tag, enumerator and file-scope variable that
                        * the program or its headers declare -> IR_NAME_AS_QUERY or
                        * IR_NAME_AS_OTHER. NULL if there are none */
    map *inner_names;  /* the set of names that function bodies declare as enumerators, types or
                        * tags. NULL if there are none */
    map *header_loops; /* each loop whose text is in one of the program's own headers (key: the
                        * pointer to its node) -> its ir_position. NULL if there are none */
    unsigned inclusion_count; /* number of `inclusions`, which are in source order; a header that is
                               * included twice occurs twice */
    const ir_inclusion *inclusions;
} ir_text;

typedef struct ir_unit {
    arena *arena;
    const source *source;
    unsigned function_count; /* number of `functions`; those with a body in the main file come
                              * first, in source order */
    ir_function **functions;
    unsigned variable_count; /* number of all variables; the id is the index */
    ir_variable **variables;
    unsigned directive_count; /* number of directives in the main file; they are in source
                               * order */
    ir_directive *directives;
    ir_dialect dialect;
    ir_text text;
    unsigned error_count;     /* number of compiler errors, in any file */
    unsigned reference_count; /* number of names in the bodies of the main file's functions.
                               * `references` is sorted by offset; the order at equal offsets is
                               * arbitrary. Not in the text form */
    const ir_reference *references;
    unsigned typed_place_count; /* number of typed places in the same bodies; sorted like
                                 * `references` */
    const ir_typed_place *typed_places;
} ir_unit;

#define IR_MACRO_AS_OBJECT ((void *)1)
#define IR_MACRO_AS_FUNCTION ((void *)2)
#define IR_NAME_AS_QUERY ((void *)1) /* declared only as a non-static `int name(void)` */
#define IR_NAME_AS_OTHER ((void *)2)

/* ---- queries ------------------------------------------------------------------------------- */

static inline ir_node *ir_child(const ir_node *node, unsigned index) {
    return index < node->child_count ? node->children[index] : NULL;
}
bool ir_is_expression(const ir_node *node);
/** Is the node an element, a member or a pointer's target: a[i], s.m, p->m, *p? */
bool ir_is_access(const ir_node *node);
/** Is the node an access (ir_is_access) whose value is loaded? False for an access of array type,
 *  which only computes an address. */
bool ir_reads_memory(const ir_node *node);
/** Is the node of the form &operand? */
bool ir_is_address_of(const ir_node *node);
/** The function that the call names; NULL if it calls through a pointer. */
ir_function *ir_called_function(const ir_node *call);
/** Does the expression have array type (ir_is_array) or pointer type (ir_is_pointer)? */
bool ir_is_array(const ir_node *node);
bool ir_is_pointer(const ir_node *node);
/** Is the node an IR_FOR, IR_WHILE or IR_DO? */
bool ir_is_loop(const ir_node *node);
/** Is the node a break, continue, goto or return? */
bool ir_is_jump(const ir_node *node);
/** The statement that a loop repeats. */
const ir_node *ir_loop_body(const ir_node *loop);
/** A predicate of one node. ir_any tells whether `question` holds for `node` or for any node below
 *  it. */
typedef bool (*ir_question)(const ir_node *node);
bool ir_any(const ir_node *node, ir_question question);
/** Is `node`, or a node below it, of that kind? */
bool ir_has_kind(const ir_node *node, ir_kind kind);
/** Does the tree contain a label, a `case` or a `default`? Then a jump from outside may enter
 *  it. */
bool ir_may_be_entered(const ir_node *node);
/** Does the tree contain a `case` or `default` of a switch that encloses the tree? */
bool ir_holds_case(const ir_node *node);
/** Is the node ++ or --, before or after its operand? */
bool ir_is_increment(const ir_node *node);
/** Does the node select the real or the imaginary part of its operand? */
bool ir_is_complex_part(const ir_node *node);
/** For a loop's body: does it contain a `continue` of that loop? */
bool ir_continues(const ir_node *node);
/** For a loop's body: does it contain a return, a goto, or a break of that loop? */
bool ir_leaves_loop(const ir_node *body);
/** Is the node ({ ... })? The node is opaque, but the block below it is complete. */
bool ir_is_statement_expression(const ir_node *node);

/** Does the node hold the lengths of a variable-length array at its declaration? Its children are
 *  these lengths. */
bool ir_is_lengths(const ir_node *node);
/** May evaluating the expression have a side effect? True if it contains an assignment, an
 *  increment, a call or an opaque part. */
bool ir_has_effect(const ir_node *node);
/** Does the parent use the value of this expression? False for an expression statement, the left
 *  side of a comma, the initialisation and increment of a for loop, and the operand of a cast to
 *  void. Also false for the right side of a comma, && or ||, and for a branch of ?:, if the value
 *  of that whole expression is not used. */
bool ir_value_is_used(const ir_node *node);
/** The variable's declarator in the tree; NULL if the tree has none. Ranges cannot decide this,
 *  because everything that a macro expands to has the same range. */
const ir_node *ir_declarator_in(const ir_node *tree, const ir_variable *variable);
bool ir_contains(const ir_node *outer, const ir_node *inner); /* is `outer` the node `inner` or an
                                                               * ancestor of it? */
/** The variable from which an access path starts: the x of x, x[i], x.m, x->m, *x, &x[i], (T)x.
 *  NULL if the path does not start at a variable. */
ir_variable *ir_root_variable(const ir_node *node);
const ir_function *ir_function_named(const ir_unit *unit, const char *name);

/** Calls `visit` for the node and all nodes below it in preorder. If `visit` returns false, the
 *  walk skips that node's children. */
typedef bool (*ir_visitor)(ir_node *node, void *context);
void ir_walk(ir_node *node, ir_visitor visit, void *context);

/* ---- building trees -------------------------------------------------------------------------- */

ir_node *ir_new(arena *a, ir_kind kind, const ir_type *type, unsigned child_count);
/** Sets the parents and ids of the nodes of a function's body, and the function's node_count. */
void ir_finish_function(ir_function *function);
/** Sets reference_count of all functions of the unit. */
void ir_count_references(ir_unit *unit);
/** Copies an expression and replaces each parameter of `function` by a copy of its argument. A
 *  parameter whose argument is NULL stays. p->m with &x for p becomes x.m. An argument whose scalar
 *  type differs from the parameter's is wrapped in an IR_CAST, as the call would convert it. The
 *  copy's nodes have no ids and belong to no function; its root has no parent. */
ir_node *ir_substitute(arena *a, const ir_node *expression, const ir_function *function,
                       ir_node *const *arguments);

/** Spells a type as clang does ("const double *"), from its kind, target and qualifiers. Records
 *  and enumerations keep the spelling they have. NULL if C cannot name the type. */
const char *ir_type_default_spelling(arena *a, const ir_type *type);

#endif
