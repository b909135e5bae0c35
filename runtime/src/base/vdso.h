/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Functions that the kernel maps into each process, such as a clock without a system call. */
#ifndef REDCC_VDSO_H
#define REDCC_VDSO_H

#if defined(__aarch64__)
#define REDCC_VDSO_CLOCK "__kernel_clock_gettime"
#define REDCC_VDSO_NODE "__kernel_getcpu" /* no such function on this processor */
#else
#define REDCC_VDSO_CLOCK "__vdso_clock_gettime"
#define REDCC_VDSO_NODE "__vdso_getcpu"
#endif

/** The function `name` in the image at address `image` (AT_SYSINFO_EHDR; 0: none), as in vdso(7); a
 *  null pointer if it does not exist. */
void (*redcc_vdso_find(unsigned long image, const char *name))(void);

#endif
