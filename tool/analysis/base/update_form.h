/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The spellings of an update: R += e, R = R + e, R = e + R - g, ++R, ... */
#ifndef ANALYSIS_UPDATE_FORM_H
#define ANALYSIS_UPDATE_FORM_H

#include "analysis/base/facts.h"

typedef struct update_form {
    bool is_update;    /* the node writes a function of its target's old value */
    bool has_operator; /* by an operator of reductions: `op` */
    reduction_operator op;
    const ir_node *target;
    const ir_node *self;  /* the second occurrence of the target, in the value: R = R + e; else
                           * NULL */
    const ir_node *value; /* right side, NULL for ++ and -- */
} update_form;

/** Classifies an IR_ASSIGN or IR_UNARY. A plain store has is_update false, and so has v = v + e
 * with a variable v. */
update_form update_form_of(const ir_node *node);

#endif
