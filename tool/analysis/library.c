/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/library.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* C17 7.12, 7.22.6 and what gcc and clang make of them; sorted by name (a test looks). Functions
 * that write through a pointer (frexp, modf, remquo, sincos) or a global (lgamma) are not here. */
static const library_function functions[] = {
    {"abs", false},        {"acos", true},        {"acosh", true},     {"asin", true},
    {"asinh", true},       {"atan", true},        {"atan2", true},     {"atanh", true},
    {"cabs", true},        {"carg", false},       {"cbrt", false},     {"ceil", false},
    {"cimag", false},      {"clz", false},        {"clzl", false},     {"clzll", false},
    {"conj", false},       {"copysign", false},   {"cos", true},       {"cosh", true},
    {"creal", false},      {"ctz", false},        {"ctzl", false},     {"ctzll", false},
    {"erf", true},         {"erfc", true},        {"exp", true},       {"exp10", true},
    {"exp2", true},        {"expect", false},     {"expm1", true},     {"fabs", false},
    {"fdim", true},        {"floor", false},      {"fma", true},       {"fmax", false},
    {"fmin", false},       {"fmod", true},        {"huge_val", false}, {"hypot", true},
    {"ilogb", true},       {"inf", false},        {"isfinite", false}, {"isinf", false},
    {"isinf_sign", false}, {"isnan", false},      {"isnormal", false}, {"labs", false},
    {"ldexp", true},       {"llabs", false},      {"llround", true},   {"log", true},
    {"log10", true},       {"log1p", true},       {"log2", true},      {"logb", true},
    {"lround", true},      {"nan", false},        {"parity", false},   {"popcount", false},
    {"popcountl", false},  {"popcountll", false}, {"pow", true},       {"remainder", true},
    {"round", false},      {"scalbln", true},     {"scalbn", true},    {"signbit", false},
    {"sin", true},         {"sinh", true},        {"sqrt", true},      {"tan", true},
    {"tanh", true},        {"tgamma", true},      {"trunc", false},
};

static int compare(const void *key, const void *entry) {
    return strcmp(key, ((const library_function *)entry)->name);
}

static const library_function *find(const char *name) {
    return bsearch(name, functions, sizeof functions / sizeof functions[0], sizeof functions[0],
                   compare);
}

const library_function *library_find(const char *name) {
    static const char prefix[] = "__builtin_";
    char stem[16];
    size_t length;
    if (strncmp(name, prefix, sizeof prefix - 1) == 0)
        name += sizeof prefix - 1;
    const library_function *found = find(name);
    length = strlen(name);
    if (found || length < 2 || length > sizeof stem)
        return found;
    if (name[length - 1] != 'f' && name[length - 1] != 'l')
        return NULL;
    memcpy(stem, name, length - 1);
    stem[length - 1] = 0;
    return find(stem);
}
