/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Prints statements of the IR as C: entirely, or only the parts that a slice keeps. */
#ifndef EMIT_TEXT_PRINT_H
#define EMIT_TEXT_PRINT_H

#include "emit/text/text.h"

typedef struct printer printer;
struct printer {
    arena *arena;
    writer *out;
    const bool *keep;   /* indexed by node id: the parts to print; NULL: print everything. If a
                         * control statement is omitted but parts under it are kept, these are
                         * printed as if executed once */
    ir_c_rename rename; /* as in ir_c_expression */
    void *context;
    /** Called before each statement, kept or not; true: it is skipped. Also called, with the result
     * ignored, before each declarator of a block's declarations. */
    bool (*before)(printer *p, const ir_node *statement);
    /** Returns true if this `for` is printed as its initialisation, followed by an `if` with the
     * loop's condition, whose body print_at_once prints. May be NULL. */
    bool (*is_at_once)(const printer *p, const ir_node *loop);
    void (*print_at_once)(printer *p, const ir_node *loop);
    /** The text before a `for`, with a blank after it; may be NULL. */
    const char *(*in_front_of_for)(const ir_node *loop);
    /** The step expression of a `for` that replaces its own, or NULL to keep its own. The hook
     * itself may be NULL. */
    const char *(*step_of)(printer *p, const ir_node *loop);
    void (*at_end)(printer *p); /* before print_body closes the block; may be NULL */
    const char *problem;        /* the first part that cannot be printed, or NULL */
    bool continues;             /* a `continue` of the outermost loop was printed */
    unsigned unkept_since_break, unkept_since_continue; /* the number of omitted control statements
                                                         * since the target of a jump; start at 0 */
    size_t no_fall_through_at; /* length of the text after a jump, a label or the head of a switch:
                                * control does not fall through into a case that is printed at this
                                * length */
    bool in_loop;              /* a printed loop encloses the current node */
    bool in_switch;            /* a printed switch or loop encloses it */
};

/** Prints a statement and the statements inside it, except what `keep` omits. */
void print_statement(printer *p, const ir_node *statement);
/** Prints the contents of a block, without its braces unless it has declarations. */
void print_body(printer *p, const ir_node *body);

#endif
