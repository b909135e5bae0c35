/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "choose/advice.h"

#include "base/clock.h"
#include "base/memory.h"
#include "base/system.h"
#include "base/trace.h"
#include "choose/cost_model.h"
#include "choose/waking.h"
#include "ownership/fences.h"
#include "plan/copies.h"
#include "plan/tile_grid.h"

#include <assert.h>
#include <math.h>
#include <string.h>

/* For a loop whose sequential execution is never timed: from this number of iterations on, waking
 * two threads is worthwhile, even if iterations are very short. */
enum {
    SMALL_TRIP = 4096,
    /* The smallest number of units of the leading group per thread with which stealable blocks are
     * used. If the units are rows of a mesh, these blocks then cost 1 %. */
    LEAST_UNITS_TO_STEAL = 32768
};

/* ---- at entry -------------------------------------------------------------------------------- */

static const struct size_state *size_of(const struct chooser *chooser, redcc_int trip) {
    return redcc_size_of(&chooser->state, trip);
}

static enum reason reason_for(const struct chooser *chooser, enum rule rule) {
    switch (rule) {
    case RULE_SHORT:
        return REASON_LITTLE_WORK;
    case RULE_COMPARING:
        return REASON_COMPARED;
    case RULE_SLOWER:
        return REASON_SERIAL_FASTER;
    case RULE_UNATTRACTIVE:
        return REASON_UNATTRACTIVE;
    case RULE_CHANGED:
    case RULE_CHANGING:
        return REASON_CHANGED;
    case RULE_STOPPED:
        return REASON_DEADLINE;
    case RULE_REFUSED:
        return chooser->refused;
    default:
        return REASON_SAVING;
    }
}

static struct advice skip(struct chooser *chooser, struct decision decision) {
    chooser->skipped++;
    return (struct advice){.action = decision.action,
                           .timed = decision.timed,
                           .reason = reason_for(chooser, decision.rule),
                           .rule = decision.rule};
}

bool redcc_advise_rest(struct chooser *chooser, redcc_int trip, int threads,
                       struct advice *advice) {
    assert(threads >= 1);
    struct decision decision;
    if (!redcc_is_left_alone(&chooser->state, trip, threads, &decision))
        return false;
    *advice = skip(chooser, decision);
    return true;
}

/* The number of bytes of the subscripts whose addresses the call gives. */
static double bytes_to_check(const redcc_loop *loop, const redcc_extent *known) {
    double bytes = 0;
    for (uint32_t s = 0; s < loop->source_count; s++)
        if (loop->sources[s].flags & REDCC_IS_SUBSCRIPT)
            bytes += (double)redcc_range_size(redcc_reading_of(loop, known, NULL, s).range);
    return bytes;
}

static bool are_the_same(const struct chooser *chooser, const redcc_loop *loop,
                         const redcc_extent *known) {
    struct fingerprint all;
    return redcc_reuse_fingerprint(loop, known, INFINITY, &all) &&
           redcc_fingerprint_equal(all, chooser->all);
}

/* Stores this call's sample. Returns whether one of the last calls had the same sample. Several are
 * remembered, because a loop that is called for several arrays in turn keeps a plan for each. */
static bool note_sampled(struct chooser *chooser, uint64_t sampled) {
    int at = 0;
    while (at < REDCC_PLANS - 1 && chooser->sampled[at] != sampled)
        at++;
    const bool met = chooser->sampled[at] == sampled;
    memmove(chooser->sampled + 1, chooser->sampled, (size_t)at * sizeof *chooser->sampled);
    chooser->sampled[0] = sampled;
    return met;
}

static void note_subscripts(struct chooser *chooser, const redcc_loop *loop,
                            const redcc_extent *known) {
    const uint64_t sample = redcc_reuse_sample(loop, known), before = chooser->sampled[0];
    chooser->sample = sample;
    chooser->steady = sample == 0 ? -1 : note_sampled(chooser, sample) ? chooser->steady + 1 : 0;
    chooser->verified = chooser->remembered ? are_the_same(chooser, loop, known)
                                            : chooser->verified && sample && sample == before;
    chooser->remembered = false;
}

