/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** May two locations overlap, if at least one is written? */
#ifndef ANALYSIS_ALIAS_H
#define ANALYSIS_ALIAS_H

#include "analysis/memory/location.h"

typedef enum overlap {
    OVERLAP_NO,    /* proved disjoint */
    OVERLAP_MAYBE, /* unknown: decided by addresses at run time */
    OVERLAP_SAME   /* in one object or behind one pointer: no guard could prove them disjoint */
} overlap;

typedef struct alias_rules {
    variable_facts *facts;
    bool strict_aliasing; /* C's effective types (C17 6.5p7) may be used */
    bool assume_noalias;  /* asserted by the user: distinct pointers do not overlap */
    const ir_node *loop;  /* the analysed loop: the compared accesses may be of different
                           * iterations */
} alias_rules;

/** By their types, too: for a load that is only moved to an earlier place, and for accesses that
 *  both read first (type_changes.h). */
overlap locations_overlap(const alias_rules *rules, const location *a, const location *b);

/** The same for an access and a store that another iteration makes, perhaps after it. The store
 * gives memory without a declared type the type of the stored value (C17 6.5p6); earlier accesses
 * may have used another type. Only declared objects are distinguished by their types. */
overlap locations_overlap_store(const alias_rules *rules, const location *read,
                                const location *store);

/** May an object of type `a` be accessed as `b`, by the rule of effective types? */
bool types_may_overlap(const ir_type *a, const ir_type *b);

#endif
