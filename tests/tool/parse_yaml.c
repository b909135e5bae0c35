/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** parse_yaml reads YAML from standard input. It prints the number of documents, and each key of
 * their top mappings with its scalar value. If the input is no YAML, it prints a message and exits
 * with status 1. */
#include <stdio.h>
#include <yaml.h>

static void show(yaml_document_t *document) {
    const yaml_node_t *root = yaml_document_get_root_node(document);
    if (!root || root->type != YAML_MAPPING_NODE)
        return;
    printf("document %s\n", root->tag ? (const char *)root->tag : "");
    const yaml_node_pair_t *pair = root->data.mapping.pairs.start;
    for (; pair < root->data.mapping.pairs.top; pair++) {
        const yaml_node_t *key = yaml_document_get_node(document, pair->key);
        const yaml_node_t *value = yaml_document_get_node(document, pair->value);
        printf("%s: %s\n", (const char *)key->data.scalar.value,
               value->type == YAML_SCALAR_NODE ? (const char *)value->data.scalar.value : "...");
    }
}

int main(void) {
    yaml_parser_t parser;
    yaml_document_t document;
    if (!yaml_parser_initialize(&parser))
        return 1;
    yaml_parser_set_input_file(&parser, stdin);
    for (unsigned count = 0;; count++) {
        if (!yaml_parser_load(&parser, &document)) {
            fprintf(stderr, "%zu: %s\n", parser.problem_mark.line + 1, parser.problem);
            yaml_parser_delete(&parser);
            return 1;
        }
        const int is_end = yaml_document_get_root_node(&document) == NULL;
        show(&document);
        yaml_document_delete(&document);
        if (is_end) {
            printf("%u documents\n", count);
            break;
        }
    }
    yaml_parser_delete(&parser);
    return 0;
}
