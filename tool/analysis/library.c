/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/library.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* C17 7.12, 7.22.6 and what gcc and clang make of them; sorted by name (a test looks). Functions
 * that write through a pointer (frexp, modf, remquo, sincos) or a global (lgamma) are not here. */
static const library_function functions[] = {
    {"abs", false, true},       {"acos", true, false},       {"acosh", true, false},
    {"asin", true, false},      {"asinh", true, false},      {"atan", true, false},
    {"atan2", true, false},     {"atanh", true, false},      {"cabs", true, false},
    {"carg", false, false},     {"cbrt", false, false},      {"ceil", false, true},
    {"cimag", false, true},     {"clz", false, true},        {"clzl", false, true},
    {"clzll", false, true},     {"conj", false, true},       {"copysign", false, true},
    {"cos", true, false},       {"cosh", true, false},       {"creal", false, true},
    {"ctz", false, true},       {"ctzl", false, true},       {"ctzll", false, true},
    {"erf", true, false},       {"erfc", true, false},       {"exp", true, false},
    {"exp10", true, false},     {"exp2", true, false},       {"expect", false, true},
    {"expm1", true, false},     {"fabs", false, true},       {"fdim", true, false},
    {"floor", false, true},     {"fma", true, true},         {"fmax", false, true},
    {"fmin", false, true},      {"fmod", true, true},        {"huge_val", false, true},
    {"hypot", true, false},     {"ilogb", true, true},       {"inf", false, true},
    {"isfinite", false, true},  {"isinf", false, true},      {"isinf_sign", false, true},
    {"isnan", false, true},     {"isnormal", false, true},   {"labs", false, true},
    {"ldexp", true, true},      {"llabs", false, true},      {"llrint", true, true},
    {"llround", true, true},    {"log", true, false},        {"log10", true, false},
    {"log1p", true, false},     {"log2", true, false},       {"logb", true, true},
    {"lrint", true, true},      {"lround", true, true},      {"nan", false, true},
    {"nearbyint", false, true}, {"parity", false, true},     {"popcount", false, true},
    {"popcountl", false, true}, {"popcountll", false, true}, {"pow", true, false},
    {"remainder", true, true},  {"rint", false, true},       {"round", false, true},
    {"scalbln", true, true},    {"scalbn", true, true},      {"signbit", false, true},
    {"sin", true, false},       {"sinh", true, false},       {"sqrt", true, true},
    {"tan", true, false},       {"tanh", true, false},       {"tgamma", true, false},
    {"trunc", false, true},
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