void redcc_advise_timed(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                        redcc_int trip, double seconds) {
    assert(trip >= 0);
    const double most = LEARN_SHARE * seconds;
    if (!chooser->sampled[0]) /* the loop had no state when this execution began */
        note_sampled(chooser, redcc_reuse_sample(loop, known));
    chooser->remembered = size_of(chooser, trip)->sequential.count == 1 &&
                          bytes_to_check(loop, known) * LEARN_BYTE / 2 < most &&
                          redcc_reuse_fingerprint(loop, known, most, &chooser->all);
}

/* The situation of a call without kept plans. `start` is the minimum cost of starting threads. */
static struct situation situation_of(const struct chooser *chooser, const redcc_loop *loop,
                                     redcc_int trip, int threads) {
    struct situation now = {.trip = trip,
                            .threads = threads,
                            .wake = redcc_wake_seconds(),
                            .start = redcc_least_start(threads),
                            .steady = chooser->steady,
                            .verified = chooser->verified,
                            .dry_run = loop->flags & REDCC_DRY_RUN,
                            .tiled = loop->flags & (REDCC_TILES | REDCC_BLOCKS),
                            .in_tiles = loop->flags & REDCC_TILES && redcc_can_be_tiled(trip),
                            .bins_only = loop->flags & REDCC_NO_INSPECTOR,
                            .whole = loop->flags & REDCC_WHOLE,
                            .begun = chooser->begun};
    if (loop->flags & REDCC_BINNED)
        now.kept[WAY_BINS] = KEPT_FITS;
    if (loop->flags & REDCC_SELECTS)
        now.kept[WAY_DIRECT] = KEPT_FITS;
    return now;
}

void redcc_advise_begun(struct chooser *chooser, redcc_int rest, redcc_int done, double seconds) {
    redcc_note_begin(&chooser->state, rest, done, seconds);
    chooser->begun = true;
}

bool redcc_advise_at_once(const redcc_loop *loop, redcc_int trip) {
    const struct situation now = {.trip = trip,
                                  .threads = 2,
                                  .bins_only = loop->flags & REDCC_NO_INSPECTOR,
                                  .whole = loop->flags & REDCC_WHOLE};
    return redcc_goes_at_once(&now);
}

bool redcc_advise_saving(struct chooser *chooser, const redcc_loop *loop, const redcc_extent *known,
                         redcc_int trip, int threads, struct advice *advice) {
    note_subscripts(chooser, loop, known);
    const struct situation now = situation_of(chooser, loop, trip, threads);
    chooser->reach = redcc_reach(&chooser->state, &now);
    if (chooser->reach != REACH_NOTHING)
        return false;
    const struct decision decision = redcc_decide(&chooser->state, &now);
    assert(decision.action == ACTION_SEQUENTIAL);
    chooser->begun = false;
    *advice = skip(chooser, decision);
    return true;
}

struct advice redcc_advise_entry(struct chooser *chooser, struct reuse *reuse, int threads) {
    const int came = chooser->asked == threads && chooser->came > 0 ? chooser->came : threads;
    assert(threads >= 1 && came <= threads);
    const struct request *request = &reuse->call->request;
    struct situation now = situation_of(chooser, request->loop, request->trip, threads);
    unsigned fits, changed;
    if (chooser->reach == REACH_TEAM)
        now.start = redcc_likely_start(threads);
    reuse->sampled = chooser->sample;
    redcc_reuse_survey(reuse, came, &fits, &changed);
    for (enum way way = WAY_COPIES; way <= WAY_LAST_PLANNED; way++)
        now.kept[way] = fits & 1u << way      ? KEPT_FITS
                        : changed & 1u << way ? KEPT_CHANGED
                                              : KEPT_NONE;
    const struct decision decision = redcc_decide(&chooser->state, &now);
    chooser->begun = false;
    struct advice advice = {.action = decision.action,
                            .way = decision.way,
                            .alone = decision.alone,
                            .deadline = decision.deadline,
                            .timed = decision.timed,
                            .may_lose = decision.may_lose,
                            .usual = redcc_usual(size_of(chooser, request->trip)),
                            .skipped_calls = chooser->skipped,
                            .earned = decision.earned,
                            .rule = decision.rule};
    chooser->skipped = decision.action == ACTION_SEQUENTIAL ? chooser->skipped + 1 : 0;
    if (decision.action == ACTION_SEQUENTIAL)
        advice.reason = reason_for(chooser, decision.rule);
    return advice;
}

