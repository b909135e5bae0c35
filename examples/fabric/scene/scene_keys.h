/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The keys of a scene file: one table for reading, setting and writing. */
#ifndef FABRIC_SCENE_KEYS_H
#define FABRIC_SCENE_KEYS_H

#include <stddef.h>
#include <stdio.h>

#include "scene.h"

typedef enum value_kind {
    VALUE_TEXT,      /* char[64] */
    VALUE_FILE,      /* char[1024]; a relative path starts at the scene's folder */
    VALUE_WHOLE,     /* int */
    VALUE_SEED,      /* unsigned */
    VALUE_NUMBER,    /* double */
    VALUE_VECTOR,    /* double[components] */
    VALUE_DIRECTION, /* double[3], made a unit vector when read */
    VALUE_CHOICE,    /* enum, or int: the word's index in `choices` */
    VALUE_SECTION,   /* nested keys; a single word is the first key's value, if that key is a
                      * choice */
    VALUE_NUMBERS,   /* int[], allocated; `list` has the offset of their count */
    VALUE_LIST       /* items with keys of their own, in an allocated array */
} value_kind;

enum { TEXT_SIZE = 64, FILE_SIZE = 1024, MOST_KEYS = 32 };

typedef struct scene_key scene_key;

typedef struct value_range {
    double low, high; /* least and greatest value */
    int above;        /* true: `low` itself is out of range */
} value_range;

/** How a struct stores a list: its count, and its items. */
typedef struct scene_list {
    size_t count_offset; /* offset of the int that counts the items */
    size_t item_size;
    const void *defaults;        /* an item before its keys are read */
    void (*release)(void *item); /* frees allocated members of an item; NULL: none */
} scene_list;

struct scene_key {
    const char *name; /* "" if the key is not in files: then the int at offset holds the kind for
                       * of_kinds */
    value_kind kind;
    size_t offset; /* offset in the struct of the section or of the list's item */
    int required;
    int components; /* number of components of a vector */
    const value_range *range;
    unsigned of_kinds; /* bits of the kinds of item or section that have this key; 0: all */
    const char *const *choices; /* NULL after the last */
    const scene_key *keys;      /* keys of a section or of a list's items; no name after the last */
    const scene_list *list;
};

/** Returns the kind of the section or item in `struct_`, for `of_kinds`, or -1 if it has no kinds.
 *  A section with kinds stores the kind at its first key, which is named `kind`, or has an empty
 *  name if files do not contain it. */
int scene_kind(const scene_key *keys, const void *struct_);

/** Does a section or item of this kind have the key in files? */
static inline int scene_has_key(const scene_key *key, int kind) {
    return key->name[0] != '\0' &&
           (key->of_kinds == 0 || (kind >= 0 && (key->of_kinds >> kind & 1u) != 0));
}

/** Returns the items of the list `key` in the struct at `source`; *count receives their number. */
char *scene_items(const scene_key *key, const char *source, int *count);
/** Frees an array of `count` items of a list. */
void scene_free_items(const scene_list *list, char *items, long count);
/** Replaces a list's items, and frees the old ones. */
void scene_set_items(const scene_key *key, char *target, void *items, int count);

/** A file's outermost keys; no name after the last. */
extern const scene_key scene_keys[];

/** Defaults of a scene. */
extern const scene scene_defaults;

/** Reads and checks the mesh of a file, and prints its defects on standard error. The caller frees
 *  it by mesh_free and free. Returns NULL after a message on standard error or in error[256]. */
mesh *scene_sheet_read(const char *path, int rest, char *error);

/** Writes one value, which is not a section or list, of the struct at `source`. */
void scene_write_value(FILE *file, const scene_key *key, const char *source);

#endif
