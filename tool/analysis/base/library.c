/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/library.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* Functions of C17 7.3, 7.12 and 7.22.6, and gcc's and clang's versions of them, sorted by name (a
 * test checks this). Functions that write through a pointer (frexp, modf, remquo, sincos) or to a
 * global (lgamma) are left out. isnan and the like are macros of <math.h> that expand to builtins,
 * so only the builtins' names are in the table. */
static const library_function functions[] = {
    {"abs", false, true, LIBRARY_C89, false},
    {"acos", true, false, LIBRARY_C89, true},
    {"acosh", true, false, LIBRARY_C99, true},
    {"asin", true, false, LIBRARY_C89, true},
    {"asinh", true, false, LIBRARY_C99, true},
    {"atan", true, false, LIBRARY_C89, true},
    {"atan2", true, false, LIBRARY_C89, true},
    {"atanh", true, false, LIBRARY_C99, true},
    {"cabs", true, false, LIBRARY_C99, true},
    {"carg", false, false, LIBRARY_C99, true},
    {"cbrt", false, false, LIBRARY_C99, true},
    {"ceil", false, true, LIBRARY_C89, true},
    {"cimag", false, true, LIBRARY_C99, true},
    {"clz", false, true, LIBRARY_BUILTIN, false},
    {"clzl", false, true, LIBRARY_BUILTIN, false},
    {"clzll", false, true, LIBRARY_BUILTIN, false},
    {"conj", false, true, LIBRARY_C99, true},
    {"copysign", false, true, LIBRARY_C99, true},
    {"cos", true, false, LIBRARY_C89, true},
    {"cosh", true, false, LIBRARY_C89, true},
    {"creal", false, true, LIBRARY_C99, true},
    {"ctz", false, true, LIBRARY_BUILTIN, false},
    {"ctzl", false, true, LIBRARY_BUILTIN, false},
    {"ctzll", false, true, LIBRARY_BUILTIN, false},
    {"erf", true, false, LIBRARY_C99, true},
    {"erfc", true, false, LIBRARY_C99, true},
    {"exp", true, false, LIBRARY_C89, true},
    {"exp10", true, false, LIBRARY_GNU, true},
    {"exp2", true, false, LIBRARY_C99, true},
    {"expect", false, true, LIBRARY_BUILTIN, false},
    {"expm1", true, false, LIBRARY_C99, true},
    {"fabs", false, true, LIBRARY_C89, true},
    {"fdim", true, false, LIBRARY_C99, true},
    {"floor", false, true, LIBRARY_C89, true},
    {"fma", true, true, LIBRARY_C99, true},
    {"fmax", false, true, LIBRARY_C99, true},
    {"fmin", false, true, LIBRARY_C99, true},
    {"fmod", true, true, LIBRARY_C89, true},
    {"huge_val", false, true, LIBRARY_BUILTIN, true},
    {"hypot", true, false, LIBRARY_C99, true},
    {"ilogb", true, true, LIBRARY_C99, true},
    {"inf", false, true, LIBRARY_BUILTIN, true},
    {"isfinite", false, true, LIBRARY_BUILTIN, true},
    {"isinf", false, true, LIBRARY_BUILTIN, true},
    {"isinf_sign", false, true, LIBRARY_BUILTIN, false},
    {"isnan", false, true, LIBRARY_BUILTIN, true},
    {"isnormal", false, true, LIBRARY_BUILTIN, true},
    {"labs", false, true, LIBRARY_C89, false},
    {"ldexp", true, true, LIBRARY_C89, true},
    {"llabs", false, true, LIBRARY_C99, false},
    {"llrint", true, true, LIBRARY_C99, true},
    {"llround", true, true, LIBRARY_C99, true},
    {"log", true, false, LIBRARY_C89, true},
    {"log10", true, false, LIBRARY_C89, true},
    {"log1p", true, false, LIBRARY_C99, true},
    {"log2", true, false, LIBRARY_C99, true},
    {"logb", true, true, LIBRARY_C99, true},
    {"lrint", true, true, LIBRARY_C99, true},
    {"lround", true, true, LIBRARY_C99, true},
    {"nan", false, true, LIBRARY_C99, true},
    {"nearbyint", false, true, LIBRARY_C99, true},
    {"parity", false, true, LIBRARY_BUILTIN, false},
    {"popcount", false, true, LIBRARY_BUILTIN, false},
    {"popcountl", false, true, LIBRARY_BUILTIN, false},
    {"popcountll", false, true, LIBRARY_BUILTIN, false},
    {"pow", true, false, LIBRARY_C89, true},
    {"remainder", true, true, LIBRARY_C99, true},
    {"rint", false, true, LIBRARY_C99, true},
    {"round", false, true, LIBRARY_C99, true},
    {"scalbln", true, true, LIBRARY_C99, true},
    {"scalbn", true, true, LIBRARY_C99, true},
    {"signbit", false, true, LIBRARY_BUILTIN, true},
    {"sin", true, false, LIBRARY_C89, true},
    {"sinh", true, false, LIBRARY_C89, true},
    {"sqrt", true, true, LIBRARY_C89, true},
    {"tan", true, false, LIBRARY_C89, true},
    {"tanh", true, false, LIBRARY_C89, true},
    {"tgamma", true, false, LIBRARY_C99, true},
    {"trunc", false, true, LIBRARY_C99, true},
};

