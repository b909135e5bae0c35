/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * What text for redcc_width lanes is compiled with (lanes.h): its names, which stand in REDCC_WIDE,
 * the list of its lanes, and its processor. To be included wherever redcc_width is defined anew.
 */
#ifdef REDCC_EXECUTE_LANES                  /* behind lanes.h: what is undone by REDCC_QUIET_END */
#pragma GCC diagnostic ignored "-Wpedantic" /* vectors made of what is no constant */
#pragma GCC diagnostic ignored "-Wdeclaration-after-statement"
#endif
#undef REDCC_WIDE
#undef REDCC_ALL
#undef REDCC_TARGET
#if redcc_width == 2
#define REDCC_WIDE(redcc_name) redcc_name##_2
#define REDCC_ALL REDCC_ALL_2
#define REDCC_TARGET REDCC_TARGET_2
#elif redcc_width == 4
#define REDCC_WIDE(redcc_name) redcc_name##_4
#define REDCC_ALL REDCC_ALL_4
#define REDCC_TARGET REDCC_TARGET_4
#else
#define REDCC_WIDE(redcc_name) redcc_name##_8
#define REDCC_ALL REDCC_ALL_8
#define REDCC_TARGET REDCC_TARGET_8
#endif
