/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "scene_value.h"

#include <assert.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/words.h"

enum { MESSAGE_SIZE = 512, MOST_ITEMS = 10000 };

int scene_complain(const scene_source *from, const yaml_node_t *node, const char *format, ...) {
    va_list arguments;
    if (from->has_lines && node)
        fprintf(stderr, "%s:%zu: ", from->source, node->start_mark.line + 1);
    else
        fprintf(stderr, "%s%s: ", from->has_lines ? "" : "--set ", from->source);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
    return -1;
}

static void append(char text[MESSAGE_SIZE], const char *format, const char *word) {
    const size_t used = strlen(text);
    snprintf(text + used, MESSAGE_SIZE - used, format, word);
}

/** Appends "one of 'a', 'b'". */
static void list_words(char text[MESSAGE_SIZE], const char *const *words, int count) {
    append(text, "%s", "one of ");
    for (int k = 0; k < count; k++)
        append(text, k == 0 ? "'%s'" : ", '%s'", words[k]);
}

/** Appends "one of 'a', 'b'; did you mean 'a'?". */
static void list_words_and_guess(char text[MESSAGE_SIZE], const char *found,
                                 const char *const *words, int count) {
    const char *nearest = words_nearest(found, words, count);
    list_words(text, words, count);
    if (nearest)
        append(text, "; did you mean '%s'?", nearest);
}

static const char *scalar(const yaml_node_t *node) {
    return node->type == YAML_SCALAR_NODE ? (const char *)node->data.scalar.value : NULL;
}

static long item_count(const yaml_node_t *list) {
    return (long)(list->data.sequence.items.top - list->data.sequence.items.start);
}

static const yaml_node_t *item_at(const scene_source *from, const yaml_node_t *list, long k) {
    assert(list->type == YAML_SEQUENCE_NODE && k >= 0 && k < item_count(list));
    return yaml_document_get_node(from->document, list->data.sequence.items.start[k]);
}

static int wrong_type(const scene_source *from, const yaml_node_t *node, const char *path,
                      const char *expected) {
    if (scalar(node))
        return scene_complain(from, node, "'%s' is '%s', expected %s", path, scalar(node),
                              expected);
    return scene_complain(from, node, "'%s' is a %s, expected %s", path,
                          node->type == YAML_SEQUENCE_NODE ? "list" : "section", expected);
}

static int is_whole(const scene_key *key) {
    return key->kind == VALUE_WHOLE || key->kind == VALUE_SEED || key->kind == VALUE_NUMBERS;
}

/** Describes the range in words: "a number greater than 0". */
static void describe_range(char *text, size_t size, const scene_key *key) {
    const char *noun = is_whole(key) ? "a whole number" : "a number";
    const value_range *in = key->range;
    if (in->low <= -1e300)
        snprintf(text, size, "%s", noun);
    else if (in->high >= 1e300)
        snprintf(text, size, in->above ? "%s greater than %g" : "%s, %g or more", noun, in->low);
    else
        snprintf(text, size, in->above ? "%s greater than %g, up to %.10g" : "%s from %g to %.10g",
                 noun, in->low, in->high);
}

/** Describes the key's valid values in words. */
static void describe(char text[MESSAGE_SIZE], const scene_key *key) {
    static const char *const fixed[VALUE_LIST + 1] = {[VALUE_TEXT] = "a text of 1 to 63 bytes",
                                                      [VALUE_FILE] = "the name of a file",
                                                      [VALUE_SECTION] = "a section of keys",
                                                      [VALUE_LIST] = "a list"};
    char range[MESSAGE_SIZE - 64];
    int count = 0;
    describe_range(range, sizeof range, key);
    while (key->kind == VALUE_CHOICE && key->choices[count])
        count++;
    text[0] = '\0';
    if (key->kind == VALUE_CHOICE)
        list_words(text, key->choices, count);
    else if (key->components > 1)
        snprintf(text, MESSAGE_SIZE, "a list of %d, each %s", key->components, range);
    else
        append(text, key->kind == VALUE_NUMBERS ? "a list, each %s" : "%s",
               fixed[key->kind] ? fixed[key->kind] : range);
}

