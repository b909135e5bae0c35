/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for MAP_ANONYMOUS and cpu_set_t */
#include "base/system.h"

#include "base/vdso.h"

#include <assert.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#if defined(__linux__)

#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>

/* glibc's reserved name of getauxval, which reads the kernel's auxiliary vector. */
extern unsigned long __getauxval(unsigned long) __attribute__((__weak__));

/* The auxiliary value `what` of the process; 0 if the kernel gives none. In that case the library's
 * function sets errno, so errno is restored. */
static unsigned long auxiliary_value(unsigned long what) {
    const int before = errno;
    const unsigned long value = __getauxval ? __getauxval(what) : 0;
    errno = before;
    return value;
}

#if UINTPTR_MAX > 0xffffffff
typedef Elf64_Ehdr elf_header;
#else
typedef Elf32_Ehdr elf_header;
#endif
/* A symbol that the linker defines at the beginning of this object. */
extern const elf_header __ehdr_start __attribute__((__weak__, __visibility__("hidden")));

bool redcc_system_is_program(void) {
    const unsigned long program = auxiliary_value(AT_PHDR);
    return &__ehdr_start && program &&
           (uintptr_t)&__ehdr_start + __ehdr_start.e_phoff == (uintptr_t)program;
}

int redcc_system_open(const char *name) {
    return (int)redcc_system(SYS_openat, AT_FDCWD, name, O_RDONLY | O_CLOEXEC);
}

long redcc_system_read(int descriptor, void *into, size_t bytes) {
    return redcc_system(SYS_read, descriptor, into, bytes);
}

void redcc_system_close(int descriptor) {
    redcc_system(SYS_close, descriptor);
}

void redcc_system_read_text(const char *name, char *text, size_t bytes) {
    assert(bytes > 0); /* room for the final 0 */
    const int file = redcc_system_open(name);
    if (file < 0)
        return;
    redcc_system_read(file, text, bytes - 1);
    redcc_system_close(file);
}

#ifdef SYS_mmap2 /* mmap2 takes the offset in pages, but the offset of these mappings is 0 */
#define MAP_CALL SYS_mmap2
#else
#define MAP_CALL SYS_mmap
#endif

/* One thread may unmap memory at addresses that the kernel then gives to another thread. The kernel
 * orders the two calls, but race detectors do not know that. This counter shows them the order. */
static atomic_uint unmapped;

