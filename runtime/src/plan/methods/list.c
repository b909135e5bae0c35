/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/method.h"

#include <string.h>

/* clang-format off */
const struct method *const redcc_methods[] = {
    &redcc_method_serial,
    &redcc_method_atomic,
    &redcc_method_localwrite,
    &redcc_method_localwrite_steal,
    &redcc_method_graph_localwrite,
    &redcc_method_graph_localwrite_steal,
    &redcc_method_wavefront,
    &redcc_method_expansion,
    &redcc_method_pseudo_expansion,
    &redcc_method_dwa_lip,
    &redcc_method_pe_dwa_lip,
    &redcc_method_dwa_lip_fixed,
    &redcc_method_expansion_fixed,
    NULL,
};
/* clang-format on */

static bool is_name(const char *name, const char *text, size_t length) {
    return name && strlen(name) == length && memcmp(name, text, length) == 0;
}

bool redcc_method_is_named(const struct method *method, const char *text, size_t length) {
    return is_name(method->name, text, length) || is_name(method->alias, text, length);
}