static int wrong_value(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                       const char *path) {
    char expected[MESSAGE_SIZE];
    describe(expected, key);
    return wrong_type(from, node, path, expected);
}

static int in_range(const value_range *in, double value) {
    return isfinite(value) && value <= in->high && (in->above ? value > in->low : value >= in->low);
}

static int read_number(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                       double *value, const char *path) {
    const char *text = scalar(node);
    char expected[MESSAGE_SIZE], *end = NULL;
    *value = text ? strtod(text, &end) : 0.0;
    if (text && end != text && *end == '\0' && in_range(key->range, *value) &&
        (!is_whole(key) || *value == floor(*value)))
        return 0;
    describe_range(expected, sizeof expected, key);
    return wrong_type(from, node, path, expected);
}

static int read_vector(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                       double *target, const char *path) {
    char expected[MESSAGE_SIZE];
    double value[3] = {0.0, 0.0, 0.0};
    if (node->type != YAML_SEQUENCE_NODE)
        return wrong_value(from, node, key, path);
    if (item_count(node) != key->components) {
        describe(expected, key);
        return scene_complain(from, node, "'%s' is a list of %ld, expected %s", path,
                              item_count(node), expected);
    }
    for (int k = 0; k < key->components; k++)
        if (read_number(from, item_at(from, node, k), key, &value[k], path) != 0)
            return -1;
    if (key->kind == VALUE_DIRECTION) {
        const double length = sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
        if (!(length > 0.0) || !isfinite(length))
            return scene_complain(from, node,
                                  "'%s' has no direction, expected a vector other "
                                  "than 0",
                                  path);
        /* A written unit vector must be read back with the same bits. */
        for (int k = 0; k < 3 && !(fabs(length - 1.0) < 4 * DBL_EPSILON); k++)
            value[k] /= length;
    }
    memcpy(target, value, (size_t)key->components * sizeof *target);
    return 0;
}

static int read_choice(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                       int *target, const char *path) {
    const char *text = scalar(node);
    char expected[MESSAGE_SIZE] = "";
    int count = 0;
    for (; key->choices[count]; count++)
        if (text && strcmp(text, key->choices[count]) == 0) {
            *target = count;
            return 0;
        }
    list_words_and_guess(expected, text ? text : "", key->choices, count);
    return wrong_type(from, node, path, expected);
}

static int read_text(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                     char *target, const char *path) {
    const char *text = scalar(node);
    if (!text || text[0] == '\0' || strlen(text) >= TEXT_SIZE ||
        strlen(text) != node->data.scalar.length)
        return wrong_value(from, node, key, path);
    strcpy(target, text); /* its length was checked */
    return 0;
}

/** Reads a path; relative paths start at the scene's folder. */
static int read_file_name(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                          char *target, const char *path) {
    const char *text = scalar(node), *slash = strrchr(from->source, '/');
    char joined[FILE_SIZE];
    if (!text || text[0] == '\0' || strlen(text) != node->data.scalar.length)
        return wrong_value(from, node, key, path);
    const int from_folder = text[0] != '/' && from->has_lines && slash != NULL;
    const int length =
        snprintf(joined, sizeof joined, "%.*s%s", from_folder ? (int)(slash - from->source + 1) : 0,
                 from->source, text);
    char *whole = length < FILE_SIZE ? realpath(joined, NULL) : NULL;
    const int found = whole && strlen(whole) < FILE_SIZE;
    if (found)
        strcpy(target, whole); /* its length was checked */
    free(whole);
    return found ? 0 : scene_complain(from, node, "'%s' is '%s': no such file", path, text);
}

/** Reads whole numbers into a new array, which replaces the old one. */
static int read_numbers(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                        char *target, const char *path) {
    if (node->type != YAML_SEQUENCE_NODE)
        return wrong_value(from, node, key, path);
    const long count = item_count(node);
    int *numbers = count <= INT_MAX ? malloc((size_t)count * sizeof *numbers + 1) : NULL;
    if (!numbers)
        return scene_complain(from, node, "out of memory");
    for (long k = 0; k < count; k++) {
        double number;
        if (read_number(from, item_at(from, node, k), key, &number, path) != 0) {
            free(numbers);
            return -1;
        }
        numbers[k] = (int)number;
    }
    scene_set_items(key, target, numbers, (int)count);
    return 0;
}

