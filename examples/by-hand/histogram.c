/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Counts how often each key occurs. */
#include "kernels.h"

#include <redcc/parallel.h>

struct histogram {
    int n;
    const int *key;
    unsigned *count;
};
enum { COUNT }; /* updated */
enum { KEY };   /* read */
static const redcc_array histogram_arrays[] = {REDCC_ARRAY("count", REDCC_SUM, unsigned, 1)};
static const redcc_source histogram_sources[] = {REDCC_SUBSCRIPTS("key")};
/* Optional: allows binning, which stores updates as records and applies them later. It is fast if
 * keys change in every call. */
static const redcc_stream histogram_streams[] = {REDCC_KEPT(COUNT, unsigned, 1)};

REDCC_SLICE(histogram, int t) {
    redcc_updates(it, COUNT, loop->count, loop->key[t]);
}

REDCC_BODY(histogram, int t) {
    unsigned *count = redcc_base(it, COUNT, loop->count);
    redcc_add(it, COUNT, &count[loop->key[t]], 1u);
}

REDCC_DESCRIBE(histogram) {
    redcc_iterations(it, 0, loop->n);
    redcc_updates_array(it, COUNT, loop->count);
    redcc_reads_rows(it, KEY, loop->key, 0, loop->n);
}

#define REDCC_LOOP histogram
#define REDCC_WHERE "histogram.c", 45, "histogram"
#define REDCC_ARRAYS 1
#define REDCC_SOURCES 1
#define REDCC_STREAMS
/* VERIFIABLE, the default: rows depend only on `key`. LIGHT: short iterations without loops. */
#define REDCC_FLAGS REDCC_VERIFIABLE | REDCC_LIGHT
#include <redcc/define_loop.h>

void histogram(int n, const int *key, unsigned *count) {
    histogram_execute(&(struct histogram){n, key, count});
}
