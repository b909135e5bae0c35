/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/method.h"

#include <string.h>

const struct method *const redcc_methods[] = {
#define METHOD(name) &redcc_method_##name,
#include "plan/methods.def"
#undef METHOD
    NULL};

static bool is_name(const char *name, const char *text, size_t length) {
    return name && strlen(name) == length && memcmp(name, text, length) == 0;
}

bool redcc_method_is_named(const struct method *method, const char *text, size_t length) {
    return is_name(method->name, text, length) || is_name(method->alias, text, length);
}
