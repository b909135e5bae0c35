#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Runs the small scene; compares what came of it. Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"

expect 0 "200 particles, 350 triangles; 5 steps taken" "$program" run patch -o a --steps 5
expect 0 "" "$program" run patch -o b --steps 5 --progress none
for file in summary.json final.state scene.yaml frames/0000.state frames/0005.state; do
  holds "a run leaves $file" test -s "a/$file"
done
holds "nothing half-written is left" test -z "$(find a b -name '*.partial')"
holds "the same run gives the same bytes" cmp a/final.state b/final.state
expect 0 "positions: equal, every bit" "$program" compare a/final.state b/final.state

# The account: everything that the benchmarks ask for.
account() { jq -e "$1" a/summary.json >/dev/null; }
holds "particles and triangles" account '.particles == 200 and .triangles == 350'
holds "steps" account '.steps.taken == 5 and .steps.rejected == 0 and .interrupted == false'
holds "iterations" account '.cg_iterations > 0'
holds "phases" account '.phases | [.forces, .collisions, .solve, .update] |
  all(.seconds >= 0 and .calls == 5)'
holds "effects" account '[.effects[] | select(.name == "bend")][0].elements == 501'
holds "no wind" account '.inactive_effects | index("wind") != null'

# The scene in the folder is the scene that was run, settings and all.
expect 0 "" "$program" run patch -o c --steps 5 --set material.bend=0.001 --progress none
expect 0 "" "$program" run c/scene.yaml -o d --progress none
holds "c/scene.yaml gives c's bits" cmp c/final.state d/final.state

expect 1 "ulps at most" "$program" compare a/final.state c/final.state
expect 0 "" "$program" compare a/final.state c/final.state --tolerance 1
expect 1 "" "$program" compare a/final.state c/final.state --tolerance 1e-12
expect 2 "torn" "$program" compare a/final.state <(head -c 3000 a/final.state)
expect 2 "not a state of fabric's" "$program" compare a/final.state a/summary.json
expect 2 "cannot be read" "$program" compare a/final.state none.state
expect 0 "" "$program" run patch -o other --steps 0 --set mesh.vertices=150 --progress none
expect 2 "states of two meshes" "$program" compare a/final.state other/final.state

# Vertices in another order are compared as the vertices they are.
expect 0 "" "$program" run patch -o s --steps 0 --set mesh.order=sorted --progress none
expect 0 "" "$program" run patch -o u --steps 0 --set mesh.order=shuffled --progress none
holds "the orders differ" test "$(cmp -s s/final.state u/final.state; echo $?)" -eq 1
expect 0 "positions: equal, every bit" "$program" compare s/final.state u/final.state

# A run into an old folder leaves nothing of the old run.
expect 0 "" "$program" run patch -o a --steps 2 --frames 2 --progress none
holds "old frames are gone" test "$(ls a/frames | tr '\n' ' ')" = "0000.state 0002.state "
expect 0 "" "$program" run patch -o a --steps 1 --frames 0 --progress none
holds "no frames" test -z "$(ls a/frames)"

"$program" run patch -o j --steps 3 --progress json >steps.json
holds "one JSON object a step and nothing else" \
  test "$(jq -s 'map(.step)' -c steps.json)" = "[1,2,3]"
expect 0 "step 3 of 3" "$program" run patch -o l --steps 3 --progress lines

# Interrupted after a step: the account of what was done, and the state so far.
interrupt TERM "$program" run patch -o i --steps 100000000 --frames 0 --progress json
holds "an interrupted run exits with 130" test $? -eq 130
holds "its first step" test "$(jq .step <<<"$first")" -eq 1
holds "its account" jq -e '.interrupted and .steps.taken >= 1' i/summary.json >/dev/null
expect 0 "" "$program" compare i/final.state i/final.state

expect 0 "" "$program" run "$scenes/patch.yaml" --steps 1
holds "the default folder" test -s patch-run/final.state
finish
