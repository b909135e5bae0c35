/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The value of an #if condition as far as it depends on which compiler it is. */
#ifndef DRIVER_CONDITION_H
#define DRIVER_CONDITION_H

#include <stdbool.h>
#include <stdint.h>

/** __GNUC__ and __GNUC_MINOR__, and whether __clang__ is defined. */
typedef struct condition_version {
    int major;
    int minor;
    bool is_clang;
} condition_version;

/** Known, with a value; or unknown: `form` is then a hash of what it is made of, so that two
 *  conditions of the same form have the same value, whatever the unknown names stand for. */
typedef struct condition_value {
    bool is_wrong; /**< not an expression that is understood */
    bool is_known;
    int64_t value;
    uint64_t form;
} condition_value;

/** Evaluates an expression of the preprocessor (C17 6.10.1). Names but those of the version are
 *  unknown; `defined` is known of these alone. */
condition_value condition_evaluate(const char *expression, condition_version version);

/** Whether both are the same value, or the same unknown; false where either is wrong. */
bool condition_equal(const condition_value *left, const condition_value *right);

#endif
