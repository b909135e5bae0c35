/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Which updates share a record. Statements that follow each other without anything between, and
 * update different arrays at one subscript, are a group; arrays of which each group has all or none
 * are one stream. Nothing that a group's operands read changes while it is executed, for what it
 * writes is written later; so all of them can be kept by its first statement.
 */
#include "emit/bins.h"
#include "emit/syntax.h"

typedef struct grouping {
    const loop_text *loop;
    unsigned member_count; /* updates so far, as they follow in the text: */
    struct member {
        const reduction_update *update;
        unsigned group;
    } * members;
    unsigned count; /* groups so far, numbered as they follow */
    unsigned begin; /* the first group of the statements at hand */
} grouping;

/** Has the element the same number, counted from its array's base in elements? Both have been found
 *  to be in step. */
static bool same_place(const loop_text *loop, const reduction_update *a,
                       const reduction_update *b) {
    const int64_t size = loop->facts->arrays[a->array].element->size;
    const int64_t other_size = loop->facts->arrays[b->array].element->size;
    const ir_node *left = a->target, *right = b->target;
    for (;; left = left->children[0], right = right->children[0]) {
        const bool ends = loop_array_of_base(loop, left) == (int)a->array;
        if (ends || loop_array_of_base(loop, right) == (int)b->array)
            return ends && loop_array_of_base(loop, right) == (int)b->array;
        if (left->kind != right->kind || left->child_count == 0 || right->child_count == 0)
            return false;
        if (left->kind == IR_INDEX && (left->type->size / size != right->type->size / other_size ||
                                       !syntax_same(left->children[1], right->children[1])))
            return false;
        if (left->kind == IR_MEMBER &&
            left->field->offset / size != right->field->offset / other_size)
            return false;
    }
}

static void add_member(grouping *g, const reduction_update *update, unsigned group) {
    g->members[g->member_count++] = (struct member){update, group};
}

static bool has_array(const grouping *g, unsigned group, unsigned array) {
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group == group && g->members[i].update->array == array)
            return true;
    return false;
}

/** The group of an update that follows: one behind those that update its array already, so that its
 *  updates keep their order. */
static unsigned group_for(grouping *g, const reduction_update *update) {
    unsigned from = g->begin;
    for (unsigned group = from; group < g->count; group++)
        if (has_array(g, group, update->array))
            from = group + 1;
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group >= from && same_place(g->loop, g->members[i].update, update))
            return g->members[i].group;
    return g->count++;
}

static void find_groups(grouping *g, const ir_node *node) {
    for (unsigned i = 0; i < node->child_count; i++) {
        const reduction_update *update = loop_update_at(g->loop->facts, node->children[i]);
        if (!update || node->kind != IR_BLOCK)
            g->begin = g->count;
        if (update)
            add_member(g, update, group_for(g, update));
        else
            find_groups(g, node->children[i]);
    }
    g->begin = g->count;
}

/** Is each group with one of the arrays a group with both? */
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

static void find_streams(const grouping *g, struct bins_text *bins, bool together) {
    bins->stream_count = 0;
    for (unsigned array = 0; array < g->loop->facts->array_count; array++) {
        unsigned s = 0;
        while (s < bins->stream_count && !(together && fits_stream(g, &bins->streams[s], array)))
            s++;
        if (s == bins->stream_count)
            bins->streams[bins->stream_count++] = (bins_stream){0};
        bins->streams[s].arrays[bins->streams[s].array_count++] = array;
    }
}

static unsigned stream_of(const struct bins_text *bins, unsigned array) {
    for (unsigned s = 0;; s++)
        for (unsigned part = 0; part < bins->streams[s].array_count; part++)
            if (bins->streams[s].arrays[part] == array)
                return s;
}

/** The record of this stream and group, after those that there are. */
static void add_record(const grouping *g, struct bins_text *bins, unsigned group, unsigned stream) {
    bins_record record = {.stream = stream};
    for (unsigned i = 0; i < g->member_count; i++)
        if (g->members[i].group == group && stream_of(bins, g->members[i].update->array) == stream)
            record.updates[record.update_count++] = g->members[i].update;
    if (record.update_count > 0)
        bins->records[bins->record_count++] = record;
}

bool group_updates(loop_text *loop, struct bins_text *bins, bool together) {
    const loop_facts *facts = loop->facts;
    grouping g = {.loop = loop,
                  .members = ARENA_ARRAY(loop->arena, struct member, facts->update_count + 1)};
    const reduction_update *only = loop_update_at(facts, facts->counted.body);
    if (only)
        add_member(&g, only, g.count++);
    else
        find_groups(&g, facts->counted.body);
    find_streams(&g, bins, together);
    bins->record_count = 0;
    for (unsigned group = 0; group < g.count; group++)
        for (unsigned stream = 0; stream < bins->stream_count; stream++)
            add_record(&g, bins, group, stream);
    return g.member_count == facts->update_count;
}
