/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/processor.h"

/* glibc's loader has asked the processor already. gcc's own library asks once more in each process
 * that it is linked into, before main: 0.07 ms in a virtual machine, where each question is
 * answered by the host (a program that does nothing: 0.68 ms with it, 0.49 without the runtime). */
#if defined(__x86_64__) && defined(__has_include)
#if __has_include(<sys/platform/x86.h>)
#include <sys/platform/x86.h>
#define HAS(gcc_name, glibc_name) CPU_FEATURE_ACTIVE(glibc_name)
#endif
#endif
#if defined(__x86_64__) && !defined(HAS)
#define HAS(gcc_name, glibc_name) __builtin_cpu_supports(gcc_name)
#endif

bool redcc_has_avx2(void) {
#ifdef HAS
    return HAS("avx2", AVX2) != 0;
#else
    return false;
#endif
}

bool redcc_has_avx512(void) {
#ifdef HAS
    return HAS("avx512f", AVX512F) != 0 && HAS("avx512dq", AVX512DQ) != 0 &&
           HAS("avx512vl", AVX512VL) != 0;
#else
    return false;
#endif
}
