#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A user who starts a setuid program must not make it write a report elsewhere, nor change its results.
set -euo pipefail
if [ "$(id -u)" != 0 ] || ! command -v setpriv >/dev/null; then
    exit 0 # cannot be tried
fi
. "$(dirname "$0")/a-loop"
mkdir mine
chmod 755 "$work"
export REDCC_REPORT=$work/mine/run.json REDCC_METHOD=unknown
if setpriv --reuid=54321 --regid=54321 --clear-groups ./parallel >/dev/null 2>&1; then
    echo "REDCC_METHOD=unknown was not heeded by a plain program" >&2
    exit 1
fi
chmod u+s parallel
setpriv --reuid=54321 --regid=54321 --clear-groups ./parallel >/dev/null || {
    echo "a setuid program heeded REDCC_METHOD" >&2
    exit 1
}
if [ -e "$REDCC_REPORT" ]; then
    echo "a setuid program wrote a report" >&2
    exit 1
fi
