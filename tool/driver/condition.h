/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The value of an #if condition as a function of the compiler's version. */
#ifndef DRIVER_CONDITION_H
#define DRIVER_CONDITION_H

#include <stdbool.h>
#include <stdint.h>

/** The macros that give the compiler's version: the values of __GNUC__ and __GNUC_MINOR__, and
 * of __clang_major__, which only clang defines, as it does __clang__. */
typedef struct condition_version {
    int major;
    int minor;
    int clang_major; /**< 0: not clang */
} condition_version;

/** A known or unknown value. The `form` of an unknown value is the hash of its expression: two
 * unknown values with the same form are equal, whatever the unknown names stand for. */
typedef struct condition_value {
    bool is_wrong; /**< the expression is not understood */
    bool is_known;
    int64_t value;
    uint64_t form;
} condition_value;

/** Evaluates a preprocessor expression (C17 6.10.1). Only the macros that `version` determines have
 * known values; they are also the only known operands of `defined`. */
condition_value condition_evaluate(const char *expression, condition_version version);

/** Returns whether both are the same value, or the same unknown; false if either is wrong. */
bool condition_equal(const condition_value *left, const condition_value *right);

#endif
