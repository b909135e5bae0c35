/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Products of 3x3 matrices such as the blocks of A (system/system.h). The output must not be one
 *  of the inputs. */
#ifndef FABRIC_MATRIX3_H
#define FABRIC_MATRIX3_H

/** out = left right */
static inline void matrix3_multiply(const double left[3][3], const double right[3][3],
                                    double out[3][3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            out[r][c] =
                left[r][0] * right[0][c] + left[r][1] * right[1][c] + left[r][2] * right[2][c];
}

/** out = left * transpose(right) */
static inline void matrix3_multiply_transposed(const double left[3][3], const double right[3][3],
                                               double out[3][3]) {
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            out[r][c] =
                left[r][0] * right[c][0] + left[r][1] * right[c][1] + left[r][2] * right[c][2];
}

#endif
