/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Statements of the IR as C: whole, or only those that a slice keeps. */
#ifndef EMIT_TEXT_PRINT_H
#define EMIT_TEXT_PRINT_H

#include "emit/text/text.h"

typedef struct printer printer;
struct printer {
    arena *arena;
    writer *out;
    const bool *keep;   /* by node id: what to print; NULL: everything. Of control that is not kept
                           the parts below it are printed as if always executed, once */
    ir_c_rename rename; /* as ir_c_expression takes it */
    void *context;
    /** Called before each statement, kept or not; true: nothing more is to be printed for it. Also
     * before each declarator of a block's declarations, where what it gives does not count. */
    bool (*before)(printer *p, const ir_node *statement);
    /** May be NULL. True: this `for` is printed as an `if` of its condition, after its
     * initialisation, with what `print_at_once` prints for its body. */
    bool (*is_at_once)(const printer *p, const ir_node *loop);
    void (*print_at_once)(printer *p, const ir_node *loop);
    /** What stands in front of a `for`, with a blank behind it; may be NULL. */
    const char *(*in_front_of_for)(const ir_node *loop);
    void (*at_end)(printer *p); /* before print_body closes the block; may be NULL */
    const char *problem;        /* the first thing that cannot be printed, or NULL */
    bool continues;             /* a `continue` of the loop around the whole was printed */
    unsigned unkept_since_break, unkept_since_continue; /* control left out between a jump and what
                                                           it jumps to: start at 0 */
    size_t settled_end; /* length of the text when a jump, label or head of a switch had just been
                           printed: nothing falls through into a case that follows */
    bool in_loop, in_switch; /* a loop, a switch or loop, has been printed around this */
};

/** Prints a statement with all below it. */
void print_statement(printer *p, const ir_node *statement);
/** Prints what stands in a block, without its braces unless it declares something. */
void print_body(printer *p, const ir_node *body);
/** The expression as C; sets p->problem where it cannot be spelled, and returns "0". */
const char *print_expression(printer *p, const ir_node *expression);

#endif
