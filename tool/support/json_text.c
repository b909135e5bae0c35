/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/json_text.h"

#include <stdlib.h>
#include <string.h>

json_t *json_text(const char *text) {
    if (!text)
        return json_null();
    json_t *value = json_string(text);
    if (value)
        return value;
    buffer ascii = {0};
    for (const char *c = text; *c; c++)
        buffer_byte(&ascii, (unsigned char)*c < 0x80 ? *c : '?');
    value = json_string(ascii.data ? ascii.data : "");
    buffer_free(&ascii);
    return value;
}

void json_print(buffer *out, json_t *value) {
    char *text = json_dumps(value, JSON_INDENT(2) | JSON_PRESERVE_ORDER);
    if (text)
        buffer_format(out, "%s\n", text);
    free(text);
    json_decref(value);
}
