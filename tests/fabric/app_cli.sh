#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# What the command line says, above all to wrong ones. Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
name=$(basename "$program")

expect 2 "usage: $name COMMAND" "$program"
expect 0 "usage: $name COMMAND" "$program" --help
expect 0 "$name " "$program" --version
for command in run plan compare mesh accuracy; do
  expect 0 "usage: $name $command " "$program" $command --help
done
view=${program%/*}/fabric-view
for command in render film gltf export plot; do
  expect 0 "usage: fabric-view $command " "$view" $command --help
done
expect 2 "unknown command 'redner', did you mean 'render'?" "$view" redner
expect 0 "usage: fabric-view render " "$program" render --help
# Installed alone it says what it lacks.
mkdir alone empty && cp "$program" alone
PATH=$PWD/empty expect 1 "$name render: fabric-view, which draws, cannot be started: No such file or directory" alone/"$name" render a
expect 2 "unknown command 'rum', did you mean 'run'?" "$program" rum patch
expect 2 "unknown command 'xyzzy', --help lists the known ones" "$program" xyzzy
expect 2 "unknown option '--hepl', did you mean '--help'?" "$program" --hepl

expect 2 "$name run: unknown option '--step', did you mean '--steps'?" "$program" run patch --step 3
expect 2 "option '--steps' needs a value: N" "$program" run patch --steps
expect 2 "--steps is 'x', expected a whole number from 0 to 1000000000" "$program" run patch --steps x
expect 2 "--steps is '-1'" "$program" run patch --steps=-1
expect 2 "--threads is '0'" "$program" run patch --threads 0
expect 2 "--progress is 'liens', expected one of 'auto', 'bar', 'lines', 'json', 'none'; did you mean 'lines'?" \
  "$program" run patch --progress liens
expect 2 "which scene?" "$program" run
expect 2 "one scene at a time, not 'b' as well" "$program" run a b
long=$(printf 'x%.0s' {1..5000})
expect 1 "path too long" "$program" run "$long.yaml"
expect 1 "no scene is called 'pach' in $scenes, expected a path or one of 'ball', 'curtain', 'flag', 'flap', 'hanging', 'patch', 'poles', 'ring', 'scarf', 'sheet218k', 'tablecloth'; did you mean 'patch'?" \
  "$program" run pach
expect 1 "./none.yaml: cannot be read: No such file or directory" "$program" run ./none.yaml
expect 1 "--set material.bnd=1: unknown key 'bnd' in 'material'" "$program" run patch --set material.bnd=1
sed 's/gravity/gravty/' "$scenes/patch.yaml" >wrong.yaml
expect 1 "wrong.yaml:22: unknown key 'gravty' in 'surroundings', expected one of 'gravity', 'drag', 'tangential_drag', 'wind', 'wind_from', 'wind_until'; did you mean 'gravity'?" \
  "$program" run wrong.yaml
expect 1 "wrong.yaml/frames" "$program" run patch -o wrong.yaml/frames --steps 1

expect 0 "stretch" "$program" plan patch
expect 0 "200 particles, 350 triangles, 549 edges, 501 hinges" "$program" plan patch
expect 2 "which scene?" "$program" plan
# What a scene probably does not mean is said, and nothing else.
expect 0 "patch: 'pins.1' holds no vertex of the cloth" "$program" plan patch \
  --set 'pins=[{nearest: [0, 0, 0]}, {low: [7, 7], high: [8, 8]}]'
expect 0 "patch: 'self_collision.gap' is 0.5 m, as wide as the cloth's edges (0.0" "$program" plan patch --set self_collision.gap=0.5
expect 0 "patch: 'colliders.0.gap' is 2 m, as wide as the cloth (0.5 m)" "$program" plan patch \
  --set 'colliders=[{kind: sphere, radius: 1, gap: 2, position: [0, 0, -9]}]'
expect 0 "patch: the cloth is 500 m long; coordinates are metres, 'mesh.scale: 0.001' converts millimetres" \
  "$program" plan patch --set mesh.side=500
expect 0 "the cloth is 500 m long" "$program" run patch --set mesh.side=500 --steps 0 --progress none
expect 0 "patch: the cloth is 0.001 m long; coordinates are metres" "$program" plan patch --set mesh.side=0.001
for scene in patch ball curtain flag flap hanging ring scarf tablecloth; do
  "$program" plan $scene 2>doubts >planned || holds "$scene" false
  holds "no doubt about $scene" test ! -s doubts
done
expect 2 "which states?" "$program" compare a
expect 2 "--tolerance is 'x'" "$program" compare a b --tolerance x
expect 2 "which folder?" "$program" render
expect 1 "none/scene.yaml: cannot be read" "$program" render none

expect 2 "generate, reorder or info?" "$program" mesh
expect 2 "the action is 'inof', expected one of 'generate', 'reorder', 'info'; did you mean 'info'?" \
  "$program" mesh inof
expect 2 "where to? -o FILE.obj" "$program" mesh generate
expect 2 "which mesh?" "$program" mesh info
expect 1 "not 6 of 6" "$program" mesh generate --vertices 6 --boundary 6 -o small.obj
expect 0 "" "$program" mesh generate --vertices 200 --boundary 48 --seed 3 -o made.obj
expect 0 "edges:     549, of which 48 on the border and 0 of more than two triangles" \
  "$program" mesh info made.obj
expect 0 "" "$program" mesh reorder made.obj --order shuffled -o shuffled.obj
expect 0 "" "$program" mesh reorder shuffled.obj --order sorted -o sorted.obj
expect 0 "hinges:    501" "$program" mesh info sorted.obj
# Numbers lead back from any order.
for order in sorted shuffled hilbert; do
  expect 0 "" "$program" mesh reorder made.obj --order $order --numbers numbers.txt -o moved.obj
  expect 0 "" "$program" mesh reorder moved.obj --restore numbers.txt -o back.obj
  cmp made.obj back.obj
done
expect 0 "hinges:    501" "$program" mesh info moved.obj
"$program" mesh reorder made.obj --order metis -o metis.obj 2>metis.said ||
  grep -q "libmetis-dev" metis.said
head -n 199 numbers.txt >few.txt
expect 1 "few.txt does not hold 200 numbers" \
  "$program" mesh reorder moved.obj --restore few.txt -o no.obj
sed 's/^7$/8/' numbers.txt >twice.txt
expect 1 "no permutation of 200 vertices" \
  "$program" mesh reorder moved.obj --restore twice.txt -o no.obj
expect 1 "cannot read nowhere.txt" "$program" mesh reorder moved.obj --restore nowhere.txt -o no.obj
expect 1 "cannot write no/where" \
  "$program" mesh reorder made.obj --order sorted --numbers no/where -o no.obj
expect 2 "--restore is for reorder" \
  "$program" mesh reorder moved.obj --order sorted --restore numbers.txt -o no.obj
expect 2 "--numbers is for generate and reorder" "$program" mesh info made.obj --numbers numbers.txt
[ ! -e no.obj ]
holds "the order changes the file" test "$(cmp -s made.obj sorted.obj; echo $?)" -eq 1
echo "v 0 0" >wrong.obj
expect 1 "wrong.obj:1: expected 3 finite numbers" "$program" mesh info wrong.obj
# What is wrong with a mesh as a cloth is said; what cannot stay is removed.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0.5 0 1\nv 2 0 0\n' >bad.obj
printf 'f 1 2 3\nf 1 4 2\nf 1 2 5\nf 3 2 1\n' >>bad.obj
for said in "1 edges of more than two triangles" "1 triangles that are there twice, removed; the first is number 4" \
  "triangles: 3" "1 vertices of no triangle, held in place; the first is number 6"; do
  expect 0 "$said" "$program" mesh info bad.obj
done
expect 0 "removed" "$program" mesh reorder bad.obj --order sorted -o cleaned.obj
holds "three triangles are left" test "$(grep -c '^f' cleaned.obj)" -eq 3
printf 'v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >nan.obj
expect 1 "nan.obj:1: expected 3 finite numbers" "$program" mesh info nan.obj
printf 'v 0 0 0\nv 1 0 0\nf 1 1 2\n' >empty.obj
expect 1 "empty.obj:3: a triangle with one vertex twice" "$program" mesh info empty.obj
finish