/* ---- facts about the loop -------------------------------------------------------------------- */

/* Does any order of contributions give the same bits? */
static bool any_order_is_exact(const redcc_loop *loop) {
    for (uint32_t array = 0; array < loop->array_count; array++)
        if (loop->arrays[array].type > REDCC_UINT64)
            return false;
    return true;
}

static bool memory_allows(size_t limit, size_t bytes) {
    const size_t used = redcc_memory_in_use();
    if (limit)
        return used < limit && bytes < limit - used;
    const uint64_t there = redcc_system_memory();
    return there == 0 || bytes < there / 4;
}

bool redcc_copies_allowed(const struct inspection *inspection) {
    return redcc_copies_possible(&inspection->partition, inspection->touched) &&
           memory_allows(inspection->call->memory_limit,
                         redcc_copy_bytes(&inspection->partition, inspection->touched) *
                             (size_t)inspection->call->planned);
}

/* Seconds of an iteration of the sequential loop. The learner's times are divided by the trip count
 * with which the loop is entered; if it is left earlier, the iterations before take all the time.
 */
static double usual_iteration(const struct chooser *chooser, const struct request *request) {
    return redcc_usual(size_of(chooser, request->asked)) * (double)request->asked /
           (double)request->trip;
}

/* Converts the arms' seconds per iteration to those of the learner. */
static void per_asked(struct arm *arm, const struct request *request) {
    for (enum way way = 0; way < WAY_COUNT; way++)
        arm[way].execution *= (double)request->trip / (double)request->asked;
}

/* Seconds to record an iteration's touches and its end, beyond its slice. */
static double time_of_records(const struct inspection *inspection) {
    return 3 * (inspection->each.records + 1) * LEARN_TOUCH;
}

static struct slice_seconds time_of_slice(const struct inspection *inspection) {
    const double measured = redcc_slice_seconds(inspection);
    const double records = time_of_records(inspection);
    const double compared = measured - records > records / 3 ? measured - records : records / 3;
    return (struct slice_seconds){
        .recorded = measured > 2 * inspection->each.touches * LEARN_TOUCH ? measured : 0,
        .compared = measured > 0 ? compared : 0};
}

/* Those findings that can be computed both after the sample and after all iterations were
 * recorded. */
static struct findings begin_findings(const struct chooser *chooser,
                                      const struct inspection *inspection) {
    const struct call *call = inspection->call;
    const redcc_loop *loop = call->request.loop;
    const bool free_order = call->order == REDCC_ORDER_ANY || any_order_is_exact(loop);
    const bool are_copied = free_order && !(loop->flags & REDCC_ORDER_NEEDED) &&
                            !inspection->no_copies && redcc_copies_allowed(inspection);
    return (struct findings){
        .trip = call->request.trip,
        .threads = call->planned,
        .sequential = usual_iteration(chooser, &call->request),
        .spent = redcc_seconds() - call->entered,
        .touches = inspection->each.touches,
        .leading_rows = inspection->each.leading_rows,
        .further_rows = inspection->each.further_rows,
        .slice = time_of_slice(inspection),
        .copied =
            are_copied ? (double)redcc_copy_bytes(&inspection->partition, inspection->touched) : 0,
        .lanes = call->one_will_do,
        .tiled = redcc_may_be_tiled(inspection),
        .checked = bytes_to_check(loop, call->request.known)};
}

