/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#define _GNU_SOURCE /* for pthread_setattr_default_np */
#include "base/team.h"

#include "base/clock.h"
#include "base/crew.h"
#include "base/forked.h"
#include "base/memory.h"
#include "base/pool.h"
#include "base/signals.h"
#include "base/system.h"
#include "base/wait.h"

#include <assert.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>

_Thread_local int redcc_within __attribute__((__tls_model__("initial-exec")));

#if defined(__linux__)

#include <fcntl.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>

/* Symbols that identify OpenMP's library, and functions by which the library creates threads. All
 * references are weak, so that programs without the library link. */
#define WEAK __attribute__((__weak__))
extern void GOMP_parallel(void) WEAK;
extern void __kmpc_fork_call(void) WEAK;
extern void kmp_set_stacksize_s(size_t) WEAK;
extern int omp_in_parallel(void) WEAK;
extern int omp_get_max_threads(void) WEAK;
extern int omp_get_level(void) WEAK;
extern int omp_get_num_threads(void) WEAK;
extern int __cxa_thread_atexit_impl(void (*)(void *), void *, void *) WEAK;
extern __typeof__(pthread_create) pthread_create WEAK;
extern __typeof__(pthread_join) pthread_join WEAK;
extern __typeof__(pthread_attr_destroy) pthread_attr_destroy WEAK;
extern __typeof__(pthread_attr_getstacksize) pthread_attr_getstacksize WEAK;
extern __typeof__(pthread_attr_setstacksize) pthread_attr_setstacksize WEAK;
extern __typeof__(pthread_getattr_default_np) pthread_getattr_default_np WEAK;
extern __typeof__(pthread_setattr_default_np) pthread_setattr_default_np WEAK;

enum {
    FEW = 8192, /* a limit on the number of processes or threads is assumed not to be reached if it
                   is at least this */
    SPARE = 4 * 1024 * 1024
};

struct team {
    int threads; /* number of threads of this thread's last region; 0: there was none */
    int pinned;  /* the libraries that contain the code of the region's threads are prevented from
                    being unloaded */
    int rest; /* number of checks to skip, after the one that last found the thread in a handler */
    int rest_left;       /* how many of these calls remain */
    size_t stack_before; /* the default size of stacks that must be restored, in bytes; 0: it was
                            not changed */
};

static _Thread_local struct team team __attribute__((__tls_model__("initial-exec")));

void redcc_team_bind(void) {
    if (!GOMP_parallel || __kmpc_fork_call) /* the calls would initialise LLVM's library */
        return;
    if (omp_in_parallel)
        omp_in_parallel();
    if (omp_get_max_threads)
        omp_get_max_threads();
}

/* ---- keeping libraries loaded ---------------------------------------------------------------- */

static void nothing(void *unused) {
    (void)unused;
}

/* Keeps the object that contains `code` loaded: an object is not unloaded while a thread must still
 * call a destructor in it. */
static void pin(void (*code)(void)) {
    if (code)
        __cxa_thread_atexit_impl(nothing, NULL, (void *)code);
}

static void pin_all(void) {
    if (team.pinned || !__cxa_thread_atexit_impl)
        return;
    team.pinned = 1;
    pin(GOMP_parallel);
    pin(__kmpc_fork_call);
    pin((void (*)(void))nothing);
}

/* ---- stacks ---------------------------------------------------------------------------------- */

/* Can this number of bytes be mapped? */
static bool fits(size_t bytes) {
    void *place = redcc_system_map(bytes);
    if (place)
        redcc_system_unmap(place, bytes);
    return place != NULL;
}

/* The limit of the main thread's stack in bytes, but at most 1 GiB; 256 MiB if the stack is
 * unlimited; 0 if the limit is unknown. */
static size_t main_stack(void) {
    struct rlimit limit;
    const size_t unlimited = (size_t)256 << 20, most = (size_t)1 << 30;
    if (redcc_system(SYS_prlimit64, 0, RLIMIT_STACK, 0, &limit) != 0)
        return 0;
    if (limit.rlim_cur == RLIM_INFINITY)
        return unlimited;
    return limit.rlim_cur < most ? (size_t)limit.rlim_cur : most;
}

static bool is_set_by_user(void) {
    return getenv("OMP_STACKSIZE") || getenv("GOMP_STACKSIZE") || getenv("KMP_STACKSIZE");
}

