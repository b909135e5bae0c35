/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds out which external functions the objects of the process refer to and define.
 *
 * In most programs signal handlers end only by returning. Then signals need not be blocked during
 * loops, which would cost a tenth of a short loop's time. References to functions by which a
 * handler could end otherwise are found in the dynamic symbol tables of the objects. A statically
 * linked program has no such tables, so its handlers are assumed to leave by siglongjmp, too.
 */
#include "base/escapes.h"

#include "base/signals.h"
#include "base/system.h"

#include <signal.h>
#include <stdatomic.h>

#if defined(__linux__) && defined(__GLIBC__) && defined(__LP64__)

#include <elf.h>
#include <link.h>
#include <string.h>

extern struct r_debug _r_debug __attribute__((__weak__));

struct object {
    const Elf64_Sym *symbol, *end; /* NULL: the symbols are unknown */
    const char *text;
    size_t text_bytes;
};

/* Compares the first characters before it calls strcmp, because most of the thousands of names
 * differ in their first characters. */
static bool is_called(const char *name, const char *other) {
    return name[0] == other[0] && strcmp(name, other) == 0;
}

static bool is_one_of(const char *name, const char *const *list) {
    for (; *list; list++)
        if (is_called(name, *list))
            return true;
    return false;
}

static bool leaves(const char *name) {
    static const char *const names[] = {"longjmp",
                                        "_longjmp",
                                        "siglongjmp",
                                        "__longjmp_chk",
                                        "__libc_longjmp",
                                        "__libc_siglongjmp",
                                        "setcontext",
                                        "swapcontext",
                                        "pthread_cancel",
                                        "pthread_exit",
                                        "thrd_exit",
                                        "__cxa_throw",
                                        "_Unwind_RaiseException",
                                        "_Unwind_ForcedUnwind",
                                        "fork",
                                        "_Fork",
                                        "vfork",
                                        "clone",
                                        "dlopen",
                                        "dlmopen",
                                        "dlsym",
                                        "dlvsym",
                                        NULL};
    return is_one_of(name, names);
}

/* Is `name` a function by which a program maps memory, or that could give it such a function? The C
 * library and the linker also map memory for themselves without such a reference, but never the
 * same memory twice. */
static bool maps(const char *name) {
    static const char *const names[] = {
        "mmap",    "mmap64", "__mmap",  "mremap", "__mremap", "shmat", "remap_file_pages",
        "syscall", "dlopen", "dlmopen", "dlsym",  "dlvsym",   NULL};
    return is_one_of(name, names);
}

/* Does a library that defines this function belong to OpenMP? Such a library refers to some of the
 * functions above, but uses them only internally. */
static bool is_openmp(const char *name) {
    static const char *const names[] = {"GOMP_parallel", "__kmpc_fork_call", NULL};
    return is_one_of(name, names);
}

/* Finds the object's symbols. Most addresses in the dynamic section have been relocated by now. In
 * objects that cannot be written, such as the kernel's, they are still relative to the load
 * address. */
static struct object object_of(const struct link_map *map) {
    struct object object = {0};
    for (const Elf64_Dyn *entry = map->l_ld; entry && entry->d_tag != DT_NULL; entry++) {
        const uintptr_t value = (uintptr_t)entry->d_un.d_ptr;
        const void *const place =
            (const void *)(value < (uintptr_t)map->l_addr ? value + (uintptr_t)map->l_addr : value);
        if (entry->d_tag == DT_SYMTAB)
            object.symbol = place;
        if (entry->d_tag == DT_STRTAB)
            object.text = place;
        if (entry->d_tag == DT_STRSZ)
            object.text_bytes = (size_t)entry->d_un.d_val;
    }
    /* The number of symbols is not stored directly; linkers put the string table after the symbols.
     */
    const uintptr_t begin = (uintptr_t)object.symbol, end = (uintptr_t)object.text;
    if (object.symbol && object.text && end >= begin)
        object.end = object.symbol + (end - begin) / sizeof *object.symbol;
    return object;
}

/* Does the object refer to a function for which `is_meant` holds? Also true if that is unknown;
 * false for OpenMP's library. */