static int compare(const void *key, const void *entry) {
    return strcmp(key, ((const library_function *)entry)->name);
}

static const library_function *find(const char *name) {
    return bsearch(name, functions, sizeof functions / sizeof functions[0], sizeof functions[0],
                   compare);
}

static const library_function *find_with_variants(const char *name) {
    char stem[16];
    const library_function *found = find(name);
    const size_t length = strlen(name);
    if (found || length < 2 || length > sizeof stem ||
        (name[length - 1] != 'f' && name[length - 1] != 'l'))
        return found;
    memcpy(stem, name, length - 1);
    stem[length - 1] = 0;
    found = find(stem);
    return found && found->has_variants ? found : NULL;
}

static bool is_reserved(const ir_unit *unit, const ir_function *function,
                        library_standard standard) {
    switch (standard) {
    case LIBRARY_C89:
        return true;
    case LIBRARY_C99:
        return !unit->dialect.is_c89 || function->is_from_system;
    case LIBRARY_GNU:
        return function->is_from_system;
    default:
        return false;
    }
}

const library_function *library_find(const ir_unit *unit, const ir_function *function) {
    static const char prefix[] = "__builtin_";
    const size_t length = sizeof prefix - 1;
    if (function->linkage.is_renamed || function->body)
        return NULL;
    if (strncmp(function->name, prefix, length) == 0)
        return find_with_variants(function->name + length);
    const library_function *found = find_with_variants(function->name);
    return found && is_reserved(unit, function, found->standard) ? found : NULL;
}

bool library_plain_name(const char *name, char plain[LIBRARY_NAME_SIZE]) {
    assert(name && plain);
    static const char builtin[] = "__builtin_", suffix[] = "_chk";
    if (strncmp(name, builtin, sizeof builtin - 1) == 0)
        name += sizeof builtin - 1;
    size_t length = strlen(name);
    const size_t around = 2 + sizeof suffix - 1;
    if (length > around && strncmp(name, "__", 2) == 0 &&
        strcmp(name + length - (sizeof suffix - 1), suffix) == 0) {
        name += 2;
        length -= around;
    }
    if (length >= LIBRARY_NAME_SIZE)
        return false;
    memcpy(plain, name, length);
    plain[length] = '\0';
    return true;
}

bool library_is_locale_table(const ir_node *call) {
    static const char *const names[] = {"__ctype_b_loc", "__ctype_tolower_loc",
                                        "__ctype_toupper_loc"};
    if (call->kind != IR_CALL || call->children[0]->kind != IR_FUNCTION ||
        call->children[0]->function->body)
        return false;
    const char *name = call->children[0]->function->name;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strcmp(name, names[i]) == 0)
            return true;
    return false;
}

/* A function declared const depends only on its arguments. If it has none, its result may be
 * specific to a thread (pthread_self, __errno_location); and a pointer result may be the address of
 * thread-local data. Functions declared pure need no check here: they may read all memory,
 * including the arrays, and are refused for that. */
bool library_depends_on_thread(const ir_function *function) {
    const ir_type *result = function->type ? function->type->target : NULL;
    return function->is_attribute_const &&
           (function->parameter_count == 0 || !result || result->kind == IR_POINTER);
}

