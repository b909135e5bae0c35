/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The spellings of an update: R += e, R = R + e, R = e + R - g, ++R, ... */
#ifndef ANALYSIS_UPDATE_FORM_H
#define ANALYSIS_UPDATE_FORM_H

#include "analysis/base/facts.h"

typedef struct update_form {
    bool is_update;    /* the node writes a function of what its target held */
    bool has_operator; /* by an operator that reductions have: `op` */
    reduction_operator op;
    const ir_node *target;
    const ir_node *self;  /* where the target stands again in the value: R = R + e; else NULL */
    const ir_node *value; /* right side, NULL for ++ and -- */
} update_form;

/** Looks at an IR_ASSIGN or IR_UNARY; a plain store has is_update false. */
update_form update_form_of(const ir_node *node);

#endif
