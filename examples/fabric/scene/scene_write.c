/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "scene.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene_keys.h"

static void write_mapping(FILE *file, const scene_key *keys, const void *source, int indent,
                          int first_indent);

/** Writes a text in YAML's single-quoted style, with quotes doubled. */
static void write_text(FILE *file, const char *text) {
    fputc('\'', file);
    for (; *text; text++)
        fputs(*text == '\'' ? "''" : (const char[]){*text, '\0'}, file);
    fputc('\'', file);
}

/** Writes the shortest decimal that is read back with the same bits. */
static void write_number(FILE *file, double value) {
    char text[32];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value)
            break;
    }
    fputs(text, file);
}

static void write_vector(FILE *file, const double *value, int components) {
    for (int k = 0; k < components; k++) {
        fputs(k == 0 ? "[" : ", ", file);
        write_number(file, value[k]);
    }
    fputc(']', file);
}

static void write_numbers(FILE *file, const scene_key *key, const char *source) {
    int count;
    const int *numbers = (const int *)(const void *)scene_items(key, source, &count);
    for (int k = 0; k < count; k++)
        fprintf(file, "%s%d", k == 0 ? "[" : ", ", numbers[k]);
    fputs(count == 0 ? "[]" : "]", file);
}

static void write_list(FILE *file, const scene_key *key, const char *source, int indent) {
    int count;
    const char *items = scene_items(key, source, &count);
    if (count == 0)
        fputs(" []", file);
    for (int k = 0; k < count; k++) {
        fprintf(file, "\n%*s- ", indent, "");
        write_mapping(file, key->keys, items + (size_t)k * key->list->item_size, indent + 2, 0);
    }
}

void scene_write_value(FILE *file, const scene_key *key, const char *source) {
    assert(key->kind != VALUE_SECTION && key->kind != VALUE_LIST);
    const void *field = source + key->offset;
    switch (key->kind) {
    case VALUE_TEXT:
    case VALUE_FILE:
        write_text(file, field);
        break;
    case VALUE_WHOLE:
        fprintf(file, "%d", *(const int *)field);
        break;
    case VALUE_SEED:
        fprintf(file, "%u", *(const unsigned *)field);
        break;
    case VALUE_NUMBER:
        write_number(file, *(const double *)field);
        break;
    case VALUE_VECTOR:
    case VALUE_DIRECTION:
        write_vector(file, field, key->components);
        break;
    case VALUE_CHOICE:
        fputs(key->choices[*(const int *)field], file);
        break;
    case VALUE_NUMBERS:
        write_numbers(file, key, source);
        break;
    case VALUE_SECTION:
    case VALUE_LIST:
        break;
    }
}

static void write_key(FILE *file, const scene_key *key, const char *source, int indent) {
    if (key->kind == VALUE_SECTION) {
        fputc('\n', file);
        write_mapping(file, key->keys, source + key->offset, indent + 2, indent + 2);
    } else if (key->kind == VALUE_LIST) {
        write_list(file, key, source, indent + 2);
    } else {
        fputc(' ', file);
        scene_write_value(file, key, source);
    }
}

/** Writes one line per key; the last line is not terminated. */
static void write_mapping(FILE *file, const scene_key *keys, const void *source, int indent,
                          int first_indent) {
    const int kind = scene_kind(keys, source);
    int written = 0;
    for (const scene_key *key = keys; key->name; key++) {
        if (!scene_has_key(key, kind))
            continue;
        if (written)
            fputc('\n', file);
        fprintf(file, "%*s%s:", written ? indent : first_indent, "", key->name);
        write_key(file, key, source, indent);
        written = 1;
    }
}

static void write_scene(FILE *file, const scene *s) {
    write_mapping(file, scene_keys, s, 0, 0);
    fputc('\n', file);
}

int scene_write(const scene *s, const char *path) {
    FILE *file = fopen(path, "wb");
    if (!file)
        return -1;
    write_scene(file, s);
    const int failed = ferror(file), reason = errno;
    if (fclose(file) == 0 && !failed)
        return 0;
    if (failed)
        errno = reason;
    return -1;
}

char *scene_text(const scene *s, size_t *size) {
    char *text = NULL;
    FILE *file = open_memstream(&text, size);
    if (!file)
        return NULL;
    write_scene(file, s);
    if (fclose(file) == 0)
        return text;
    free(text);
    return NULL;
}
