/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Finds the first key in which two scenes differ, other than files and time.steps. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"
#include "scene_value.h"

/** Two structs with the same keys, and the buffer for a message about their difference. */
typedef struct comparison {
    const char *a, *b;
    char *text; /* [256] */
    int failed; /* out of memory */
} comparison;

static int compare_keys(comparison *of, const scene_key *keys, const char *path);

/** Returns a value in the format of scene files, which the caller frees, or NULL if out of
 *  memory. */
static char *value_text(const scene_key *key, const char *source) {
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    if (!file)
        return NULL;
    scene_write_value(file, key, source);
    if (fclose(file) == 0)
        return text;
    free(text);
    return NULL;
}

static int compare_values(comparison *of, const scene_key *key, const char *path) {
    char *one = value_text(key, of->a), *other = value_text(key, of->b);
    const int differ = !one || !other || strcmp(one, other) != 0;
    of->failed |= !one || !other;
    if (differ && !of->failed)
        snprintf(of->text, 256, "'%.100s' is %.60s, there %.60s", path, one, other);
    free(one);
    free(other);
    return differ;
}

/** Compares the structs of two sections or list items. */
static int compare_within(comparison *of, const char *a, const char *b, const scene_key *keys,
                          const char *path) {
    comparison within = {a, b, of->text, of->failed};
    const int differ = compare_keys(&within, keys, path);
    of->failed = within.failed;
    return differ;
}

static int compare_lists(comparison *of, const scene_key *key, const char *path) {
    char item_path[PATH_SIZE];
    int count, other_count;
    const char *one = scene_items(key, of->a, &count);
    const char *other = scene_items(key, of->b, &other_count);
    if (count != other_count) {
        snprintf(of->text, 256, "'%.100s' has %d items, there %d", path, count, other_count);
        return 1;
    }
    for (int k = 0; k < count; k++) {
        const size_t offset = (size_t)k * key->list->item_size;
        snprintf(item_path, sizeof item_path, "%.100s.%d", path, k);
        if (compare_within(of, one + offset, other + offset, key->keys, item_path))
            return 1;
    }
    return 0;
}

/** Compares the keys and stops at the first difference. If the kinds differ, the keys do as
 *  well. */
static int compare_keys(comparison *of, const scene_key *keys, const char *path) {
    const int kind = scene_kind(keys, of->a);
    if (keys->name[0] == '\0' && kind != scene_kind(keys, of->b)) {
        snprintf(of->text, 256, "'%.100s' is given by other keys there", path);
        return 1;
    }
    for (const scene_key *key = keys; key->name; key++) {
        char name[PATH_SIZE];
        int differ = 0;
        snprintf(name, sizeof name, "%.80s%s%.40s", path, path[0] ? "." : "", key->name);
        if (!scene_has_key(key, kind))
            continue;
        if (key->kind == VALUE_SECTION)
            differ = compare_within(of, of->a + key->offset, of->b + key->offset, key->keys, name);
        else if (key->kind == VALUE_LIST)
            differ = compare_lists(of, key, name);
        else if (key->kind != VALUE_FILE && strcmp(name, "time.steps") != 0)
            differ = compare_values(of, key, name);
        if (differ)
            return 1;
    }
    return 0;
}

int scene_differ(const scene *a, const scene *b, char *text) {
    comparison whole = {(const char *)a, (const char *)b, text, 0};
    const int differ = compare_keys(&whole, scene_keys, "");
    if (whole.failed)
        snprintf(text, 256, "out of memory");
    return differ;
}
