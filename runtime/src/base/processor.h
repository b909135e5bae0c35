/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** What the processor can do beyond what the runtime is compiled for. */
#ifndef REDCC_BASE_PROCESSOR_H
#define REDCC_BASE_PROCESSOR_H

#include <stdbool.h>

/** May functions of the target "avx2" be called? Never on other processors than x86-64.
 * Thread-safe.
 */
bool redcc_has_avx2(void);

/** Has it protection keys (rights.h), which the system has switched on? Some nanoseconds. */
bool redcc_has_protection_keys(void);

#endif