/* Are stealable blocks (partition.h) worth their cost? Uses share, overhead and changes of *found,
 * which is estimated with these blocks. */
static bool stealing_pays(const struct chooser *chooser, const struct call *call,
                          const struct estimate *found) {
    if (found->overhead > LEARN_SHARE / 2 || found->share * call->planned > LEARN_CONTENDED)
        return false; /* stealable blocks would save only 2 to 20 % of the iterations */
    /* If the iterations of a block are scattered, reading their subscripts also loads subscripts of
     * other blocks. */
    return found->changes < LEARN_FREQUENT ||
           usual_iteration(chooser, &call->request) >= 4 * LEARN_ROW;
}

/* ---- after the sample ------------------------------------------------------------------------ */

bool redcc_wants_estimate(const struct inspection *inspection) {
    return !inspection->call->method || inspection->call->method->selects;
}

static double bytes_touched(const struct inspection *inspection) {
    double bytes = 0;
    for (uint32_t array = 0; array < inspection->call->request.loop->array_count; array++)
        bytes += (double)redcc_range_size(inspection->touched[array]);
    return bytes;
}

/* Does the loop update arrays irregularly that are larger than the caches? */
static bool is_random(const struct inspection *inspection, double changes) {
    return changes >= LEARN_FREQUENT && bytes_touched(inspection) >= 3 * LEARN_CACHE;
}

/* Will plans prefetch the data that the original loop waits for? */
static bool is_fetched(const struct inspection *inspection, double changes) {
    const struct call *call = inspection->call;
    const bool is_said_off = call->prefetch == 0;
    return !is_said_off && (call->request.loop->flags & (REDCC_PREFETCHES | REDCC_LIGHT)) &&
           is_random(inspection, changes);
}

/* Seconds per iteration in which a thread selects its own iterations: it evaluates an equal share
 * of the slices in the survey (execute/survey.h), and those of blocks with elements of several
 * owners. Without fences all threads together (or one, in a dry run) have evaluated all slices once
 * before. */
static double time_of_selecting(const struct inspection *inspection, const struct findings *it) {
    const redcc_loop *loop = inspection->call->request.loop;
    const double even = 1.0 / it->threads;
    const double dried = inspection->inspector[0]->dry_run.seconds / (double)it->trip;
    const bool is_dry = loop->flags & REDCC_DRY_RUN;
    const double records = is_dry && dried > 0 ? dried : time_of_records(inspection);
    const double slice = records > it->slice.recorded ? records : it->slice.recorded;
    const double alike = it->slice.compared > 0 ? it->slice.compared : slice;
    const double open = is_dry || it->runs >= LEARN_FREQUENT ? 1 : it->runs / LEARN_FREQUENT;
    const double before = redcc_may_be_fenced(loop) ? 0 : (is_dry ? dried : 0) + slice * even;
    return before + (alike + open * (slice - alike)) * even + open * slice * (1 - even);
}

/* The share of a thread that selects its own iterations. With REDCC_PARTS, replicated iterations
 * count as a quarter, since they skip most of their work. */
static double share_directly(const struct inspection *inspection, const struct findings *it,
                             double largest) {
    const uint32_t flags = inspection->call->request.loop->flags;
    const double even = 1.0 / it->threads;
    const double share = flags & REDCC_PARTS ? even + (largest - even) / 4 : largest;
    /* tiles compute each pair once, and their slices are short */
    if (redcc_may_be_tiled(inspection) && it->sequential > 0)
        return even;
    return flags & REDCC_SELECTS && it->sequential > 0
               ? share + time_of_selecting(inspection, it) / it->sequential
               : 0;
}

/* Adds the findings for bins. Bins are expected to pay if updates are irregular, or if private
 * copies of small arrays of integers can be used. */
