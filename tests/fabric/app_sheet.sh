#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# Scenes whose cloth is a mesh from a file. Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
run() { expect 0 "" "$program" run "$@" --steps 12 --frames 2 --progress none; }
equal() { expect 0 "positions: equal, every bit" "$program" compare "$1/final.state" "$2/final.state"; }
# sheet FILE [LINE...]: patch.yaml with this cloth instead of the generated one, and these lines.
sheet() {
  sed -e '/^mesh:/,/^$/d' "$scenes/patch.yaml"
  printf 'mesh:\n  file: %s\n  order: sorted\n  origin: [0, 0, 0.62]\n' "$1"
  shift
  [ $# -eq 0 ] || printf '%s\n' "$@"
}

# The generated sheet, through a file: the same bits.
run patch -o generated
expect 0 "" "$program" mesh generate --vertices 200 --boundary 48 --seed 3 --side 0.5 -o sheet.obj
sheet sheet.obj >sheet.yaml
run sheet.yaml -o sheet
equal generated sheet
run sheet/scene.yaml -o again # what a run leaves is the same scene, from anywhere
equal generated again
expect 0 "200" "$program" plan sheet.yaml
expect 0 "" "$program" run sheet.yaml --steps 12 --frames 2 --progress none --stop-after 5 -o resumed
expect 0 "" "$program" run --resume resumed --progress none
equal generated resumed
mkdir -p elsewhere && cp sheet.obj elsewhere && sheet sheet.obj >elsewhere/sheet.yaml
run elsewhere/sheet.yaml -o fromelsewhere # a relative name starts from the scene's folder
equal generated fromelsewhere

# A roof of two triangles, bent by a right angle: at rest where the scene says so.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\n' >roof.obj
roof() {
  printf 'name: roof\nmesh: {file: roof.obj%s}\nmaterial: {density: 1, stretch: 10, shear: 2, bend: 1}\n' "$1"
  printf 'time: {step: 0.01, steps: 1}\n'
}
roof '' >flat.yaml
roof ', rest_angles: mesh' >bent.yaml
expect 0 "" "$program" run flat.yaml --steps 0 --progress none -o roof
for shape in flat bent; do expect 0 "" "$program" run $shape.yaml --steps 5 --progress none -o $shape; done
equal roof bent
expect 1 "numbers differ" "$program" compare roof/final.state flat/final.state
expect 1 "expected one of 'flat', 'mesh'" "$program" plan bent.yaml --set mesh.rest_angles=round

# Upright, its rest shape is the one in the file: at rest nothing moves it.
awk '$1 == "v" {print $1, $2, $4, $3} $1 == "f"' sheet.obj | sed 's,/[0-9]*,,g' >upright.obj
still=(--set 'surroundings.gravity=[0, 0, 0]' --set colliders='[]')
sheet upright.obj >upright.yaml
run upright.yaml "${still[@]}" -o upright
run upright.yaml "${still[@]}" --steps 0 -o upright0
equal upright upright0
# Larger in the file than its texture coordinates say: it shrinks if those are its rest shape.
sheet sheet.obj '  scale: 1.0' >scaled.yaml
run scaled.yaml --set mesh.scale=1 -o scaled
equal generated scaled
awk '$1 == "v" {print $1, 1.1 * $2, 1.1 * $3, $4; next} 1' sheet.obj >wide.obj
sheet wide.obj '  rest: texture' >wide.yaml
run wide.yaml "${still[@]}" -o shrunk
run wide.yaml "${still[@]}" --set mesh.rest=positions -o wide
expect 1 "" "$program" compare shrunk/final.state wide/final.state

# Pins: the same corner four ways.
corner=$(awk '$1 == "v" {n++; d = ($2 + 0.25)^2 + ($3 + 0.25)^2; if (n == 1 || d < best) {best = d; at = n}} END {print at}' sheet.obj)
pinned() { # pinned NAME PIN
  { cat sheet.yaml && printf '\npins:\n  - %s\n' "$2"; } >$1.yaml
  run $1.yaml -o $1
}
pinned rectangle '{low: [-0.26, -0.26], high: [-0.249, -0.249]}'
pinned box '{box_low: [-0.26, -0.26, 0.6], box_high: [-0.249, -0.249, 0.7]}'
pinned nearest '{nearest: [-0.3, -0.3, 0.7]}'
pinned vertices "{vertices: [$corner]}"
for by in box nearest vertices; do equal rectangle $by; done
expect 1 "" "$program" compare rectangle/final.state generated/final.state
run vertices/scene.yaml -o vertices-again
equal vertices vertices-again
run vertices.yaml --set "pins.0.vertices=[$corner, $corner]" -o vertices-set
equal vertices vertices-set
{ cat sheet.yaml && printf '\npins:\n  - {vertices: [1, 201]}\n'; } >wrong.yaml
expect 1 "wrong.yaml:38: 'pins.0.vertices' has the number 201" "$program" plan wrong.yaml
expect 1 "'pins.0.vertices' has the number 201, expected up to 200" \
  "$program" plan vertices.yaml --set 'pins.0.vertices=[1, 201]'
expect 1 "'pins.0.vertices' is '0', expected a whole number from 1 to 2000000000" \
  "$program" plan vertices.yaml --set 'pins.0.vertices=[0]'
expect 1 "'pins.0.vertices' is '7', expected a list, each a whole number from 1" \
  "$program" plan vertices.yaml --set 'pins.0.vertices=7'
expect 1 "unknown key 'low' in 'pins.0', expected one of 'vertices', 'velocity'" \
  "$program" plan vertices.yaml --set 'pins.0.low=[0, 0]'
expect 1 "'pins.0.box_low' lies above 'box_high', expected a corner below it" \
  "$program" plan box.yaml --set 'pins.0.box_low=[1, 1, 1]'

# A collider from a file is where the scene puts it.
run ring --set mesh.vertices=150 --set mesh.boundary=40 --set 'mesh.origin=[0, 0, 0.6]' -o ring
cp "$scenes/ring.obj" .
run ring --set mesh.vertices=150 --set mesh.boundary=40 --set 'mesh.origin=[0, 0, 0.6]' \
  --set "colliders.0.file=$PWD/ring.obj" -o ring-copy
equal ring ring-copy
run ring --set mesh.vertices=150 --set mesh.boundary=40 --set 'mesh.origin=[0, 0, 0.6]' \
  --set colliders.0.position='[0, 0, 0.4]' -o ring-low
expect 1 "" "$program" compare ring/final.state ring-low/final.state

# What is wrong is said with file and line.
sheet none.obj >none.yaml
expect 1 "none.yaml:33: 'mesh.file' is 'none.obj': no such file" "$program" plan none.yaml
printf 'v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n' >nan.obj
sheet nan.obj >nan.yaml
expect 1 "nan.yaml:33: 'mesh.file' is '$PWD/nan.obj': it cannot be read" "$program" plan nan.yaml
expect 1 "nan.obj:3: expected 3 finite numbers" "$program" plan nan.yaml
sheet sheet.obj '  side: 2' >both.yaml
expect 1 "both.yaml:36: unknown key 'side' in 'mesh', expected one of 'file', 'scale'" "$program" plan both.yaml
expect 1 "unknown key 'vertices' in 'mesh'" "$program" plan sheet.yaml --set mesh.vertices=100
expect 1 "its mesh is a file" "$program" accuracy mesh --scene sheet.yaml --quick -o accuracy
cp sheet.obj more.obj && printf 'v 5 5 5\nf 1 2 2\n' >>more.obj
sheet more.obj >more.yaml
expect 1 "more.obj:" "$program" plan more.yaml
cp sheet.obj more.obj && printf 'v 5 5 5\n' >>more.obj
expect 0 "1 vertices of no triangle, held in place; the first is number 201" "$program" plan more.yaml
finish