static int read_list(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                     char *target, const char *path) {
    const scene_list *list = key->list;
    if (node->type != YAML_SEQUENCE_NODE)
        return wrong_value(from, node, key, path);
    const long count = item_count(node);
    if (count > MOST_ITEMS)
        return scene_complain(from, node, "'%s' has %ld items, expected %d at most", path, count,
                              MOST_ITEMS);
    char *items = count > 0 ? calloc((size_t)count, list->item_size) : NULL;
    if (count > 0 && !items)
        return scene_complain(from, node, "out of memory");
    for (long k = 0; k < count; k++) {
        char item_path[PATH_SIZE];
        char *item = items + (size_t)k * list->item_size;
        snprintf(item_path, sizeof item_path, "%.100s.%ld", path, k);
        memcpy(item, list->defaults, list->item_size);
        if (scene_read_mapping(from, item_at(from, node, k), key->keys, item, item_path) != 0) {
            scene_free_items(list, items, k + 1);
            return -1;
        }
    }
    scene_set_items(key, target, items, (int)count);
    return 0;
}

int scene_read_value(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                     void *target, const char *path) {
    char *field = (char *)target + key->offset;
    double number;
    switch (key->kind) {
    case VALUE_TEXT:
        return read_text(from, node, key, field, path);
    case VALUE_FILE:
        return read_file_name(from, node, key, field, path);
    case VALUE_WHOLE:
    case VALUE_SEED:
        if (read_number(from, node, key, &number, path) != 0)
            return -1;
        if (key->kind == VALUE_WHOLE)
            *(int *)(void *)field = (int)number;
        else
            *(unsigned *)(void *)field = (unsigned)number;
        return 0;
    case VALUE_NUMBER:
        return read_number(from, node, key, (double *)(void *)field, path);
    case VALUE_VECTOR:
    case VALUE_DIRECTION:
        return read_vector(from, node, key, (double *)(void *)field, path);
    case VALUE_CHOICE:
        return read_choice(from, node, key, (int *)(void *)field, path);
    case VALUE_SECTION:
        if (node->type == YAML_SCALAR_NODE && key->keys->kind == VALUE_CHOICE)
            return scene_read_value(from, node, key->keys, field, path);
        return scene_read_mapping(from, node, key->keys, field, path);
    case VALUE_NUMBERS:
        return read_numbers(from, node, key, target, path);
    case VALUE_LIST:
        return read_list(from, node, key, target, path);
    }
    return -1;
}

/** Writes " in 'section'" for messages, or nothing for the outermost section. */
static const char *within(char text[PATH_SIZE + 8], const char *path) {
    snprintf(text, PATH_SIZE + 8, path[0] != '\0' ? " in '%s'" : "%s", path);
    return text;
}

const scene_key *scene_find_key(const scene_source *from, const yaml_node_t *node,
                                const scene_key *keys, int kind, const char *name,
                                const char *path) {
    const char *names[MOST_KEYS] = {NULL};
    char expected[MESSAGE_SIZE] = "", section[PATH_SIZE + 8];
    int count = 0;
    for (; keys->name; keys++) {
        if (!scene_has_key(keys, kind))
            continue;
        if (strcmp(keys->name, name) == 0)
            return keys;
        assert(count < MOST_KEYS);
        names[count++] = keys->name;
    }
    list_words_and_guess(expected, name, names, count);
    scene_complain(from, node, "unknown key '%s'%s, expected %s", name, within(section, path),
                   expected);
    return NULL;
}