void *redcc_system_map(size_t bytes) {
    assert(bytes > 0);
    const long place = redcc_system(MAP_CALL, 0, bytes, PROT_READ | PROT_WRITE,
                                    MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    (void)atomic_load_explicit(&unmapped, memory_order_acquire);
    return place < 0 && place > -4096 ? NULL : (void *)place;
}

void redcc_system_unmap(void *memory, size_t bytes) {
    atomic_fetch_add_explicit(&unmapped, 1, memory_order_release);
    redcc_system(SYS_munmap, memory, bytes);
}

size_t redcc_page_size(void) {
    const unsigned long page = auxiliary_value(AT_PAGESZ);
    return page ? page : 4096;
}

typedef int clock_function(int clock, struct timespec *now);
typedef int node_function(unsigned *processor, unsigned *node, void *unused);

static int clock_by_call(int clock, struct timespec *now) {
    return (int)redcc_system(SYS_clock_gettime, clock, now);
}

static int node_by_call(unsigned *processor, unsigned *node, void *unused) {
    (void)unused;
    return (int)redcc_system(SYS_getcpu, processor, node, 0);
}

static clock_function find_clock;
static node_function find_node;
static _Atomic(clock_function *) clock_of = find_clock;
static _Atomic(node_function *) node_of = find_node;

static int find_clock(int clock, struct timespec *now) {
    clock_function *const found =
        (clock_function *)redcc_vdso_find(auxiliary_value(AT_SYSINFO_EHDR), REDCC_VDSO_CLOCK);
    atomic_store_explicit(&clock_of, found ? found : clock_by_call, memory_order_relaxed);
    return (found ? found : clock_by_call)(clock, now);
}

static int find_node(unsigned *processor, unsigned *node, void *unused) {
    node_function *const found =
        (node_function *)redcc_vdso_find(auxiliary_value(AT_SYSINFO_EHDR), REDCC_VDSO_NODE);
    atomic_store_explicit(&node_of, found ? found : node_by_call, memory_order_relaxed);
    return (found ? found : node_by_call)(processor, node, unused);
}

struct timespec redcc_system_clock(int clock) {
    struct timespec now = {0, 0};
    atomic_load_explicit(&clock_of, memory_order_relaxed)(clock, &now);
    return now;
}

int redcc_system_node(void) {
    unsigned processor, node;
    if (atomic_load_explicit(&node_of, memory_order_relaxed)(&processor, &node, NULL) == 0)
        return (int)node;
    return -1;
}

/* The result is cached, because it is needed before each execution of a loop, and many executions
 * are shorter than a system call. */
uint64_t redcc_system_memory(void) {
    static atomic_uint mebibytes;
    unsigned known = atomic_load_explicit(&mebibytes, memory_order_relaxed);
    struct sysinfo info;
    if (known == 0 && redcc_system(SYS_sysinfo, &info) == 0) {
        known = (unsigned)((uint64_t)info.totalram * info.mem_unit >> 20);
        atomic_store_explicit(&mebibytes, known, memory_order_relaxed);
    }
    return (uint64_t)known << 20;
}

void redcc_system_yield(void) {
    redcc_system(SYS_sched_yield);
}

long redcc_system_process(void) {
    return redcc_system(SYS_getpid);
}

/* Reads the 22nd field of /proc/self/stat. The search begins after the second field, a name in
 * brackets which may itself contain spaces and brackets. */
unsigned long long redcc_system_started(void) {
    char text[1024] = "";
    redcc_system_read_text("/proc/self/stat", text, sizeof text);
    const char *at = strrchr(text, ')');
    for (int field = 2; at && field < 22; field++)
        at = strchr(at + 1, ' ');
    return at ? strtoull(at, NULL, 10) : 0;
}

/* Reads /proc/loadavg. In "0.25 1.42 1.78 3/77 7479", 3 of 77 threads are runnable. */
int redcc_system_running(void) {
    char text[128] = "";
    redcc_system_read_text("/proc/loadavg", text, sizeof text);
    const char *at = text;
    for (int field = 1; at && field < 4; field++)
        at = strchr(at + 1, ' ');
    return at ? (int)strtol(at, NULL, 10) : 0;
}

/* Counts processors in lists such as "0-1" and "0,2-5". */
int redcc_system_online(void) {
    char text[1024] = "";
    redcc_system_read_text("/sys/devices/system/cpu/online", text, sizeof text);
    int count = 0;
    for (char *at = text; '0' <= *at && *at <= '9'; at += *at == ',') {
        const long first = strtol(at, &at, 10);
        const long last = *at == '-' ? strtol(at + 1, &at, 10) : first;
        count += (int)(last - first) + 1;
    }
    return count;
}

long redcc_system_preemptions(void) {
    struct rusage used;
    return redcc_system(SYS_getrusage, RUSAGE_SELF, &used) == 0 ? used.ru_nivcsw : 0;
}

bool redcc_system_is_privileged(void) {
    return auxiliary_value(AT_SECURE) != 0;
}

void redcc_system_secret(uint64_t *word, size_t words) {
    const size_t bytes = words * sizeof *word;
    if (redcc_system(SYS_getrandom, word, bytes, 1 /* GRND_NONBLOCK */) == (long)bytes)
        return;
    /* the kernel's 16 random bytes */
    const uint64_t *given = (const uint64_t *)auxiliary_value(AT_RANDOM);
    const struct timespec now = redcc_system_clock(CLOCK_REALTIME);
    uint64_t state = (uint64_t)now.tv_nsec ^ (uint64_t)(uintptr_t)&state;
    for (size_t i = 0; i < words; i++) { /* the generator splitmix64 */
        state += 0x9e3779b97f4a7c15u + (given ? given[i & 1] : 0);
        uint64_t mixed = (state ^ state >> 30) * 0xbf58476d1ce4e5b9u;
        mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111ebu;
        word[i] = mixed ^ mixed >> 31;
    }
}

#else /* other systems: POSIX functions under their public names */

#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

void *redcc_system_map(size_t bytes) {
    void *place = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return place == MAP_FAILED ? NULL : place;
}

void redcc_system_unmap(void *memory, size_t bytes) {
    munmap(memory, bytes);
}

size_t redcc_page_size(void) {
    return (size_t)sysconf(_SC_PAGESIZE);
}

struct timespec redcc_system_clock(int clock) {
    struct timespec now = {0, 0};
    clock_gettime((clockid_t)clock, &now);
    return now;
}

int redcc_system_node(void) {
    return -1;
}

uint64_t redcc_system_memory(void) {
    return 0;
}

void redcc_system_yield(void) {
    sched_yield();
}

long redcc_system_process(void) {
    return (long)getpid();
}

unsigned long long redcc_system_started(void) {
    return 0;
}

int redcc_system_running(void) {
    return 0;
}

int redcc_system_online(void) {
    return 0;
}

long redcc_system_preemptions(void) {
    return 0;
}

bool redcc_system_is_privileged(void) {
    return getuid() != geteuid() || getgid() != getegid();
}

void redcc_system_secret(uint64_t *word, size_t words) {
    const struct timespec now = redcc_system_clock(CLOCK_REALTIME);
    uint64_t state = (uint64_t)now.tv_nsec ^ (uint64_t)(uintptr_t)&state;
    for (size_t i = 0; i < words; i++) {
        state += 0x9e3779b97f4a7c15u;
        word[i] = (state ^ state >> 29) * 0xbf58476d1ce4e5b9u;
    }
}

#endif
