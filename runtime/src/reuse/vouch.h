/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * A kept plan's sources that need not be read to be compared, because the system vouches that
 * nobody wrote to them since they were (docs/decisions/0007).
 */
#ifndef REDCC_VOUCH_H
#define REDCC_VOUCH_H

#include "reuse/reading.h"

struct execution;
struct member;

/** What is known of a source; version and ends hold for one reading only. */
struct vouch {
    struct reading reading;  /* where it lay when its pages began to be watched */
    uint64_t version;        /* of its whole pages, as they were compared; 0: not watched */
    struct fingerprint ends; /* of what lies beside them */
    uint64_t begun;          /* this execution's: a version, if comparing finds no change; or 0 */
    bool stands;             /* this execution's: the whole pages are untouched */
    uint32_t calm;           /* how often, one after the other, it was read and had not changed;
                                calls that were the sequential loop's in between count as well */
    uint32_t spared;         /* how often it was not read since it has been watched */
};

/** Asks of each source of the execution's candidate whether the system vouches for it; has those
 *  watched for which it is time. Alone, before any of them is read. */
void redcc_ask_watch(struct execution *execution);

/** Is the candidate's source, for which the system vouches, what it was? Reads what lies beside its
 *  whole pages. Any thread. */
bool redcc_vouched_unchanged(const struct execution *execution, uint32_t source);

/** Source number `source` of the candidate was read and is what it was. Called by one thread. */
void redcc_note_unchanged(struct execution *execution, uint32_t source);

/** How many sources of the execution's plan were not read in this execution. */
uint32_t redcc_vouched_sources(const struct execution *execution);

#endif
