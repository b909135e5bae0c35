/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fuzz/kernel.h"

#include <string.h>

/* Texts that may replace a blank or a line end. */
static const char *const blanks[] = {
    " ", "  ", "\n", "\t", " \\\n ", " /* i < n; */ ", "\n/* } */\n", " // k++;\n  "};

void put_with_noise(buffer *b, random_source *r, const char *text) {
    for (; *text; text++) {
        if ((*text == ' ' || *text == '\n') && random_chance(r, 25))
            buffer_text(b, blanks[random_below(r, (int)(sizeof blanks / sizeof *blanks))]);
        else
            buffer_byte(b, *text);
    }
}

/* ---- conditional directives ------------------------------------------------------------------ */

static const char *const holds[] = {"1", "defined(ADD)", "!defined(FUZZ_NEVER)", "__LINE__ > 0",
                                    "defined(EACH) /* and\n */ && 1"};
static const char *const fails[] = {"0", "defined(FUZZ_NEVER)", "!defined ADD", "__LINE__ < 1"};
static const char *const left_out[] = {"} else {\n", "#pragma omp parallel for\n", "i++; /* } */\n",
                                       "#if 1\nfor (;;) {\n#else\n}\n#endif\n", ""};

static const char *one_of(random_source *r, const char *const *texts, size_t bytes) {
    return texts[random_below(r, (int)(bytes / sizeof *texts))];
}

#define ONE_OF(r, texts) one_of(r, texts, sizeof(texts))

static void put_branch(buffer *b, random_source *r, const char *line, int length) {
    const char *holding = ONE_OF(r, holds), *failing = ONE_OF(r, fails), *out = ONE_OF(r, left_out);
    switch (random_below(r, 5)) {
    case 0:
        buffer_format(b, "#if %s\n%s#else\n%.*s#endif\n", failing, out, length, line);
        break;
    case 1:
        buffer_format(b, "#if %s\n%.*s#else\n%s#endif\n", holding, length, line, out);
        break;
    case 2:
        buffer_format(b, "#if %s\n%s#elif %s\n%.*s#else\n%s#endif\n", failing, out, holding, length,
                      line, out);
        break;
    case 3:
        buffer_format(b, "# if %s\n%s#elif %s\n%s# endif\n%.*s", failing, out, failing, out, length,
                      line);
        break;
    default:
        buffer_format(b, "#if %s\n#ifdef FUZZ_NEVER\n%s#endif\n%.*s#endif\n", holding, out, length,
                      line);
    }
}

void put_with_branches(buffer *b, random_source *r, const char *text) {
    while (*text) {
        const char *const end = strchr(text, '\n');
        const int length = end ? (int)(end + 1 - text) : (int)strlen(text);
        if (end && random_chance(r, 25))
            put_branch(b, r, text, length);
        else
            buffer_append(b, text, (size_t)length);
        text += length;
    }
}
