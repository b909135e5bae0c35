#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
# The frames of a run in formats of other programs, read back by od and awk. Arguments: PROGRAM SCENES
# FOLDER.
source "$(dirname "$0")/app_common.sh"
expect 0 "" "$program" run patch --steps 4 --frames 3 -o run --progress none
for format in pc2 vtu; do
  expect 0 "3 frames of " "$program" export run --format $format
done
read -r vertices triangles < <("$program" plan patch | awk '$1 == "mesh:" {print $2, $4}')
frames=$((3 * vertices * 3))
# floats ORDER FROM FILE: all that follow byte FROM, one a line
floats() { od --endian="$1" -An -v -w4 -t f4 -j "$2" "$3" | awk '{printf "%.9g\n", $1}'; }
# whole ORDER FROM FILE: the number of 4 bytes there
whole() { od --endian="$1" -An -t d4 -j "$2" -N 4 "$3" | tr -d ' '; }

holds "a cloth" test "$vertices" -gt 10 -a "$triangles" -gt 10
holds "PC2: its name" test "$(head -c 11 run/cloth.pc2)" = POINTCACHE2
holds "PC2: version" test "$(whole little 12 run/cloth.pc2)" = 1
holds "PC2: vertices" test "$(whole little 16 run/cloth.pc2)" = "$vertices"
holds "PC2: frames" test "$(whole little 28 run/cloth.pc2)" = 3
holds "PC2: size" test "$(stat -c %s run/cloth.pc2)" = $((32 + 4 * frames))
floats little 32 run/cloth.pc2 >pc2.floats
# What is in the files of one frame is what the cache holds, in the same order.
points() { # points FILE BEGIN: the vertices after the line that BEGIN matches
  awk -v begin="$2" -v n="$vertices" 'on && n-- > 0 {for (k = 1; k <= 3; k++) printf "%.9g\n", $k} $0 ~ begin {on = 1}' "$1"
}
for step in 0000 0002 0004; do points run/vtu/$step.vtu 'NumberOfComponents'; done >vtu.floats
# near FILE FILE: the same numbers, but for the digits that od leaves out.
near() {
  [ "$(wc -l <"$1")" = "$(wc -l <"$2")" ] &&
    paste "$1" "$2" | awk '{d = $1 - $2} d * d > 1e-13 * (1e-6 + $1 * $1) {exit 1}'
}
holds "the VTU files' positions" near pc2.floats vtu.floats
holds "the cloth moves" test "$(head -n $((3 * vertices)) pc2.floats | md5sum)" != "$(tail -n $((3 * vertices)) pc2.floats | md5sum)"
holds "it begins at its height" test "$(sed -n 3p pc2.floats)" = 0.62
holds "VTU: vertices" grep -q "NumberOfPoints=\"$vertices\"" run/vtu/0004.vtu
holds "VTU: triangles" grep -q "NumberOfCells=\"$triangles\"" run/vtu/0004.vtu
holds "VTU: their types" test "$(grep -c '^5$' run/vtu/0004.vtu)" = "$triangles"
holds "PVD: the frames" test "$(grep -o 'file="[0-9]*.vtu"' run/vtu/cloth.pvd | tr -d '\n')" = \
  'file="0000.vtu"file="0002.vtu"file="0004.vtu"'

for format in gltf glb; do
  expect 0 "3 frames of $vertices vertices in run/cloth.$format" "$program" export run --format $format
done
# Read back as a mesh it is the cloth of the first frame.
if [[ $("$program" mesh info run/cloth.glb 2>&1) != *"built without assimp"* ]]; then
  expect 0 "" "$program" run patch --steps 0 -o bare --frames 1 --progress none --set 'colliders=[]'
  expect 0 "" "$program" export bare --format glb
  expect 0 "" "$program" export bare --format pc2
  expect 0 "" "$program" mesh reorder bare/cloth.glb --order generated -o glb.obj
  awk '$1 == "v" {for (k = 2; k <= 4; k++) printf "%.9g\n", $k}' glb.obj >glb.floats
  floats little 32 bare/cloth.pc2 >bare.floats
  holds "the floats of glTF are those of the cache" near glb.floats bare.floats
fi

expect 0 "in elsewhere.pc2" "$program" export run -o elsewhere.pc2
holds "the path given" cmp run/cloth.pc2 elsewhere.pc2
expect 1 "no/where.pc2.partial" "$program" export run -o no/where.pc2.partial
expect 1 "cannot be written" "$program" export run -o no/where.pc2
expect 2 "--format is 'pc3', expected one of 'pc2', 'vtu', 'gltf', 'glb', 'mp4'; did you mean 'pc2'?" \
  "$program" export run --format pc3
for format in mdd obj ply stl; do
  expect 2 "--format is '$format', expected one of" "$program" export run --format $format
done
expect 2 "which folder?" "$program" export
expect 2 "one folder at a time, not 'b' as well" "$program" export run b
expect 1 "cannot be read" "$program" export nowhere
cp -r run torn
head -c 100 run/frames/0002.state >torn/frames/0002.state
expect 1 "0002.state" "$program" export torn -o torn.pc2
holds "nothing half-written" test ! -e torn.mdd -a ! -e torn.pc2.partial
finish
