/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Files with a header, a payload and a checksum over both, in the writing machine's number formats.
 * Files that are incomplete, damaged, or of another kind, version or byte order are rejected.
 *
 *   0  char[8]  which kind of file it is
 *   8  uint32   0x01020304, to detect the byte order
 *  12  uint32   version of the kind's format
 *  16  uint32   bits of the parts that the payload has; each kind defines its own
 *  20  int32    vertices
 *  24  int32    triangles
 *  28  uint32   0
 *  32  double   time, s
 *  40  int64    step
 *  48  uint64   bytes of payload
 *  56  uint64   checksum: FNV-1a, 64 bits, of header (with 0 here) and payload
 */
#ifndef FABRIC_OUTPUT_SEALED_FILE_H
#define FABRIC_OUTPUT_SEALED_FILE_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef struct sealed_header {
    char magic[8];
    uint32_t byte_order;
    uint32_t version;
    uint32_t parts;
    int32_t vertex_count;
    int32_t triangle_count;
    uint32_t zero;
    double time;
    int64_t step;
    uint64_t payload_size;
    uint64_t checksum;
} sealed_header;

typedef struct sealed_kind {
    char magic[9];    /* 8 characters */
    uint32_t version; /* the version that this program writes and reads */
    const char *name; /* the kind of file in messages: "a state" */
    int durable;      /* true: flushed to the disk before it is renamed, so that it survives a
                       * crash */
    int (*check)(const sealed_header *); /* returns 0 if the rest of the header is valid, else -1 */
} sealed_kind;

/** Writes a temporary file and renames it, so that a file of that name is always complete. The
 *  caller sets the header's parts, counts, time, step and payload_size; the rest is filled in.
 *  Returns 0, or -1 after a message. */
int sealed_file_write(const sealed_kind *kind, sealed_header *header, const void *payload,
                      const char *path);

/** Reads and checks the file. Returns its payload, [header->payload_size], which the caller frees,
 *  or NULL after a message about the defect. */
void *sealed_file_read(const sealed_kind *kind, sealed_header *header, const char *path);

/** Prints "path: what" on standard error. Returns -1. */
int sealed_file_complain(const char *path, const char *what);

/** Returns the 64-bit FNV-1a hash (Fowler, Noll, Vo) of the bytes, continued from `hash`, which is
 *  FNV_1A_BEGIN at first. */
uint64_t fnv_1a(uint64_t hash, const void *bytes, size_t size);
#define FNV_1A_BEGIN UINT64_C(0xcbf29ce484222325)

#endif
