/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Direct system calls on Linux, in place of POSIX functions such as read, close, mmap, sysconf and
 * clock_gettime, which other systems use. ISO C does not reserve these names (C17 7.1.3). So the
 * program may define a function with such a name, which would replace the library's. On Linux, no
 * function here sets errno, is a cancellation point, allocates or takes a lock; all are thread-safe
 * and async-signal-safe. tests/runtime/check-symbols checks the names to which the runtime refers.
 */
#ifndef REDCC_SYSTEM_H
#define REDCC_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#if defined(__linux__)
#include <sys/stat.h>
#include <sys/syscall.h>
#ifndef STATX_TYPE /* musl before 1.2.5 leaves struct statx to the kernel's headers */
#include <linux/stat.h>
#endif

#if defined(__x86_64__) && defined(__LP64__)

/** System call `number`; returns its result, or -errno. */
static inline long redcc_system_call(long number, long a, long b, long c, long d, long e, long f) {
    long result;
    register long fourth __asm__("r10") = d;
    register long fifth __asm__("r8") = e;
    register long sixth __asm__("r9") = f;
    __asm__ volatile("syscall"
                     : "=a"(result)
                     : "a"(number), "D"(a), "S"(b), "d"(c), "r"(fourth), "r"(fifth), "r"(sixth)
                     : "rcx", "r11", "memory");
    return result;
}

#elif defined(__aarch64__) && defined(__LP64__)

static inline long redcc_system_call(long number, long a, long b, long c, long d, long e, long f) {
    register long call __asm__("x8") = number;
    register long first __asm__("x0") = a;
    register long second __asm__("x1") = b;
    register long third __asm__("x2") = c;
    register long fourth __asm__("x3") = d;
    register long fifth __asm__("x4") = e;
    register long sixth __asm__("x5") = f;
    __asm__ volatile("svc #0"
                     : "+r"(first)
                     : "r"(call), "r"(second), "r"(third), "r"(fourth), "r"(fifth), "r"(sixth)
                     : "memory");
    return first;
}

#else /* there is no alternative to the library's function under its public name */

#include <errno.h>
#include <unistd.h>
extern long syscall(long number, ...);

static inline long redcc_system_call(long number, long a, long b, long c, long d, long e, long f) {
    const int before = errno;
    const long result = syscall(number, a, b, c, d, e, f);
    const int failure = errno;
    errno = before;
    return result == -1 ? -failure : result;
}

#endif

/* Passes 0 for the omitted arguments. */
#define REDCC_SYSTEM_7(number, a, b, c, d, e, f, ...)                                              \
    redcc_system_call((long)(number), (long)(a), (long)(b), (long)(c), (long)(d), (long)(e),       \
                      (long)(f))
#define redcc_system(...) REDCC_SYSTEM_7(__VA_ARGS__, 0, 0, 0, 0, 0, 0, 0)

/** Is the runtime linked into the executable, which is never unloaded? False if that is unknown. */
bool redcc_system_is_program(void);
/** Opens a file for reading. Returns its descriptor, or a negative number on failure. */
int redcc_system_open(const char *name);

/** Reads up to `bytes` bytes. Returns the number of bytes read, 0 at the end of the file, or a
 * negative number on failure. */
long redcc_system_read(int descriptor, void *into, size_t bytes);

void redcc_system_close(int descriptor);

/** Reads the beginning of a file into `text`, a buffer of `bytes` bytes that are all zero. The last
 * byte stays zero. On failure all bytes stay zero. */
void redcc_system_read_text(const char *name, char *text, size_t bytes);

#endif

/** Maps `bytes` bytes of memory (a multiple of the page size), which are all zero. NULL on
 * failure. */
void *redcc_system_map(size_t bytes);

/** Unmaps memory of redcc_system_map. */
void redcc_system_unmap(void *memory, size_t bytes);

/** The size of a page in bytes. */
size_t redcc_page_size(void);

/** The time of a `clock` of <time.h>; cheap for CLOCK_MONOTONIC. */
struct timespec redcc_system_clock(int clock);

/** The NUMA node of the calling thread; -1: unknown. */
int redcc_system_node(void);

/** The size of the machine's memory in bytes; 0: unknown. */
uint64_t redcc_system_memory(void);

/** Yields the processor. */
void redcc_system_yield(void);

/** The id of the process. */
long redcc_system_process(void);

/** The start time of the process, in ticks since boot; 0: not known. Together with the process's id
 * it identifies the process. */
unsigned long long redcc_system_started(void);

/** The number of runnable threads of all programs, including the caller; 0: not known. */
int redcc_system_running(void);

/** The number of online processors; 0: not known. */
int redcc_system_online(void);

/** The number of involuntary context switches of the process's threads; 0: not known. */
long redcc_system_preemptions(void);

/** Does the program have more rights than its caller (setuid)? Then the environment must be
 * ignored. */
bool redcc_system_is_privileged(void);

/** Fills word[words] with random values. */
void redcc_system_secret(uint64_t *word, size_t words);

#endif
