/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/**
 * Definitions of the kernel's binary interface for asynchronous write protection, in which the
 * kernel itself resolves and records faults. They are those of Linux's <linux/userfaultfd.h> and
 * <linux/fs.h> since 6.7, under other names, because older headers lack them. See
 * ioctl_userfaultfd(2) and PAGEMAP_SCAN(2const).
 */
#ifndef REDCC_PAGE_WATCH_ABI_H
#define REDCC_PAGE_WATCH_ABI_H

#include <stdint.h>
#include <sys/ioctl.h>

/** A flag of userfaultfd(2): only faults in user mode are handled. So no privilege is needed. */
#define WATCH_USER_MODE_ONLY 1

/** The argument of UFFDIO_API, with the requested features. */
struct watch_api {
    uint64_t api;
    uint64_t features;
    uint64_t ioctls;
};
#define WATCH_API_VERSION UINT64_C(0xAA)
#define WATCH_FEATURE_UNPOPULATED (UINT64_C(1) << 13) /* also protects unpopulated pages */
#define WATCH_FEATURE_ASYNC (UINT64_C(1) << 15)       /* the kernel resolves faults */
#define WATCH_IOCTL_API _IOWR(0xAA, 0x3F, struct watch_api)

struct watch_range {
    uint64_t start;
    uint64_t length;
};

/** The argument of UFFDIO_REGISTER. */
struct watch_register {
    struct watch_range range;
    uint64_t mode;
    uint64_t ioctls;
};
#define WATCH_REGISTER_WRITES (UINT64_C(1) << 1)
#define WATCH_IOCTL_REGISTER _IOWR(0xAA, 0x00, struct watch_register)

/** The argument of UFFDIO_WRITEPROTECT. */
struct watch_protect {
    struct watch_range range;
    uint64_t mode;
};
#define WATCH_PROTECT UINT64_C(1)
#define WATCH_IOCTL_PROTECT _IOWR(0xAA, 0x06, struct watch_protect)

/** The argument of PAGEMAP_SCAN, a request to /proc/self/pagemap. */
struct watch_scan {
    uint64_t size;
    uint64_t flags;
    uint64_t start;
    uint64_t end;
    uint64_t walk_end; /* output: the end of the scan */
    uint64_t regions;  /* address of struct watch_region [region_count] */
    uint64_t region_count;
    uint64_t most_pages;
    uint64_t inverted;
    uint64_t all_of;
    uint64_t any_of;
    uint64_t wanted;
};
struct watch_region {
    uint64_t start;
    uint64_t end;
    uint64_t categories;
};
#define WATCH_SCAN_ASYNC_ONLY (UINT64_C(1) << 1) /* fails if a part is not registered as async */
#define WATCH_IS_WRITTEN (UINT64_C(1) << 1)
#define WATCH_IS_PRESENT (UINT64_C(1) << 3)
#define WATCH_IOCTL_SCAN _IOWR('f', 16, struct watch_scan)

#endif
