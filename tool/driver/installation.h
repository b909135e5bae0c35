/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds the files that belong to this program, relative to its own path or to $REDCC_ROOT. No
 * absolute path is compiled in, except REDCC_DOCUMENTS_URI if it is set. */
#ifndef DRIVER_INSTALLATION_H
#define DRIVER_INSTALLATION_H

#include "support/arena.h"

/** Absolute paths; NULL for missing files. */
typedef struct installation {
    const char *self;       /**< this program */
    const char *translator; /**< redcc */
    const char *library;    /**< libredcc_rt.a, else libredcc_rt.so */
    const char *include;    /**< the folder that holds redcc/runtime.h */
} installation;

/** Searches below $REDCC_ROOT if it is set, else around this program: first an installed tree (with
 *  the folders bin, lib and include), then a build tree. */
installation installation_find(arena *a);

/** The URI of the folder with the pages reasons.md and refused.md: the one given at configuration
 * (REDCC_DOCUMENTS_URI), else the installed one. Returns NULL if there is none. */
const char *installation_documents(arena *a);

#endif
