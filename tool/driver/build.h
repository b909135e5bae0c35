/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiles and links the translated texts or, if that fails, the sources themselves. */
#ifndef DRIVER_BUILD_H
#define DRIVER_BUILD_H

#include "driver/translate.h"

/** Returns whether the command links a program to which the runtime can be added. */
bool build_can_add_runtime(const session *s);

/** Executes the command, given the results of translating its `count` C sources. Ends
 *  the process. */
_Noreturn void build(session *s, const translation *translations, unsigned count);

#endif
