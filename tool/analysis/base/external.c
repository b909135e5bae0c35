/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
#include "analysis/base/external.h"

#include <assert.h>
#include <string.h>

exported_kind external_kind(const analysis_options *options, const ir_function *function) {
    if (!options || !options->external || function->body || function->linkage.is_static ||
        function->has_other_attributes || function->linkage.is_renamed)
        return EXPORTED_NOTHING;
    const exported_kind *known = map_get(options->external, function->name, strlen(function->name));
    assert(!known || (*known > EXPORTED_NOTHING && *known <= EXPORTED_PURE));
    return known ? *known : EXPORTED_NOTHING;
}
