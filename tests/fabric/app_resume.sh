#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# A run that was interrupted and goes on leaves what one leaves that was not. Arguments: PROGRAM
# SCENES FOLDER [PARALLEL]: with PARALLEL the two programs go on with each other's runs.
export OMP_WAIT_POLICY=passive # a thread that waits does not take the core of one that works
source "$(dirname "$0")/app_common.sh"
parallel=${4:-}

# The account without what differs from run to run: seconds, the program and its threads.
account() {
  jq -S 'del(.program, .threads, .threads_at_last) | del(.. | .most_memory_bytes?, .seconds?, .mesh_seconds?, .setup_seconds?, .step_seconds?)' \
    "$1/summary.json"
}

# same_results FOLDER REFERENCE: the same files, byte for byte.
same_results() {
  holds "$1: its last state" cmp "$2/final.state" "$1/final.state"
  holds "$1: its frames" diff -rq "$2/frames" "$1/frames"
  holds "$1: its scene" cmp "$2/scene.yaml" "$1/scene.yaml"
  holds "$1: its account" cmp <(account "$2") <(account "$1")
}

quietly=(--progress none --frames 5)
small=(--set mesh.boundary=36 --set mesh.vertices=120)

if [ -n "$parallel" ]; then
  # What one program and some threads began another and others go on with.
  for scene in ball ring; do
    run=(run $scene "${quietly[@]}" "${small[@]}" --steps 9)
    run+=(--set mesh.origin="[0, 0, 0.7]" --set self_collision.gap=0.004)
    expect 0 "" "$program" "${run[@]}" -o $scene-whole
    for threads in 1 2 3; do
      expect 0 "" "$program" "${run[@]}" -o $scene-a$threads --stop-after 4
      expect 0 "" "$parallel" run --resume $scene-a$threads --threads $threads --progress none
      same_results $scene-a$threads $scene-whole
      expect 0 "" "$parallel" "${run[@]}" -o $scene-b$threads --stop-after 4 --threads $threads
      expect 0 "" "$program" run --resume $scene-b$threads --progress none
      same_results $scene-b$threads $scene-whole
    done
  done
  finish
  exit
fi

# Every scene of the gallery.
for scene in tablecloth hanging flag ball curtain ring patch flap; do
  run=(run $scene "${quietly[@]}" "${small[@]}" --steps 12)
  case $scene in
    flag) run+=(--set surroundings.wind_from=0.1) ;;
    tablecloth) run+=(--set mesh.origin="[0, 0, 0.9]") ;;
    ball) run+=(--set mesh.origin="[0, 0, 0.75]") ;;
    ring) run+=(--set mesh.origin="[0, 0, 0.6]") ;;
    curtain) run+=(--set pins.1.move_from=0) ;;
  esac
  expect 0 "" "$program" "${run[@]}" -o $scene-whole
  expect 0 "ended after step 3 of 12; to go on: $(basename "$program") run --resume $scene" \
    "$program" "${run[@]}" -o $scene --stop-after 3
  holds "$scene: it says that it has ended early" jq -e .interrupted $scene/summary.json >/dev/null
  expect 0 "" "$program" run --resume $scene/checkpoint --progress none
  same_results $scene $scene-whole
  holds "$scene: nothing is left to go on with" test ! -e $scene/checkpoint
done

# A mesh from a file, and cloth that lies against itself.
expect 0 "" "$program" run scarf "${quietly[@]}" --steps 4 -o scarf-whole
expect 0 "" "$program" run scarf "${quietly[@]}" --steps 4 -o scarf --stop-after 2
expect 0 "" "$program" run --resume scarf --progress none
same_results scarf scarf-whole

