/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Instructions of x86-64 that compilers do not find by themselves, where the functions for a width
 * (2, 4 or 8) have them:
 *   REDCC_ROOTS_w(root, value): root is the square root of each lane of the redcc_vector value.
 *     Compilers branch to the library's function for each lane, as it may have to set errno.
 *   REDCC_SIGNS_w(mask): other than 0 where a lane of the redcc_mask is negative.
 * Included by lanes.h, which has the same by other means where one of these is not defined.
 */
#ifndef REDCC_LANES_X86_H
#define REDCC_LANES_X86_H

/** One operand from another; the second list of operands is for -masm=intel. */
#define REDCC_BY(redcc_instruction, redcc_to, redcc_result, redcc_from, redcc_operand)             \
    __asm__(redcc_instruction " {%1, %0|%0, %1}"                                                   \
            : redcc_to(redcc_result)                                                               \
            : redcc_from(redcc_operand))
#define REDCC_SIGNS_BY(redcc_instruction, redcc_to, redcc_type, redcc_from, redcc_operand)         \
    __extension__({                                                                                \
        redcc_type redcc__signs;                                                                   \
        REDCC_BY(redcc_instruction, redcc_to, redcc__signs, redcc_from, redcc_operand);            \
        redcc__signs;                                                                              \
    })

#if defined(__x86_64__) && !defined(REDCC_IS_CHECKED)
#ifdef __AVX__
#define REDCC_ROOTS_2(redcc_root, redcc_v) REDCC_BY("vsqrtpd", "=x", redcc_root, "x", redcc_v)
#define REDCC_SIGNS_2(redcc_mask_2) REDCC_SIGNS_BY("vmovmskpd", "=r", int, "x", redcc_mask_2)
#else
#define REDCC_ROOTS_2(redcc_root, redcc_v) REDCC_BY("sqrtpd", "=x", redcc_root, "x", redcc_v)
#define REDCC_SIGNS_2(redcc_mask_2) REDCC_SIGNS_BY("movmskpd", "=r", int, "x", redcc_mask_2)
#endif
#if defined(__AVX2__) || !defined(REDCC_ONLY_WIDTH)
#define REDCC_ROOTS_4(redcc_root, redcc_v) REDCC_BY("vsqrtpd", "=x", redcc_root, "x", redcc_v)
#define REDCC_SIGNS_4(redcc_mask_4) REDCC_SIGNS_BY("vmovmskpd", "=r", int, "x", redcc_mask_4)
#endif
#if defined(__AVX512DQ__) || !defined(REDCC_ONLY_WIDTH)
#define REDCC_ROOTS_8(redcc_root, redcc_v) REDCC_BY("vsqrtpd", "=v", redcc_root, "v", redcc_v)
#define REDCC_SIGNS_8(redcc_mask_8)                                                                \
    REDCC_SIGNS_BY("vpmovq2m", "=k", unsigned char, "v", redcc_mask_8)
#endif
#endif

#endif
