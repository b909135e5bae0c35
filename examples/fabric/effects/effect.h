/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The effects as an enumeration (EFFECT_DRAG, ...), and which of them this build contains. */
#ifndef FABRIC_EFFECT_H
#define FABRIC_EFFECT_H

enum {
#define EFFECT(NAME, text, active, elements) EFFECT_##NAME,
#include "effects.def"
    EFFECT_COUNT
};

/* Bit mask of the effects that a build leaves out, to measure what each effect costs. */
#ifndef FABRIC_WITHOUT
#define FABRIC_WITHOUT 0
#endif

#define BUILT_WITH(effect) (((unsigned)FABRIC_WITHOUT >> (effect)&1u) == 0)

#endif
