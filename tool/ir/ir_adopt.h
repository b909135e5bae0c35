/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Bodies of functions that another file of the program defines. */
#ifndef IR_IR_ADOPT_H
#define IR_IR_ADOPT_H

#include "ir/ir.h"

/** May this definition of the other unit be adopted? */
typedef bool (*ir_adoptable)(const ir_unit *from, const ir_function *function, void *context);

/**
 * Gives the functions `names`, which `unit` only declares, the bodies that `from` defines, and
 * likewise the functions that these call. A function counts as found if its declaration here agrees
 * with the definition. Identical records of both units become one. The other declarations that the
 * bodies use are added to the unit; they have no offsets in its text, and its text cannot name
 * them. `from` must be in the same arena, and must not be used afterwards. Returns how many of the
 * names were found.
 */
unsigned ir_adopt(ir_unit *unit, ir_unit *from, unsigned count, const char *const *names,
                  ir_adoptable may_be, void *context);

#endif
