/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Where this program's own companions lie: found from its place, never compiled in. */
#ifndef DRIVER_INSTALLATION_H
#define DRIVER_INSTALLATION_H

#include "support/arena.h"

/** Absolute paths; NULL for what is not there. */
typedef struct installation {
    const char *self;       /**< this program */
    const char *translator; /**< redcc */
    const char *library;    /**< libredcc_rt.a, else libredcc_rt.so */
    const char *include;    /**< the folder that holds redcc/runtime.h */
} installation;

/** Looks below $REDCC_ROOT where it is set, else around this program: first as installed
 *  (bin, lib, include side by side), then as built. */
installation installation_find(arena *a);

/** The URI of the folder that holds the pages, reasons.md and refused.md: where the project said
 * that they are to be read (REDCC_DOCUMENTS_URI), else as installed. NULL: there is none. */
const char *installation_documents(arena *a);

#endif
