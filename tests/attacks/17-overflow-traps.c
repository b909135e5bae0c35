/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// PROGRAM: 02-signed-overflows-where-not-computed.c
// CFLAGS: -O1 -ftrapv
// EXPECT-ALL: refuse option
// Since such options refuse every loop, what is left to show is that the program is the same; the text
// is also built without the option, with a sanitizer (17-overflow-under-ubsan.c), where it is translated.
