/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// PROGRAM: 02-signed-overflows-where-not-computed.c
// CFLAGS: -O1 -ftrapv
// EXPECT-ALL: refuse option
// These options refuse every loop, so this test only shows that the program is unchanged.
// 17-overflow-under-ubsan.c translates the same text, with a sanitizer instead of -ftrapv.
