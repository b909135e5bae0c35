#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The scenes of a test of hard cases end in the same bits with the physics as it is and with the
# physics behind redcc-cc. Arguments: TEST PARALLEL-TEST FOLDER THREADS...
set -uo pipefail
test=$1 parallel=$2 folder=$3
shift 3
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder" || exit 1

FABRIC_STAGE_BITS=$folder/serial.bits "$test" >serial.log 2>&1
[ -s serial.bits ] || { echo "no scene ended:"; tail -n 5 serial.log; exit 1; }
failures=0
for threads in "$@"; do
  OMP_NUM_THREADS=$threads FABRIC_STAGE_BITS=$folder/$threads.bits "$parallel" >$threads.log 2>&1 ||
    { echo "FAILED at $threads threads:"; grep -m 3 FAILED $threads.log; failures=1; }
  cmp serial.bits $threads.bits || { echo "other bits at $threads threads:"; diff serial.bits $threads.bits | head -n 4; failures=1; }
done
echo "$(wc -l <serial.bits) scenes"
exit $failures