/* Sets the default size of new threads' stacks. Returns the previous size; 0 if unknown. */
static size_t set_stacks(size_t bytes) {
    pthread_attr_t usual;
    size_t before = 0;
    if (!pthread_getattr_default_np || !pthread_setattr_default_np || !pthread_attr_destroy ||
        !pthread_attr_getstacksize || !pthread_attr_setstacksize ||
        pthread_getattr_default_np(&usual) != 0)
        return 0;
    if (pthread_attr_getstacksize(&usual, &before) == 0 && before != bytes &&
        pthread_attr_setstacksize(&usual, bytes) == 0)
        pthread_setattr_default_np(&usual);
    pthread_attr_destroy(&usual);
    return before;
}

/* The size of each of `more` stacks. Begins with the main thread's limit, and halves it until all
 * stacks can be mapped. Returns 0, which means the default size, if the result is at most 2 MiB. */
static size_t stack_for(int more) {
    size_t wanted = main_stack();
    const size_t usual = (size_t)2 << 20;
    while (wanted > usual && !fits(wanted / 4096 * 4096 * (size_t)more))
        wanted /= 2;
    return wanted > usual ? wanted / 4096 * 4096 : 0;
}

static void enlarge_stacks(int more) {
    static atomic_int tried;
    const size_t wanted = is_set_by_user() ? 0 : stack_for(more);
    if (!wanted)
        return;
    if (kmp_set_stacksize_s && atomic_exchange(&tried, 1) == 0)
        kmp_set_stacksize_s(wanted);
    const size_t before = set_stacks(wanted);
    team.stack_before = before && before != wanted ? before : 0;
    if (before > wanted) /* the program has requested a larger size */
        set_stacks(before);
}

/* ---- threads --------------------------------------------------------------------------------- */

static bool is_low(const char *name) {
    char text[32] = "";
    redcc_system_read_text(name, text, sizeof text);
    return text[0] >= '0' && text[0] <= '9' && strtol(text, NULL, 10) < FEW;
}

/* May the system refuse a thread to the process, or memory for one? */
static bool is_limited(void) {
    struct rlimit processes = {RLIM_INFINITY, 0}, bytes = {RLIM_INFINITY, 0};
    redcc_system(SYS_prlimit64, 0, RLIMIT_NPROC, 0, &processes);
    redcc_system(SYS_prlimit64, 0, RLIMIT_AS, 0, &bytes);
    return processes.rlim_cur < FEW || bytes.rlim_cur != RLIM_INFINITY ||
           is_low("/sys/fs/cgroup/pids.max");
}

/* Shared by the threads of a trial, which only wait for its end. */
struct trial {
    atomic_uint over;
    atomic_int asleep;
};

static void *be_there(void *argument) {
    struct trial *trial = argument;
    redcc_wait_while(&trial->over, 0, &trial->asleep, INT32_MAX);
    return NULL;
}

/* The number of threads of the process; 0: unknown. Each thread is a subdirectory of
 * /proc/self/task. */
static int count_tasks(void) {
    enum { LINKS = 2 }; /* number of links of a directory without subdirectories */
    struct statx tasks;
    if (redcc_system(SYS_statx, AT_FDCWD, "/proc/self/task", 0, STATX_NLINK, &tasks) != 0)
        return 0;
    return (int)tasks.stx_nlink - LINKS;
}

/* Finds out how many of `more` threads OpenMP could start, by starting them. All of these threads
 * have ended on return. */
static int try_threads(int more) {
    const int before = count_tasks();
    struct trial trial = {0};
    int made = 0;
    pthread_t *thread = redcc_memory_alloc((size_t)more * sizeof *thread);
    if (!thread)
        return 0;
    while (made < more && pthread_create(&thread[made], NULL, be_there, &trial) == 0)
        made++;
    const int useful = fits(SPARE) || made == 0 ? made : made - 1; /* OpenMP needs memory, too */
    atomic_store(&trial.over, 1);
    redcc_wake(&trial.over, &trial.asleep);
    for (int i = 0; i < made; i++)
        pthread_join(thread[i], NULL);
    redcc_memory_free(thread);
    for (int wait = 0; wait < 10000 && count_tasks() > before; wait++)
        redcc_system_yield(); /* until the system has removed the threads, they count towards the
                                 limit */
    return useful;
}

