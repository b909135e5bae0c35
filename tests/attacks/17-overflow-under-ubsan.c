/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// PROGRAM: 02-signed-overflows-where-not-computed.c
// CFLAGS: -O1 -fsanitize=undefined -fno-sanitize-recover=all
// The sanitizer would report t * stride if it were computed in iterations where the program does not compute it.
