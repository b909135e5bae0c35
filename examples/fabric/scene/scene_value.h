/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Stores nodes of a YAML document in fields of the scene's struct, with messages about errors. */
#ifndef FABRIC_SCENE_VALUE_H
#define FABRIC_SCENE_VALUE_H

#include <yaml.h>

#include "scene_keys.h"

enum { PATH_SIZE = 128 };

/** A document being read. Messages begin with "source:line: " or, without line numbers, "--set
 *  source: ". */
typedef struct scene_source {
    const char *source;
    int has_lines;
    yaml_document_t *document;
} scene_source;

/** Prints a message about the node (NULL: without a line number) to standard error. Returns -1. */
int scene_complain(const scene_source *from, const yaml_node_t *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Returns the key of this name for items of this kind (kind < 0: without kinds), or NULL after a
 *  message with the valid names. `path` is that of the enclosing section, "" for the outermost
 *  keys. */
const scene_key *scene_find_key(const scene_source *from, const yaml_node_t *node,
                                const scene_key *keys, int kind, const char *name,
                                const char *path);

/** Returns the value of the key whose name is the first `length` bytes of `name`, or NULL if the
 *  mapping has none. */
const yaml_node_t *scene_value_of(const scene_source *from, const yaml_node_t *mapping,
                                  const char *name, size_t length);

/** Reads a mapping whose keys are `keys` into the struct at `target`. Returns 0, or -1 after a
 *  message. */
int scene_read_mapping(const scene_source *from, const yaml_node_t *node, const scene_key *keys,
                       void *target, const char *path);

/** Reads one value; a list replaces the old one. `path` is the key's path. Returns 0, or -1 after a
 *  message. */
int scene_read_value(const scene_source *from, const yaml_node_t *node, const scene_key *key,
                     void *target, const char *path);

#endif