static void find_bins(const struct inspection *inspection, const struct estimate *estimate,
                      struct findings *findings) {
    const redcc_loop *loop = inspection->call->request.loop;
    const double bytes = bytes_touched(inspection);
    const double least_row = 4; /* smallest size of a row in bytes, from which an upper bound of the
                                   number of rows follows */
    const bool is_copied = any_order_is_exact(loop) && !(loop->flags & REDCC_ORDER_NEEDED) &&
                           bytes <= LEARN_CACHE &&
                           findings->touches * (double)findings->trip * least_row > bytes;
    findings->binned = loop->flags & REDCC_BINNED;
    findings->bins_known = is_copied || is_random(inspection, estimate->changes);
    const bool is_swept = loop->flags & REDCC_BINS_CHECKED;
    findings->bin_more =
        (is_copied ? bytes * LEARN_BYTE : 0) +
        (is_swept ? findings->slice.recorded * (double)findings->trip / findings->threads : 0);
}

static void trace_arms(const struct findings *findings, const struct arm *arm,
                       const redcc_loop *loop) {
    const char *const names[WAY_COUNT] = {
        [WAY_COPIES] = "copies",
        [WAY_INDEX] = "owners by index",
        [WAY_GRAPH] = "owners by graph",
        [WAY_DIRECT] = loop->flags & REDCC_TILES ? "tiles" : "owners directly",
        [WAY_BINS] = "bins"};
    const double trip = (double)findings->trip;
    for (enum way way = WAY_COPIES; way < WAY_COUNT; way++)
        if (arm[way].possible)
            redcc_trace(TRACE_CHOICE, loop,
                        "expected by %s: %.3g s, set-up %.3g s; sequential %.3g s", names[way],
                        arm[way].execution * trip, arm[way].set_up, findings->sequential * trip);
}

static struct decision pick_way(struct chooser *chooser, const struct inspection *inspection,
                                const struct estimate *estimate, const struct advice *entry) {
    const struct call *call = inspection->call;
    struct arm arm[WAY_COUNT];
    struct findings findings = begin_findings(chooser, inspection);
    findings.share = estimate->share;
    findings.runs = estimate->changes;
    findings.reusable = (call->request.loop->flags & REDCC_VERIFIABLE) != 0;
    findings.fetched = is_fetched(inspection, findings.runs);
    findings.direct = share_directly(inspection, &findings, estimate->direct);
    find_bins(inspection, estimate, &findings);
    redcc_estimate_arms(&findings, arm);
    trace_arms(&findings, arm, call->request.loop);
    per_asked(arm, &call->request);
    if (entry->alone) { /* a plan that pays is constructed in a later call */
        redcc_note_arms(&chooser->state, call->request.asked, arm, findings.spent);
        return (struct decision){.action = ACTION_SEQUENTIAL};
    }
    const bool is_dry = call->request.loop->flags & REDCC_DRY_RUN;
    const struct situation now = {.trip = call->request.asked,
                                  .threads = call->planned,
                                  .wake = redcc_wake_seconds(),
                                  .dried = is_dry ? inspection->inspector[0]->dry_run.seconds : 0,
                                  .awaited = entry->awaited,
                                  .tiled = findings.tiled,
                                  .steady = chooser->steady,
                                  .verified = chooser->verified,
                                  .measured = findings.slice.compared > 0,
                                  .kept = {[WAY_DIRECT] = KEPT_FITS}};
    return redcc_pick_way(&chooser->state, &now, arm, findings.spent);
}

/* Sets the deadline of the stage that begins now. */
static void set_deadline(struct inspection *inspection, double seconds) {
    inspection->pace.began = redcc_seconds();
    inspection->pace.deadline = inspection->pace.began + seconds;
}

