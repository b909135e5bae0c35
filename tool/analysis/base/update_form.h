/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Recognises the forms of an update: R += e, R = R + e, R = e + R - g, ++R and so on. */
#ifndef ANALYSIS_UPDATE_FORM_H
#define ANALYSIS_UPDATE_FORM_H

#include "analysis/base/facts.h"

typedef struct update_form {
    bool is_update;    /* the node writes a function of its target's old value */
    bool has_operator; /* the update uses one of the operators of reductions, which is `op` */
    reduction_operator op;
    const ir_node *target;
    const ir_node *self;  /* the occurrence of the target in the value, as in R = R + e; NULL for
                           * other forms */
    const ir_node *value; /* the right side; NULL for ++ and -- */
} update_form;

/** Classifies an IR_ASSIGN or IR_UNARY. For a plain store, and for v = v + e with a variable v,
 *  is_update is false. */
update_form update_form_of(const ir_node *node);

#endif
