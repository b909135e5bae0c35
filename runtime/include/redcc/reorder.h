/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Orders of rows and iterations that improve locality, for a program that may renumber its mesh.
 * The program first orders its rows, by the graph of the iterations that update them or along a
 * curve through their points. Then it orders the iterations by their rows.
 *
 * An order is a permutation new_of_old: record i becomes record new_of_old[i].
 * redcc_reorder_records moves data from one order to another, and back.
 *
 * Every function returns 0, or -1 if out of memory or if an argument is out of range (then nothing
 * is written). All are thread-safe and execute in the calling thread. C89 and C++ may include this
 * header.
 */
#ifndef REDCC_REORDER_H
#define REDCC_REORDER_H

#include <stddef.h>

#if defined(__GNUC__)
#ifdef REDCC_HIDDEN /* static library: programs linked with it export none of these names */
#pragma GCC visibility push(hidden)
#else
#pragma GCC visibility push(default)
#endif
#endif
#ifdef __cplusplus
extern "C" {
#endif

/**
 * Orders rows by the reverse Cuthill-McKee algorithm, on the graph in which two rows are neighbours
 * if one iteration updates both.
 *   trip, touches   number of iterations; number of rows that each iteration updates
 *   row             [trip * touches] these rows: 0 <= row < rows
 *   new_of_old      [rows] the result
 */
int redcc_reorder_rows(int trip, int touches, const int *row, int rows, int *new_of_old);

/**
 * Orders points along Hilbert's curve.
 *   count, dimensions   number of points; 2 or 3 coordinates each
 *   point               [count * dimensions]; a NaN counts as the smallest number
 *   new_of_old          [count] the result
 */
int redcc_reorder_points(int count, int dimensions, const double *point, int *new_of_old);

/**
 * Orders iterations by the rows that they update: by the lowest, then by the second lowest.
 * Iterations for which both are equal keep their order.
 *   trip, touches, row   as for redcc_reorder_rows, the rows in their new order
 *   new_of_old           [trip] the result
 */
int redcc_reorder_iterations(int trip, int touches, const int *row, int *new_of_old);

/**
 * Permutes records of `bytes` bytes each: record i moves to new_of_old[i] or, if `back` is
 * set, from there to i.
 *   record       [count]
 *   new_of_old   [count] a permutation
 */
int redcc_reorder_records(void *record, int count, size_t bytes, const int *new_of_old, int back);

#ifdef __cplusplus
}
#endif
#if defined(__GNUC__)
#pragma GCC visibility pop
#endif

#endif
