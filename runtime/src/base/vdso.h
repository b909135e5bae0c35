/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Finds functions that the kernel maps into each process, such as a clock that needs no system
 * call. */
#ifndef REDCC_VDSO_H
#define REDCC_VDSO_H

#if defined(__aarch64__)
#define REDCC_VDSO_CLOCK "__kernel_clock_gettime"
#define REDCC_VDSO_NODE "__kernel_getcpu" /* this processor has no such function */
#else
#define REDCC_VDSO_CLOCK "__vdso_clock_gettime"
#define REDCC_VDSO_NODE "__vdso_getcpu"
#endif

/** Returns the function `name` in the image at address `image`, as vdso(7) describes; a null
 * pointer if it does not exist. `image` is the value of AT_SYSINFO_EHDR; 0: there is no image. */
void (*redcc_vdso_find(unsigned long image, const char *name))(void);

#endif
