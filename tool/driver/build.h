/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Compiling and linking: the translated texts where that works, the sources themselves else. */
#ifndef DRIVER_BUILD_H
#define DRIVER_BUILD_H

#include "driver/translate.h"

/** Whether the command links a program that the runtime can be added to. */
bool build_can_add_runtime(const session *s);

/** Does what the command asks, with `count` sources translated or tried. Ends the process. */
_Noreturn void build(session *s, const translation *translations, unsigned count);

#endif
