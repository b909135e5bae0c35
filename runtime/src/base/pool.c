/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "base/pool.h"

#include "base/system.h"
#include "base/team.h"
#include "base/wait.h"

#include <assert.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>

/* The references to functions for threads are strong: with weak references, these functions would
 * not be linked into a static program. */

#ifdef __GLIBC__

extern int __cxa_thread_atexit_impl(void (*)(void *), void *, void *);

static void nothing(void *unused) {
    (void)unused;
}

/* Registers a thread destructor in this object, which keeps the object loaded until the thread
 * ends. Not needed in the executable, because it is never unloaded. A registration calls the
 * program's allocator, which may support only one thread (attack 32 of docs/soundness.md). */
static void stay_loaded(void) {
    if (!redcc_system_is_program())
        __cxa_thread_atexit_impl(nothing, NULL, (void *)(uintptr_t)nothing);
}

/* Registers end(it), to be called when the calling thread ends. False: registration failed. */
static bool call_at_end(void (*end)(void *), void *it) {
    return __cxa_thread_atexit_impl(end, it, (void *)(uintptr_t)nothing) == 0;
}

#else /* musl: its dlclose unloads nothing */

static void stay_loaded(void) {
}

static pthread_key_t key;
static bool has_key;
static void (*at_end)(void *);

static void make_key(void) {
    has_key = pthread_key_create(&key, at_end) == 0;
}

static bool call_at_end(void (*end)(void *), void *it) {
    static pthread_once_t once = PTHREAD_ONCE_INIT;
    at_end = end;
    return pthread_once(&once, make_key) == 0 && has_key && pthread_setspecific(key, it) == 0;
}

#endif

enum { MOST = 1024, LINE = 64 };

/* One thread's next task. It has cache lines of its own. */
struct slot {
    _Alignas(LINE) atomic_uint region; /* changes when there is a new task */
    atomic_int asleep;
    struct pool *pool;
    int number;
    int threads;
    region_work *work; /* NULL: the thread must end */
    void *shared;
};

struct pool {
    atomic_uint left; /* number of threads that the current region waits for */
    atomic_int asleep;
    atomic_int alive; /* number of threads that still use this memory; the last one frees it */
    int threads;      /* number of started threads, plus one for the calling thread */
    struct slot slot[MOST];
};

static _Thread_local struct pool *pool __attribute__((__tls_model__("initial-exec")));

int redcc_pool_threads(void) {
    return pool ? pool->threads : 1;
}

static void arrive(struct pool *it) {
    if (atomic_fetch_sub(&it->left, 1) == 1)
        redcc_wake(&it->left, &it->asleep);
}

/* ---- the threads ----------------------------------------------------------------------------- */

static void *serve(void *given) {
    struct slot *slot = given;
    struct pool *const it = slot->pool;
    stay_loaded();
    redcc_within = 1; /* a loop inside a loop's body must not run in parallel */
    unsigned seen = 0;
    arrive(it);
    for (;;) {
        redcc_wait_idle(&slot->region, seen, &slot->asleep);
        seen = atomic_load(&slot->region);
        if (!slot->work)
            break;
        slot->work(slot->number, slot->threads, slot->shared);
        arrive(it);
    }
    if (atomic_fetch_sub(&it->alive, 1) == 1)
        redcc_system_unmap(it, sizeof *it);
    return NULL;
}

static void begin(struct slot *slot, int threads, region_work *work, void *shared) {
    slot->threads = threads;
    slot->work = work;
    slot->shared = shared;
    atomic_fetch_add(&slot->region, 1);
    redcc_wake(&slot->region, &slot->asleep);
}

static void wait_for_all(struct pool *it, int threads) {
    for (unsigned left; (left = atomic_load(&it->left)) > 0;)
        redcc_wait_while(&it->left, left, &it->asleep, threads);
}

/* ---- the calling thread ---------------------------------------------------------------------- */

/* Called when the owning thread ends: ends the pool's threads. Does not wait for them, because they
 * may still be asleep. */
static void end(void *given) {
    struct pool *it = given;
    pool = NULL;
    for (int number = 1; number < it->threads; number++)
        begin(&it->slot[number], 0, NULL, NULL);
    if (atomic_fetch_sub(&it->alive, 1) == 1)
        redcc_system_unmap(it, sizeof *it);
}

static struct pool *make(void) {
    struct pool *it = redcc_system_map((sizeof *it + 4095) / 4096 * 4096);
    if (!it)
        return NULL;
    it->threads = 1;
    atomic_store(&it->alive, 1);
    if (call_at_end(end, it))
        return it;
    redcc_system_unmap(it, sizeof *it);
    return NULL;
}

static bool start(struct pool *it, const pthread_attr_t *attributes) {
    struct slot *slot = &it->slot[it->threads];
    pthread_t thread;
    slot->pool = it;
    slot->number = it->threads;
    atomic_fetch_add(&it->alive, 1);
    atomic_fetch_add(&it->left, 1);
    if (pthread_create(&thread, attributes, serve, slot) != 0) {
        atomic_fetch_sub(&it->alive, 1);
        atomic_fetch_sub(&it->left, 1);
        return false;
    }
    pthread_detach(thread);
    it->threads++;
    return true;
}

int redcc_pool_prepare(int threads, size_t stack) {
    assert(threads >= 1);
    pthread_attr_t attributes;
    threads = threads < MOST ? threads : MOST;
    if (threads <= redcc_pool_threads())
        return threads;
    if (!(pool || (pool = make())) || pthread_attr_init(&attributes) != 0)
        return redcc_pool_threads();
    if (stack)
        pthread_attr_setstacksize(&attributes, stack);
    while (pool->threads < threads && start(pool, &attributes))
        ;
    pthread_attr_destroy(&attributes);
    wait_for_all(pool, pool->threads);
    return pool->threads;
}

void redcc_pool_run(int threads, region_work *work, void *shared) {
    struct pool *const it = pool;
    assert(it && threads <= it->threads && atomic_load(&it->left) == 0);
    atomic_store(&it->left, (unsigned)threads - 1);
    for (int number = 1; number < threads; number++)
        begin(&it->slot[number], threads, work, shared);
    work(0, threads, shared);
    wait_for_all(it, threads);
}