static bool refers(const struct link_map *map, bool (*is_meant)(const char *name)) {
    const struct object object = object_of(map);
    if (!object.end)
        return true;
    bool does = false, openmp = false;
    for (const Elf64_Sym *symbol = object.symbol; symbol < object.end; symbol++) {
        if (symbol->st_name >= object.text_bytes)
            continue;
        const char *const name = object.text + symbol->st_name;
        if (symbol->st_shndx == SHN_UNDEF)
            does = does || is_meant(name);
        else
            openmp = openmp || is_openmp(name);
    }
    return does && !openmp;
}

static bool defines(const struct link_map *map, const char *name) {
    const struct object object = object_of(map);
    for (const Elf64_Sym *symbol = object.symbol; object.end && symbol < object.end; symbol++)
        if (symbol->st_shndx != SHN_UNDEF && symbol->st_name < object.text_bytes &&
            is_called(object.text + symbol->st_name, name))
            return true;
    return false;
}

enum { FREE = 1, ALIGNED = 2 + 4 + 8 };

/* Returns a bit for each of the functions in names[] that the object defines. */
static int allocator_of(const struct link_map *map) {
    static const char *const names[] = {"free", "aligned_alloc", "posix_memalign", "memalign"};
    const struct object object = object_of(map);
    int defined = 0;
    for (const Elf64_Sym *symbol = object.symbol; object.end && symbol < object.end; symbol++)
        for (int n = 0; n < 4; n++)
            if (symbol->st_shndx != SHN_UNDEF && symbol->st_name < object.text_bytes &&
                is_called(object.text + symbol->st_name, names[n]))
                defined |= 1 << n;
    return defined;
}

/* All objects call the definition of free in the first object that has one. Does that object lack
 * one of the functions for aligned memory? */
static bool is_split(void) {
    for (const struct link_map *map = &_r_debug ? _r_debug.r_map : NULL; map; map = map->l_next) {
        const int defined = allocator_of(map);
        if (defined & FREE)
            return (defined & ALIGNED) != ALIGNED;
    }
    return false;
}

/* A failing assertion calls __assert_fail. Does each object that defines this function also define
 * abort, as the C library does? False if there is no such object. */
static bool are_assertions_plain(void) {
    bool are_there = false;
    for (const struct link_map *map = &_r_debug ? _r_debug.r_map : NULL; map; map = map->l_next) {
        if (!defines(map, "__assert_fail"))
            continue;
        if (!defines(map, "abort"))
            return false;
        are_there = true;
    }
    return are_there;
}

static bool some_object_refers(bool (*is_meant)(const char *name)) {
    if (!&_r_debug || !_r_debug.r_map)
        return true;
    for (const struct link_map *map = _r_debug.r_map; map; map = map->l_next)
        if (refers(map, is_meant))
            return true;
    return false;
}

static bool look_for_escapes(void) {
    return some_object_refers(leaves);
}

static bool look_for_maps(void) {
    return some_object_refers(maps);
}

#else

static bool look_for_escapes(void) {
    return true;
}

static bool look_for_maps(void) {
    return true;
}

static bool is_split(void) {
    return false;
}

static bool are_assertions_plain(void) {
    return false;
}

#endif

/* Returns the cached answer; the first call computes it. */
static bool answer(atomic_int *known, bool (*compute)(void)) {
    enum { UNKNOWN, YES, NO };
    int answer = atomic_load_explicit(known, memory_order_relaxed);
    if (answer == UNKNOWN) {
        answer = compute() ? YES : NO;
        atomic_store_explicit(known, answer, memory_order_relaxed);
    }
    return answer == YES;
}

bool redcc_may_escape(void) {
    static atomic_int known;
    return answer(&known, look_for_escapes);
}

bool redcc_may_map(void) {
    static atomic_int known;
    return answer(&known, look_for_maps);
}

bool redcc_allocator_is_split(void) {
    static atomic_int known;
    return answer(&known, is_split);
}

bool redcc_assertions_abort(void) {
    static atomic_int known;
    return answer(&known, are_assertions_plain) && redcc_signal_is_default(SIGABRT);
}
