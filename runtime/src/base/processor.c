/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/processor.h"

/* Uses the processor features that glibc's loader has found. gcc's library would query the
 * processor again before main. In a virtual machine, where the host emulates each query, that takes
 * 0.07 ms. */
#if defined(__x86_64__) && defined(__has_include)
#if __has_include(<sys/platform/x86.h>)
#include <sys/platform/x86.h>
#define GLIBC_ASKED

/* The header's own macro shifts an int by 31, which is undefined. */
static bool is_active(unsigned feature) {
    const unsigned bit = feature % 128;
    return __x86_get_cpuid_feature_leaf(feature / 128)->active_array[bit / 32] >> bit % 32 & 1;
}

#define HAS(gcc_name, glibc_name) is_active(x86_cpu_##glibc_name)
#endif
#endif
#if defined(__x86_64__) && !defined(HAS)
#include <cpuid.h>
#include <stdatomic.h>
#define HAS(gcc_name, glibc_name) (__builtin_cpu_supports(gcc_name) != 0)
#endif

bool redcc_has_avx2(void) {
#ifdef HAS
    return HAS("avx2", AVX2);
#else
    return false;
#endif
}

/* Uses the CPUID bit that shows whether the system has enabled the keys. */
bool redcc_has_protection_keys(void) {
#if defined(GLIBC_ASKED)
    const unsigned bit = x86_cpu_OSPKE % 128;
    return __x86_get_cpuid_feature_leaf(x86_cpu_OSPKE / 128)->cpuid_array[bit / 32] >> bit % 32 & 1;
#elif defined(__x86_64__)
    enum { UNKNOWN, NONE, SOME };
    static atomic_int known;
    unsigned a, b, c = 0, d;
    if (atomic_load_explicit(&known, memory_order_relaxed) == UNKNOWN) {
        const bool some = __get_cpuid_count(7, 0, &a, &b, &c, &d) && c >> 4 & 1;
        atomic_store_explicit(&known, some ? SOME : NONE, memory_order_relaxed);
    }
    return atomic_load_explicit(&known, memory_order_relaxed) == SOME;
#else
    return false;
#endif
}