# By each integrator, stopped three times. (fabric.hard.resume goes on from every step.)
for integrator in linear-euler euler bdf2 midpoint; do
  run=(run patch "${quietly[@]}" "${small[@]}" --steps 7 --set time.integrator=$integrator)
  run+=(--set mesh.origin="[0, 0, 0.35]" --set material.strain_limit=0.02)
  run+=(--set self_collision.gap=0.002)
  expect 0 "" "$program" "${run[@]}" -o $integrator-whole
  expect 0 "" "$program" "${run[@]}" -o $integrator --stop-after 0
  for step in 3 5; do
    expect 0 "ended after step $step of 7" \
      "$program" run --resume $integrator --stop-after $step --progress none
  done
  expect 0 "" "$program" run --resume $integrator --progress none
  same_results $integrator $integrator-whole
done

# Checkpoints on the way: the last one stays, and leads on to more steps than were asked for.
run=(run patch "${quietly[@]}" "${small[@]}")
expect 0 "" "$program" "${run[@]}" -o longer --steps 9
expect 0 "" "$program" "${run[@]}" -o steps --steps 6 --checkpoint-every 4
holds "the last checkpoint" test -s steps/checkpoint
expect 0 "" "$program" run --resume steps --steps 9 --progress none
holds "more steps: the same state" cmp longer/final.state steps/final.state
expect 1 "steps/checkpoint: of step 9, expected one up to step 8, the last" \
  "$program" run --resume steps --steps 8
expect 0 "" "$program" run --resume steps --progress none
holds "a run that is done stays so" cmp longer/final.state steps/final.state

# A run into the folder of another begins anew.
expect 0 "" "$program" "${run[@]}" -o steps --steps 2
holds "no checkpoint of the older run is left" test ! -e steps/checkpoint

# A killed run leaves frames after its checkpoint, and goes on from there.
expect 0 "" "$program" "${run[@]}" -o whole --steps 9
expect 0 "" "$program" "${run[@]}" -o killed --steps 9 --checkpoint-every 4 --stop-after 4
cp killed/checkpoint kept
expect 0 "" "$program" run --resume killed --progress none
cp kept killed/checkpoint
rm killed/final.state killed/summary.json
head -c 100 killed/frames/0009.state >killed/frames/0008.state
expect 0 "" "$program" run --resume killed --progress none
same_results killed whole

# A signal while it runs: the state is saved, and how to go on is said.
interrupt INT "$program" "${run[@]}" -o signalled --steps 300 --progress json 2>signalled.said
holds "an interrupted run exits with 130" test $? -eq 130
holds "what Ctrl-C does is said" grep -q "ends after this step" signalled.said
holds "how to go on is said" grep -q "to go on: .* run --resume signalled" signalled.said
holds "it was one step at least" test "$(jq .step <<<"$first")" -eq 1
expect 0 "" "$program" run --resume signalled --progress none
expect 0 "" "$program" "${run[@]}" -o unsignalled --steps 300
same_results signalled unsignalled