static int available_threads(int threads) {
    static atomic_int most; /* the limit found so far; 0: none was found */
    const int known = atomic_load(&most), there = team.threads > 0 ? team.threads : 1;
    if (known)
        return threads < known ? threads : known;
    if (!pthread_create || !pthread_join || !is_limited())
        return threads;
    const int can = there + try_threads(threads - there);
    if (can < threads)
        atomic_store(&most, can);
    return can;
}

/* Is the thread in a signal handler? If a check says yes, the next checks are skipped, and their
 * answer is yes, too. The number of skipped checks grows exponentially (back-off). */
static bool is_in_handler(uint64_t before) {
    enum { REST_MOST = 1024 };
    if (team.rest_left > 0) {
        team.rest_left--;
        return true;
    }
    const bool is_so = redcc_signals_in_handler(before);
    team.rest = is_so ? (team.rest < REST_MOST ? 2 * team.rest + 1 : REST_MOST) : 0;
    team.rest_left = team.rest;
    return is_so;
}

/* The number of threads that exist for the calling thread's next region: those of its crew, of the
 * runtime's pool, or of its last OpenMP region. 0: there was no such region. */
static int there(void) {
    if (redcc_crew_threads() > 0)
        return redcc_crew_threads();
    return redcc_region_is_own() ? redcc_pool_threads() : team.threads;
}

int redcc_team_prepare(int threads, uint64_t before) {
    assert(threads >= 1);
    if (threads <= there())
        return threads;
    if (is_in_handler(before))
        return 0;
    if (redcc_region_is_own())
        return redcc_pool_prepare(threads, stack_for(redcc_team_missing(threads)));
    redcc_signals_let_default(before);
    pin_all();
    if (threads < 2)
        return threads;
    enlarge_stacks(redcc_team_missing(threads));
    const int can = available_threads(threads);
    if (can < 2)
        redcc_team_begun(team.threads);
    return can;
}

bool redcc_team_grows(int threads) {
    return threads > there();
}

int redcc_team_missing(int threads) {
    const int have = there() > 0 ? there() : 1;
    return threads > have ? threads - have : 0;
}

int redcc_team_to_start(int threads) {
    if (redcc_region_is_own())
        return 0;
    const int missing = redcc_team_missing(threads);
    const bool is_first = missing > 0 && team.threads < 2;
    const bool is_main = is_first && redcc_system(SYS_gettid) == redcc_system_process();
    return is_main && count_tasks() >= threads ? 0 : missing;
}

void redcc_team_begun(int threads) {
    if (redcc_crew_threads() > 0)
        return;
    team.threads = threads;
    if (team.stack_before)
        set_stacks(team.stack_before);
    team.stack_before = 0;
}

/* ---- threads outside of regions -------------------------------------------------------------- */

static atomic_int members; /* number of threads (members) that exist because they have executed
                              regions, without the first threads of these regions */

/* Thread ids of the members that most recently began to exit; an entry of 0 is unused. The kernel
 * may still count these threads, because they are running destructors or the machine is busy. */
enum { LEAVING = 256 };
static atomic_int leaving[LEAVING];
static atomic_uint left;

static void leave_members(void *unused) {
    (void)unused;
    const unsigned slot = atomic_fetch_add(&left, 1) % LEAVING;
    atomic_store(&leaving[slot], (int)redcc_system(SYS_gettid));
    atomic_fetch_sub(&members, 1);
}

void redcc_team_note_member(void) {
    static _Thread_local bool is_noted __attribute__((__tls_model__("initial-exec")));
    if (is_noted || !__cxa_thread_atexit_impl)
        return;
    is_noted = true;
    if (__cxa_thread_atexit_impl(leave_members, NULL, (void *)leave_members) == 0)
        atomic_fetch_add(&members, 1);
}

void redcc_team_forked(void) {
    atomic_store(&members, 0);
    for (unsigned i = 0; i < LEAVING; i++)
        atomic_store(&leaving[i], 0);
}

static void be_noted(int number, int threads, void *unused) {
    (void)number;
    (void)threads;
    (void)unused;
}

/* The number of threads that are neither the initial thread nor members; negative: unknown. */
static int count_others(void) {
    const int tasks = count_tasks(), known = 1 + atomic_load(&members);
    return tasks == 0 ? -1 : tasks - known;
}