enum route redcc_advise_sampled(struct chooser *chooser, struct advice *entry,
                                struct inspection *inspection, const struct estimate *estimate) {
    const struct call *call = inspection->call;
    struct partition *partition = &inspection->partition;
    if (call->method)
        return call->method->in_levels                      ? ROUTE_LEVELS
               : call->method->by_graph                     ? ROUTE_GRAPH
               : redcc_goes_without_schedules(call->method) ? ROUTE_DIRECT
                                                            : ROUTE_OWNERS;
    if (redcc_goes_directly(entry)) {
        redcc_partition_join_stealable(partition);
        return ROUTE_DIRECT;
    }
    const bool steals = partition->stealable > 0 && stealing_pays(chooser, call, estimate);
    const struct decision decision = pick_way(chooser, inspection, estimate, entry);
    if (partition->stealable > 0 && (!steals || decision.way != WAY_INDEX))
        redcc_partition_join_stealable(partition);
    entry->way = decision.way;
    if (decision.action == ACTION_REUSE && decision.way == WAY_DIRECT) {
        entry->action = ACTION_REUSE;
        return ROUTE_DIRECT;
    }
    if (decision.action != ACTION_INSPECT)
        return ROUTE_SERIAL;
    set_deadline(inspection, decision.deadline);
    if (entry->way != WAY_COPIES)
        return entry->way == WAY_GRAPH ? ROUTE_GRAPH : ROUTE_OWNERS;
    redcc_partition_in_one(partition); /* only the touched range matters: no owners */
    return ROUTE_COPIES;
}

void redcc_advise_check(const struct advice *entry, struct inspection *inspection) {
    const struct call *call = inspection->call;
    const double most = LEARN_SHARE * entry->usual * (double)call->request.asked;
    if (call->method || entry->may_lose == 0 || most == 0)
        return;
    set_deadline(inspection, most);
}

bool redcc_may_be_tiled(const struct inspection *inspection) {
    const struct call *call = inspection->call;
    const struct partition *partition = &inspection->partition;
    for (uint32_t array = 0; array < partition->array_count; array++)
        if (partition->group_of[array] != array) /* arrays overlap: two share an element */
            return false;
    return call->request.loop->flags & REDCC_TILES && redcc_can_be_tiled(call->request.trip);
}

/* ---- after the sweep ------------------------------------------------------------------------- */

/* Called when all iterations are recorded: are owners by address still expected to be faster than
 * the original loop? If not, the plan is not built. */
static bool index_pays(const struct chooser *chooser, const struct inspection *inspection,
                       bool reusable) {
    struct arm arm[WAY_COUNT];
    struct findings findings = begin_findings(chooser, inspection);
    findings.share = redcc_largest_share(inspection);
    findings.runs = redcc_count_runs(inspection) / (double)findings.trip;
    findings.fetched = is_fetched(inspection, findings.runs);
    findings.reusable = reusable;
    redcc_estimate_arms(&findings, arm);
    trace_arms(&findings, arm, inspection->call->request.loop);
    return arm[WAY_INDEX].execution <
           /* halfway between equality and the required gain */
           (1 + LEARN_BETTER) / 2 * findings.sequential;
}

const struct method *redcc_advise_swept(const struct chooser *chooser,
                                        const struct inspection *inspection, bool reusable) {
    assert(!redcc_is_logged(inspection));
    const struct method *named = inspection->call->method;
    if (!named && inspection->route == ROUTE_DIRECT)
        return redcc_may_be_tiled(inspection) ? &redcc_method_tiles
                                              : &redcc_method_localwrite_direct;
    if (inspection->route == ROUTE_COPIES)
        return named ? named : &redcc_method_expansion;
    if (named && !inspection->no_graph)
        return named;
    if (!named && !index_pays(chooser, inspection, reusable))
        return NULL;
    return inspection->partition.stealable ? &redcc_method_localwrite_steal
                                           : &redcc_method_localwrite;
}

/* ---- after the log and the partition --------------------------------------------------------- */

/* As stealing_pays, for owners chosen by the access graph. It assumes that their iterations are
 * scattered over the loop. */
static bool stealing_is_worth(const struct chooser *chooser, const struct call *call, double share,
                              double overhead) {
    const struct estimate found = {.share = share, .overhead = overhead, .changes = 1};
    return stealing_pays(chooser, call, &found);
}

