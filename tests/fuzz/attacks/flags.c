/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "fuzz/attacks/attack.h"

/* Options of the translation and of both compilations. */
static const block_flags usual = {"-O1", true, false, false, false};
static const block_flags others[] = {
    {"-O0", true, false, false, false},
    {"-O2", true, false, false, false},
    {"-O1 -ftrapv", true, false, false, false},
    {"-O1 -fno-strict-aliasing", true, false, false, false},
    {"-O2 -funsigned-char -fshort-enums", true, false, false, false},
    {"-O1 -fno-math-errno -fno-trapping-math", false, false, false, false},
    {"-O1 -fsanitize=signed-integer-overflow,shift,integer-divide-by-zero "
     "-fno-sanitize-recover=all",
     true, false, false, false},
    {"-O1 -mfpmath=387", true, false, true, false},
    {"-Ofast", false, true, false, false},
    {"-O3 -march=native", true, false, false, false},
    {"-O1 -fwrapv", true, false, false, true},
    {"-O1 -std=c11", true, false, false, false},
    {"-O1 -fno-builtin", true, false, false, false},
};

const block_flags *flags_of_block(uint64_t block) {
    random_source r = {block * 0x51ed27 + 9};
    const int count = (int)(sizeof others / sizeof *others);
    return random_chance(&r, 45) ? &usual : &others[random_below(&r, count)];
}