/* Functions that the C library's headers declare pure or const and that read no thread-local data
 * except the locale, which the loop's threads share. The names have no leading __ and no suffix for
 * a type. Sorted. */
static const char *const same_in_threads[] = {"a64l",
                                              "abs",
                                              "argz_count",
                                              "atof",
                                              "atoi",
                                              "atol",
                                              "atoll",
                                              "bcmp",
                                              "ceil",
                                              "copysign",
                                              "difftime",
                                              "div",
                                              "dysize",
                                              "fabs",
                                              "ffs",
                                              "ffsl",
                                              "ffsll",
                                              "finite",
                                              "floor",
                                              "fmax",
                                              "fmaximum",
                                              "fmaximum_mag",
                                              "fmaximum_mag_num",
                                              "fmaximum_num",
                                              "fmaxmag",
                                              "fmin",
                                              "fminimum",
                                              "fminimum_mag",
                                              "fminimum_mag_num",
                                              "fminimum_num",
                                              "fminmag",
                                              "fpclassify",
                                              "gnu_dev_major",
                                              "gnu_dev_makedev",
                                              "gnu_dev_minor",
                                              "htonl",
                                              "htons",
                                              "imaxabs",
                                              "imaxdiv",
                                              "index",
                                              "iscanonical",
                                              "isinf",
                                              "isnan",
                                              "issignaling",
                                              "labs",
                                              "ldiv",
                                              "llabs",
                                              "lldiv",
                                              "mbsinit",
                                              "memchr",
                                              "memcmp",
                                              "memcmpeq",
                                              "memmem",
                                              "memrchr",
                                              "ntohl",
                                              "ntohs",
                                              "pthread_equal",
                                              "rawmemchr",
                                              "rindex",
                                              "round",
                                              "roundeven",
                                              "signbit",
                                              "strcasecmp",
                                              "strcasecmp_l",
                                              "strcasestr",
                                              "strchr",
                                              "strchrnul",
                                              "strcmp",
                                              "strcoll",
                                              "strcoll_l",
                                              "strcspn",
                                              "strlen",
                                              "strncasecmp",
                                              "strncasecmp_l",
                                              "strncmp",
                                              "strnlen",
                                              "strpbrk",
                                              "strrchr",
                                              "strspn",
                                              "strstr",
                                              "strverscmp",
                                              "totalorder",
                                              "totalordermag",
                                              "trunc",
                                              "wcschr",
                                              "wcschrnul",
                                              "wcscmp",
                                              "wcscspn",
                                              "wcslen",
                                              "wcsncmp",
                                              "wcsnlen",
                                              "wcspbrk",
                                              "wcsrchr",
                                              "wcsspn",
                                              "wcsstr",
                                              "wcswcs",
                                              "wmemchr",
                                              "wmemcmp"};

static int compare_names(const void *key, const void *entry) {
    return strcmp(key, *(const char *const *)entry);
}

static bool is_same_in_threads(const char *name) {
    return bsearch(name, same_in_threads, sizeof same_in_threads / sizeof same_in_threads[0],
                   sizeof same_in_threads[0], compare_names) != NULL;
}

bool library_is_same_in_threads(const ir_function *function) {
    static const char *const suffixes[] = {"f", "l", "f32", "f32x", "f64", "f64x", "f128"};
    const char *name = function->name;
    if (strncmp(name, "__builtin_", 10) == 0)
        return true;
    if (!function->is_from_system || function->linkage.is_renamed)
        return false;
    name += strncmp(name, "__", 2) == 0 ? 2 : 0;
    bool is_known = is_same_in_threads(name);
    for (size_t i = 0; !is_known && i < sizeof suffixes / sizeof suffixes[0]; i++) {
        char stem[24];
        const size_t length = strlen(name), tail = strlen(suffixes[i]);
        if (length <= tail || length - tail >= sizeof stem ||
            strcmp(name + length - tail, suffixes[i]) != 0)
            continue;
        memcpy(stem, name, length - tail);
        stem[length - tail] = 0;
        is_known = is_same_in_threads(stem);
    }
    return is_known;
}

bool library_is_message_passing(const ir_function *function) {
    return !function->body &&
           (strncmp(function->name, "MPI_", 4) == 0 || strncmp(function->name, "PMPI_", 5) == 0);
}
