/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
// PROGRAM: 32-an-allocator-for-one-thread.c
// CFLAGS: -O2 -DWITHOUT_ALIGNED -DSIZE=600000 -DAREA=(256<<20)
// METHODS: auto localwrite binning
// EXPECT-ALL: transformed
// The program's allocator has only the functions that glibc requires. OpenMP's library gets aligned
// memory from the C library, and this memory must not reach the program's free.
