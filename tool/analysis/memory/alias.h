/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** May two locations overlap, of which at least one is written? */
#ifndef ANALYSIS_ALIAS_H
#define ANALYSIS_ALIAS_H

#include "analysis/memory/location.h"

typedef enum overlap {
    OVERLAP_NO,    /* proved apart */
    OVERLAP_MAYBE, /* not known: addresses at run time tell */
    OVERLAP_SAME   /* of one object or behind one pointer: no guard can hold */
} overlap;

typedef struct alias_rules {
    variable_facts *facts;
    bool strict_aliasing; /* C's effective types (C17 6.5p7) may be used */
    bool assume_noalias;  /* the user's word: distinct pointers do not overlap */
    const ir_node *loop;  /* that is analysed: what is compared may be of different iterations */
} alias_rules;

overlap locations_overlap(const alias_rules *rules, const location *a, const location *b);

/** The same of a read and of a store that another iteration makes, maybe after it. The store gives
 *  memory without a declared type the stored value's (C17 6.5p6): what was read there before may
 *  have been of another. Only declared objects are kept apart by their types. */
overlap locations_overlap_store(const alias_rules *rules, const location *read,
                                const location *store);

/** May an object of type `a` be accessed as `b`, by the rule of effective types? */
bool types_may_overlap(const ir_type *a, const ir_type *b);

#endif
