/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "support/map.h"

#include <assert.h>
#include <stdint.h>
#include <string.h>

typedef struct entry {
    const void *key; /* NULL: free */
    size_t length;
    uint64_t hash;
    void *value;
} entry;

struct map {
    arena *arena;
    entry *entries;  /* open addressing; at most half of them taken */
    size_t capacity; /* a power of two, or 0 */
    size_t count;
};

/* FNV-1a, on words of 8 bytes as far as possible. Each step is mixed so that the low bits of the
 * hash depend on the whole key. */
static uint64_t hash_of(const void *key, size_t length) {
    const unsigned char *bytes = key;
    uint64_t hash = 0xcbf29ce484222325u;
    for (; length >= 8; bytes += 8, length -= 8) {
        uint64_t word;
        memcpy(&word, bytes, 8);
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
    }
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    return hash ^ (hash >> 32);
}

map *map_new(arena *a) {
    map *m = ARENA_NEW(a, map);
    m->arena = a;
    return m;
}

/* The key's entry, or the free one in which it would be stored. */
static entry *find(const map *m, const void *key, size_t length, uint64_t hash) {
    assert((m->capacity & (m->capacity - 1)) == 0 && m->count < m->capacity);
    size_t i = (size_t)hash & (m->capacity - 1);
    for (;; i = (i + 1) & (m->capacity - 1)) {
        entry *e = &m->entries[i];
        if (e->key == NULL ||
            (e->hash == hash && e->length == length && memcmp(e->key, key, length) == 0))
            return e;
    }
}

static void grow(map *m) {
    map larger = *m;
    larger.capacity = m->capacity == 0 ? 16 : m->capacity * 2;
    larger.entries = ARENA_ARRAY(m->arena, entry, larger.capacity);
    for (size_t i = 0; i < m->capacity; i++)
        if (m->entries[i].key != NULL)
            *find(&larger, m->entries[i].key, m->entries[i].length, m->entries[i].hash) =
                m->entries[i];
    *m = larger;
}

void **map_at(map *m, const void *key, size_t length) {
    assert(key || length == 0);
    if (2 * m->count >= m->capacity)
        grow(m);
    uint64_t hash = hash_of(key, length);
    entry *e = find(m, key, length, hash);
    if (e->key == NULL) {
        *e = (entry){.key = arena_copy(m->arena, key, length), .length = length, .hash = hash};
        m->count++;
    }
    assert(2 * m->count <= m->capacity + 2);
    return &e->value;
}

void *map_get(const map *m, const void *key, size_t length) {
    return m->capacity == 0 ? NULL : find(m, key, length, hash_of(key, length))->value;
}