/* Is there an ended member that the system has not removed yet? */
static bool is_one_leaving(void) {
    bool is_one = false;
    const long process = redcc_system_process();
    for (unsigned i = 0; i < LEAVING; i++) {
        int id = atomic_load(&leaving[i]);
        if (id == 0)
            continue;
        if (redcc_system(SYS_tgkill, process, id, 0) == 0)
            is_one = true;
        else
            atomic_compare_exchange_strong(&leaving[i], &id, 0);
    }
    return is_one;
}

/* As count_others, but waits for other threads to end: up to `seconds`, or up to 1 s while
 * registered members are ending. Threads that OpenMP created only for the program's regions may be
 * ending, too. */
static int count_others_that_stay(double seconds) {
    enum { MOST_YIELDS = 100 };
    const struct timespec pause = {0, 200000};
    const double begin = redcc_seconds();
    for (int wait = 0;; wait++) {
        const bool may_change = is_one_leaving();
        const int others = count_others();
        if (others <= 0 || redcc_seconds() - begin > (may_change ? 1 : seconds))
            return others;
        if (wait < MOST_YIELDS)
            redcc_system_yield();
        else
            redcc_system(SYS_nanosleep, &pause, NULL);
    }
}

/* Opens a region in which OpenMP's threads register as members. The region has as many threads as
 * the process, so that each idle thread gets a part. If these are more than 256 or threads are
 * limited, it has the usual number. */
static void note_all(int others) {
    enum { MOST = 256 };
    const int usual = redcc_region_threads(), all = 1 + atomic_load(&members) + others;
    const bool may_be_more = all <= MOST && !redcc_region_is_own() && !is_limited();
    redcc_region_run(may_be_more && all > usual ? all : usual, be_noted, NULL);
}

static atomic_int known; /* the number of other threads that had not ended after the last wait */

/* As count_others, but first waits for members that are ending. */
static int count_unknown(void) {
    (void)redcc_is_forked(); /* in a forked child, this first resets the count of members */
    const int others = count_others();
    return others > 0 && others != atomic_load(&known) ? count_others_that_stay(0) : others;
}

/* Waits for other threads to end. Returns whether none is left. */
static bool others_leave(void) {
    /* time in seconds; halved after each wait that did not see all of them end */
    static _Atomic double longest = 0.25;
    const double seconds = atomic_load(&longest);
    const int others = count_others_that_stay(seconds);
    atomic_store(&known, others);
    if (others > 0)
        atomic_store(&longest, seconds / 2);
    return others == 0;
}

/* Are all other threads of the process members? If some are unknown, waits for them to end, unless
 * the last wait left equally many. If `registers` is set, first opens a region in which OpenMP's
 * idle threads register as members. */
static bool are_others_idle(bool registers) {
    const int others = count_unknown();
    if (others == 0 && atomic_load(&known) != 0)
        atomic_store(&known, 0);
    if (others <= 0 || others == atomic_load(&known))
        return others == 0;
    if (registers)
        note_all(others);
    return others_leave();
}

bool redcc_team_is_alone(void) {
    if (redcc_region_is_nested() || redcc_crew_threads() > 0 ||
        redcc_system(SYS_gettid) != redcc_system_process())
        return false;
    return are_others_idle(true);
}

bool redcc_team_has_met(void) {
    if (!omp_get_level || omp_get_level() == 0)
        return redcc_team_is_alone();
    if (redcc_within || omp_get_level() > 1)
        return false;
    /* A region of one thread keeps the sequential order even with the directives, so there is
     * nothing to wait for. OpenMP's other threads are then idle and do not execute this loop. */
    if (omp_get_num_threads && omp_get_num_threads() == 1)
        return count_unknown() == 0;
    return are_others_idle(false);
}

#else

bool redcc_team_is_alone(void) {
    return false;
}

bool redcc_team_has_met(void) {
    return false;
}

void redcc_team_note_member(void) {
}

void redcc_team_forked(void) {
}

void redcc_team_bind(void) {
}

int redcc_team_prepare(int threads, uint64_t before) {
    (void)before;
    return threads;
}

bool redcc_team_grows(int threads) {
    (void)threads;
    return false;
}

int redcc_team_missing(int threads) {
    (void)threads;
    return 0;
}

int redcc_team_to_start(int threads) {
    (void)threads;
    return 0;
}

void redcc_team_begun(int threads) {
    (void)threads;
}

#endif
