/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Processor features that the runtime may use although it is not compiled for them. */
#ifndef REDCC_BASE_PROCESSOR_H
#define REDCC_BASE_PROCESSOR_H

#include <stdbool.h>

/** May functions that are compiled for the target "avx2" be called? False on processors other than
 * x86-64. Thread-safe. */
bool redcc_has_avx2(void);

/** Does the processor have protection keys (rights.h) that the system has enabled? Takes some
 * nanoseconds. */
bool redcc_has_protection_keys(void);

#endif
