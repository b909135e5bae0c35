/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/** The variants of binning that REDCC_METHOD names: binning (EITHER), binning:records and
 * binning:copies. */
#ifndef REDCC_BINS_KIND_H
#define REDCC_BINS_KIND_H

enum bins_kind { BINS_EITHER = 1, BINS_RECORDS, BINS_COPIES };

#endif