/* auto tries stealable blocks if the owners have many units each. The cost of the blocks is known
 * only once they exist. */
const struct method *redcc_advise_logged(const struct chooser *chooser,
                                         struct inspection *inspection, bool reusable) {
    const struct call *call = inspection->call;
    const struct method *method = call->method ? call->method
                                  : reusable   ? &redcc_method_graph_localwrite
                                               : NULL;
    struct partition *partition = &inspection->partition;
    const uint32_t threads = (uint32_t)call->threads;
    if (call->method || !method || partition->stealable || partition->room > REDCC_OWNERS_MOST ||
        inspection->divide.units.leading / threads < LEAST_UNITS_TO_STEAL ||
        !stealing_is_worth(chooser, call, 1.0 / threads, 0))
        return method;
    redcc_partition_add_stealable(partition);
    return &redcc_method_graph_localwrite_steal;
}

void redcc_tell_no_graph(struct advice *entry) {
    entry->way = WAY_INDEX;
}

/* Were stealable blocks tried that turned out not to be worth their cost? */
static bool goes_without_stealing(const struct chooser *chooser,
                                  const struct inspection *inspection) {
    const struct call *call = inspection->call;
    if (call->method || !inspection->partition.stealable)
        return false;
    const redcc_int with = redcc_executed_in_all(inspection);
    const redcc_int without = redcc_executed_joined(inspection);
    const double trip = (double)call->request.trip;
    return !stealing_is_worth(chooser, call, (double)without / call->threads / trip,
                              (double)(with - without) / trip);
}

/* Would executing levels be faster than executing by the owners that the access graph gave?
 * Computes the levels to decide, but only if these owners are unbalanced and the deadline
 * permits. */
static bool levels_serve_better(struct inspection *inspection) {
    const struct call *call = inspection->call;
    const double share = redcc_largest_share(inspection), all = (double)call->request.trip;
    if (call->method || share * call->threads <= 1 + LEARN_RISK ||
        redcc_seconds() + inspection->each.touches * all * LEARN_ROW > inspection->pace.deadline)
        return false;
    return redcc_partition_levels(inspection) &&
           redcc_levels_length(&inspection->levels, call->threads) < LEARN_BETTER * share * all;
}

enum partitioned redcc_advise_partitioned(const struct chooser *chooser,
                                          struct inspection *inspection,
                                          const struct method **method) {
    if (goes_without_stealing(chooser, inspection)) {
        redcc_partition_join_stealable(&inspection->partition);
        *method = &redcc_method_graph_localwrite;
        return PARTITIONED_JOIN;
    }
    if (!levels_serve_better(inspection))
        return PARTITIONED_KEEP;
    *method = &redcc_method_wavefront;
    return PARTITIONED_LEVELS;
}

/* ---- after the execution --------------------------------------------------------------------- */

void redcc_tell(struct chooser *chooser, const struct outcome *outcome, enum reason reason) {
    if (outcome->result == RESULT_REFUSED)
        chooser->refused = reason;
    if (outcome->result == RESULT_CHANGED) /* the change was outside of the sampled words */
        chooser->steady = 0;
    redcc_observe(&chooser->state, outcome);
}

void redcc_tell_team(struct chooser *chooser, int asked, int came, double seconds, int started) {
    assert(asked >= 1 && started >= 0);
    chooser->asked = asked;
    chooser->came = came;
    redcc_note_waking(seconds, started);
}

enum rule redcc_advice_rule(const struct chooser *chooser, redcc_int trip) {
    return size_of(chooser, trip)->rule;
}

int redcc_advise_threads(redcc_int trip, int threads, double seconds, redcc_int iterations) {
    assert(threads >= 1 && iterations >= 0);
    const double each = iterations > 0 ? seconds / (double)iterations : 0;
    return trip < SMALL_TRIP && each * (double)trip < LEARN_WAKES * redcc_wake_seconds() ? 1
                                                                                         : threads;
}
