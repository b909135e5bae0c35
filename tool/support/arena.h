/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** Memory that is freed all at once. */
#ifndef SUPPORT_ARENA_H
#define SUPPORT_ARENA_H

#include <stdarg.h>
#include <stddef.h>

typedef struct arena arena;

/** Creates an arena. All functions that allocate end the program with a message if memory is
 * exhausted. */
arena *arena_new(void);
void *arena_allocate(arena *a, size_t size); /* zeroed, aligned for any type */
void arena_free(arena *a);
/** Frees everything that was allocated; the arena may be filled again. */
void arena_clear(arena *a);
size_t arena_used(const arena *a);

char *arena_copy(arena *a, const char *text, size_t length); /* ends in 0 */
char *arena_string(arena *a, const char *text);
char *arena_format(arena *a, const char *format, ...) __attribute__((format(printf, 2, 3)));

#define ARENA_NEW(a, type) ((type *)arena_allocate((a), sizeof(type)))
#define ARENA_ARRAY(a, type, count) ((type *)arena_allocate((a), sizeof(type) * (size_t)(count)))

#endif
