/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "bits.h"

#include <stdio.h>
#include <string.h>

#include "base/options.h"
#include "base/words.h"

enum { ORDERS = 2 };
static const char *const orders[ORDERS] = {[BITS_SERIAL] = "serial", [BITS_ANY] = "any"};

/* Does the command simulate? Other commands solve no system and reject the option themselves. */
static int simulates(int argc, char **argv) {
    return argc > 1 && (strcmp(argv[1], "run") == 0 || strcmp(argv[1], "accuracy") == 0);
}

static int complain(const char *value) {
    const char *nearest = words_nearest(value, orders, ORDERS);
    fprintf(stderr, "fabric-mpi: --bits is '%s', expected serial or any", value);
    if (nearest)
        fprintf(stderr, ", did you mean '%s'?", nearest);
    fputc('\n', stderr);
    return EXIT_USAGE;
}

static int read_order(const char *value, int says, bits_order *bits) {
    for (int k = 0; k < ORDERS; k++)
        if (strcmp(value, orders[k]) == 0) {
            *bits = (bits_order)k;
            return 0;
        }
    return says ? complain(value) : EXIT_USAGE;
}

/* Returns the value of an option --bits at argv[k], and sets *words to the number of its words.
 * Returns NULL if argv[k] is not that option. */
static const char *value_at(int argc, char **argv, int k, int *words) {
    static const char name[] = "--bits";
    const size_t length = sizeof name - 1;
    if (strncmp(argv[k], name, length) != 0)
        return NULL;
    *words = argv[k][length] == '=' ? 1 : 2;
    if (argv[k][length] == '=')
        return argv[k] + length + 1;
    if (argv[k][length] != '\0')
        return NULL;
    return k + 1 < argc ? argv[k + 1] : "";
}

int bits_take(int *argc, char **argv, int says, bits_order *bits) {
    const int given = *argc;
    int kept = 0, wrong = 0, words;
    if (!simulates(given, argv))
        return 0;
    for (int k = 0; k < given && wrong == 0; k += words) {
        const char *value = value_at(given, argv, k, &words);
        if (value) {
            wrong = read_order(value, says, bits);
        } else {
            argv[kept++] = argv[k];
            words = 1;
        }
    }
    if (wrong != 0)
        return wrong;
    argv[kept] = NULL;
    *argc = kept;
    return 0;
}

void bits_help(int argc, char **argv) {
    int asked = 0;
    for (int k = 2; k < argc; k++)
        asked |= strcmp(argv[k], "--help") == 0;
    if (asked && simulates(argc, argv))
        printf("  --bits ORDER            over ranks: serial (default) has fabric-serial's bits, "
               "any leaves the\n                          solution to PETSc "
               "(PETSC_OPTIONS)\n");
}
