#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The frames of a run for other programs: VTK's files, compared with the states that od reads, and glTF.
# Arguments: PROGRAM SCENES FOLDER.
source "$(dirname "$0")/app_common.sh"
view=${program%/*}/fabric-view
expect 0 "" "$program" run patch --steps 4 --frames 3 -o run --progress none
expect 0 "3 frames of 200 vertices in run/vtu" "$program" export run
read -r vertices triangles < <("$program" plan patch | awk '$1 == "mesh:" {print $2, $4}')

holds "a cloth" test "$vertices" -gt 10 -a "$triangles" -gt 10
# A frame keeps positions as floats behind a header of 64 bytes (output/sealed_file.h).
floats() { # floats FILE: the positions in it
  od --endian=little -An -v -w4 -t f4 -j 64 -N $((12 * vertices)) "$1" | awk '{printf "%.9g\n", $1}'
}
points() { # points FILE: the vertices in it
  awk -v n="$vertices" 'on && n-- > 0 {for (k = 1; k <= 3; k++) printf "%.9g\n", $k} /NumberOfComponents/ {on = 1}' "$1"
}
# near FILE FILE: the same numbers, but for the digits that od leaves out.
near() {
  [ "$(wc -l <"$1")" = "$(wc -l <"$2")" ] &&
    paste "$1" "$2" | awk '{d = $1 - $2} d * d > 1e-13 * (1e-6 + $1 * $1) {exit 1}'
}
points run/vtu/0000.vtu >first.floats
for step in 0000 0002 0004; do
  floats run/frames/$step.state >state.floats
  points run/vtu/$step.vtu >vtu.floats
  holds "positions of frame $step" near state.floats vtu.floats
done
holds "the cloth moves" test "$(cmp -s first.floats vtu.floats; echo $?)" -eq 1
holds "it begins at its height" test "$(sed -n 3p first.floats)" = 0.620000005
holds "VTU: vertices" grep -q "NumberOfPoints=\"$vertices\"" run/vtu/0004.vtu
holds "VTU: triangles" grep -q "NumberOfCells=\"$triangles\"" run/vtu/0004.vtu
holds "VTU: their types" test "$(grep -c '^5$' run/vtu/0004.vtu)" = "$triangles"
holds "PVD: the frames" test "$(grep -o 'file="[0-9]*.vtu"' run/vtu/cloth.pvd | tr -d '\n')" = \
  'file="0000.vtu"file="0002.vtu"file="0004.vtu"'

expect 0 "3 frames of $vertices vertices in run/cloth.glb" "$view" gltf run
expect 0 "3 frames of $vertices vertices in other.gltf" "$view" gltf run -o other.gltf
holds "binary" test "$(head -c 4 run/cloth.glb)" = glTF
holds "text" test "$(head -c 1 other.gltf)" = '{'
expect 1 "other.fbx: not a glTF file by its name, expected .glb or .gltf" "$view" gltf run -o other.fbx
expect 2 "which folder?" "$view" gltf
expect 2 "one folder at a time, not 'b' as well" "$view" gltf run b
expect 1 "no/where.glb: cannot be written" "$view" gltf run -o no/where.glb

expect 0 "in elsewhere" "$program" export run -o elsewhere
holds "the folder given" diff -r run/vtu elsewhere
expect 1 "run/scene.yaml/vtu" "$program" export run -o run/scene.yaml/vtu
expect 2 "which folder?" "$program" export
expect 2 "one folder at a time, not 'b' as well" "$program" export run b
expect 1 "cannot be read" "$program" export nowhere
cp -r run torn
rm -r torn/vtu torn/cloth.glb
head -c 100 run/frames/0002.state >torn/frames/0002.state
expect 1 "0002.state" "$program" export torn
expect 1 "0002.state" "$view" gltf torn
holds "nothing half-written" test ! -e torn/vtu -a ! -e torn/cloth.glb -a ! -e torn/cloth.glb.partial
finish
