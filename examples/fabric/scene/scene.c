/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "scene.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "input/mesh_file.h"
#include "scene_value.h"

/** Returns the node at `path` (names and item numbers separated by dots), or its nearest existing
 *  ancestor. */
static const yaml_node_t *node_at(const scene_source *from, const char *path) {
    const yaml_node_t *node = yaml_document_get_root_node(from->document);
    while (*path) {
        const size_t length = strcspn(path, ".");
        const yaml_node_t *next =
            node->type == YAML_SEQUENCE_NODE
                ? yaml_document_get_node(from->document,
                                         node->data.sequence.items.start[atoi(path)])
            : node->type == YAML_MAPPING_NODE ? scene_value_of(from, node, path, length)
                                              : NULL;
        if (!next)
            break;
        node = next;
        path += length + (path[length] == '.');
    }
    return node;
}

/** Returns the node at `path`, whose line a message names, or NULL if the document has no lines. */
static const yaml_node_t *line_of(const scene_source *from, const char *path) {
    return from->has_lines ? node_at(from, path) : NULL;
}

/** Reads the meshes of colliders that have none yet. */
static int read_surfaces(const scene_source *from, scene *s) {
    for (int n = 0; n < s->collider_count; n++) {
        collider *c = &s->colliders[n];
        char path[PATH_SIZE], error[256] = "";
        if (c->kind != COLLIDER_MESH || c->surface)
            continue;
        c->surface = surface_read(c->file, error);
        snprintf(path, sizeof path, "colliders.%d.file", n);
        if (!c->surface)
            return scene_complain(from, line_of(from, path), "'%s' is '%s': %s", path, c->file,
                                  error);
    }
    return 0;
}

/** Reads the cloth's mesh if it comes from a file and has not been read yet. */
static int read_sheet(const scene_source *from, scene *s) {
    char error[256] = "it cannot be read";
    if (s->mesh.from != SHEET_FILE)
        return 0;
    if (!s->mesh.sheet && !(s->mesh.sheet = scene_sheet_read(s->mesh.file, s->mesh.rest, error)))
        return scene_complain(from, line_of(from, "mesh.file"), "'mesh.file' is '%s': %s",
                              s->mesh.file, error);
    s->mesh.vertices = s->mesh.sheet->vertex_count;
    s->mesh.boundary = 0;
    s->mesh.side = s->mesh.scale * sqrt(mesh_rest_area(s->mesh.sheet));
    return 0;
}

static int check_pins(const scene_source *from, const scene *s) {
    char path[PATH_SIZE];
    for (int k = 0; k < s->pin_count; k++) {
        const pin *p = &s->pins[k];
        const int in_box = p->by == PIN_BOX;
        const double *low = in_box ? p->box_low : p->low, *high = in_box ? p->box_high : p->high;
        for (int a = 0; a < (in_box ? 3 : p->by == PIN_RECTANGLE ? 2 : 0); a++)
            if (low[a] > high[a]) {
                snprintf(path, sizeof path, "pins.%d.%slow", k, in_box ? "box_" : "");
                return scene_complain(from, line_of(from, path),
                                      "'%s' lies above '%shigh', expected a corner below it", path,
                                      in_box ? "box_" : "");
            }
        for (int n = 0; n < p->vertex_count; n++)
            if (p->vertices[n] > s->mesh.vertices) {
                snprintf(path, sizeof path, "pins.%d.vertices", k);
                return scene_complain(from, line_of(from, path),
                                      "'%s' has the number %d, expected up to %d", path,
                                      p->vertices[n], s->mesh.vertices);
            }
    }
    return 0;
}

static int check_motions(const scene_source *from, const scene *s) {
    char path[PATH_SIZE];
    for (int n = 0; n < s->collider_count; n++)
        for (int k = 1; k < s->colliders[n].keyframe_count; k++)
            if (!(s->colliders[n].keyframes[k].time > s->colliders[n].keyframes[k - 1].time)) {
                snprintf(path, sizeof path, "colliders.%d.motion.%d.time", n, k);
                return scene_complain(from, line_of(from, path),
                                      "'%s' is %g, expected a time after the one before, %g", path,
                                      s->colliders[n].keyframes[k].time,
                                      s->colliders[n].keyframes[k - 1].time);
            }
    return 0;
}

