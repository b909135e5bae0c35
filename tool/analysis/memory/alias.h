/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Determines whether two locations may overlap, if at least one of them is written. */
#ifndef ANALYSIS_ALIAS_H
#define ANALYSIS_ALIAS_H

#include "analysis/memory/location.h"

typedef enum overlap {
    OVERLAP_NO,    /* proved disjoint */
    OVERLAP_MAYBE, /* unknown; at run time, addresses decide */
    OVERLAP_SAME   /* they are in one object or behind one pointer, and no guard could prove them
                    * disjoint */
} overlap;

typedef struct alias_rules {
    variable_facts *facts;
    bool strict_aliasing; /* C's effective type rule (C17 6.5p7) may be used */
    bool assume_noalias;  /* the user asserts that distinct pointers do not overlap */
    const ir_node *loop;  /* the analysed loop; the two accesses may be in different iterations */
} alias_rules;

/** May the locations overlap? Types count too. Use this for a load that is only moved to an earlier
 *  place, and for accesses that both read first (type_changes.h). */
overlap locations_overlap(const alias_rules *rules, const location *a, const location *b);

/** Same as locations_overlap, for an access and a store that another iteration makes, perhaps
 *  later. A store gives memory without a declared type the type of the stored value (C17 6.5p6),
 *  and earlier accesses may have used another type. Types are therefore used only if one of the
 *  locations is in a declared object. */
overlap locations_overlap_store(const alias_rules *rules, const location *read,
                                const location *store);

/** May an object of type `a` be accessed as `b`, under the effective type rule? */
bool types_may_overlap(const ir_type *a, const ir_type *b);

#endif
