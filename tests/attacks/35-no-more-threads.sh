#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The system refuses a process the threads, or the memory for their stacks: OpenMP would end it.
set -euo pipefail
. "$(dirname "$0")/a-loop"
./sequential >expected
export REDCC_METHOD=localwrite REDCC_REPORT=run.json
check() { # check WHAT COMMAND...
    local what=$1 status=0
    shift
    "$@" >found 2>error || status=$?
    if [ "$status" != 0 ] || ! cmp -s expected found; then
        echo "$what: status $status: $(cat error)" >&2
        exit 1
    fi
}
for threads in 2 7 40; do
    export OMP_NUM_THREADS=$threads
    check "no limit" ./parallel
    jq -e ".loops[0].threads == $threads" run.json >/dev/null
    for megabytes in 8 16 24 32 48 64 96 200; do # address space
        check "$threads threads in $megabytes MB" bash -c "ulimit -v $((megabytes * 1024)) && exec ./parallel"
    done
done
# As somebody whom the limit on processes binds (it does not bind root).
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then
    chmod 777 "$work"
    rm -f run.json
    for processes in 1 2 3 5; do
        export OMP_NUM_THREADS=4
        check "$processes processes" setpriv --reuid=54321 --regid=54321 --clear-groups \
            prlimit --nproc=$processes ./parallel
    done
fi