/** Checks that concern several keys, for a document whose keys are all valid. */
static int check_whole(const scene_source *from, scene *s) {
    if (s->mesh.from == SHEET_GENERATED && s->mesh.boundary >= s->mesh.vertices)
        return scene_complain(from, line_of(from, "mesh.boundary"),
                              "'mesh.boundary' is %d, expected less than 'mesh.vertices', %d",
                              s->mesh.boundary, s->mesh.vertices);
    if (s->material.strain_limit > 0 && !(s->material.stretch > 0))
        return scene_complain(from, line_of(from, "material.strain_limit"),
                              "'material.strain_limit' limits a stretch that 'material.stretch' "
                              "sets to 0, expected more");
    if (read_sheet(from, s) != 0 || check_pins(from, s) != 0 || check_motions(from, s) != 0)
        return -1;
    return read_surfaces(from, s);
}

/** Frees the meshes from files, so that they will be read again. */
static void free_meshes(scene *s) {
    for (int n = 0; n < s->collider_count; n++) {
        surface_free(s->colliders[n].surface);
        s->colliders[n].surface = NULL;
    }
    if (s->mesh.sheet)
        mesh_free(s->mesh.sheet);
    free(s->mesh.sheet);
    s->mesh.sheet = NULL;
}

static int complain_syntax(const scene_source *from, const yaml_parser_t *parser) {
    if (from->has_lines)
        fprintf(stderr, "%s:%zu: ", from->source, parser->problem_mark.line + 1);
    else
        fprintf(stderr, "--set %s: ", from->source);
    fprintf(stderr, "not YAML: %s\n", parser->problem ? parser->problem : "out of memory");
    return -1;
}

/** Complains if the file has a second document. */
static int check_end(const scene_source *from, yaml_parser_t *parser) {
    yaml_document_t rest;
    if (!yaml_parser_load(parser, &rest))
        return complain_syntax(from, parser);
    const yaml_node_t *root = yaml_document_get_root_node(&rest);
    const int status =
        root ? scene_complain(from, root, "a second document, expected the file's end") : 0;
    yaml_document_delete(&rest);
    return status;
}

static int read_document(scene *s, scene_source *from, FILE *file) {
    yaml_parser_t parser;
    yaml_document_t document;
    int status = -1;
    if (!yaml_parser_initialize(&parser))
        return scene_complain(from, NULL, "out of memory");
    yaml_parser_set_input_file(&parser, file);
    if (!yaml_parser_load(&parser, &document))
        complain_syntax(from, &parser);
    else {
        const yaml_node_t *root = yaml_document_get_root_node(&document);
        from->document = &document;
        if (!root)
            scene_complain(from, NULL, "the file is empty, expected a scene");
        else if (scene_read_mapping(from, root, scene_keys, s, "") == 0 &&
                 check_end(from, &parser) == 0)
            status = check_whole(from, s);
        yaml_document_delete(&document);
    }
    yaml_parser_delete(&parser);
    return status;
}

/** Reads a scene. If `file` is NULL, it could not be opened for the reason `wrong`. */
static int read_from(scene *s, const char *name, FILE *file, const char *wrong) {
    scene_source from = {name, 1, NULL};
    *s = scene_defaults;
    if (!file)
        return scene_complain(&from, NULL, "%s", wrong);
    const int status = read_document(s, &from, file);
    fclose(file);
    if (status != 0)
        scene_free(s);
    return status;
}

int scene_read(scene *s, const char *path) {
    char wrong[256];
    FILE *file = fopen(path, "rb");
    snprintf(wrong, sizeof wrong, "cannot be read: %s", strerror(errno));
    return read_from(s, path, file, wrong);
}

int scene_read_text(scene *s, char *text, size_t size, const char *name) {
    return read_from(s, name, size > 0 ? fmemopen(text, size, "rb") : NULL,
                     "its scene cannot be read");
}

void scene_free(scene *s) {
    free_meshes(s);
    for (int k = 0; k < s->pin_count; k++)
        free(s->pins[k].vertices);
    free(s->pins);
    for (int n = 0; n < s->collider_count; n++)
        free(s->colliders[n].keyframes);
    free(s->colliders);
    *s = (scene){0};
}

