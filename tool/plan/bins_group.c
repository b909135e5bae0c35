/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Finds updates that share a record. In a run of adjacent update statements, a group consists of
 * the updates of one row of an array, or of rows of different arrays at one subscript. Arrays that
 * occur only together, in all groups, may be one stream. The group's writes are deferred, so its
 * operands do not change while it is executed, and the record at its first statement can hold all
 * of them.
 */
#include <assert.h>

#include "plan/bins_parts.h"
#include "plan/lookup.h"

typedef struct grouping {
    const loop_facts *facts;
    const bins_plan *bins;
    bool wide;             /* a record may update a row several times */
    unsigned member_count; /* number of updates so far, in textual order */
    struct member {
        const reduction_update *update;
        unsigned group;
    } * members;
    unsigned count; /* number of groups so far, in textual order */
    unsigned begin; /* the first group of the current run of adjacent updates */
} grouping;

static bool has_array(const grouping *g, unsigned group, unsigned array) {
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group == group && g->members[i].update->array == array)
            return true;
    return false;
}

/** Does the group have the update's row, and space for the update? An update in a nest has a
 *  separate record. */
static bool may_join(const grouping *g, unsigned group, const reduction_update *update) {
    unsigned count = 0;
    bool has_row = false;
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group == group) {
            if (nest_of(g->facts, g->bins, update) ||
                nest_of(g->facts, g->bins, g->members[i].update))
                return false;
            count++;
            has_row = has_row || is_same_row(g->facts, g->bins, g->members[i].update, update);
        }
    assert(count <= MOST_RECORD_UPDATES);
    return has_row && count < MOST_RECORD_UPDATES;
}

/** Returns the group for the next update; g->count means a new one. An array's updates must keep
 * their order, so groups before the last one that updates the array are excluded. Unless `wide`,
 * that last group is excluded too. */
static unsigned group_for(const grouping *g, const reduction_update *update) {
    assert(g->begin <= g->count);
    unsigned from = g->begin;
    for (unsigned group = from; group < g->count; group++)
        if (has_array(g, group, update->array))
            from = g->wide ? group : group + 1;
    while (from < g->count && !may_join(g, from, update))
        from++;
    return from;
}

static void add_update(grouping *g, const reduction_update *update) {
    assert(g->member_count < g->facts->update_count);
    const unsigned group = group_for(g, update);
    g->count += group == g->count;
    g->members[g->member_count++] = (struct member){update, group};
}

static void find_groups(grouping *g, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const reduction_update *update = loop_update_at(g->facts, node->children[i]);
        if (!update || node->kind != IR_BLOCK)
            g->begin = g->count;
        if (update)
            add_update(g, update);
        else
            find_groups(g, node->children[i]);
    }
    g->begin = g->count;
}

/** Does each group that updates either array update both? */
static bool are_always_together(const grouping *g, unsigned a, unsigned b) {
    for (unsigned group = 0; group < g->count; group++)
        if (has_array(g, group, a) != has_array(g, group, b))
            return false;
    return true;
}

static bool fits_stream(const grouping *g, const bins_stream *stream, unsigned array) {
    return stream->array_count < MOST_STREAM_ARRAYS &&
           are_always_together(g, stream->arrays[0], array);
}

static void find_streams(const grouping *g, bins_plan *bins, bool together) {
    bins->stream_count = 0;
    for (unsigned array = 0; array < g->facts->array_count; array++) {
        unsigned s = 0;
        while (s < bins->stream_count && !(together && fits_stream(g, &bins->streams[s], array)))
            s++;
        if (s == bins->stream_count)
            bins->streams[bins->stream_count++] = (bins_stream){0};
        assert(bins->streams[s].array_count < MOST_STREAM_ARRAYS);
        bins->streams[s].arrays[bins->streams[s].array_count++] = array;
    }
}

static unsigned stream_of(const bins_plan *bins, unsigned array) {
    for (unsigned s = 0;; s++)
        for (unsigned part = 0; part < bins->streams[s].array_count; part++)
            if (bins->streams[s].arrays[part] == array)
                return s;
}

/** Appends the group's record in this stream, if the group updates any of the stream's arrays. */
static void add_record(const grouping *g, bins_plan *bins, unsigned group, unsigned stream) {
    bins_record record = {.stream = stream};
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group == group && stream_of(bins, g->members[i].update->array) == stream)
            record.updates[record.update_count++] = g->members[i].update;
    if (record.update_count == 0)
        return;
    record.nest = nest_of(g->facts, bins, record.updates[0]);
    const bins_span *span = &bins->spans[record.updates[0] - g->facts->updates];
    record.span = span->loop ? span : NULL;
    assert(bins->record_count < g->facts->update_count);
    bins->records[bins->record_count++] = record;
}

bool group_updates(arena *a, const loop_facts *facts, bins_plan *bins, bool wide, bool together) {
    grouping g = {.facts = facts,
                  .bins = bins,
                  .wide = wide,
                  .members = ARENA_ARRAY(a, struct member, facts->update_count + 1)};
    find_rows(facts, bins, wide);
    const reduction_update *only = loop_update_at(facts, facts->counted.body);
    if (only)
        add_update(&g, only);
    else
        find_groups(&g, facts->counted.body);
    find_streams(&g, bins, together);
    bins->record_count = 0;
    for (unsigned group = 0; group < g.count; group++)
        for (unsigned stream = 0; stream < bins->stream_count; stream++)
            add_record(&g, bins, group, stream);
    return g.member_count == facts->update_count;
}
