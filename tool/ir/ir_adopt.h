/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Bodies of functions that another file of the program defines. */
#ifndef IR_IR_ADOPT_H
#define IR_IR_ADOPT_H

#include "ir/ir.h"

/** Which definitions of the other unit may be taken. */
typedef bool (*ir_adoptable)(const ir_unit *from, const ir_function *function, void *context);

/**
 * Gives the functions `names`, which `unit` only declares, the bodies that `from` defines, and
 * those of the functions which these lead to. A function counts as found where its declaration here
 * agrees with the definition. Records of both units that are alike become one; what else of the
 * other file is mentioned becomes the unit's, without places in its text, and without names where
 * it has none here. `from` is of the same arena, and is not to be used afterwards. The unit is
 * whole again when the function returns. Returns how many of the names were found.
 */
unsigned ir_adopt(ir_unit *unit, ir_unit *from, unsigned count, const char *const *names,
                  ir_adoptable may_be, void *context);

#endif
