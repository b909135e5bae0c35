/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * The system, without a function that the program may define itself: ISO C leaves it read, close,
 * mmap, sysconf, clock_gettime and all other names of POSIX (C17 7.1.3), and a function of that
 * name in the program would be called in the place of the library's. So the kernel is called
 * directly. Nothing here sets errno, is a cancellation point, allocates or takes a lock; all of it
 * may be called by any thread and in a signal handler. tests/runtime/symbols checks what names are
 * left.
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

/** System call `number`; what it returns, -errno where it fails. */
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

#else /* the library's own, under its public name: there is nothing else */

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

/* With 0 for the arguments that are not given. */
#define REDCC_SYSTEM_7(number, a, b, c, d, e, f, ...)                                              \
    redcc_system_call((long)(number), (long)(a), (long)(b), (long)(c), (long)(d), (long)(e),       \
                      (long)(f))
#define redcc_system(...) REDCC_SYSTEM_7(__VA_ARGS__, 0, 0, 0, 0, 0, 0, 0)

/** Is the runtime a part of the program's file, which is never unloaded? False where that cannot be
 *  said. */
bool redcc_system_is_program(void);
/** Opens a file to read; its descriptor, or negative. */
int redcc_system_open(const char *name);

/** Reads up to `bytes` bytes; how many they were, 0 at the end, negative where it fails. */
long redcc_system_read(int descriptor, void *into, size_t bytes);

void redcc_system_close(int descriptor);

/** Reads the beginning of a file into `text`, `bytes` bytes of zeros, of which the last stays one.
 *  Where the file cannot be read all stay zeros. */
void redcc_system_read_text(const char *name, char *text, size_t bytes);

#endif

/** `bytes` bytes of memory of our own, a multiple of a page, all zero; NULL: there are none. */
void *redcc_system_map(size_t bytes);

/** Gives back what redcc_system_map gave. */
void redcc_system_unmap(void *memory, size_t bytes);

/** Bytes of a page. */
size_t redcc_page_size(void);

/** Of a `clock` of <time.h>; cheap for CLOCK_MONOTONIC. */
struct timespec redcc_system_clock(int clock);

/** The NUMA node the calling thread is on; -1: not known. */
int redcc_system_node(void);

/** The processor the calling thread is on; -1: not known. */
int redcc_system_core(void);

/** Bytes of the machine's memory; 0: not known. */
uint64_t redcc_system_memory(void);

/** Lets another thread have the processor. */
void redcc_system_yield(void);

/** The process's id. */
long redcc_system_process(void);

/** When the process began, in ticks since the system did; 0: not known. Together with its id no
 *  other process has it. */
unsigned long long redcc_system_started(void);

/** How many threads of all programs run or want to, the calling one included; 0: not known. */
int redcc_system_running(void);

/** The machine's processors that are in use; 0: not known. */
int redcc_system_online(void);

/** How often the process's threads had to leave their cores to others; 0: not known. */
long redcc_system_cores_lost(void);

/** Has the program more rights than its caller (setuid), so that the environment must not tell it
 *  anything? */
bool redcc_system_is_privileged(void);

/** Fills `word` with what nobody can have known when the program was written. */
void redcc_system_secret(uint64_t *word, size_t words);

#endif