# at_once BEFORE AFTER: between two outputs of times, the command that was interrupted has used less than a
# second more than the `used` before the signal.
at_once() {
  local late
  late=$(awk -F'[ms ]' -v used="$used" 'FNR == 2 {sum = 60 * $1 + $2 + 60 * $4 + $5 - sum}
    END {print sum - used}' "$1" "$2")
  holds "that takes no second, but $late s" awk -v late="$late" 'BEGIN {exit !(late > -0.1 && late < 1)}'
}
# With a barrier Ctrl-C waits for no step: that under way is undone, within a second.
times >begun
interrupt INT "$program" run poles -o large --set mesh.vertices=8000 --set mesh.boundary=350 \
  --frames 0 --progress json 2>large.said
status=$?
times >ended
holds "a run with a barrier is interrupted as well" test $status -eq 130
holds "its step is undone" grep -q "ended after step 1 of 70; to go on" large.said
at_once begun ended

# While the simulation is made, nothing is awaited.
"$program" run poles -o unmade --set mesh.vertices=60000 --set mesh.boundary=900 --progress none 2>unmade.said &
running=$! used=0
while awk -v used="$used" 'BEGIN {exit used >= 0.3}' && kill -0 $running; do cpu_seconds $running; done
times >begun
kill -TERM $running
wait $running
status=$?
times >ended
holds "the program ends at once" test $status -eq 130
holds "nothing is said or written" test ! -e unmade -a ! -s unmade.said
at_once begun ended

# A folder's name that a shell would take apart is quoted.
expect 0 "to go on: $(basename "$program") run --resume 'two words'" \
  "$program" "${run[@]}" -o "two words" --stop-after 1

# What is not this run's is refused, with what differs, and nothing is changed.
expect 0 "" "$program" "${run[@]}" -o refused --steps 9 --stop-after 5
cp -r refused before
refuse() { expect 1 "refused/checkpoint: $1" "$program" run --resume refused "${@:2}"; }
refuse "of another scene: 'name' is 'ball', there 'patch'" ball
refuse "of another scene: 'mesh.vertices' is 200, there 120" patch
refuse "of another scene: 'material.bend' is 0.5, there 0.0002" --set material.bend=0.5
refuse "of another scene: 'solution.precision' is mixed, there double" --set solution.precision=mixed
refuse "of another scene: 'time.integrator' is bdf2, there linear-euler" patch "${small[@]}" \
  --set time.integrator=bdf2
refuse "of step 5, expected one up to step 4, the last" --steps 4
head -c 3000 before/checkpoint >refused/checkpoint
refuse "torn: 3000 of $(stat -c %s before/checkpoint) bytes"
cp before/final.state refused/checkpoint
refuse "not a checkpoint of fabric's"
{ cat before/checkpoint; echo; } >refused/checkpoint
refuse "damaged: it goes on after its end"
{ head -c 12 before/checkpoint; printf '\007'; tail -c +14 before/checkpoint; } >refused/checkpoint
refuse "of format version 7, this program reads version 2"
cp before/checkpoint refused/checkpoint
holds "a refusal changes nothing" diff -r before refused
expect 0 "" "$program" run patch "${small[@]}" --resume refused --progress none
same_results refused whole

expect 1 "empty: no checkpoint in it" "$program" run --resume "$(mkdir empty; echo empty)"
expect 1 "nowhere: cannot be read: No such file" "$program" run --resume nowhere
expect 2 "--resume goes on in the folder" "$program" run --resume refused -o other
expect 2 "--resume keeps to what it began with" "$program" run --resume refused --frames 3
expect 2 "--stop-after is '-1'" "$program" run patch --stop-after -1
expect 2 "did you mean '--resume'?" "$program" run patch --resum x

# A collider's file that is another one now.
cp "$scenes/ring.yaml" "$scenes/ring.obj" .
run=(run ./ring.yaml "${quietly[@]}" "${small[@]}" --steps 4)
expect 0 "" "$program" "${run[@]}" -o collider --stop-after 2
sed -i '0,/^v /s/^v .*/v 0.25 0.01 0.002/' ring.obj
expect 1 "a collider's file has changed" "$program" run --resume collider

# A checkpoint that cannot be written ends the run; the one before it is as it was.
expect 0 "" "$program" run patch "${quietly[@]}" "${small[@]}" -o full --steps 6 --stop-after 2
cp full/checkpoint kept
mkdir full/checkpoint.partial
expect 1 "full/checkpoint: cannot be written" "$program" run --resume full --stop-after 4
holds "the older checkpoint" cmp kept full/checkpoint
rmdir full/checkpoint.partial
ln -s /dev/full full/checkpoint.partial
expect 1 "full/checkpoint: cannot be written: No space left on device" \
  "$program" run --resume full --stop-after 4
holds "the older checkpoint" cmp kept full/checkpoint
rm -f full/checkpoint.partial
expect 0 "" "$program" run --resume full --progress none
holds "nothing half-written is left" test -z "$(find . -name '*.partial')"
finish
