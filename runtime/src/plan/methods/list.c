/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "plan/method.h"

/* clang-format off */
const struct method *const redcc_methods[] = {
    &redcc_method_serial,
    &redcc_method_atomic,
    &redcc_method_localwrite,
    &redcc_method_spare_localwrite,
    &redcc_method_graph_localwrite,
    &redcc_method_spare_graph_localwrite,
    &redcc_method_wavefront,
    &redcc_method_expansion,
    &redcc_method_pseudo_expansion,
    &redcc_method_dwa_lip,
    &redcc_method_pe_dwa_lip,
    &redcc_method_dwa_lip_fixed,
    &redcc_method_expansion_fixed,
    NULL,
};
/* clang-format on */
