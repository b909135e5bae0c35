/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Takes the bodies of functions from another file of the program into a unit. */
#ifndef IR_IR_ADOPT_H
#define IR_IR_ADOPT_H

#include "ir/ir.h"

/** May this definition of the unit `from` be adopted? */
typedef bool (*ir_adoptable)(const ir_unit *from, const ir_function *function, void *context);

/** Gives the functions `names`, which `unit` only declares, the bodies that `from` defines. Also
 *  takes the bodies of functions that these bodies call. `may_be` decides for each function that is
 *  not static. Returns how many of the names received a body.
 *
 *  A declaration must agree with the definition. Identical records of both units become one. Other
 *  declarations that the bodies use are added to `unit`. They have no offsets in its text, and its
 *  text cannot name them.
 *
 *  `from` must be in the same arena, and must not be used afterwards. */
unsigned ir_adopt(ir_unit *unit, ir_unit *from, unsigned count, const char *const *names,
                  ir_adoptable may_be, void *context);

#endif