/** Returns the address of item `number` of a list, or NULL after a message. */
static void *find_item(const scene_source *from, const scene_key *key, char *target,
                       const char *number) {
    char *end;
    int count;
    char *items = scene_items(key, target, &count);
    const long index = strtol(number, &end, 10);
    if (end != number && *end == '\0' && index >= 0 && index < count)
        return items + (size_t)index * key->list->item_size;
    if (count == 0)
        scene_complain(from, NULL, "'%s' has no items", key->name);
    else
        scene_complain(from, NULL, "'%s' has no item '%s', expected 0 to %d", key->name, number,
                       count - 1);
    return NULL;
}

/** Finds the key at `path`, which it splits at the dots. *target receives the struct that contains
 *  the key's value. Returns NULL after a message. */
static const scene_key *find_target(const scene_source *from, scene *s, char *path, void **target) {
    const scene_key *keys = scene_keys;
    char *word = path, parent[PATH_SIZE] = "";
    int kind = -1;
    *target = s;
    for (;;) {
        char *dot = strchr(word, '.');
        if (dot)
            *dot = '\0';
        const scene_key *key = scene_find_key(from, NULL, keys, kind, word, parent);
        if (!key || !dot)
            return key;
        if (!key->keys) {
            scene_complain(from, NULL, "'%s' is a value and has no keys in it", key->name);
            return NULL;
        }
        snprintf(parent, sizeof parent, "%s", key->name);
        word = dot + 1;
        keys = key->keys;
        if (key->kind != VALUE_LIST) {
            *target = (char *)*target + key->offset;
            kind = scene_kind(keys, *target);
            continue;
        }
        dot = strchr(word, '.');
        if (!dot) {
            scene_complain(from, NULL, "'%s.%s' is an item: set one of its keys", key->name, word);
            return NULL;
        }
        *dot = '\0';
        if (!(*target = find_item(from, key, (char *)*target, word)))
            return NULL;
        snprintf(parent, sizeof parent, "%s.%.20s", key->name, word);
        kind = scene_kind(keys, *target);
        word = dot + 1;
    }
}

static int set_value(const scene_source *from, scene *s, char *path, const char *value_path,
                     const yaml_node_t *value) {
    void *target;
    const scene_key *key = find_target(from, s, path, &target);
    if (!key)
        return -1;
    if (key->kind == VALUE_SECTION &&
        (key->keys->kind != VALUE_CHOICE || value->type != YAML_SCALAR_NODE))
        return scene_complain(from, NULL, "'%s' is a section: set one of its keys", key->name);
    if (strcmp(key->name, "kind") == 0)
        return scene_complain(from, NULL, "the kind of a collider cannot be set, only read");
    if (scene_read_value(from, value, key, target, value_path) != 0)
        return -1;
    if (key->kind == VALUE_FILE)
        free_meshes(s);
    return check_whole(from, s);
}

int scene_set(scene *s, const char *assignment) {
    scene_source from = {assignment, 0, NULL};
    yaml_parser_t parser;
    yaml_document_t document;
    char path[PATH_SIZE], value_path[PATH_SIZE];
    const char *equals = strchr(assignment, '=');
    int status = -1;
    if (!equals || equals == assignment || equals - assignment >= PATH_SIZE)
        return scene_complain(&from, NULL, "expected KEY=VALUE, such as material.bend=0.01");
    snprintf(path, sizeof path, "%.*s", (int)(equals - assignment), assignment);
    snprintf(value_path, sizeof value_path, "%s", path);
    if (!yaml_parser_initialize(&parser))
        return scene_complain(&from, NULL, "out of memory");
    yaml_parser_set_input_string(&parser, (const unsigned char *)equals + 1, strlen(equals + 1));
    if (!yaml_parser_load(&parser, &document))
        complain_syntax(&from, &parser);
    else {
        const yaml_node_t *root = yaml_document_get_root_node(&document);
        from.document = &document;
        status = root ? set_value(&from, s, path, value_path, root)
                      : scene_complain(&from, NULL, "no value, expected KEY=VALUE");
        yaml_document_delete(&document);
    }
    yaml_parser_delete(&parser);
    return status;
}
