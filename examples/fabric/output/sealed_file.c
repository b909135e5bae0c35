/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "output/sealed_file.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/files.h"
#include "output/fresh_file.h"

_Static_assert(sizeof(sealed_header) == 64, "the file's header has no padding");

enum { BYTE_ORDER_MARK = 0x01020304, BYTE_ORDER_SWAPPED = 0x04030201 };

int sealed_file_complain(const char *path, const char *what) {
    fprintf(stderr, "%s: %s\n", path, what);
    return -1;
}

static int complain_torn(const char *path, unsigned long long found, const sealed_header *header) {
    fprintf(stderr, "%s: torn: %llu of %llu bytes\n", path, found,
            (unsigned long long)header->payload_size + sizeof *header);
    return -1;
}

uint64_t fnv_1a(uint64_t hash, const void *bytes, size_t size) {
    const unsigned char *byte = bytes;
    for (size_t k = 0; k < size; k++)
        hash = (hash ^ byte[k]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t checksum(sealed_header header, const void *payload) {
    header.checksum = 0;
    return fnv_1a(fnv_1a(FNV_1A_BEGIN, &header, sizeof header), payload, header.payload_size);
}

int sealed_file_write(const sealed_kind *kind, sealed_header *header, const void *payload,
                      const char *path) {
    fresh_file f;
    memcpy(header->magic, kind->magic, sizeof header->magic);
    header->byte_order = BYTE_ORDER_MARK;
    header->version = kind->version;
    header->zero = 0;
    header->checksum = checksum(*header, payload);
    if (fresh_file_open(&f, path) != 0)
        return -1;
    fwrite(header, sizeof *header, 1, f.file);
    fwrite(payload, 1, header->payload_size, f.file);
    return fresh_file_close(&f, kind->durable ? fresh_file_sync(&f) : 0);
}

static int read_header(const sealed_kind *kind, sealed_header *header, FILE *file,
                       const char *path) {
    const size_t found = fread(header, 1, sizeof *header, file);
    if (found < sizeof header->magic ||
        memcmp(header->magic, kind->magic, sizeof header->magic) != 0) {
        fprintf(stderr, "%s: not %s of fabric's\n", path, kind->name);
        return -1;
    }
    if (found < sizeof *header)
        return sealed_file_complain(path, "torn: it ends in its header");
    if (header->byte_order == BYTE_ORDER_SWAPPED)
        return sealed_file_complain(path, "written by a machine of the other byte order");
    if (header->byte_order != BYTE_ORDER_MARK)
        return sealed_file_complain(path, "damaged: its byte order is none");
    if (header->version != kind->version) {
        fprintf(stderr, "%s: of format version %u, this program reads version %u\n", path,
                header->version, kind->version);
        return -1;
    }
    if (kind->check(header) != 0)
        return sealed_file_complain(path, "damaged: its header contradicts itself");
    return 0;
}

/* Checks, before memory is allocated, that a regular file is at least as long as the header claims.
 */
static int check_size(const sealed_header *header, FILE *file, const char *path) {
    struct stat status;
    if (fstat(fileno(file), &status) != 0 || !S_ISREG(status.st_mode))
        return 0;
    const uint64_t size = (uint64_t)status.st_size;
    if (size < sizeof *header || size - sizeof *header < header->payload_size)
        return complain_torn(path, size, header);
    return 0;
}

static int read_payload(const sealed_header *header, void *payload, FILE *file, const char *path) {
    const size_t found = fread(payload, 1, header->payload_size, file);
    if (found < header->payload_size)
        return complain_torn(path, found + sizeof *header, header);
    if (fgetc(file) != EOF)
        return sealed_file_complain(path, "damaged: it goes on after its end");
    if (checksum(*header, payload) != header->checksum)
        return sealed_file_complain(path, "damaged: its checksum differs");
    return 0;
}

void *sealed_file_read(const sealed_kind *kind, sealed_header *header, const char *path) {
    void *payload = NULL;
    FILE *file = files_open(path);
    if (!file)
        return NULL;
    if (read_header(kind, header, file, path) == 0 && check_size(header, file, path) == 0) {
        payload = malloc(header->payload_size + 1);
        if (!payload)
            sealed_file_complain(path, "out of memory");
        else if (read_payload(header, payload, file, path) != 0) {
            free(payload);
            payload = NULL;
        }
    }
    fclose(file);
    return payload;
}