static int check_required(const scene_source *from, const yaml_node_t *node, const scene_key *keys,
                          int kind, unsigned seen, const char *path) {
    for (int k = 0; keys[k].name; k++) {
        if (!keys[k].required || !scene_has_key(&keys[k], kind) || (seen >> k & 1u) != 0)
            continue;
        char expected[MESSAGE_SIZE], section[PATH_SIZE + 8];
        describe(expected, &keys[k]);
        return scene_complain(from, node, "missing key '%s'%s, expected %s", keys[k].name,
                              within(section, path), expected);
    }
    return 0;
}

const yaml_node_t *scene_value_of(const scene_source *from, const yaml_node_t *mapping,
                                  const char *name, size_t length) {
    for (const yaml_node_pair_t *pair = mapping->data.mapping.pairs.start;
         pair < mapping->data.mapping.pairs.top; pair++) {
        const char *key = scalar(yaml_document_get_node(from->document, pair->key));
        if (key && strlen(key) == length && memcmp(key, name, length) == 0)
            return yaml_document_get_node(from->document, pair->value);
    }
    return NULL;
}

/** Returns the kind that follows from the keys present, or 0 if none follows. The first key that
 *  not all kinds have decides: the first kind that has it is returned. */
static int kind_by_keys(const scene_source *from, const yaml_node_t *node, const scene_key *keys) {
    for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         pair < node->data.mapping.pairs.top; pair++) {
        const char *name = scalar(yaml_document_get_node(from->document, pair->key));
        for (const scene_key *key = keys; name && key->name; key++)
            if (key->of_kinds != 0 && strcmp(key->name, name) == 0)
                for (int kind = 0;; kind++)
                    if ((key->of_kinds >> kind & 1u) != 0)
                        return kind;
    }
    return 0;
}

/** Returns the item's kind, on which its other keys depend, -1 if keys have no kind, or -2 after a
 *  message. */
static int read_kind(const scene_source *from, const yaml_node_t *node, const scene_key *keys,
                     const char *path) {
    if (keys->name[0] == '\0')
        return kind_by_keys(from, node, keys);
    if (strcmp(keys->name, "kind") != 0)
        return -1;
    const yaml_node_t *value = scene_value_of(from, node, "kind", strlen("kind"));
    char value_path[PATH_SIZE];
    int kind;
    snprintf(value_path, sizeof value_path, "%.100s.kind", path);
    if (value)
        return read_choice(from, value, keys, &kind, value_path) == 0 ? kind : -2;
    check_required(from, node, keys, 0, 0, path);
    return -2;
}

int scene_read_mapping(const scene_source *from, const yaml_node_t *node, const scene_key *keys,
                       void *target, const char *path) {
    unsigned seen = 0; /* one bit for each key; a section has at most MOST_KEYS */
    _Static_assert(MOST_KEYS <= 8 * sizeof seen, "one bit for each key");
    if (node->type != YAML_MAPPING_NODE)
        return wrong_type(from, node, path[0] != '\0' ? path : "the scene", "a section of keys");
    const int kind = read_kind(from, node, keys, path);
    if (kind == -2)
        return -1;
    if (keys->name[0] == '\0')
        memcpy((char *)target + keys->offset, &kind, sizeof kind);
    for (const yaml_node_pair_t *pair = node->data.mapping.pairs.start;
         pair < node->data.mapping.pairs.top; pair++) {
        const yaml_node_t *key_node = yaml_document_get_node(from->document, pair->key);
        const yaml_node_t *value = yaml_document_get_node(from->document, pair->value);
        char value_path[PATH_SIZE];
        if (!scalar(key_node))
            return scene_complain(from, key_node, "a key must be a word");
        const scene_key *key = scene_find_key(from, key_node, keys, kind, scalar(key_node), path);
        if (!key)
            return -1;
        if ((seen >> (key - keys) & 1u) != 0)
            return scene_complain(from, key_node, "key '%s' stands here twice", key->name);
        assert(key - keys < MOST_KEYS);
        seen |= 1u << (key - keys);
        snprintf(value_path, sizeof value_path, path[0] != '\0' ? "%.90s.%.30s" : "%.0s%.30s", path,
                 key->name);
        if (scene_read_value(from, value, key, target, value_path) != 0)
            return -1;
    }
    return check_required(from, node, keys, kind, seen, path);
}
